// A block of stone, 1 m x 0.5 m, above fixed ground: the smallest run with an impact, a rest and an energy ledger.
#pragma once

#include "model/builder/builder.hpp"
#include "run/simulation.hpp"

namespace trilith::testing {

inline constexpr double block_weight = 2000 * 1 * 0.5 * standard_gravity;  // [N]

/// `height`: drop height [m].
inline Model<2> dropped_block(double height) {
  ModelBuilder builder;
  builder.add_material({"stone", 2000});
  builder.add_law("joint", Frictional{1e8, 4e7, 0.6, 2e-3});
  builder.set_contact("*", "*", "joint");
  BodySpec ground;
  ground.name = "ground";
  ground.material = "stone";
  ground.outline = {{-3, -1}, {3, -1}, {3, 0}, {-3, 0}};
  ground.support = {Support::fixed, Support::fixed, Support::fixed};
  builder.add_body(ground);
  BodySpec block;
  block.name = "block";
  block.material = "stone";
  block.groups = {"stones"};
  block.outline = {{-0.5, height}, {0.5, height}, {0.5, height + 0.5}, {-0.5, height + 0.5}};
  block.floating = true;
  builder.add_body(block);
  return builder.build();
}

/// The fall, the bounces and the rest.
inline StageOptions fall_stage(double duration = 1.5) {
  StageOptions o;
  o.name = "fall";
  o.duration = duration;
  o.safety = 0.2;  // so that the impact takes about ten steps, and its energy is right to one percent
  o.frame_interval = 0.02;
  o.history_interval = 0.01;
  o.energy_interval = 0.02;
  return o;
}

}  // namespace trilith::testing
