#include "draw/scene/scene_labels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "draw/scene/scene_marks.hpp"
#include "geometry/plane/overlap.hpp"
#include "geometry/plane/polygon.hpp"

namespace trilith::draw {
namespace {

using Outline = std::vector<PagePoint>;

PageBox box_of(const Outline& outline) {
  PageBox box{outline[0].x(), outline[0].y(), outline[0].x(), outline[0].y()};
  for (const PagePoint& p : outline) {
    box.x0 = std::min(box.x0, p.x()), box.x1 = std::max(box.x1, p.x());
    box.y0 = std::min(box.y0, p.y()), box.y1 = std::max(box.y1, p.y());
  }
  return box;
}

/// True if the line from `a` to `b` intersects the box (Liang and Barsky 1984).
bool line_meets(const PagePoint& a, const PagePoint& b, const PageBox& box) {
  const PagePoint d = b - a;
  const std::array<double, 4> p = {-d.x(), d.x(), -d.y(), d.y()};
  const std::array<double, 4> q = {a.x() - box.x0, box.x1 - a.x(), a.y() - box.y0, box.y1 - a.y()};
  double enter = 0, leave = 1;
  for (std::size_t i = 0; i < 4; ++i) {
    if (p[i] == 0 && q[i] < 0) return false;
    if (p[i] < 0) enter = std::max(enter, q[i] / p[i]);
    if (p[i] > 0) leave = std::min(leave, q[i] / p[i]);
  }
  return enter <= leave;
}

bool border_meets(const Outline& outline, const PageBox& box) {
  for (std::size_t i = 0; i < outline.size(); ++i)
    if (line_meets(outline[i], outline[(i + 1) % outline.size()], box)) return true;
  return false;
}

PagePoint middle(const PageBox& box) {
  return {(box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2};
}

/// A panel's outlines and the occupied boxes.
struct Room {
  PageBox panel;
  std::vector<Outline> outlines;  ///< one per body, empty where outside
  std::vector<char> is_ground;    ///< one per body
  std::vector<PageBox> taken;

  bool within_panel(const PageBox& b) const {
    return b.x0 >= panel.x0 && b.x1 <= panel.x1 && b.y0 >= panel.y0 && b.y1 <= panel.y1;
  }
  bool clear_of_marks(const PageBox& b) const {
    return std::none_of(taken.begin(), taken.end(), [&](const PageBox& t) { return t.overlaps(b); });
  }
  bool in_the_open(const PageBox& b) const {
    return within_panel(b) && clear_of_marks(b) &&
           std::none_of(outlines.begin(), outlines.end(),
                        [&](const Outline& o) { return !o.empty() && (border_meets(o, b) || contains(o, middle(b))); });
  }
  /// True if the box is inside body `i` and away from the borders of other bodies.
  bool inside(std::size_t i, const PageBox& b) const {
    if (!within_panel(b) || !clear_of_marks(b) || !contains(outlines[i], middle(b))) return false;
    return std::none_of(outlines.begin(), outlines.end(), [&](const Outline& o) { return border_meets(o, b); });
  }
};

PageBox around(const PagePoint& centre, double width, double height) {
  return {centre.x() - width / 2, centre.y() - height / 2, centre.x() + width / 2, centre.y() + height / 2};
}

/// The position inside body `i` nearest to its centroid, on a fine grid.
std::optional<PageBox> place_inside(const Room& room, std::size_t i, double width, double height) {
  const Outline& outline = room.outlines[i];
  const PageBox box = box_of(outline);
  if (box.width() < width || box.height() < height) return std::nullopt;
  const PagePoint centroid = polygon_moments(outline).centroid;
  if (room.inside(i, around(centroid, width, height))) return around(centroid, width, height);
  std::optional<PageBox> best;
  double least = 1e30;
  constexpr int steps = 24;
  for (int row = 0; row <= steps; ++row)
    for (int column = 0; column <= steps; ++column) {
      const PagePoint at(box.x0 + box.width() * column / steps, box.y0 + box.height() * row / steps);
      const double distance = (at - centroid).squaredNorm();
      if (distance >= least || !room.inside(i, around(at, width, height))) continue;
      best = around(at, width, height);
      least = distance;
    }
  return best;
}

/// True if a name at `b` appears to belong to body `i`: it must be close, and no other free body as close.
bool belongs(const Room& room, std::size_t i, const PageBox& b) {
  const double own = boundary_point(room.outlines[i], middle(b)).distance;
  if (own > b.width() / 2 + b.height()) return false;
  for (std::size_t j = 0; j < room.outlines.size(); ++j) {
    if (j == i || room.is_ground[j] || room.outlines[j].empty()) continue;
    if (boundary_point(room.outlines[j], middle(b)).distance <= own) return false;
  }
  return true;
}

/// The nearest free position around body `i`, upward first.
std::optional<PageBox> place_beside(const Room& room, std::size_t i, double width, double height) {
  static const std::array<PagePoint, 8> ways = {PagePoint(0, -1),    PagePoint(0, 1),      PagePoint(1, 0),
                                                PagePoint(-1, 0),    PagePoint(0.7, -0.7), PagePoint(-0.7, -0.7),
                                                PagePoint(0.7, 0.7), PagePoint(-0.7, 0.7)};
  const PageBox box = box_of(room.outlines[i]);
  const PagePoint centroid = polygon_moments(room.outlines[i]).centroid;
  const double reach = std::hypot(box.width(), box.height()) / 2 + width;
  for (double distance = 0; distance <= reach; distance += 1.5)
    for (const PagePoint& way : ways) {
      const PageBox place = around(centroid + distance * way, width, height);
      if (room.in_the_open(place) && belongs(room, i, place)) return place;
    }
  return std::nullopt;
}

/// Position of each name relative to the centroid of its body at the start, on an unbounded page without marks. It does
/// not depend on the moment of the picture, so that names do not jump between pictures.
std::vector<std::optional<PagePoint>> places_at_start(const Scene& scene, const PageView& page,
                                                      const TextStyle& style) {
  constexpr double endless = 1e7;
  Room room{{-endless, -endless, endless, endless}, {}, {}, {}};
  for (const SceneBody& body : scene.bodies) {
    Outline outline;
    for (const Vec2& p : body.start) outline.push_back(page.place(p));
    room.outlines.push_back(std::move(outline));
    room.is_ground.push_back(body.role != BodyRole::free);
  }
  std::vector<std::optional<PagePoint>> out(scene.bodies.size());
  const double height = 1.3 * style.size;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const SceneBody& body = scene.bodies[i];
    if (body.name.empty() || room.outlines[i].size() < 3 || room.is_ground[i]) continue;
    const double width = text_width(body.name, style) + 3;
    std::optional<PageBox> place = place_inside(room, i, width, height);
    if (!place) place = place_beside(room, i, width, height);
    if (!place) continue;
    out[i] = middle(*place) - polygon_moments(room.outlines[i]).centroid;
    room.taken.push_back(*place);
  }
  return out;
}

/// The initial position, if it is free and still unambiguous.
std::optional<PageBox> kept_place(const Room& room, std::size_t i, const PagePoint& offset, double width,
                                  double height) {
  const PageBox place = around(polygon_moments(room.outlines[i]).centroid + offset, width, height);
  const bool beside = room.in_the_open(place) && belongs(room, i, place);
  return beside || room.inside(i, place) ? std::optional(place) : std::nullopt;
}

}  // namespace

/// A name is placed at its initial position if that is free, otherwise inside its body near the centroid. Otherwise it
/// is placed next to the body if no other body is near, or omitted. Placed names occupy space for the following ones.
void draw_labels(Canvas& canvas, const Scene& scene, const SceneView& view, const PageView& page,
                 std::vector<PageBox> marks, const TextStyle& style) {
  Room room{page.box, {}, {}, std::move(marks)};
  for (const SceneBody& body : scene.bodies) {
    room.outlines.push_back(page_outline(page, body.outline));
    room.is_ground.push_back(body.role != BodyRole::free);
  }
  const std::vector<std::optional<PagePoint>> kept = places_at_start(scene, page, style);
  const double height = 1.3 * style.size;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const SceneBody& body = scene.bodies[i];
    if (body.name.empty() || room.outlines[i].empty()) continue;
    const double width = text_width(body.name, style) + 3;
    TextStyle text = style;
    text.align = Align::centre;
    std::optional<PageBox> place = kept[i] ? kept_place(room, i, *kept[i], width, height) : std::nullopt;
    if (!place) place = place_inside(room, i, width, height);
    if (place && contains(room.outlines[i], middle(*place))) {
      const Colour fill = body_fill(view, body);
      text.colour = ink_on(fill);
      if (body.role != BodyRole::free) canvas.rectangle(*place, fill, std::nullopt);  // covers the hatch
    } else if (!place && body.role == BodyRole::free) {
      place = place_beside(room, i, width, height);
    }
    if (!place) continue;
    canvas.text(middle(*place) + PagePoint(0, 0.36 * style.size), body.name, text);
    room.taken.push_back(*place);
  }
}

}  // namespace trilith::draw
