// One direction of a bearing: what goes into a law and what comes out.
//
// Signs: the displacement of the second point against the first is positive along the axis; a positive force
// resists it (it acts on the second body against the axis).
#pragma once

namespace trilith {

/// What one direction remembers from step to step.
struct DirectionMemory {
  double inner = 0;        ///< plastic displacement or place of the slider [m] or [rad]
  double force = 0;        ///< elastic or frictional part of the last force [N] or [N m]
  double damping = 0;      ///< dashpot part of the last force
  double travelled = 0;    ///< accumulated plastic or sliding distance
  double compression = 0;  ///< of the last step, where the law's own force is in proportion to it [N]
};

struct DirectionMotion {
  double displacement;  ///< [m] or [rad]
  double rate;          ///< [m/s] or [rad/s]
  double dt;            ///< [s]
  double compression;   ///< compressive force of the bearing's axial direction, at least 0 [N]
  double mean = rate;   ///< rate over the step: times dt the change since it began. In a leapfrog step the same
};

struct DirectionResponse {
  DirectionMemory memory;
  double stored = 0;        ///< elastic energy [J]
  double lost_inner = 0;    ///< plastic or frictional energy given off in this step [J]
  double lost_damping = 0;  ///< [J]
  bool yielding = false;

  [[nodiscard]] double force() const { return memory.force + memory.damping; }
};

/// Adds a dashpot; its power is taken with the mean force of the step.
inline void add_dashpot(double damping, const DirectionMotion& m, const DirectionMemory& before,
                        DirectionResponse& out) {
  out.memory.damping = damping * m.rate;
  out.lost_damping = 0.5 * (out.memory.damping + before.damping) * m.mean * m.dt;
}

}  // namespace trilith
