// A program outside the project, against the installed engine: a block dropped from 1 m falls freely until it lands.
#include <trilith/model/builder/builder.hpp>
#include <trilith/run/simulation.hpp>

#include <cmath>
#include <cstdio>

int main() {
  trilith::ModelBuilder builder;
  builder.add_law("joint", trilith::Frictional{1e8, 4e7, 0.6, 1e-3});
  builder.set_contact("*", "*", "joint");
  const auto held = trilith::Support::fixed;
  trilith::BodySpec ground{.name = "ground", .outline = {{-2, -1}, {2, -1}, {2, 0}, {-2, 0}}, .density = 2400};
  ground.support = {held, held, held};
  builder.add_body(ground);
  builder.add_body(
      {.name = "block", .outline = {{-0.5, 1}, {0.5, 1}, {0.5, 2}, {-0.5, 2}}, .density = 2400, .floating = true});
  trilith::Simulation<2> simulation(builder.build());
  double landed = 0;
  const auto on_event = [&](const trilith::Event& event, const trilith::Instant<2>&) {
    landed = landed > 0 ? landed : event.time * (event.type == trilith::EventType::impact);
  };
  simulation.run({.name = "drop", .duration = 1, .safety = 0.1}, {.on_event = on_event});
  std::printf("landed after %.4f s, free fall from 1 m takes %.4f s\n", landed,
              std::sqrt(2 / trilith::standard_gravity));
  return std::abs(landed - std::sqrt(2 / trilith::standard_gravity)) < 0.001 ? 0 : 1;
}
