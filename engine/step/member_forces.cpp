#include "step/member_forces.hpp"

#include "step/beam_motion.hpp"
#include "step/resist_beams.hpp"

namespace trilith {

/// Two rows for each beam, its start and its end: the moment is linear in between, N and the shear even.
std::vector<SectionForces> member_forces(const Model<2>& model, const State<2>& state, int member) {
  const Member& m = model.members[member];
  std::vector<SectionForces> rows;
  double along = 0;
  for (int i = m.first_beam; i < m.first_beam + m.beams; ++i) {
    const Beam& beam = model.beams[i];
    Vec2 arm;
    const BeamEnd from = end_of(state, beam, 0, arm), to = end_of(state, beam, 1, arm);
    const BeamNow now(from, to, beam.length, beam.angle);
    const BeamStress stress = beam_stress(model, state, beam, now);
    // Moments on the beam's ends, counter-clockwise: the one at its start bends its bottom into tension where it is
    // below 0, the one at its end where it is above.
    const double shear = (stress[1] + stress[2]) / now.length;
    rows.push_back({along, from.place, stress[0], shear, -stress[1]});
    along += beam.length;
    rows.push_back({along, to.place, stress[0], shear, stress[2]});
  }
  return rows;
}

std::vector<HingeReading> member_hinges(const Model<2>& model, const State<2>& state, int member) {
  const Member& m = model.members[member];
  std::vector<HingeReading> rows;
  for (const int end : {0, 1}) {
    const Beam& beam = model.beams[end == 0 ? m.first_beam : m.first_beam + m.beams - 1];
    if (beam.yield != BeamYield::at_hinges || !has_hinge(model.yields, beam, end)) continue;
    // What is remembered is of the last commit; what is read is of the present place.
    const std::span before = memory_of(model, beam, std::span(state.beam_memory));
    std::vector<double> memory(before.size());
    respond(model.yields, beam, now_of(state, beam), before, memory);
    Vec2 arm;
    const Vec2 place = end_of(state, beam, static_cast<std::size_t>(end), arm).place;
    const EndHingeMemory at = hinge_memory(memory);
    rows.push_back({end, place, yield_status(beam, memory, end), at.turned[end], at.stretch, at.moment[end], at.normal,
                    at.given_off[end]});
  }
  return rows;
}

}  // namespace trilith
