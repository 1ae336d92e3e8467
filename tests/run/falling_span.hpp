// One span on two piers, the right one of which moves away: the bearings fail, the span loses its seat and falls. A
// collapse in three seconds, for tests of recording, pictures and the program's verbs.
#pragma once

#include <filesystem>
#include <memory>

#include "build/plane/bridge.hpp"
#include "run/record/recording.hpp"
#include "run/simulation.hpp"

namespace trilith::testing {

inline void add_part(ModelBuilder& builder, const Part& part, bool fixed) {
  BodySpec spec;
  spec.name = part.name;
  spec.outline = part.outline;
  spec.groups = part.groups;
  spec.material = "concrete";
  if (fixed) spec.support = {Support::fixed, Support::fixed, Support::fixed};
  spec.floating = true;
  builder.add_body(std::move(spec));
}

/// `along`: its law, and its displacement limit [m].
inline BearingSpec span_bearing(const std::string& name, const std::string& pier, double x, const DirectionLaw& along,
                                double limit) {
  BearingSpec b;
  b.name = name;
  b.body_a = pier;
  b.body_b = "span";
  b.point_a = b.point_b = Vec2(x, 5);
  b.law = {along, DirectionLaw(Linear{1e9, 1e6}), std::monostate{}};
  b.limit = {limit, 0.05, unbounded};
  b.replaces_contact = true;
  return b;
}

inline SeatSpec span_seat(const std::string& name, const std::string& pier, double end, double edge, double inward) {
  SeatSpec s;
  s.name = name;
  s.body = "span";
  s.support = pier;
  s.end = Vec2(end, 5);
  s.edge = Vec2(edge, 5);
  s.inward = Vec2(inward, 0);
  return s;
}

inline Model<2> falling_span() {
  ModelBuilder builder;
  builder.add_material({"concrete", 2400});
  builder.add_law("joint", Frictional{2e9, 1e9, 0.6, 1e-3});
  builder.set_contact("*", "*", "joint");
  add_part(builder, {"left ground", {{-6, -2}, {5, -2}, {5, 0}, {-6, 0}}, {"grounds"}}, true);
  add_part(builder, {"right ground", {{5, -2}, {16, -2}, {16, 0}, {5, 0}}, {"grounds"}}, true);
  for (const auto& [name, x] : {std::pair("P1", 0.0), std::pair("P2", 10.0)}) {
    Pier pier;
    pier.name = name;
    pier.x = x;
    pier.height = 5;
    pier.stem_width = 1;
    pier.footing_width = 3;
    pier.footing_thickness = 0.8;
    add_part(builder, build_pier(pier), false);
  }
  Span span;
  span.x0 = 0;
  span.x1 = 10;
  span.end_gap = 0.1;
  span.soffit_level = 5;
  span.depth = 0.8;
  add_part(builder, build_span(span), false);
  builder.add_bearing(span_bearing("left", "P1", 0.5, Linear{5e6, 1e5}, 0.01));
  builder.add_bearing(span_bearing("right", "P2", 9.5, std::monostate{}, 0.3));
  builder.add_seat(span_seat("left seat", "P1", 0.1, 0.5, -1));
  builder.add_seat(span_seat("right seat", "P2", 9.9, 9.5, 1));
  return builder.build();
}

/// The right ground moves by 0.8 m to the right within a second and stays there.
inline std::shared_ptr<const GroundMotion> walk_away() {
  const double a = 3.2;
  const std::vector<double> samples{a, a, a, a, a, -a, -a, -a, -a, -a};
  return std::make_shared<GroundMotion>(samples, 0.1);
}

/// The complete collapse, recorded to `path` and reported to `listener` too.
inline void record_falling_span(const std::filesystem::path& path, double seconds = 2.5) {
  Simulation<2> simulation(falling_span());
  RecordingOptions<2> options;
  options.provenance.script_path = "falling_span.lua";
  options.provenance.start_time = "2025-11-21T09:30:00Z";
  options.materials = {{"concrete", 2400}};
  options.sync = false;
  options.histories = {
      {"span.x", "m", "position of the span", [](const Instant<2>& now) { return now.state.position[4].x(); }},
      {"span.y", "m", "height of the span", [](const Instant<2>& now) { return now.state.position[4].y(); }},
      {"left.force", "N", "force of the left bearing along",
       [](const Instant<2>& now) { return now.work.bearing_force[0].x(); }}};
  Recording<2> recording(path, simulation.model(), simulation.state(), std::move(options));
  StageOptions o;
  o.name = "consolidation";
  o.duration = 0.5;
  o.rest_share = 0.8;
  o.frame_interval = 0.05;
  o.history_interval = 0.01;
  o.energy_interval = 0.02;
  simulation.run(o, recording.listener());
  set_drive(simulation.edit_model(), 1, 0, walk_away(), simulation.state().time, simulation.state().position[1].x());
  o.name = "shaking";
  o.duration = seconds;
  o.rest_share = 0;
  simulation.run(o, recording.listener());
  recording.finish();
}

}  // namespace trilith::testing
