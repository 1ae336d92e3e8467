#include "body/beam_yield_3d.hpp"

#include <algorithm>

#include "body/resisting_part.hpp"

namespace trilith {

int memory_size(const BeamYields3& yields, const Beam3& beam) {
  if (beam.fibre_row < 0) return 0;
  const FibreBeamRow3& row = yields.fibre_beams[static_cast<std::size_t>(beam.fibre_row)];
  return 1 + row.beam.memory_size(yields.sections[static_cast<std::size_t>(row.section)]);
}

BeamAnswer3 respond(const BeamYields3& yields, const Beam3& beam, const BeamStrain3& strain, const BeamStrain3& rate,
                    std::span<const double> before, std::span<double> after) {
  const FibreBeamRow3& row = yields.fibre_beams[static_cast<std::size_t>(beam.fibre_row)];
  const FibreBeamResponse3 r = respond(row.beam, yields.sections[static_cast<std::size_t>(row.section)], strain,
                                       before.subspan(1), after.subspan(1));
  after[0] = before[0] != 0 || r.yielding ? 1 : 0;
  BeamAnswer3 out;
  out.stress = r.stress, out.by_strain = r.tangent, out.stored = r.stored, out.dissipated = r.dissipated;
  if (!(beam.damping > 0)) return out;
  out.by_rate = beam.damping * resisting_part(r.tangent);
  const Eigen::Matrix<double, 6, 1> damping = out.by_rate * Eigen::Map<const Eigen::Matrix<double, 6, 1>>(rate.data());
  std::copy_n(damping.data(), out.damping.size(), out.damping.begin());
  return out;
}

}  // namespace trilith
