#include "draw/scene_faces.hpp"

#include <algorithm>

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

/// Sides in a row that are edges as one line each.
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
    const Colour fill = lit(body_fill(view, body), face.light);
    const Stroke edge{body.role == BodyRole::free ? palette().outline : palette().ground_outline, edge_width};
    const bool whole = std::find(face.is_edge.begin(), face.is_edge.end(), false) == face.is_edge.end();
    if (face.is_section) {
      canvas.polygon(points, fill, std::nullopt);
      canvas.hatch(points, section_hatch_degrees, section_hatch_spacing, {palette().quiet_ink, 0.25});
    }
    const auto inside = face.is_section ? std::nullopt : std::optional<Colour>(fill);
    if (whole) {
      canvas.polygon(std::move(points), inside, edge);
      continue;
    }
    // A seam of the same colour closes the hair between parts of one face.
    if (!face.is_section) canvas.polygon(points, fill, Stroke{fill, 0.25});
    draw_edges(canvas, points, face.is_edge, edge);
  }
}

void draw_axes(Canvas& canvas, const Scene& scene, const PageView& page) {
  constexpr double longest = 17, head = 3.2, room = 9;
  double most = 0, left = 0, below = 0;
  for (const SceneAxis& axis : scene.axes) most = std::max(most, axis.along.norm());
  if (most <= 0) return;
  const auto on_page = [&](const SceneAxis& axis) {
    return PagePoint(longest / most * axis.along.x(), -longest / most * axis.along.y());
  };
  for (const SceneAxis& axis : scene.axes) {
    left = std::max(left, -on_page(axis).x());
    below = std::max(below, on_page(axis).y());
  }
  const PagePoint origin(page.box.x0 + left + room, page.box.y1 - below - room);
  const Stroke stroke{palette().quiet_ink, 0.8};
  for (const SceneAxis& axis : scene.axes) {
    const PagePoint reach = on_page(axis);
    if (reach.norm() < 0.08 * longest) {
      canvas.circle(origin, 1.2, palette().quiet_ink, std::nullopt);
      continue;
    }
    const PagePoint along = reach.normalized(), across(-along.y(), along.x()), tip = origin + reach;
    canvas.line(origin, tip - 0.6 * head * along, stroke);
    canvas.polygon({tip, tip - head * along + 0.34 * head * across, tip - head * along - 0.34 * head * across},
                   palette().quiet_ink, std::nullopt);
    const TextStyle style{6.5, false, palette().quiet_ink, Align::centre};
    canvas.text(tip + 4.2 * along + PagePoint(0, 0.33 * style.size), axis.name, style);
  }
}

}  // namespace trilith::draw
