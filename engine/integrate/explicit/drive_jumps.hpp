// Jumps of the velocity of supports within the coming step. A motion may begin or end at a speed, replace another
// motion, or a moving body may be fixed. No force announces such a jump, and the velocities of a leapfrog step are half
// a step old. So the jump is found from the motions, which are known ahead.
#pragma once

#include <vector>

#include "base/schema.hpp"
#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// True if a motion begins or ends within the last step or the next one, of length dt [s].
template <int D>
bool motions_change(const Model<D>& model, const State<D>& state, double dt);

/// Jumps of the velocities of all bodies within the next step. Velocities that change smoothly have none.
template <int D>
class DriveJumps {
 public:
  DriveJumps() = default;
  /// For a next step of length dt [s].
  DriveJumps(const Model<D>& model, const State<D>& state, double dt);

  /// Upper bound of the jump of the relative velocity of any points of two bodies [m/s].
  [[nodiscard]] double between(int body_a, int body_b) const;
  /// Time until the earliest jump, at least 0 [s]; unbounded if there is none.
  [[nodiscard]] double begins() const { return begins_; }

 private:
  struct BodyJump {
    Vec<D> along = Vec<D>::Zero();  ///< of the first node [m/s]
    double spread = 0;              ///< largest difference of any other point from it [m/s]
  };
  void gather(const Model<D>& model, const std::vector<Vec<D>>& along, const std::vector<double>& about);

  std::vector<BodyJump> body_;  ///< [body]; empty if nothing jumps
  double begins_ = unbounded;
};

}  // namespace trilith
