#include "draw/scene/scene_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/error.hpp"

namespace trilith::draw {
namespace {

constexpr double most_metres = 1e9;
constexpr std::size_t most_arrows = 60;

bool is_ground(BodyRole role) {
  return role != BodyRole::free;
}

struct Extent {
  WorldBox box;
  bool any = false;
  void add(const Vec2& p) {
    if (!any) box = {p.x(), p.y(), p.x(), p.y()};
    any = true;
    box.x0 = std::min(box.x0, p.x()), box.x1 = std::max(box.x1, p.x());
    box.y0 = std::min(box.y0, p.y()), box.y1 = std::max(box.y1, p.y());
  }
  void add(const std::vector<Vec2>& points) {
    for (const Vec2& p : points) add(p);
  }
};

void check_point(const Vec2& p, const std::string& what) {
  if (!(p.array().abs() <= most_metres).all())
    throw InputError(fmt::format("{} is ({:g}, {:g}) m, must be finite and within 1e9 m", what, p.x(), p.y()));
}

void check_outline(const std::vector<Vec2>& outline, const std::string& what) {
  if (outline.size() < 3)
    throw InputError(fmt::format("{}: its outline has {} points, needs at least 3", what, outline.size()));
  for (std::size_t i = 0; i < outline.size(); ++i) check_point(outline[i], fmt::format("{}: point {}", what, i + 1));
}

void check_scene(const Scene& scene, const std::string& where) {
  if (scene.bodies.empty()) throw InputError(where + " has no body to draw");
  if (scene.time) require_finite(*scene.time, where + ": time");
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const SceneBody& body = scene.bodies[i];
    const std::string name = body.name.empty() ? fmt::format("body {}", i + 1) : fmt::format("body '{}'", body.name);
    check_outline(body.outline, fmt::format("{}, {}", where, name));
    if (body.value) require_finite(*body.value, fmt::format("{}, {}: value", where, name));
    for (const ScenePatch& patch : body.patches) {
      check_outline(patch.outline, fmt::format("{}, {}, part", where, name));
      require_finite(patch.value, fmt::format("{}, {}, part: value", where, name));
    }
  }
  for (const SceneStrip& strip : scene.strips) {
    for (const Vec2& p : {strip.a, strip.b}) check_point(p, where + ", joint with a value");
    require_finite(strip.value, where + ", value of a joint");
  }
  for (const SceneFace& face : scene.faces) {
    check_outline(face.outline, where + ", face of a solid");
    if (face.body < 0 || face.body >= static_cast<int>(scene.bodies.size()) ||
        face.is_edge.size() != face.outline.size())
      throw InputError(where + ": a face of a solid belongs to no body, or has a different number of marks and sides");
  }
  for (const auto& ghost : scene.ghosts) check_outline(ghost, where + ", outline of an earlier configuration");
  for (const SceneForce& f : scene.forces) {
    check_point(f.point, where + ", contact");
    require_finite(f.force.norm(), where + ", contact force");
  }
  for (const SceneBearing& b : scene.bearings)
    for (const Vec2& p : {b.a, b.b}) check_point(p, where + ", bearing");
  for (const SceneHinge& h : scene.hinges) check_point(h.at, where + ", hinge");
  for (const SceneDiagram& d : scene.diagrams) {
    if (d.axis.size() != d.value.size() || d.axis.size() != d.towards.size())
      throw InputError(where + ": a diagram has different numbers of points and values");
    for (std::size_t i = 0; i < d.axis.size(); ++i) {
      check_point(d.axis[i], where + ", diagram");
      require_finite(d.value[i], where + ", value of a diagram");
    }
  }
}

void check_style(const PictureStyle& style) {
  if (!(style.width >= 100 && style.width <= 5000))
    throw InputError(fmt::format("picture width is {:g} pt, must be 100 to 5000", style.width));
  if (!(style.height == 0 || (style.height >= 100 && style.height <= 5000)))
    throw InputError(fmt::format("picture height is {:g} pt, must be 100 to 5000, or 0 for automatic", style.height));
  if (!(style.font_size >= 4 && style.font_size <= 40))
    throw InputError(fmt::format("picture font size is {:g} pt, must be 4 to 40", style.font_size));
  if (!style.view) return;
  const WorldBox& v = *style.view;
  check_point({v.x0, v.y0}, "view of the picture: lower left corner");
  check_point({v.x1, v.y1}, "view of the picture: upper right corner");
  if (!(v.width() > 0 && v.height() > 0))
    throw InputError(fmt::format("view of the picture is {:g} x {:g} m, each must be above 0", v.width(), v.height()));
}

Extent free_extent(const std::vector<Scene>& scenes, bool fit_all) {
  Extent out;
  for (const Scene& scene : scenes) {
    for (const SceneBody& body : scene.bodies)
      if (!is_ground(body.role) && (fit_all || !body.is_debris)) out.add(body.outline);
    for (const auto& ghost : scene.ghosts) out.add(ghost);
    for (const SceneBearing& b : scene.bearings) out.add(b.a), out.add(b.b);
    for (const SceneForce& f : scene.forces) out.add(f.point);
  }
  return out;
}

double area_of(const std::vector<Vec2>& outline) {
  double sum = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) sum += cross(outline[i], outline[(i + 1) % outline.size()]);
  return 0.5 * std::abs(sum);
}

/// Value at the quantile `share` of the weight.
double quantile(std::vector<std::pair<double, double>> value_weight, double share) {
  std::sort(value_weight.begin(), value_weight.end());
  double all = 0, below = 0;
  for (const auto& [value, weight] : value_weight) all += weight;
  for (const auto& [value, weight] : value_weight)
    if ((below += weight) >= share * all) return value;
  return value_weight.back().first;
}

/// The region of nearly all of the free bodies' area in all scenes, enlarged by its size, so that a few stones far away
/// do not reduce the scale.
WorldBox bulk(const std::vector<Scene>& scenes) {
  constexpr double few = 0.04;
  std::vector<std::pair<double, double>> x, y;
  for (const Scene& scene : scenes)
    for (const SceneBody& body : scene.bodies) {
      if (is_ground(body.role) || body.is_debris) continue;
      const double weight = area_of(body.outline) / static_cast<double>(body.outline.size());
      for (const Vec2& p : body.outline) x.emplace_back(p.x(), weight), y.emplace_back(p.y(), weight);
    }
  if (x.empty()) return {-most_metres, -most_metres, most_metres, most_metres};
  WorldBox box{quantile(x, few), quantile(y, few), quantile(x, 1 - few), quantile(y, 1 - few)};
  const double around = 0.5 * std::max(box.width(), box.height());
  return {box.x0 - around, box.y0 - around, box.x1 + around, box.y1 + around};
}

Extent ground_extent(const std::vector<Scene>& scenes) {
  Extent out;
  for (const Scene& scene : scenes)
    for (const SceneBody& body : scene.bodies)
      if (is_ground(body.role)) out.add(body.outline);
  return out;
}

/// A typical length of the picture; for a slender structure not only its thickness.
double typical_size(const WorldBox& box) {
  const double larger = std::max(box.width(), box.height()), smaller = std::min(box.width(), box.height());
  return std::max(std::sqrt(larger * std::max(smaller, 0.1 * larger)), 1e-6);
}

/// Extends the box down to the ground below bodies in the air: the highest one beneath them, unless it is far away.
void reach_ground(WorldBox& box, const std::vector<Scene>& scenes) {
  const double far = std::max(box.width(), box.height());
  std::optional<double> level;
  for (const Scene& scene : scenes)
    for (const SceneBody& body : scene.bodies) {
      if (!is_ground(body.role)) continue;
      Extent ground;
      ground.add(body.outline);
      const bool beneath = ground.box.x0 < box.x1 && ground.box.x1 > box.x0 && ground.box.y1 < box.y0;
      if (beneath && ground.box.y1 > box.y0 - far) level = std::max(level.value_or(ground.box.y1), ground.box.y1);
    }
  if (level) box.y0 = *level;
}

/// Includes the ground; of a large one only a border.
void take_ground(WorldBox& box, const WorldBox& ground, double border) {
  box.x0 = std::min(box.x0, std::max(ground.x0, box.x0 - border));
  box.y0 = std::min(box.y0, std::max(ground.y0, box.y0 - border));
  box.x1 = std::max(box.x1, std::min(ground.x1, box.x1 + border));
  box.y1 = std::max(box.y1, std::min(ground.y1, box.y1 + border));
}

void set_forces(SceneView& view, const std::vector<Scene>& scenes, ForceMark mark, double size) {
  std::size_t most = 0;
  for (const Scene& scene : scenes) {
    most = std::max(most, scene.forces.size());
    for (const SceneForce& f : scene.forces) view.largest_force = std::max(view.largest_force, f.force.norm());
  }
  view.bars = mark == ForceMark::bar || (mark == ForceMark::automatic && most > most_arrows);
  // With many contacts long marks would overlap.
  view.longest_arrow = size * std::clamp(1.6 / std::sqrt(static_cast<double>(most) + 1), 0.05, 0.18);
}

/// The largest ordinate is about a seventh of the structure.
void set_ordinates(SceneView& view, const std::vector<Scene>& scenes, const WorldBox& box, double size) {
  for (const Scene& scene : scenes)
    for (const SceneDiagram& d : scene.diagrams)
      for (const double v : d.value) view.largest_ordinate = std::max(view.largest_ordinate, std::abs(v));
  view.longest_ordinate = std::max(0.16 * size, 0.08 * std::max(box.width(), box.height()));
}

/// Includes the tips of the diagrams, with space for the texts beyond them.
void add_ordinates(const SceneView& view, const std::vector<Scene>& scenes, Extent& content) {
  if (!(view.largest_ordinate > 0)) return;
  const double scale = view.longest_ordinate / view.largest_ordinate, space = 0.5 * view.longest_ordinate;
  for (const Scene& scene : scenes)
    for (const SceneDiagram& d : scene.diagrams)
      for (std::size_t i = 0; i < d.axis.size(); ++i)
        content.add(d.axis[i] + (scale * d.value[i] + std::copysign(space, d.value[i])) * d.towards[i]);
}

/// Includes all free bodies within the region of most of them, then arrows, a border of ground and a margin.
void set_world(SceneView& view, const std::vector<Scene>& scenes, const PictureStyle& style) {
  Extent content = free_extent(scenes, style.fit_all);
  const Extent ground = ground_extent(scenes);
  if (!content.any) content = ground;
  const WorldBox most = style.fit_all ? content.box : bulk(scenes);
  content.box = {std::max(content.box.x0, most.x0), std::max(content.box.y0, most.y0),
                 std::min(content.box.x1, most.x1), std::min(content.box.y1, most.y1)};
  reach_ground(content.box, scenes);
  const double size = typical_size(style.view.value_or(content.box));
  set_forces(view, scenes, style.force_mark, size);
  set_ordinates(view, scenes, style.view.value_or(content.box), size);
  view.world = style.view.value_or(content.box);
  if (style.view) return;
  if (view.largest_force > 0)
    for (const Scene& scene : scenes)
      for (const SceneForce& f : scene.forces)
        if (content.box.contains(f.point)) content.add(f.point + f.force * (view.longest_arrow / view.largest_force));
  add_ordinates(view, scenes, content);
  // In space a large ground has been cut off already, where it does not look like an end of the ground.
  if (ground.any) take_ground(content.box, ground.box, view.has_faces ? most_metres : 0.16 * size);
  const double margin = 0.04 * size;
  view.world = {content.box.x0 - margin, content.box.y0 - margin, content.box.x1 + margin, content.box.y1 + margin};
}

void note_value(SceneView& view, double value) {
  view.low = view.has_values ? std::min(view.low, value) : value;
  view.high = view.has_values ? std::max(view.high, value) : value;
  view.has_values = true;
}

void set_groups_and_values(SceneView& view, const std::vector<Scene>& scenes) {
  for (const Scene& scene : scenes) {
    for (const SceneStrip& strip : scene.strips) note_value(view, strip.value);
    for (const SceneFace& face : scene.faces)
      if (face.value) note_value(view, *face.value);
    for (const SceneBody& body : scene.bodies) {
      const BodyGroup group{body.role, body.group};
      const bool coloured = body.role == BodyRole::free && body.value;
      if (!coloured && std::find(view.groups.begin(), view.groups.end(), group) == view.groups.end())
        view.groups.push_back(group);
      if (coloured) note_value(view, *body.value);
      for (const ScenePatch& patch : body.patches) note_value(view, patch.value);
    }
  }
  // For values of both signs 0 has the middle colour; the scale ends at the extreme values.
  if (view.low < 0 && view.high > 0) view.farthest = std::max(view.high, -view.low);
}

/// Index of the group among the groups of its kind (free bodies, or ground).
std::size_t rank(const SceneView& view, const BodyGroup& group) {
  std::size_t count = 0;
  for (const BodyGroup& g : view.groups) {
    if (g == group) return count;
    if (is_ground(g.first) == is_ground(group.first)) ++count;
  }
  return count;
}

/// Sutherland and Hodgman (1974): the part of `points` on the side of one border where `inside` grows above zero.
template <class Inside>
std::vector<PagePoint> cut(const std::vector<PagePoint>& points, Inside inside) {
  std::vector<PagePoint> out;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PagePoint &from = points[i], &to = points[(i + 1) % points.size()];
    const double a = inside(from), b = inside(to);
    if (a >= 0) out.push_back(from);
    if ((a < 0) != (b < 0)) out.push_back(from + (to - from) * (a / (a - b)));
  }
  return out;
}

}  // namespace

SceneView scene_view(const std::vector<Scene>& scenes, const PictureStyle& style) {
  check_style(style);
  if (scenes.empty()) throw InputError("a picture needs at least one scene");
  for (std::size_t i = 0; i < scenes.size(); ++i)
    check_scene(scenes[i],
                scenes[i].title.empty() ? fmt::format("scene {}", i + 1) : fmt::format("scene '{}'", scenes[i].title));
  SceneView view;
  view.units = style.units;
  view.has_faces = std::any_of(scenes.begin(), scenes.end(), [](const Scene& s) { return !s.faces.empty(); });
  set_world(view, scenes, style);
  set_groups_and_values(view, scenes);
  return view;
}

std::string group_text(const BodyGroup& group) {
  if (!group.second.empty()) return group.second;
  if (group.first == BodyRole::fixed_ground) return "fixed ground";
  return group.first == BodyRole::moved_ground ? "moved ground" : "free body";
}

Colour group_fill(const SceneView& view, const BodyGroup& group) {
  return is_ground(group.first) ? palette().ground : body_tint(rank(view, group));
}

Colour body_fill(const SceneView& view, const SceneBody& body) {
  if (is_ground(body.role) || !body.value) return group_fill(view, {body.role, body.group});
  return value_fill(view, *body.value);
}

Colour value_fill(const SceneView& view, double value) {
  const double span = view.high - view.low;
  return value_colour(view, span > 0 ? (value - view.low) / span : 0.5);
}

Colour value_colour(const SceneView& view, double share) {
  if (view.farthest > 0)
    return diverging_colour(0.5 + 0.5 * (view.low + share * (view.high - view.low)) / view.farthest);
  return sequential_colour(view.high <= 0 && view.low < 0 ? 1 - share : share);
}

double hatch_direction(const SceneView& view, const BodyGroup& group) {
  return rank(view, group) % 2 == 0 ? 45 : 135;
}

std::vector<PagePoint> page_outline(const PageView& page, const std::vector<Vec2>& outline) {
  std::vector<PagePoint> points;
  for (const Vec2& p : outline) points.push_back(page.place(p));
  const PageBox& b = page.box;
  constexpr double beyond = 10;  // [pt]; the cut itself is not visible
  points = cut(points, [&](const PagePoint& p) { return p.x() - (b.x0 - beyond); });
  points = cut(points, [&](const PagePoint& p) { return b.x1 + beyond - p.x(); });
  points = cut(points, [&](const PagePoint& p) { return p.y() - (b.y0 - beyond); });
  points = cut(points, [&](const PagePoint& p) { return b.y1 + beyond - p.y(); });
  return points.size() < 3 ? std::vector<PagePoint>{} : points;
}

}  // namespace trilith::draw
