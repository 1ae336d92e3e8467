// The analytical tangent stiffness of beams against central differences of their forces.
#include "assembly/tangent/beam_tangent.hpp"

#include "physics/members/yielding.hpp"

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
    // Any motion that is not a common one of all nodes.
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
        if (damping > 0 && std::holds_alternative<MemberFibres>(yields)) continue;  // see beam_block
        MovingMember member(yields, size, damping);
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

}  // namespace
}  // namespace trilith::testing
