// One direction of a bearing: input and output of a law.
//
// Signs: the displacement of the second point relative to the first is positive along the axis. A positive force
// resists it (it acts on the second body against the axis).
#pragma once

namespace trilith {

/// Memory of one direction between steps.
struct DirectionMemory {
  double inner = 0;        ///< plastic displacement or position of the slider [m] or [rad]
  double force = 0;        ///< elastic or frictional part of the last force [N] or [N m]
  double damping = 0;      ///< dashpot part of the last force
  double travelled = 0;    ///< accumulated plastic or sliding distance
  double compression = 0;  ///< of the last step, where the law's force is proportional to it [N]
};

struct DirectionMotion {
  double displacement;  ///< [m] or [rad]
  double rate;          ///< [m/s] or [rad/s]
  double dt;            ///< [s]
  double compression;   ///< compressive force of the bearing's axial direction, at least 0 [N]
  double mean = rate;   ///< mean rate over the step: times dt it is the change since the step began. Equal to `rate` in
                        ///< a leapfrog step
};

struct DirectionResponse {
  DirectionMemory memory;
  double stored = 0;        ///< elastic energy [J]
  double lost_inner = 0;    ///< plastic or frictional energy dissipated in this step [J]
  double lost_damping = 0;  ///< [J]
  bool yielding = false;

  [[nodiscard]] double force() const { return memory.force + memory.damping; }
};

/// Adds a dashpot; its power is computed with the mean force of the step.
inline void add_dashpot(double damping, const DirectionMotion& m, const DirectionMemory& before,
                        DirectionResponse& out) {
  out.memory.damping = damping * m.rate;
  out.lost_damping = 0.5 * (out.memory.damping + before.damping) * m.mean * m.dt;
}

}  // namespace trilith
