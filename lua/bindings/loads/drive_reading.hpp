// Assignment of ground motions to bodies in m:shake and m:drive.
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

/// Bodies and the motions that they follow.
struct DriveOrder {
  std::vector<int> bodies;
  /// In the plane along x and y and about the centroid, in space along x, y and z and about each of them.
  std::array<std::shared_ptr<const GroundMotion>, 6> motion;
};

/// Reads the keys body, x, y and so on, or the list `motions`. Errors are problems of `keys`.
std::vector<DriveOrder> read_drives(Keys& keys, const ScriptModel& m);
/// The bodies follow the motion from now on, or from the next step border.
void apply_drive(ScriptModel& m, const DriveOrder& order);
/// Notes motions that end at speed, because their bodies stop there within one step. `owner`: "shake" or "drive".
void tell_abrupt_ends(ScriptModel& m, const std::string& owner, const std::vector<DriveOrder>& orders, Host& host);
/// Prints the ground motions, each once: "shake: 'base' x: elcentro.csv, x 0.1: PGA 0.0349 g, 53.8 s".
void tell_motions(const ScriptModel& m, const std::vector<DriveOrder>& orders, RunObserver* observer);
/// End of the last motion, from its start [s].
double last_end(const std::vector<DriveOrder>& orders);

}  // namespace trilith::script
