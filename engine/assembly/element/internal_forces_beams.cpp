#include "assembly/element/internal_forces_beams.hpp"

#include "assembly/element/beam_motion.hpp"
#include "assembly/element/fibre_answers.hpp"
#include "assembly/field/heated_beams.hpp"

namespace trilith {
namespace {

BeamResponse respond_elastic(const Beam& beam, const BeamNow& now) {
  BeamResponse out{stress_of(beam.stiffness, now.strain), {}, stored_in(beam.stiffness, now.strain), 0};
  if (!(beam.damping > 0)) return out;
  // Only K acts on the rates; the effect of curvature on the normal force is not damped.
  out.damping = linear_stress(beam.stiffness, now.rate);
  for (double& v : out.damping) v *= beam.damping;
  return out;
}

/// Hinges and fibres read the memory of the last commit and write the trial memory in Work. The answer of fibres is
/// kept for the tangent.
BeamResponse respond_yielding(const Model<2>& model, const State<2>& state, Work<2>& work, const Beam& beam,
                              const BeamNow& now) {
  const BeamAnswer a = answer_of(model.yields, beam, now, memory_of(model, beam, std::span(state.beam_memory)),
                                 memory_of(model, beam, std::span(work.beam_memory)));
  if (beam.yield == BeamYield::in_fibres)
    FibreAnswers<2>::keep(model, beam.yield_row, fibre_answer(now.strain, now.rate, a.tangent), work.beam_memory);
  return {a.tangent.stress, a.tangent.damping, a.stored, a.dissipated};
}

}  // namespace

bool is_removed(const Model<2>& model, const Beam& beam, std::span<const double> memories) {
  return beam.yield == BeamYield::at_hinges && hinge_memory(memory_of(model, beam, memories)).gone[0] > 1;
}

/// Adds forces and moments of beams on the nodes. For an elastic beam they are the derivatives of its energy
/// (element/beam/beam_element.hpp); for a yielding beam they follow from its fibres or hinges
/// (element/beam/beam_yield.hpp). The ends move rigidly with their nodes.
void resist_beams(const Model<2>& model, const State<2>& state, Work<2>& work, double dt, ElementEnergy& sums) {
  BandRelaxation<2> bands(model, state, work, dt);
  FibreAnswers<2>::make_room(model, work.beam_memory);
  for (const Beam& beam : model.beams) {
    std::array<Vec2, 2> arm;
    const BeamEnd from = end_of(state, beam, 0, arm[0]), to = end_of(state, beam, 1, arm[1]);
    BeamNow now(from, to, beam.length, beam.angle);
    relax_heated(model, state, beam, now);
    // On the nodes: the force adds its moment by the arm. M_0 and M_1 resist the bends, so the nodes receive their
    // opposite.
    const auto add = [&](const BeamStress& stress, std::vector<Vec2>& force, std::vector<double>& moment) {
      const Vec2 start = now.force_on_start(stress);
      force[beam.node[0]] += start, force[beam.node[1]] -= start;
      moment[beam.node[0]] += cross(arm[0], start) - stress[1];
      moment[beam.node[1]] -= cross(arm[1], start) + stress[2];
    };
    const BeamResponse r =
        beam.yield == BeamYield::never ? respond_elastic(beam, now) : respond_yielding(model, state, work, beam, now);
    sums.stored += r.stored, sums.plastic += r.dissipated;
    add(r.stress, work.element_force, work.element_moment);
    if (beam.damping > 0) add(r.damping, work.element_damping, work.element_damping_moment);
    if (beam.band >= 0) add(bands.damping(beam, r.stress), work.element_damping, work.element_damping_moment);
  }
}

BeamStress beam_stress(const Model<2>& model, const State<2>& state, const Beam& beam, const BeamNow& position) {
  BeamNow now = position;
  relax_heated(model, state, beam, now);
  if (beam.yield == BeamYield::never) return stress_of(beam.stiffness, now.strain);
  const std::span before = memory_of(model, beam, std::span(state.beam_memory));
  std::vector<double> after(before.size());
  return respond(model.yields, beam, now, before, after).stress;
}

}  // namespace trilith
