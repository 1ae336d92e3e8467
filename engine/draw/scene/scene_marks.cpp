#include "draw/scene/scene_marks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "draw/members/scene_diagrams.hpp"
#include "draw/scene/scene_faces.hpp"

namespace trilith::draw {
namespace {

constexpr double hatch_spacing = 4.2;

/// Thin for small bodies, so that a wall of bricks remains readable.
double outline_width(const Scene& scene, const PageView& page) {
  std::vector<double> sizes;
  for (const SceneBody& body : scene.bodies) {
    if (body.role != BodyRole::free) continue;
    double x0 = body.outline[0].x(), x1 = x0, y0 = body.outline[0].y(), y1 = y0;
    for (const Vec2& p : body.outline) {
      x0 = std::min(x0, p.x()), x1 = std::max(x1, p.x());
      y0 = std::min(y0, p.y()), y1 = std::max(y1, p.y());
    }
    sizes.push_back(page.scale * std::sqrt((x1 - x0) * (y1 - y0)));
  }
  if (sizes.empty()) return 0.6;
  std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2), sizes.end());
  return std::clamp(0.035 * sizes[sizes.size() / 2], 0.2, 0.6);
}

PageBox box_around(const PagePoint& a, const PagePoint& b, double room) {
  return {std::min(a.x(), b.x()) - room, std::min(a.y(), b.y()) - room, std::max(a.x(), b.x()) + room,
          std::max(a.y(), b.y()) + room};
}

/// A frame: first the lines of all its polygons, then their fills, so that only the line around all of them remains.
void draw_parts(Canvas& canvas, const SceneBody& body, const PageView& page, const Colour& fill, double width) {
  std::vector<std::vector<PagePoint>> polygons;
  for (const std::vector<Vec2>& part : body.parts)
    if (std::vector<PagePoint> shown = page_outline(page, part); !shown.empty()) polygons.push_back(std::move(shown));
  for (const std::vector<PagePoint>& polygon : polygons)
    canvas.polygon(polygon, std::nullopt, Stroke{palette().outline, 2 * width});
  for (const std::vector<PagePoint>& polygon : polygons) canvas.polygon(polygon, fill, Stroke{fill, 0.1});
}

/// Parts with their own colours, and the outline again over them. A seam of the same colour closes gaps between them.
void draw_patches(Canvas& canvas, const SceneBody& body, const SceneView& view, const PageView& page,
                  const std::vector<PagePoint>& outline, double width) {
  for (const ScenePatch& patch : body.patches) {
    const std::vector<PagePoint> shown = page_outline(page, patch.outline);
    const Colour fill = value_fill(view, patch.value);
    if (!shown.empty()) canvas.polygon(shown, fill, Stroke{fill, 0.25});
  }
  canvas.polygon(outline, std::nullopt, Stroke{palette().outline, width});
}

/// Water in a joint: a band of the value's colour between dark edges.
void draw_strips(Canvas& canvas, const Scene& scene, const SceneView& view, const PageView& page) {
  constexpr double band = 3, edge = 0.6;
  for (const SceneStrip& strip : scene.strips)
    canvas.line(page.place(strip.a), page.place(strip.b), {palette().ink, band + 2 * edge});
  for (const SceneStrip& strip : scene.strips)
    canvas.line(page.place(strip.a), page.place(strip.b), {value_fill(view, strip.value), band});
}

void draw_bodies(Canvas& canvas, const Scene& scene, const SceneView& view, const PageView& page, bool ground) {
  const double width = outline_width(scene, page);
  for (const SceneBody& body : scene.bodies) {
    if ((body.role != BodyRole::free) != ground) continue;
    const std::vector<PagePoint> outline = page_outline(page, body.outline);
    if (outline.empty()) continue;
    if (ground)
      draw_ground(canvas, outline, hatch_direction(view, {body.role, body.group}), {palette().ground_outline, 0.7});
    else
      canvas.polygon(outline, body_fill(view, body), Stroke{palette().outline, width});
    if (!ground && !body.patches.empty()) draw_patches(canvas, body, view, page, outline, width);
    if (!ground && !body.parts.empty()) draw_parts(canvas, body, page, body_fill(view, body), width);
  }
}

void draw_link(Canvas& canvas, const PagePoint& a, const PagePoint& b, BearingMark state, std::vector<PageBox>& marks) {
  const bool joined = state != BearingMark::failed;
  canvas.line(a, b, {joined ? palette().ink : palette().failed, 0.5, joined ? Dash::solid : Dash::dotted});
  const int steps = 1 + static_cast<int>((b - a).norm() / 4);
  for (int i = 0; i <= steps; ++i) {
    const PagePoint p = a + (b - a) * (static_cast<double>(i) / steps);
    marks.push_back(box_around(p, p, 1));
  }
}

void draw_bearings(Canvas& canvas, const Scene& scene, const PageView& page, std::vector<PageBox>& marks) {
  // Smaller symbols in the small panels of a figure.
  const double radius = bearing_mark_radius * std::clamp(page.box.width() / 400, 0.7, 1.0);
  std::vector<PagePoint> places;
  std::vector<BearingMark> states;
  for (const SceneBearing& bearing : scene.bearings) {
    const PagePoint a = page.place(bearing.a), b = page.place(bearing.b);
    const bool apart = (a - b).norm() > 3 * radius;
    if (apart) draw_link(canvas, a, b, bearing.state, marks);
    places.push_back(apart ? a : PagePoint((a + b) / 2));
    states.push_back(bearing.state);
    if (!apart) continue;
    places.push_back(b);
    states.push_back(bearing.state);
  }
  places = spread(std::move(places), 2.7 * radius);
  for (const PagePoint& p : places) draw_bearing_halo(canvas, p, radius);
  for (std::size_t i = 0; i < places.size(); ++i) {
    draw_bearing_mark(canvas, places[i], states[i], radius);
    marks.push_back(box_around(places[i], places[i], radius + 1));
  }
}

void draw_forces(Canvas& canvas, const Scene& scene, const SceneView& view, const PageView& page,
                 std::vector<PageBox>& marks) {
  if (view.largest_force <= 0) return;
  for (const SceneForce& f : scene.forces) {
    // Below 1 % of the largest force only a dot would be visible.
    if (f.force.norm() < 0.01 * view.largest_force) continue;
    const Vec2 reach = f.force * (view.longest_arrow / view.largest_force);
    const Vec2 first = view.bars ? Vec2(f.point - reach / 2) : f.point;
    const PagePoint start = page.place(first), end = page.place(first + reach);
    draw_force(canvas, start, end, view.bars);
    marks.push_back(box_around(start, end, 1));
  }
}

}  // namespace

void draw_ground(Canvas& canvas, const std::vector<PagePoint>& outline, double hatch_degrees,
                 const Stroke& outline_stroke) {
  canvas.polygon(outline, palette().ground, std::nullopt);
  canvas.hatch(outline, hatch_degrees, hatch_spacing, {palette().ground_hatch, 0.35});
  canvas.polygon(outline, std::nullopt, outline_stroke);
}

Stroke ghost_stroke() {
  return {palette().ghost, 0.45, Dash::dashed};
}

void draw_force(Canvas& canvas, const PagePoint& start, const PagePoint& end, bool bar) {
  const Colour colour = palette().force;
  if (bar) return canvas.line(start, end, {colour, 1.1});
  const double length = (end - start).norm();
  if (length <= 0) return;
  const PagePoint along = (end - start) / length, across(-along.y(), along.x());
  const double head = std::min(5.0, 0.6 * length);
  const PagePoint neck = end - head * along;
  canvas.line(start, neck + 0.2 * head * along, {colour, 0.9});
  canvas.polygon({end, neck + 0.36 * head * across, neck - 0.36 * head * across}, colour, std::nullopt);
}

void draw_crack(Canvas& canvas, const PagePoint& a, const PagePoint& b, CrackMark mark) {
  // Width by class; for a short joint limited to a part of its length.
  constexpr double widths[] = {0.5, 1.1, 2.2, 0.9};  // fine, opened, wide, slid
  const double most = std::max(0.3, 0.25 * (b - a).norm());
  canvas.line(a, b,
              {mark == CrackMark::slid ? palette().slid : palette().opened,
               std::min(widths[static_cast<std::size_t>(mark)], most)});
}

std::string crack_text(CrackMark mark) {
  switch (mark) {
    case CrackMark::fine:
      return fmt::format("joint open up to {:g} mm", 1e3 * fine_crack);
    case CrackMark::opened:
      return fmt::format("{:g} to {:g} mm", 1e3 * fine_crack, 1e3 * wide_crack);
    case CrackMark::wide:
      return fmt::format("more than {:g} mm", 1e3 * wide_crack);
    case CrackMark::slid:
      return "joint slid, opening smaller";
  }
  return "";
}

Stroke line_stroke() {
  return {palette().thrust, 1.2};
}

void draw_bearing_halo(Canvas& canvas, const PagePoint& at, double radius) {
  canvas.circle(at, 1.4 * radius, palette().paper, std::nullopt);
}

void draw_bearing_mark(Canvas& canvas, const PagePoint& at, BearingMark state, double radius) {
  const Palette& p = palette();
  const double r = radius;
  const Stroke thin{p.ink, 0.5};
  const auto at_offset = [&](double x, double y) { return PagePoint(at + PagePoint(x, y)); };
  switch (state) {
    case BearingMark::intact:
      canvas.circle(at, 0.85 * r, p.intact, std::nullopt);
      break;
    case BearingMark::yielded:
      canvas.polygon({at_offset(0, -1.3 * r), at_offset(1.3 * r, 0), at_offset(0, 1.3 * r), at_offset(-1.3 * r, 0)},
                     p.yielded, thin);
      break;
    case BearingMark::changed:
      canvas.rectangle({at.x() - 0.9 * r, at.y() - 0.9 * r, at.x() + 0.9 * r, at.y() + 0.9 * r}, p.paper,
                       Stroke{p.changed, 1.1});
      break;
    case BearingMark::failed:
      canvas.line(at_offset(-r, -r), at_offset(r, r), {p.failed, 1.3});
      canvas.line(at_offset(-r, r), at_offset(r, -r), {p.failed, 1.3});
      break;
  }
}

/// Moves points along x alone, so that marks keep their height: |d.x| must be sqrt(least^2 - d.y^2), and each point
/// moves half of the missing distance. Several rounds, because pairs affect each other.
std::vector<PagePoint> spread(std::vector<PagePoint> points, double least) {
  for (int round = 0; round < 12; ++round)
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t j = i + 1; j < points.size(); ++j) {
        const PagePoint d = points[j] - points[i];
        if (d.norm() >= least) continue;
        const double wanted = std::sqrt(least * least - d.y() * d.y());
        const double push = (wanted - std::abs(d.x())) / 2 * (d.x() < 0 ? -1 : 1);
        points[i].x() -= push;
        points[j].x() += push;
      }
  return points;
}

std::string bearing_text(BearingMark state) {
  switch (state) {
    case BearingMark::intact:
      return "bearing intact";
    case BearingMark::yielded:
      return "bearing yielded";
    case BearingMark::changed:
      return "bearing changed";
    case BearingMark::failed:
      break;
  }
  return "bearing failed";
}

std::vector<PageBox> draw_scene_content(Canvas& canvas, const Scene& scene, const SceneView& view,
                                        const PageView& page) {
  std::vector<PageBox> marks;
  canvas.clipped(page.box, [&] {
    const FaceRange ground = leading_ground(scene);
    const double edge_width = 0.75 * outline_width(scene, page);
    if (scene.faces.empty()) draw_bodies(canvas, scene, view, page, true);
    draw_faces(canvas, scene, ground, view, page, edge_width);
    for (const auto& ghost : scene.ghosts) {
      const std::vector<PagePoint> outline = page_outline(page, ghost);
      if (!outline.empty()) canvas.polygon(outline, std::nullopt, ghost_stroke());
    }
    if (scene.faces.empty()) draw_bodies(canvas, scene, view, page, false);
    draw_faces(canvas, scene, {ground.end, scene.faces.size()}, view, page, edge_width);
    draw_strips(canvas, scene, view, page);
    for (const SceneCrack& c : scene.cracks) draw_crack(canvas, page.place(c.a), page.place(c.b), c.mark);
    for (const std::vector<Vec2>& line : scene.lines)
      for (std::size_t i = 0; i + 1 < line.size(); ++i)
        canvas.line(page.place(line[i]), page.place(line[i + 1]), line_stroke());
    draw_diagrams(canvas, scene, view, page, marks);
    draw_hinges(canvas, scene, page, marks);
    draw_forces(canvas, scene, view, page, marks);
    draw_bearings(canvas, scene, page, marks);
  });
  draw_axes(canvas, scene, view.axes, page);
  return marks;
}

Colour ink_on(const Colour& fill) {
  const double luminance = 0.2126 * fill.red + 0.7152 * fill.green + 0.0722 * fill.blue;
  return luminance < 0.5 ? palette().paper : palette().ink;
}

}  // namespace trilith::draw
