// What follows which ground motion, as m:shake and m:drive are told.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "keys.hpp"
#include "load/motion.hpp"

namespace trilith::script {

class RunObserver;
class ScriptModel;

/// What is to follow which motion.
struct DriveOrder {
  std::vector<int> bodies;
  /// In the plane along x and y and about the centroid, in space along x, y and z and about each of them.
  std::array<std::shared_ptr<const GroundMotion>, 6> motion;
};

/// Of the keys body, x, y and so on, or of the list `motions`. What is wrong is a problem of `keys`.
std::vector<DriveOrder> read_drives(Keys& keys, const ScriptModel& m);
/// From now on, or the next step border on, the bodies follow.
void apply_drive(ScriptModel& m, const DriveOrder& order);
/// Says what the ground does, each motion once: "shake: 'base' x: elcentro.csv, x 0.1: PGA 0.0349 g, 53.8 s".
void tell_motions(const ScriptModel& m, const std::vector<DriveOrder>& orders, RunObserver* observer);
/// When the last of the motions is over, from its start [s].
double last_end(const std::vector<DriveOrder>& orders);

}  // namespace trilith::script
