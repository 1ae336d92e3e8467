#include "draw/scene/scene_faces.hpp"

#include <algorithm>
#include <utility>

#include "draw/scene/scene_marks.hpp"

namespace trilith::draw {
namespace {

constexpr double section_hatch_degrees = 45, section_hatch_spacing = 2.6;

bool is_outside(const std::vector<PagePoint>& points, const PageBox& box) {
  PageBox around{points[0].x(), points[0].y(), points[0].x(), points[0].y()};
  for (const PagePoint& p : points) {
    around.x0 = std::min(around.x0, p.x()), around.x1 = std::max(around.x1, p.x());
    around.y0 = std::min(around.y0, p.y()), around.y1 = std::max(around.y1, p.y());
  }
  return !around.overlaps(box);
}

/// Draws consecutive sides that are edges as one line.
void draw_edges(Canvas& canvas, const std::vector<PagePoint>& points, const std::vector<bool>& is_edge,
                const Stroke& stroke) {
  const std::size_t count = points.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_edge[i] || is_edge[(i + count - 1) % count]) continue;
    std::vector<PagePoint> line{points[i]};
    for (std::size_t k = i; is_edge[k % count] && line.size() <= count; ++k) line.push_back(points[(k + 1) % count]);
    canvas.polyline(std::move(line), stroke);
  }
}

void draw_flat_face(Canvas& canvas, const SceneFace& face, const Colour& fill, const std::vector<PagePoint>& points,
                    const Stroke& edge) {
  const bool whole = std::find(face.is_edge.begin(), face.is_edge.end(), false) == face.is_edge.end();
  if (face.is_section) {
    canvas.polygon(points, fill, std::nullopt);
    canvas.hatch(points, section_hatch_degrees, section_hatch_spacing, {palette().quiet_ink, 0.25});
  }
  const auto inside = face.is_section ? std::nullopt : std::optional<Colour>(fill);
  if (whole) return canvas.polygon(points, inside, edge);
  // A seam of the same colour closes the gap between parts of one face.
  if (!face.is_section) canvas.polygon(points, fill, Stroke{fill, 0.25});
  draw_edges(canvas, points, face.is_edge, edge);
}

constexpr double longest_arrow = 17, axes_room = 9;  // of the axes, and space around them for their names [pt]

/// An axis on the page, from their common point [pt].
PagePoint arrow_of(const Scene& scene, const SceneAxis& axis) {
  double most = 0;
  for (const SceneAxis& other : scene.axes) most = std::max(most, other.along.norm());
  return longest_arrow / most * PagePoint(axis.along.x(), -axis.along.y());
}

/// Extent of the axes and their names from their common point [pt].
std::pair<PagePoint, PagePoint> axes_reach(const Scene& scene) {
  PagePoint low = PagePoint::Zero(), high = low;
  for (const SceneAxis& axis : scene.axes) {
    const PagePoint tip = arrow_of(scene, axis);
    low = low.cwiseMin(tip), high = high.cwiseMax(tip);
  }
  return {low - PagePoint(axes_room, axes_room), high + PagePoint(axes_room, axes_room)};
}

PageBox axes_box(const Scene& scene, PanelCorner corner, const PageView& page) {
  const auto [low, high] = axes_reach(scene);
  const PagePoint size = high - low;
  const bool left = corner == PanelCorner::lower_left || corner == PanelCorner::upper_left;
  const bool upper = corner == PanelCorner::upper_left || corner == PanelCorner::upper_right;
  const double x = left ? page.box.x0 : page.box.x1 - size.x(), y = upper ? page.box.y0 : page.box.y1 - size.y();
  return {x, y, x + size.x(), y + size.y()};
}

/// True if a body covers a box of the page; outlines are clipped at this distance beyond it.
bool covers(const Scene& scene, const PageBox& box, const PageView& page) {
  const PageBox inner{box.x0 + axes_room, box.y0 + axes_room, box.x1 - axes_room, box.y1 - axes_room};
  const double x0 = page.world.x0 + (inner.x0 - page.box.x0) / page.scale;
  const double y0 = page.world.y0 + (page.box.y1 - inner.y1) / page.scale;
  const PageView part{{x0, y0, x0 + inner.width() / page.scale, y0 + inner.height() / page.scale}, inner, page.scale};
  return std::any_of(scene.bodies.begin(), scene.bodies.end(),
                     [&](const SceneBody& body) { return !page_outline(part, body.outline).empty(); });
}

}  // namespace

Colour lit(const Colour& fill, double light) {
  constexpr double darkest = 0.56, palest = 1;
  const double times = darkest + (palest - darkest) * std::clamp(light, -0.5, 1.0);
  const auto part = [&](double v) { return std::min(1.0, v * times); };
  return {part(fill.red), part(fill.green), part(fill.blue), fill.opacity};
}

FaceRange leading_ground(const Scene& scene) {
  const auto first = std::find_if(scene.faces.begin(), scene.faces.end(), [&](const SceneFace& face) {
    return scene.bodies[static_cast<std::size_t>(face.body)].role == BodyRole::free;
  });
  return {0, static_cast<std::size_t>(first - scene.faces.begin())};
}

void draw_faces(Canvas& canvas, const Scene& scene, FaceRange range, const SceneView& view, const PageView& page,
                double edge_width) {
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const SceneFace& face = scene.faces[i];
    std::vector<PagePoint> points;
    for (const Vec2& p : face.outline) points.push_back(page.place(p));
    if (is_outside(points, page.box)) continue;
    const SceneBody& body = scene.bodies[static_cast<std::size_t>(face.body)];
    if (face.radius > 0) {
      const Colour own = body_fill(view, body);
      canvas.ball(page.place(face.centre), page.scale * face.radius, lit(own, 1), lit(own, -0.2));
      continue;
    }
    // Shading would change the colour of a value, so only a little of it remains.
    const bool has_value = body.role == BodyRole::free && (body.value || face.value);
    const double light = has_value ? 0.8 + 0.2 * face.light : face.light;
    const Colour fill = has_value && face.value ? value_fill(view, *face.value) : body_fill(view, body);
    draw_flat_face(canvas, face, lit(fill, light), points,
                   {body.role == BodyRole::free ? palette().outline : palette().ground_outline, edge_width});
    for (const SceneCrack& c : face.cracks) draw_crack(canvas, page.place(c.a), page.place(c.b), c.mark);
  }
}

void draw_axes(Canvas& canvas, const Scene& scene, PanelCorner corner, const PageView& page) {
  if (scene.axes.empty()) return;
  const PageBox box = axes_box(scene, corner, page);
  const PagePoint origin = PagePoint(box.x0, box.y0) - axes_reach(scene).first;
  const Stroke stroke{palette().quiet_ink, 0.8};
  for (const SceneAxis& axis : scene.axes) {
    const PagePoint reach = arrow_of(scene, axis);
    if (reach.norm() < 0.08 * longest_arrow) {
      canvas.circle(origin, 1.2, palette().quiet_ink, std::nullopt);
      continue;
    }
    constexpr double head = 3.2;
    const PagePoint along = reach.normalized(), across(-along.y(), along.x()), tip = origin + reach;
    canvas.line(origin, tip - 0.6 * head * along, stroke);
    canvas.polygon({tip, tip - head * along + 0.34 * head * across, tip - head * along - 0.34 * head * across},
                   palette().quiet_ink, std::nullopt);
    const TextStyle style{6.5, false, palette().quiet_ink, Align::centre};
    canvas.text(tip + 4.2 * along + PagePoint(0, 0.33 * style.size), axis.name, style);
  }
}

PanelCorner corner_for_axes(const std::vector<Scene>& scenes, const PageView& page) {
  for (const PanelCorner corner :
       {PanelCorner::lower_left, PanelCorner::lower_right, PanelCorner::upper_left, PanelCorner::upper_right})
    if (std::none_of(scenes.begin(), scenes.end(), [&](const Scene& scene) {
          return !scene.axes.empty() && covers(scene, axes_box(scene, corner, page), page);
        }))
      return corner;
  return PanelCorner::lower_left;
}

}  // namespace trilith::draw
