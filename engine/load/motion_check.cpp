#include "load/motion_check.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"
#include "base/quantity_text.hpp"
#include "load/motion_measures.hpp"

namespace trilith {

namespace {

// Limits of drift, as shares of the record's peak velocity, so that they apply to strong and weak records. A corrected
// record ends well below all of them, a record with an offset in its acceleration far above.
constexpr double end_velocity_limit = 0.10;       // of PGV, independent of the previous motion
constexpr double end_velocity_negligible = 0.01;  // of PGV: the ground has come to rest
constexpr double last_quarter_limit = 0.05;       // of PGV, for the mean velocity over the last quarter

/// Mean velocity over the last quarter of the record [m/s].
double last_quarter_velocity(const GroundMotion& motion) {
  const auto samples = motion.samples();
  const std::size_t last = samples.size() - 1;
  const std::size_t from = std::min(3 * last / 4, last - 1);
  const double time = static_cast<double>(last - from) * motion.step();
  return (samples[last].displacement - samples[from].displacement) / time;
}

/// A record drifts if it ends fast, or if it does not end at rest and has moved in one direction over its last quarter.
/// Ground that ends at rest with an offset does not drift.
std::string drift_of(const GroundMotion& motion) {
  const double pgv = std::abs(motion_peaks(motion).velocity.value);
  const double end = motion.samples().back().velocity;
  const double late = last_quarter_velocity(motion);
  const bool moves_at_end = std::abs(end) > end_velocity_limit * pgv;
  const bool travels = std::abs(end) > end_velocity_negligible * pgv && std::abs(late) > last_quarter_limit * pgv;
  if (!moves_at_end && !travels) return "";
  const double offset = motion.samples().back().displacement - motion.start().displacement;
  return fmt::format(
      "motion '{}' drifts: {:.3g} m in {:.4g} s, end velocity {:.3g} cm/s ({:.3g} % of PGV), mean of the last quarter "
      "{:.3g} cm/s ({:.3g} %). Correct its baseline, as by motion:baseline(1), start it from the velocity of its "
      "source (zero mean velocity needs {:.4g} cm/s), or use a version of the record that begins and ends at rest. To "
      "allow the drift, give trilith.motion the key allow_drift = true",
      motion.description(), offset, motion.duration(), end * 100, 100 * std::abs(end) / pgv, late * 100,
      100 * std::abs(late) / pgv, 100 * balanced_start_velocity(motion));
}

}  // namespace

/// The start velocity with which the record ends where it began: it adds its product with the duration.
double balanced_start_velocity(const GroundMotion& motion) {
  const double offset = motion.samples().back().displacement - motion.start().displacement;
  return motion.start().velocity - offset / motion.duration();
}

std::string end_drift(const GroundMotion& motion) {
  const double pgv = std::abs(motion_peaks(motion).velocity.value), end = motion.samples().back().velocity;
  if (!(std::abs(end) > end_velocity_negligible * pgv)) return "";
  const double offset = motion.samples().back().displacement - motion.start().displacement;
  return fmt::format("the ground still moves at {} at the end ({:.3g} % of PGV), {} from its start",
                     quantity_text(end, "m/s"), 100 * std::abs(end) / pgv, quantity_text(offset, "m"));
}

std::string why_not_usable(const GroundMotion& motion, Drift drift) {
  if (motion.amplitude_factor() == 0) return "";  // a control run, scaled to zero on purpose
  if (motion_peaks(motion).acceleration.value == 0)
    return fmt::format("motion '{}' is zero everywhere; check the file and its column", motion.description());
  return drift == Drift::allow ? "" : drift_of(motion);
}

void check_usable(const GroundMotion& motion, Drift drift) {
  const std::string why = why_not_usable(motion, drift);
  if (!why.empty()) throw InputError(why);
}

}  // namespace trilith
