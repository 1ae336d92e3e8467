// Models that collapse in different ways, for tests of invariants of every run.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <random>
#include <string>
#include <vector>

#include "base/portable.hpp"
#include "build/plane/running_bond.hpp"
#include "build/plane/stack.hpp"
#include "geometry/plane/random_convex.hpp"
#include "physics/scene.hpp"

namespace trilith::testing {

/// Adds the parts of a builder with the scene's material: the part called "base" is fixed, the others are free.
inline void add_parts(Scene& scene, const std::vector<Part>& parts) {
  for (const Part& part : parts) {
    BodySpec spec;
    spec.name = part.name, spec.outline = part.outline, spec.groups = part.groups;
    if (part.name == "base" || part.name == "table") spec.support = held;
    scene.add(spec);
  }
}

/// A sine of `peak` [m/s2] at `frequency` [1/s] for `duration` [s], about no mean displacement.
inline GroundMotion sine(double peak, double frequency, double duration) {
  const double w = 2 * M_PI * frequency;
  return *motion_of(
      duration, 1e-3, [&](double t) { return peak * portable::sin(w * t); }, -peak / w);
}

struct Collapse {
  std::string name;
  std::function<Model<2>()> model;
  double duration;  ///< time range with contact events [s]
};

/// A stack of six blocks, each slightly offset, dropped from a small height.
inline Model<2> leaning_stack() {
  Scene scene(Frictional{1e8, 5e7, 0.6, 2e-4});
  scene.fixed("base", box(-2, -0.4, 2, 0));
  for (int i = 0; i < 6; ++i) {
    const double x = 0.03 * (i % 3) - 0.02, y = 0.2005 * i + 5e-4;
    scene.block(fmt::format("b{}", i), box(x - 0.2, y, x + 0.2, y + 0.2), 160);
  }
  return scene.builder.build();
}

/// A dry wall on a base that shakes it to pieces: general contacts, many courses, faces that change partners.
inline Model<2> shaken_wall() {
  Scene scene(Frictional{2e8, 8e7, 0.6, 1e-4});
  add_parts(scene, build_running_bond({.columns = 4, .courses = 7, .base_height = 0.3, .base_margin = 2}));
  Model<2> model = scene.builder.build();
  scene.drive_along_x(model, "base", sine(1.5 * standard_gravity, 2, 4));
  return model;
}

/// Random convex polygons that fall into a heap.
inline Model<2> falling_polygons(int count = 25, std::uint64_t seed = 12) {
  Scene scene(Frictional{5e7, 2e7, 0.4, 2e-4});
  scene.fixed("floor", box(-6, -0.5, 6, 0));
  scene.fixed("left", {{-6, 0}, {-3, 0}, {-5, 6}, {-6, 6}});
  scene.fixed("right", {{3, 0}, {6, 0}, {6, 6}, {5, 6}});
  std::mt19937_64 bits(seed);
  for (int i = 0; i < count; ++i) {
    RandomConvex wanted;
    wanted.smallest = 0.4, wanted.largest = 0.9, wanted.slenderest = 2.5;
    const Vec2 at(-2 + 1.0 * (i % 5), 1.2 + 1.0 * (i / 5));
    BodySpec spec;
    // Drawn in separate statements: the order of evaluation of arguments is unspecified.
    const Vec2 direction = random_direction(bits);
    spec.name = fmt::format("p{}", i), spec.outline = placed(random_convex(bits, wanted), direction, at);
    spec.velocity = {random_between(bits, -1, 1), random_between(bits, -3, 0)};
    spec.spin = random_between(bits, -3, 3), spec.floating = true;
    scene.add(spec);
  }
  return scene.builder.build();
}

/// Drums of many corners that roll down a slope: at any time several pairs of their faces are candidates for contact.
inline Model<2> rolling_drums() {
  Scene scene(Frictional{5e7, 2e7, 0.3, 2e-4});
  scene.fixed("slope", {{-4, 0}, {6, -2}, {6, -1.8}, {-4, 0.2}});
  scene.fixed("stop", box(6, -2, 7, 2));
  for (int i = 0; i < 8; ++i) {
    Polygon drum;
    const double radius = 0.25 + 0.02 * i, x = -3.4 + 0.9 * i, y = 0.2 - 0.2 * (x + 4) + radius + 0.02;
    for (int k = 0; k < 40; ++k)
      drum.emplace_back(x + radius * portable::cos(2 * M_PI * k / 40), y + radius * portable::sin(2 * M_PI * k / 40));
    BodySpec spec;
    spec.name = fmt::format("d{}", i), spec.outline = drum, spec.floating = true, spec.spin = 3.0 * (i % 3);
    scene.add(spec);
  }
  return scene.builder.build();
}

/// Concave stones of two pieces each and squares of two elements, which fall onto each other: ridges and corners shared
/// by two pieces strike and slide.
inline Model<2> falling_chevrons() {
  Scene scene(Frictional{5e7, 2e7, 0.4, 1e-3});
  scene.builder.add_material({"soft", 2000, Solid{LinearElastic{5e8, 0.2}}});
  scene.fixed("floor", box(-4, -0.5, 4, 0));
  for (int i = 0; i < 18; ++i) {
    const Turn turn(0.9 * i);
    const Vec2 at(-1.2 + 0.8 * (i % 4), 0.5 + 0.7 * (i / 4));
    BodySpec spec;
    spec.name = fmt::format("c{}", i), spec.floating = true, spec.spin = i % 3 - 1;
    if (i % 3 == 2) {
      spec.kind = BodyKind::mesh, spec.material = "soft", spec.spin = 0;
      Mesh mesh;
      for (const Vec2& x : {Vec2(-0.2, -0.2), Vec2(0.2, -0.2), Vec2(0.2, 0.2), Vec2(-0.2, 0.2)})
        mesh.node.push_back(at + turn.apply(x));
      mesh.element = {{0, 1, 2, -1}, {0, 2, 3, -1}};
      spec.mesh = mesh;
    } else {
      for (const Vec2& x : {Vec2(-0.3, -0.2), Vec2(0, -0.05), Vec2(0.3, -0.2), Vec2(0, 0.15)})
        spec.outline.push_back(at + turn.apply(x));
    }
    scene.add(spec);
  }
  return scene.builder.build();
}

/// A wall whose mortar bonds break. `by_point`: bonds break by half faces.
inline Model<2> bonded_wall(bool by_point = false) {
  Scene scene(Bonded{2e8, 8e7, 0.7, 1e-4, 12e3, 16e3, by_point ? 1.0 : 0.0});
  add_parts(scene, build_running_bond({.columns = 4, .courses = 6, .base_height = 0.3, .base_margin = 2}));
  Model<2> model = scene.builder.build();
  scene.drive_along_x(model, "base", sine(2.0 * standard_gravity, 3, 3));
  return model;
}

/// The same wall with mortar that softens and dilates.
inline Model<2> softening_wall() {
  Scene scene(Cohesive{2e8, 8e7, 0.7, 1e-4, 12e3, 16e3, 8, 12, 0.05, 2e-3});
  add_parts(scene, build_running_bond({.columns = 4, .courses = 6, .base_height = 0.3, .base_margin = 2}));
  Model<2> model = scene.builder.build();
  scene.drive_along_x(model, "base", sine(2.0 * standard_gravity, 3, 3));
  return model;
}

/// A span on two piers, one of which is driven away. The bearing of the left end fails and becomes a frictional
/// contact, the right end loses its seat, and the span falls onto the ground.
inline Model<2> pulled_span() {
  Scene scene(Frictional{1e8, 5e7, 0.3, 3e-4});
  scene.fixed("ground", box(-4, -1, 16, 0));
  const double seat = 2.96, soffit = 3;  // bearings 4 cm high
  scene.fixed("left pier", box(-0.5, 0.01, 0.5, seat));
  scene.fixed("right pier", box(9.5, 0.01, 10.5, seat));
  scene.block("span", box(-0.3, soffit, 10.2, 3.6), 12000);
  for (const char* side : {"left", "right"}) {
    const bool left = side == std::string("left");
    BearingSpec bearing;
    bearing.name = fmt::format("{} bearing", side), bearing.body_a = fmt::format("{} pier", side),
    bearing.body_b = "span";
    bearing.point_a = {left ? 0.0 : 10.0, seat}, bearing.point_b = {left ? 0.0 : 10.0, soffit};
    bearing.law[axial] = Linear{4e7, 2e4};
    if (left)
      bearing.law[along] = ElasticPlastic{6e5, 3e4, 0.05, 2e3};
    else
      bearing.law[along] = Friction{0.15, 2e6, 0};
    bearing.limit = {left ? 0.12 : 0.25, 0.05, unbounded};
    bearing.replaces_contact = true;
    scene.builder.add_bearing(bearing);
  }
  SeatSpec end;
  end.name = "right seat", end.body = "span", end.support = "right pier";
  end.end = {10.2, soffit}, end.edge = {9.5, seat};
  scene.builder.add_seat(end);
  end.name = "left seat", end.support = "left pier";
  end.end = {-0.3, soffit}, end.edge = {0.5, seat}, end.inward = {-1, 0};
  scene.builder.add_seat(end);
  Model<2> model = scene.builder.build();
  // The right pier moves away by 1.5 m in 3 s, smoothly.
  const double way = 1.5, w = 2 * M_PI / 3;
  const auto away = motion_of(3, 1e-3, [&](double t) { return way * w * w / (2 * M_PI) * portable::sin(w * t); });
  const int pier = model.find_body("right pier");
  set_drive(model, pier, 0, away, 0, model.start_position[pier].x());
  return model;
}

inline std::vector<Collapse> collapses() {
  return {{"leaning stack", leaning_stack, 1.0},
          {"shaken wall", shaken_wall, 2.0},
          {"falling polygons", [] { return falling_polygons(); }, 1.5},
          {"rolling drums", rolling_drums, 2.0},
          {"falling chevrons and squares of two elements", falling_chevrons, 1.0},
          {"bonded wall", [] { return bonded_wall(); }, 1.0},
          {"bonded wall, by point", [] { return bonded_wall(true); }, 1.0},
          {"bonded wall, softening", softening_wall, 1.0},
          {"pulled span", pulled_span, 4.0}};
}

}  // namespace trilith::testing
