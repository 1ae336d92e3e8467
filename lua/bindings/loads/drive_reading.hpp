// What follows which ground motion, as m:shake and m:drive are told.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "bindings/core/keys.hpp"
#include "load/motion.hpp"

namespace trilith::script {

struct Host;
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
/// Notes motions that end at speed, as their bodies stop there within one step. `owner`: "shake" or "drive".
void tell_abrupt_ends(ScriptModel& m, const std::string& owner, const std::vector<DriveOrder>& orders, Host& host);
/// Says what the ground does, each motion once: "shake: 'base' x: elcentro.csv, x 0.1: PGA 0.0349 g, 53.8 s".
void tell_motions(const ScriptModel& m, const std::vector<DriveOrder>& orders, RunObserver* observer);
/// When the last of the motions is over, from its start [s].
double last_end(const std::vector<DriveOrder>& orders);

}  // namespace trilith::script
