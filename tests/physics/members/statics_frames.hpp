// Frames and a rocking block for the tests of statics.
#pragma once

#include <cmath>
#include <string>

#include "physics/members/frames.hpp"
#include "statics/equilibrium.hpp"
#include "statics/load_path.hpp"

namespace trilith::testing {

/// Two pinned bars of half span 10 m, rise 0.5 m and EA = 1e6 N, with 1 N down at the apex.
inline Model<2> shallow_truss() {
  BodySpec spec;
  spec.name = "truss", spec.kind = BodyKind::frame, spec.material = "m", spec.floating = true;
  FrameSpec frame;
  frame.joints = {{.name = "a", .place = {-10, 0}, .support = held},
                  {.name = "b", .place = {0, 0.5}, .support = {Support::free, Support::free, Support::fixed}},
                  {.name = "c", .place = {10, 0}, .support = held}};
  FrameMember bar;
  // The bending stiffness is so high that the bars stay straight.
  bar.section = given_section(1e-3, 0.1, 0.01), bar.divisions = 2, bar.pinned = {true, true};
  bar.from = 0, bar.to = 1, frame.members.push_back(bar);
  bar.from = 1, bar.to = 2, frame.members.push_back(bar);
  spec.frame = frame;
  Model<2> model = of_frames(elastic_material("m", 1000, 1e9), {spec});
  add_load(model, "truss", {0, 0.5}, {0, -1});
  return model;
}

/// A toggle clamped at both feet, 10 elements per half, with 1 N down at the apex.
inline Model<2> toggle(double half_span, double rise, double width, double depth, double young) {
  BodySpec spec;
  spec.name = "toggle", spec.kind = BodyKind::frame, spec.material = "m", spec.floating = true;
  FrameSpec frame;
  frame.joints = {{.name = "a", .place = {-half_span, 0}, .support = held},
                  {.name = "b", .place = {0, rise}},
                  {.name = "c", .place = {half_span, 0}, .support = held}};
  FrameMember half;
  half.section = rectangle_section(width, depth), half.divisions = 10;
  for (const int i : {0, 1}) half.from = i, half.to = i + 1, frame.members.push_back(half);
  spec.frame = frame;
  Model<2> model = of_frames(elastic_material("m", 2700, young), {spec});
  add_load(model, "toggle", {0, rise}, {0, -1});
  return model;
}

/// Lee's frame with 1 N down on its beam, 0.24 m from the corner, and the loaded node.
struct LeeFrame {
  Model<2> model;
  int loaded;

  explicit LeeFrame(int divisions) {
    BodySpec spec;
    spec.name = "lee", spec.kind = BodyKind::frame, spec.material = "m", spec.floating = true;
    FrameSpec frame;
    frame.joints = {{.name = "a", .place = {0, 0}, .support = hinged},
                    {.name = "b", .place = {0, 1.2}},
                    {.name = "c", .place = {1.2, 1.2}, .support = hinged}};
    FrameMember m;
    m.section = rectangle_section(0.03, 0.02), m.divisions = divisions;
    for (const int i : {0, 1}) m.from = i, m.to = i + 1, frame.members.push_back(m);
    spec.frame = frame;
    model = of_frames(elastic_material("m", 2700, 70.608e9), {spec});
    add_load(model, "lee", {0.24, 1.2}, {0, -1});
    loaded = 3 + (divisions - 1) + divisions / 5 - 1;  // joints, within the column, within the beam
  }
};

/// A clamped beam of length 1 m with EI = 1/12 * 10 N m2, under an end load of load number P L^2/(EI) = 1 or an end
/// moment of EI/L.
inline Model<2> cantilever_under(double force, double moment, int divisions) {
  BodySpec spec = beam_body("beam", {0, 0}, {1, 0}, rectangle_section(0.01, 0.01), "m", divisions);
  spec.frame->joints[0].support = held;
  Model<2> model = of_frames(elastic_material("m", 1000, 1e9), {spec});
  const double bending = 1e9 * 1e-8 / 12;
  add_load(model, "beam", {1, 0}, {0, -force * bending}, moment * bending);
  return model;
}

/// Load factor of a path at a displacement, linearly interpolated.
inline double factor_at(const LoadPath& path, double displacement) {
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const PathPoint &a = path.points[i - 1], &b = path.points[i];
    if ((a.displacement - displacement) * (b.displacement - displacement) > 0) continue;
    return a.factor + (b.factor - a.factor) * (displacement - a.displacement) / (b.displacement - a.displacement);
  }
  return std::nan("");
}

}  // namespace trilith::testing
