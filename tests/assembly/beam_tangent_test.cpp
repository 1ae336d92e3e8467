// The analytical tangent stiffness of beams against central differences of their forces.
#include "assembly/tangent/beam_tangent.hpp"

#include "assembly/element/fibre_answers.hpp"
#include "assembly/implicit_turn.hpp"
#include "events/commit.hpp"
#include "physics/members/yielding.hpp"
#include "physics/space/space_frames.hpp"

namespace trilith::testing {
namespace {

/// A bent member of two beams with end offsets from its joints, strained and in motion.
struct MovingMember {
  Model<2> model;
  State<2> state;

  MovingMember(const decltype(FrameMember::yields)& yields, double size, double damping) {
    BodySpec spec = beam_body("beam", {0, 0}, {3, 1}, rectangle_section(0.1, 0.2), "steel", 2);
    FrameMember& member = spec.frame->members[0];
    member.ends = {Vec2(0.2, 0.3), Vec2(2.9, 0.6)}, member.yields = yields;
    model = of_frames(elastic_material("steel", 7850, 2.1e11, 0.3, damping), {spec});
    state = initial_state(model);
    move_on(size);
  }
  /// Any motion that is not a common one of all nodes.
  void move_on(double size) {
    for (int n = 0; n < model.nodes(); ++n) {
      const double a = 0.7 + n, b = 1.3 + 2 * n;
      state.position[n] += size * Vec2(std::sin(a), std::cos(3 * a)), state.rotation[n] = 3 * size * std::sin(b);
      state.velocity[n] = Vec2(std::cos(b), std::sin(2 * b)), state.spin[n] = std::cos(5 * a);
    }
  }
  /// Force and moment of a single beam on its two nodes.
  [[nodiscard]] Eigen::Matrix<double, 6, 1> forces(const Beam& beam) const {
    Model<2> alone = model;
    alone.beams = {beam};
    Work<2> work;
    internal_forces(alone, state, work);
    Eigen::Matrix<double, 6, 1> out;
    for (const int end : {0, 1}) {
      const int n = beam.node[end];
      out.segment<2>(3 * end) = work.element_force[n] + work.element_damping[n];
      out[3 * end + 2] = work.element_moment[n] + work.element_damping_moment[n];
    }
    return out;
  }
  /// Ends a step in the present position, so that later steps are damped by the tangent of this one.
  void take_step() {
    Work<2> work;
    internal_forces(model, state, work);
    commit(model, state, work);
  }
  [[nodiscard]] BeamBlock differences(const Beam& beam, double rate) {
    BeamBlock out;
    for (int column = 0; column < 6; ++column) {
      const int n = beam.node[column / 3], k = column % 3;
      double &place = dof_of(state, n, k), &speed = k == 2 ? state.spin[n] : state.velocity[n][k];
      const double was = place, ran = speed, by = 1e-8;
      place = was + by, speed = ran + rate * by;
      const Eigen::Matrix<double, 6, 1> more = forces(beam);
      place = was - by, speed = ran - rate * by;
      out.col(column) = (more - forces(beam)) / (2 * by);
      place = was, speed = ran;
    }
    return out;
  }
};

TEST_CASE("the tangent of a beam matches finite differences: elastic, fibres, hinges, damped, rigid ends") {
  BilinearSteel steel;
  steel.young = 2.1e11, steel.yield = 240e6, steel.hardening = 0.02;
  HingeLaw axial = plain_hinge();
  axial.hardening = 1e5, axial.tension = 4e6, axial.capping = 0.05, axial.softening = 0.2, axial.residual = 0.3;
  const MemberFibres fibres{{RectangleSection{0.1, 0.2}, steel}};
  using Yields = decltype(FrameMember::yields);
  for (const Yields& yields : {Yields{}, Yields{fibres}, Yields{MemberHinges{{plain_hinge(), std::nullopt}}},
                               Yields{MemberHinges{{axial, axial}}}})
    for (const double size : {1e-4, 3e-3, 3e-2})
      for (const double damping : {0.0, 1e-3}) {
        MovingMember member(yields, size, damping);
        if (std::holds_alternative<MemberFibres>(yields)) member.take_step(), member.move_on(size);
        for (const Beam& beam : member.model.beams) {
          const BeamBlock by_hand = beam_block(member.model, member.state, beam, 50);
          const BeamBlock differences = member.differences(beam, 50);
          CAPTURE(yields.index());
          CAPTURE(size);
          CAPTURE(damping);
          CHECK((by_hand - differences).cwiseAbs().maxCoeff() < 1e-6 * differences.cwiseAbs().maxCoeff());
        }
      }
}

const MemberFibres plain_fibres{{RectangleSection{0.1, 0.2}, BilinearSteel{2.1e11, 240e6, 0.02, 0}}};

/// The blocks of all beams, with the responses that `trial` keeps; null without.
template <int D>
Eigen::VectorXd blocks_of(const Model<D>& model, const State<D>& state, const std::vector<double>* trial) {
  Eigen::VectorXd out(0);
  for (const auto& beam : beams_of(model)) {
    const auto block = beam_block(model, state, beam, 50, 0, trial);
    const Eigen::Index end = out.size();
    out.conservativeResize(end + block.size());
    std::copy_n(block.data(), block.size(), out.data() + end);
  }
  return out;
}

/// An evaluation keeps the tangents of fibres: the blocks are the same bits with them. They are not used in another
/// motion, nor after the commit, when the memories of the fibres have changed.
template <int D, class MoveOn>
void check_kept_tangents(const Model<D>& model, State<D>& state, const MoveOn& move_on) {
  Work<D> work;
  internal_forces(model, state, work);
  const Eigen::VectorXd evaluated = blocks_of(model, state, nullptr);
  CHECK(blocks_of(model, state, &work.beam_memory) == evaluated);
  // Stresses that were kept are used: a changed one changes the block.
  for (std::size_t i = static_cast<std::size_t>(model.beam_memory); i < work.beam_memory.size(); ++i) {
    constexpr std::size_t strains = D == 2 ? 3 : 6;
    const std::size_t place = (i - static_cast<std::size_t>(model.beam_memory)) % FibreAnswers<D>::Answer::size;
    if (place >= 2 * strains && place < 3 * strains) work.beam_memory[i] *= 1.5;
  }
  CHECK(blocks_of(model, state, &work.beam_memory) != evaluated);
  State<D> moved = state;
  move_on(moved);
  CHECK(blocks_of(model, moved, &work.beam_memory) == blocks_of<D>(model, moved, nullptr));
  internal_forces(model, state, work);
  commit(model, state, work);
  CHECK(state.beam_memory.size() == static_cast<std::size_t>(model.beam_memory));
  CHECK(blocks_of(model, state, &work.beam_memory) == blocks_of<D>(model, state, nullptr));
}

TEST_CASE("tangents of fibres kept by an evaluation equal another evaluation, in the plane") {
  for (const double damping : {0.0, 1e-3}) {
    MovingMember member(plain_fibres, 3e-2, damping);
    check_kept_tangents(member.model, member.state, [](State<2>& other) { other.rotation[2] += 1e-3; });
  }
}

TEST_CASE("tangents of fibres kept by an evaluation equal another evaluation, in space") {
  for (const double damping : {0.0, 1e-3}) {
    SolidSpec spec = chain_body("beam", {Vec3(0, 0, 0), Vec3(3, 1, 0.5)}, plain_section(0.1, 0.2), 2);
    spec.frame->members[0].yields = plain_fibres;
    const Model<3> model = of_space_frames(member_material(7850, 2.1e11, 0.3, damping), {spec});
    State<3> state = initial_state(model);
    for (int n = 0; n < model.nodes(); ++n) {
      const auto i = static_cast<std::size_t>(n);
      const double a = 0.7 + n;
      state.position[i] += 3e-2 * Vec3(std::sin(a), std::cos(3 * a), std::sin(2 * a));
      turn_about(n % 3, 0.05 * std::cos(a), state.rotation[i]);
      state.velocity[i] = Vec3(std::cos(a), std::sin(2 * a), 1), state.spin[i] = Vec3(0.5, std::cos(5 * a), 1);
    }
    check_kept_tangents(model, state, [](State<3>& other) { turn_about(1, 1e-3, other.rotation[2]); });
  }
}

}  // namespace
}  // namespace trilith::testing
