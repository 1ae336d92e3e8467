#include "assembly/tangent/beam_tangent.hpp"

#include "assembly/element/beam_motion.hpp"
#include "assembly/element/fibre_answers.hpp"
#include "assembly/element/internal_forces_beams.hpp"
#include "assembly/field/heated_beams.hpp"
#include "assembly/implicit_turn.hpp"

namespace trilith {
namespace {

/// Derivatives of stretch and bends with respect to position and rotation of both nodes. The vector D between the ends
/// of the chord moves with the nodes and with the arms that rotate with them.
struct BeamShape {
  Eigen::Matrix<double, 3, 6> strain;
  Eigen::Matrix<double, 2, 6> way, way_rate;  // dD; derivative of dD/dt by position, if arms rotate
};

/// Columns x_0, y_0, turn_0, x_1, y_1, turn_1. D = x_1 + arm_1 - x_0 - arm_0, and an arm rotates by left_of(arm):
///   d stretch = along . dD,   d theta_i = d turn_i - across . dD / l.
BeamShape shape_of(const BeamNow& now, const std::array<Vec2, 2>& arm, const std::array<double, 2>& spin) {
  BeamShape s;
  s.way.setZero(), s.way_rate.setZero(), s.strain.setZero();
  for (const int end : {0, 1}) {
    const double sign = end == 0 ? -1 : 1;
    s.way.block<2, 2>(0, 3 * end).diagonal().setConstant(sign);
    s.way.col(3 * end + 2) = sign * left_of(arm[end]);
    s.way_rate.col(3 * end + 2) = -sign * spin[end] * arm[end];
    s.strain(1 + end, 3 * end + 2) = 1;
  }
  const Vec2 across = left_of(now.along);
  s.strain.row(0) = now.along.transpose() * s.way;
  const Eigen::Matrix<double, 1, 6> turn = across.transpose() * s.way / now.length;
  s.strain.row(1) -= turn, s.strain.row(2) -= turn;
  return s;
}

/// Geometric stiffness: N along the rotating chord, M_0 + M_1 that rotate it, and the arms.
BeamBlock geometric(const BeamNow& now, const BeamShape& shape, const std::array<Vec2, 2>& arm,
                    const BeamStress& stress) {
  const Vec2 across = left_of(now.along);
  const double moments = stress[1] + stress[2];
  // With D from end to end, l = |D|: d2 l = across across' / l, and for the turn of the chord d2 turn = -(along across'
  // + across along') / l^2. The bends have it with the opposite sign.
  const Eigen::Matrix2d both = now.along * across.transpose() + across * now.along.transpose();
  const Eigen::Matrix2d chord =
      stress[0] / now.length * (across * across.transpose()) + moments / (now.length * now.length) * both;
  BeamBlock out = shape.way.transpose() * chord * shape.way;
  const Vec2 pull = now.force_on_start(stress);
  // An arm that rotates by w moves by w left_of(arm) - w^2 arm / 2: its second derivative times the force.
  out(2, 2) += pull.dot(arm[0]), out(5, 5) -= pull.dot(arm[1]);
  return out;
}

/// Derivative of the rates of stretch and bends with respect to position; `speed` is dD/dt.
Eigen::Matrix<double, 3, 6> rate_by_place(const BeamNow& now, const BeamShape& shape, const Vec2& speed) {
  const Vec2 across = left_of(now.along);
  const double along = now.along.dot(speed), aside = across.dot(speed), per = 1 / now.length;
  const Eigen::Matrix<double, 1, 6> stretch =
      per * aside * (across.transpose() * shape.way) + now.along.transpose() * shape.way_rate;
  const Eigen::Matrix<double, 1, 6> turn = -per * per * ((along * across + aside * now.along).transpose() * shape.way) +
                                           per * (across.transpose() * shape.way_rate);
  Eigen::Matrix<double, 3, 6> out;
  out << stretch, -turn, -turn;
  return out;
}

/// The branches contribute to a change of stress within the step; a removed beam has none.
void add_branches(const Model<2>& model, const State<2>& state, const Beam& beam, double dt, BeamTangent& t) {
  if (t.by_strain.isZero(0)) return;
  const DampingBranches& branches = model.bands[beam.band];
  const BranchStep step(branches, dt);
  std::array<double, 3 * (1 + DampingBranches::most)> after;
  const BeamStress more =
      relax(branches, step, t.stress, branches_of(model, beam, std::span(state.beam_memory)), after);
  for (std::size_t k = 0; k < more.size(); ++k) t.damping[k] += more[k];
  t.by_strain *= 1 + step.sum;
}

/// Stresses and tangents of a beam, kept or evaluated.
BeamTangent tangent_now(const Model<2>& model, const State<2>& state, const Beam& beam, const BeamNow& now,
                        const std::vector<double>* trial) {
  if (trial != nullptr && beam.yield == BeamYield::in_fibres)
    if (const auto kept = FibreAnswers<2>::find(model, beam.yield_row, now.strain, now.rate, *trial))
      return {kept->stress, kept->damping, kept->by_strain, kept->by_rate};
  return tangent_of(model.yields, beam, now, memory_of(model, beam, std::span(state.beam_memory)));
}

}  // namespace

/// With s the stretch and bends, J = ds/dq and stress S(s) + C ds/dt, the forces are -J^T S, so that
///   dF = -(J^T T J + dJ^T S) dq - J^T C (J rate + d(ds/dt)/dq) dq.
BeamBlock beam_block(const Model<2>& model, const State<2>& state, const Beam& beam, double rate, double dt,
                     const std::vector<double>* trial) {
  std::array<Vec2, 2> arm;
  const BeamEnd from = end_of(state, beam, 0, arm[0]), to = end_of(state, beam, 1, arm[1]);
  BeamNow now(from, to, beam.length, beam.angle);
  relax_heated(model, state, beam, now);
  BeamTangent t = tangent_now(model, state, beam, now, trial);
  if (beam.band >= 0 && dt > 0) add_branches(model, state, beam, dt, t);
  const BeamShape shape = shape_of(now, arm, {from.spin, to.spin});
  BeamStress all;
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = t.stress[k] + t.damping[k];
  BeamBlock out = -shape.strain.transpose() * t.by_strain * shape.strain - geometric(now, shape, arm, all);
  if (beam.damping > 0)
    out -= shape.strain.transpose() * t.by_rate *
           (rate * shape.strain + rate_by_place(now, shape, to.velocity - from.velocity));
  return out;
}

namespace {

/// Both ends of a beam in space, with the motion of its nodes.
struct BeamNodes3 {
  std::array<Vec3, 2> place, velocity, spin;
  std::array<UnitQuaternion, 2> rotation;
  std::optional<FreeStrain> free;

  BeamNodes3(const Model<3>& model, const State<3>& state, const Beam3& beam) : free(free_strain(model, state, beam)) {
    for (const std::size_t i : {0, 1}) {
      const auto n = static_cast<std::size_t>(beam.node[i]);
      place[i] = state.position[n], velocity[i] = state.velocity[n], spin[i] = state.spin[n];
      rotation[i] = state.rotation[n];
    }
  }
  /// Moves along one of the twelve unknowns, with a velocity of `rate` times the displacement.
  void move(int unknown, double by, double rate) {
    const auto i = static_cast<std::size_t>(unknown / 6);
    const int k = unknown % 6;
    if (k < 3) {
      place[i][k] += by, velocity[i][k] += rate * by;
    } else {
      turn_about(k - 3, by, rotation[i]);
      spin[i][k - 3] += rate * by;
    }
  }
  [[nodiscard]] BeamNow3 beam_now(const Beam3& beam) const {
    const auto end = [&](std::size_t i) { return carried_end(beam, i, place[i], rotation[i], velocity[i], spin[i]); };
    BeamNow3 now(end(0), end(1), beam.length);
    if (free) now.subtract_free(free->stretch, free->bend);
    return now;
  }
  /// Forces and moments on the nodes from the action on the beam's ends.
  [[nodiscard]] Eigen::Matrix<double, 12, 1> forces(const Beam3& beam, const BeamAction3& action) const {
    const auto carried = [&](std::size_t i) {
      return has_arm(beam, i) ? cross(turn_of(rotation[i]).apply(beam.arm[i]), action.force) : Vec3(0, 0, 0);
    };
    Eigen::Matrix<double, 12, 1> out;
    out << action.force, action.moment[0] + carried(0), -action.force, action.moment[1] - carried(1);
    return out;
  }
};

/// Contribution of the branches of a beam's band damping to its stress within a step.
class BandAnswer {
 public:
  BandAnswer(const Model<3>& model, const State<3>& state, const Beam3& beam, double dt) {
    if (beam.band < 0 || !(dt > 0)) return;
    branches_ = &model.bands[static_cast<std::size_t>(beam.band)];
    step_ = BranchStep(*branches_, dt);
    before_ = branches_of(model, beam, std::span(state.beam_memory));
  }
  [[nodiscard]] BeamStress3 damping(const BeamStress3& stress) const {
    if (branches_ == nullptr) return {};
    std::array<double, 6 * (1 + DampingBranches::most)> after;
    return relax(*branches_, step_, stress, before_, after);
  }
  /// Ratio of the stress with damping to the stress alone, for increments.
  [[nodiscard]] double stiffening() const { return branches_ == nullptr ? 1 : 1 + step_.sum; }

 private:
  const DampingBranches* branches_ = nullptr;
  BranchStep step_;
  std::span<const double> before_;
};

/// Stress of an elastic beam in a given position and motion.
struct ElasticAnswer {
  const Beam3& beam;
  BandAnswer band;

  [[nodiscard]] BeamStress3 operator()(const BeamNow3& now) const {
    BeamStress3 all = stress_of(beam.stiffness, now.strain());
    const BeamStress3 remembered = band.damping(all);
    for (std::size_t k = 0; k < all.size(); ++k) all[k] += remembered[k];
    const BeamStress3 damping = linear_stress(beam.stiffness, now.rate());
    for (std::size_t k = 0; k < all.size(); ++k) all[k] += beam.damping * damping[k];
    return all;
  }
};

/// Stress of a yielding beam, linearised by its tangent at the present state: differences of it have no kinks.
struct YieldingAnswer {
  BeamAnswer3 answer;
  BeamStrain3 strain, rate;

  YieldingAnswer(const Model<3>& model, const State<3>& state, const Beam3& beam, const BeamNow3& now, double dt,
                 const std::vector<double>* trial)
      : strain(now.strain()), rate(now.rate()) {
    find_answer(model, state, beam, trial);
    if (answer.by_strain.isZero(0)) return;  // removed
    const BandAnswer band(model, state, beam, dt);
    const BeamStress3 remembered = band.damping(answer.stress);
    for (std::size_t k = 0; k < remembered.size(); ++k) answer.damping[k] += remembered[k];
    answer.by_strain *= band.stiffening();
  }
  /// Kept or evaluated.
  void find_answer(const Model<3>& model, const State<3>& state, const Beam3& beam, const std::vector<double>* trial) {
    if (trial != nullptr && beam.yield == BeamYield::in_fibres)
      if (const auto kept = FibreAnswers<3>::find(model, beam.yield_row, strain, rate, *trial)) {
        answer.stress = kept->stress, answer.damping = kept->damping;
        answer.by_strain = kept->by_strain, answer.by_rate = kept->by_rate;
        return;
      }
    const std::span before = memory_of(model, beam, std::span(state.beam_memory));
    std::vector<double> after(before.size());
    answer = respond(model.yields_3d, beam, strain, rate, before, after);
  }
  [[nodiscard]] BeamStress3 operator()(const BeamNow3& now) const {
    BeamStress3 all;
    for (std::size_t k = 0; k < all.size(); ++k) {
      all[k] = answer.stress[k] + answer.damping[k];
      for (std::size_t j = 0; j < all.size(); ++j) {
        const auto row = static_cast<Eigen::Index>(k), column = static_cast<Eigen::Index>(j);
        all[k] += answer.by_strain(row, column) * (now.strain()[j] - strain[j]) +
                  answer.by_rate(row, column) * (now.rate()[j] - rate[j]);
      }
    }
    return all;
  }
};

/// Perturbation, as a share of the beam's length, or as a rotation [rad]. For differences of fourth order, truncation
/// and rounding errors are both small then.
constexpr double beam_disturbance = 1e-4;

template <class Answer>
BeamBlock3 block_by_differences(const BeamNodes3& now, const Beam3& beam, double rate, const Answer& answer) {
  BeamBlock3 out;
  for (int unknown = 0; unknown < 12; ++unknown) {
    const double by = beam_disturbance * (unknown % 6 < 3 ? beam.length : 1);
    const auto forces_at = [&](double way) {
      BeamNodes3 moved = now;
      moved.move(unknown, way, rate);
      const BeamNow3 there = moved.beam_now(beam);
      return moved.forces(beam, there.action(answer(there)));
    };
    out.col(unknown) = (8 * (forces_at(by) - forces_at(-by)) - (forces_at(2 * by) - forces_at(-2 * by))) / (12 * by);
  }
  return out;
}

}  // namespace

BeamBlock3 beam_block(const Model<3>& model, const State<3>& state, const Beam3& beam, double rate, double dt,
                      const std::vector<double>* trial) {
  const BeamNodes3 now(model, state, beam);
  if (beam.yield == BeamYield::never)
    return block_by_differences(now, beam, rate, ElasticAnswer{beam, BandAnswer(model, state, beam, dt)});
  return block_by_differences(now, beam, rate, YieldingAnswer(model, state, beam, now.beam_now(beam), dt, trial));
}

}  // namespace trilith
