// Frames in space: what the motion of their nodes makes of their beams.
#include "step/beam_motion.hpp"
#include "step/evaluate.hpp"
#include "step/resist_beams.hpp"

namespace trilith {
namespace {

/// Force and moments on the two nodes of a beam.
void add_action(const Beam3& beam, const BeamAction3& action, double share, std::vector<Vec3>& force,
                std::vector<Vec3>& moment) {
  const auto a = static_cast<std::size_t>(beam.node[0]), b = static_cast<std::size_t>(beam.node[1]);
  force[a] += share * action.force, force[b] -= share * action.force;
  moment[a] += share * action.moment[0], moment[b] += share * action.moment[1];
}

}  // namespace

/// s = K(d) of the strains d in axes that go with the chord, and beta K d' of their rates, which brakes; the transpose
/// of d' brings both to the nodes.
void resist_beams(const Model<3>& model, const State<3>& state, Work<3>& work, ResistSums& sums) {
  for (const Beam3& beam : model.beams_3d) {
    const BeamNow3 now = now_of(state, beam);
    add_action(beam, now.action(stress_of(beam.stiffness, now.strain())), 1, work.element_force, work.element_moment);
    sums.stored += stored_in(beam.stiffness, now.strain());
    if (beam.damping > 0)
      add_action(beam, now.action(linear_stress(beam.stiffness, now.rate())), beam.damping, work.element_damping,
                 work.element_damping_moment);
  }
}

void resist(const Model<3>& model, const State<3>& state, Work<3>& work, double /*dt*/) {
  work.element_stored = 0;
  if (model.beams_3d.empty()) return;
  const auto nodes = static_cast<std::size_t>(model.nodes());
  work.element_force.assign(nodes, Vec3::Zero()), work.element_damping.assign(nodes, Vec3::Zero());
  work.element_moment.assign(nodes, Vec3::Zero()), work.element_damping_moment.assign(nodes, Vec3::Zero());
  ResistSums sums;
  if (!work.leave_out_beams) resist_beams(model, state, work, sums);
  work.element_stored = sums.stored;
}

}  // namespace trilith
