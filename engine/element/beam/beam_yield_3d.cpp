#include "element/beam/beam_yield_3d.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "element/beam/beam_yield.hpp"
#include "element/beam/fibre_damping.hpp"

namespace trilith {
namespace {

BeamAnswer3 answer_of_fibres(const BeamYields3& yields, const Beam3& beam, const BeamStrain3& strain,
                             std::span<const double> before, std::span<double> after) {
  const FibreBeamRow3& row = yields.fibre_beams[static_cast<std::size_t>(beam.yield_row)];
  const FibreSection3& section = yields.sections[static_cast<std::size_t>(row.section)];
  const auto fibres = static_cast<std::size_t>(row.beam.memory_size(section));
  const FibreBeamResponse3 r = respond(row.beam, section, strain, before.subspan(1, fibres), after.subspan(1, fibres));
  after[0] = before[0] != 0 || r.yielding ? 1 : 0;
  BeamAnswer3 out;
  out.stress = r.stress, out.by_strain = r.tangent, out.stored = r.stored, out.dissipated = r.dissipated;
  if (beam.damping > 0) {
    out.by_rate = beam.damping * FibreDamping<6>::matrix(before.subspan(1 + fibres), r.tangent);
    FibreDamping<6>::keep(r.tangent, after.subspan(1 + fibres));
  }
  return out;
}

/// K about both axes without the moments of yielding ends; 0 for a removed beam.
Eigen::Matrix<double, 6, 6> stiffness_beside(const BeamStiffness3& k, const EndHingeResponse3& r) {
  Eigen::Matrix<double, 6, 6> out = Eigen::Matrix<double, 6, 6>::Zero();
  if (r.memory.gone[0] > 1) return out;
  out(0, 0) = k.axial, out(5, 5) = k.torsion;
  for (const std::size_t axis : {0, 1}) {
    const std::array<double, 3> left = bend_beside(k.bend[axis].bend, r.flowing);
    const auto a = static_cast<Eigen::Index>(1 + axis), b = static_cast<Eigen::Index>(3 + axis);
    out(a, a) = left[0], out(a, b) = out(b, a) = left[1], out(b, b) = left[2];
  }
  return out;
}

BeamAnswer3 answer_of_hinges(const BeamYields3& yields, const Beam3& beam, const BeamStrain3& strain,
                             std::span<const double> before, std::span<double> after) {
  const auto& [first, second] = yields.hinged_beams[static_cast<std::size_t>(beam.yield_row)];
  const EndHingeResponse3 r = respond(
      beam.stiffness,
      {&yields.hinge_laws[static_cast<std::size_t>(first)], &yields.hinge_laws[static_cast<std::size_t>(second)]},
      strain, space_hinge_memory(before));
  std::ranges::copy(std::bit_cast<std::array<double, EndHingeMemory3::size>>(r.memory), after.begin());
  BeamAnswer3 out;
  out.stress = r.stress, out.by_strain = r.tangent, out.stored = r.stored, out.dissipated = r.dissipated;
  if (beam.damping > 0) out.by_rate = beam.damping * stiffness_beside(beam.stiffness, r);
  return out;
}

}  // namespace

int memory_size(const BeamYields3& yields, const Beam3& beam) {
  switch (beam.yield) {
    case BeamYield::never:
      return 0;
    case BeamYield::in_fibres: {
      const FibreBeamRow3& row = yields.fibre_beams[static_cast<std::size_t>(beam.yield_row)];
      return 1 + row.beam.memory_size(yields.sections[static_cast<std::size_t>(row.section)]) +
             (beam.damping > 0 ? FibreDamping<6>::memory_size : 0);
    }
    case BeamYield::at_hinges:
      return EndHingeMemory3::size;
  }
  return 0;
}

BeamAnswer3 respond(const BeamYields3& yields, const Beam3& beam, const BeamStrain3& strain, const BeamStrain3& rate,
                    std::span<const double> before, std::span<double> after) {
  BeamAnswer3 out = beam.yield == BeamYield::in_fibres ? answer_of_fibres(yields, beam, strain, before, after)
                                                       : answer_of_hinges(yields, beam, strain, before, after);
  if (!(beam.damping > 0)) return out;
  const Eigen::Matrix<double, 6, 1> damping = out.by_rate * Eigen::Map<const Eigen::Matrix<double, 6, 1>>(rate.data());
  std::copy_n(damping.data(), out.damping.size(), out.damping.begin());
  return out;
}

bool has_hinge(const BeamYields3& yields, const Beam3& beam, int end) {
  const int law = yields.hinged_beams[static_cast<std::size_t>(beam.yield_row)][static_cast<std::size_t>(end)];
  return std::isfinite(yields.hinge_laws[static_cast<std::size_t>(law)].sagging);
}

EndHingeMemory3 space_hinge_memory(std::span<const double> memory) {
  std::array<double, EndHingeMemory3::size> words;
  std::copy_n(memory.begin(), words.size(), words.begin());
  return std::bit_cast<EndHingeMemory3>(words);
}

HingeStatus yield_status(const Beam3& beam, std::span<const double> memory, int end) {
  if (beam.yield == BeamYield::at_hinges) return status_of(space_hinge_memory(memory), end);
  return end == 0 && memory[0] != 0 ? HingeStatus::yielded : HingeStatus::elastic;
}

}  // namespace trilith
