#include "step/member_forces.hpp"

#include "step/beam_motion.hpp"

namespace trilith {

std::vector<SectionForces> member_forces(const Model<2>& model, const State<2>& state, int member) {
  const Member& m = model.members[member];
  std::vector<SectionForces> rows;
  double along = 0;
  for (int i = m.first_beam; i < m.first_beam + m.beams; ++i) {
    const Beam& beam = model.beams[i];
    Vec2 arm;
    const BeamEnd from = end_of(state, beam, 0, arm), to = end_of(state, beam, 1, arm);
    const BeamNow now(from, to, beam.length, beam.angle);
    const BeamStress stress = stress_of(beam.stiffness, now.strain);
    // Moments on the beam's ends, counter-clockwise: the one at its start bends its bottom into tension where it is
    // below 0, the one at its end where it is above.
    const double shear = (stress[1] + stress[2]) / now.length;
    rows.push_back({along, from.place, stress[0], shear, -stress[1]});
    along += beam.length;
    rows.push_back({along, to.place, stress[0], shear, stress[2]});
  }
  return rows;
}

}  // namespace trilith
