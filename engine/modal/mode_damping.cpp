#include "modal/mode_damping.hpp"

#include <algorithm>
#include <cmath>

#include "assembly/bearing_motion.hpp"
#include "assembly/element/beam_motion.hpp"
#include "assembly/element/internal_forces_beams.hpp"
#include "assembly/evaluate.hpp"
#include "assembly/implicit_turn.hpp"
#include "assembly/node_forces.hpp"
#include "model/pose.hpp"

namespace trilith {
namespace {

/// Largest speed of a node [m/s]; in a mode with rotations only, of a rotation [rad/s].
constexpr double tried_speed = 1e-3;

/// Work rate of the dampings along a mode [1/s] for phi' M phi = 1, by source.
struct Along {
  double all = 0, bearings = 0, elements = 0;
};

double size_of(double turn) {
  return std::abs(turn);
}
double size_of(const Vec3& turn) {
  return turn.norm();
}

double product(double moment, double turn) {
  return moment * turn;
}
double product(const Vec3& moment, const Vec3& turn) {
  return moment.dot(turn);
}

/// phi . F, including the moments times the rotations of the mode.
template <int D>
double work_along(const NaturalMode<D>& mode, const std::vector<Vec<D>>& force, const std::vector<Moment<D>>& moment) {
  double sum = 0;
  for (std::size_t n = 0; n < force.size(); ++n)
    sum += force[n].dot(mode.displacement[n]) + (moment.empty() ? 0 : product(moment[n], mode.rotation[n]));
  return sum;
}

/// The forces of bearings on the nodes, along one line through b's point.
template <int D>
double bearings_along(const Model<D>& model, const State<D>& state, const Work<D>& work, const NaturalMode<D>& mode) {
  std::vector<Vec<D>> force(model.mass.size(), Vec<D>::Zero());
  std::vector<Moment<D>> moment(model.mass.size(), nothing<Moment<D>>());
  for (std::size_t i = 0; i < model.bearings.size(); ++i)
    push_ends(model, state, model.bearings[i], work.bearing_force[i], work.bearing_moment[i], force, moment);
  return work_along(mode, force, moment);
}

/// The present forces along the mode, while the state moves with `scale` times it.
template <int D>
Along forces_along(const Model<D>& model, State<D>& state, const NaturalMode<D>& mode, double scale) {
  for (std::size_t n = 0; n < state.velocity.size(); ++n)
    state.velocity[n] = scale * mode.displacement[n], state.spin[n] = scale * mode.rotation[n];
  Work<D> work;
  evaluate(model, state, work, state.last_dt);
  Along out;
  out.all = work_along(mode, work.force, work.moment);
  out.bearings = bearings_along(model, state, work, mode);
  if (!work.element_damping.empty()) out.elements = work_along(mode, work.element_damping, work.element_damping_moment);
  return out;
}

BeamStrain strain_of(const State<2>& state, const Beam& beam) {
  return now_of(state, beam).strain;
}
BeamStrain3 strain_of(const State<3>& state, const Beam3& beam) {
  return now_of(state, beam).strain();
}

/// Damping ratio of the beams with band damping.
template <int D>
double band_ratio(const Model<D>& model, const State<D>& rest, const NaturalMode<D>& mode, double scale) {
  // Displacement along the mode for which the rotation of chords is small and rounding is smaller still.
  const double way = scale * 1e-3, w = std::sqrt(mode.square);
  State<D> moved = rest;
  for (std::size_t n = 0; n < moved.position.size(); ++n) {
    moved.position[n] += way * mode.displacement[n];
    moved.rotation[n] = turned_by(Spin<D>(way * mode.rotation[n]), rest.rotation[n]);
  }
  double lost = 0, stiffer = 0;
  for (const auto& beam : beams_of(model)) {
    if (beam.band < 0 || is_removed(model, beam, rest.beam_memory)) continue;
    auto s = strain_of(moved, beam);
    const auto was = strain_of(rest, beam);
    for (std::size_t k = 0; k < s.size(); ++k) s[k] = (s[k] - was[k]) / way;
    const auto stress = linear_stress(beam.stiffness, s);
    double held = 0;
    for (std::size_t k = 0; k < s.size(); ++k) held += stress[k] * s[k];
    const DampingBranches& branches = model.bands[beam.band];
    lost += branches.loss(w) * held, stiffer += (branches.stiffness(w) - 1) * held;
  }
  return lost / (2 * (mode.square + stiffer));
}

/// Damping ratio of one mode, by source. The model at rest is moved along the mode with a small velocity s in both
/// senses. Half the difference of the forces is the part that depends on the velocity, to first order:
///
///     zeta = -phi . (F(s phi) - F(-s phi)) / (2 s) / (2 w),   phi' M phi = 1
template <int D>
ModeDamping damping_of(const Model<D>& model, State<D>& rest, const NaturalMode<D>& mode) {
  if (!(mode.square > 0)) return {};
  double most = 0, most_turn = 0;
  for (const auto& v : mode.displacement) most = std::max(most, v.norm());
  for (const auto& v : mode.rotation) most_turn = std::max(most_turn, size_of(v));
  // In space a torsional mode contains rounding of displacements, so rotations count too.
  if constexpr (D == 3)
    for (int n = 0; n < model.nodes(); ++n) most = std::max(most, gyration_of(model, n) * size_of(mode.rotation[n]));
  const double scale = tried_speed / (most > 0 ? most : most_turn);
  const Along ahead = forces_along(model, rest, mode, scale), back = forces_along(model, rest, mode, -scale);
  const double critical = 2 * std::sqrt(mode.square);
  const auto ratio = [&](double more, double less) { return (less - more) / (2 * scale) / critical; };
  ModeDamping out;
  out.bearings = ratio(ahead.bearings, back.bearings);
  out.elements = ratio(ahead.elements, back.elements);
  out.contacts = ratio(ahead.all, back.all) - out.bearings - out.elements;
  if (!model.bands.empty()) out.bands = band_ratio(model, rest, mode, scale);
  // alpha M v on M phi: alpha / (2 w).
  out.mass = model.mass_damping / critical;
  return out;
}

}  // namespace

template <int D>
std::vector<ModeDamping> mode_damping(const Model<D>& model, const State<D>& state,
                                      const std::vector<NaturalMode<D>>& modes) {
  State<D> rest = at_rest(state);
  std::vector<ModeDamping> out;
  for (const NaturalMode<D>& mode : modes) out.push_back(damping_of(model, rest, mode));
  return out;
}

template std::vector<ModeDamping> mode_damping(const Model<2>&, const State<2>&, const std::vector<NaturalMode<2>>&);
template std::vector<ModeDamping> mode_damping(const Model<3>&, const State<3>&, const std::vector<NaturalMode<3>>&);

}  // namespace trilith
