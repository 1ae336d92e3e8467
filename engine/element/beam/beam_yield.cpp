#include "element/beam/beam_yield.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "element/beam/beam_answer.hpp"
#include "element/beam/fibre_damping.hpp"

namespace trilith {
namespace {

Eigen::Matrix3d matrix_of(const std::array<double, 3>& bend, double axial) {
  Eigen::Matrix3d k = Eigen::Matrix3d::Zero();
  k(0, 0) = axial;
  k(1, 1) = bend[0], k(1, 2) = k(2, 1) = bend[1], k(2, 2) = bend[2];
  return k;
}

BeamStress times(const Eigen::Matrix3d& m, const BeamStrain& v) {
  const Eigen::Vector3d out = m * Eigen::Vector3d(v[0], v[1], v[2]);
  return {out[0], out[1], out[2]};
}

/// Remaining K while ends yield or are lost.
Eigen::Matrix3d left_stiffness(const Beam& beam, const EndHingeMemory& before, const EndHingeMemory& after) {
  std::array<bool, 2> flowing{};
  for (const int end : {0, 1}) flowing[end] = after.gone[end] != 0 || after.turned[end] != before.turned[end];
  return matrix_of(bend_beside(beam.stiffness.bend, flowing), beam.stiffness.axial);
}

/// Tangent of an elastic beam: K, and the contribution of the bow's normal force. d stress / d strain = K + EA/L s s' +
/// N d2(L q), s = d(u + L q)/d(u, theta_0, theta_1).
Eigen::Matrix3d elastic_tangent(const BeamStiffness& k, const BeamStrain& d, double normal) {
  Eigen::Matrix3d out = matrix_of(k.bend, 0);
  const Eigen::Vector3d stretch(1, 2 * k.bow[0] * d[1] + k.bow[1] * d[2], 2 * k.bow[2] * d[2] + k.bow[1] * d[1]);
  out += k.axial * stretch * stretch.transpose();
  out(1, 1) += 2 * normal * k.bow[0], out(2, 2) += 2 * normal * k.bow[2];
  out(1, 2) += normal * k.bow[1], out(2, 1) += normal * k.bow[1];
  return out;
}

BeamAnswer answer_of_fibres(const BeamYields& yields, const Beam& beam, const BeamNow& now,
                            std::span<const double> before, std::span<double> after) {
  BeamAnswer out;
  const FibreBeamRow& row = yields.fibre_beams[beam.yield_row];
  const FibreSection& section = yields.sections[row.section];
  const auto fibres = static_cast<std::size_t>(row.beam.memory_size(section));
  const FibreBeamResponse r =
      respond(row.beam, section, now.strain, before.subspan(1, fibres), after.subspan(1, fibres));
  after[0] = before[0] != 0 || r.yielding ? 1 : 0;
  out.tangent.stress = r.stress, out.tangent.by_strain = r.tangent;
  out.stored = r.stored, out.dissipated = r.dissipated;
  if (beam.damping > 0) {
    out.tangent.by_rate = beam.damping * FibreDamping<3>::matrix(before.subspan(1 + fibres), r.tangent);
    FibreDamping<3>::keep(r.tangent, after.subspan(1 + fibres));
  }
  return out;
}

BeamAnswer answer_of_hinges(const BeamYields& yields, const Beam& beam, const BeamNow& now,
                            std::span<const double> before, std::span<double> after) {
  BeamAnswer out;
  const auto [first, second] = yields.hinged_beams[beam.yield_row];
  const EndHingeMemory was = hinge_memory(before);
  const EndHingeResponse r =
      respond(beam.stiffness, {&yields.hinge_laws[first], &yields.hinge_laws[second]}, now.strain, was);
  std::ranges::copy(std::bit_cast<std::array<double, EndHingeMemory::size>>(r.memory), after.begin());
  out.tangent.stress = r.stress, out.tangent.by_strain = r.tangent;
  out.stored = r.stored, out.dissipated = r.dissipated;
  if (beam.damping > 0) out.tangent.by_rate = beam.damping * left_stiffness(beam, was, r.memory);
  return out;
}

}  // namespace

std::array<double, 3> bend_beside(const std::array<double, 3>& bend, const std::array<bool, 2>& flowing) {
  std::array<double, 3> left = bend;
  for (const int end : {0, 1}) {
    if (!flowing[end]) continue;
    // Static condensation: K_other - K_01^2 / K_own. With both ends released nothing remains.
    double &own = left[2 * end], &other = left[2 * (1 - end)];
    if (own > 0) other -= left[1] * left[1] / own;
    own = left[1] = 0;
  }
  return left;
}

int memory_size(const BeamYields& yields, const Beam& beam) {
  switch (beam.yield) {
    case BeamYield::never:
      return 0;
    case BeamYield::in_fibres: {
      const FibreBeamRow& row = yields.fibre_beams[beam.yield_row];
      return 1 + row.beam.memory_size(yields.sections[row.section]) +
             (beam.damping > 0 ? FibreDamping<3>::memory_size : 0);
    }
    case BeamYield::at_hinges:
      return EndHingeMemory::size;
  }
  return 0;
}

BeamAnswer answer_of(const BeamYields& yields, const Beam& beam, const BeamNow& now, std::span<const double> before,
                     std::span<double> after) {
  BeamAnswer out = beam.yield == BeamYield::in_fibres ? answer_of_fibres(yields, beam, now, before, after)
                                                      : answer_of_hinges(yields, beam, now, before, after);
  if (beam.damping > 0) out.tangent.damping = times(out.tangent.by_rate, now.rate);
  return out;
}

BeamResponse respond(const BeamYields& yields, const Beam& beam, const BeamNow& now, std::span<const double> before,
                     std::span<double> after) {
  const BeamAnswer a = answer_of(yields, beam, now, before, after);
  return {a.tangent.stress, a.tangent.damping, a.stored, a.dissipated};
}

/// A yielding beam is evaluated as a trial, whose memory is discarded.
BeamTangent tangent_of(const BeamYields& yields, const Beam& beam, const BeamNow& now, std::span<const double> before) {
  if (beam.yield != BeamYield::never) {
    std::vector<double> after(before.size());
    return answer_of(yields, beam, now, before, after).tangent;
  }
  BeamTangent out;
  out.stress = stress_of(beam.stiffness, now.strain);
  out.by_strain = elastic_tangent(beam.stiffness, now.strain, out.stress[0]);
  out.by_rate = beam.damping * matrix_of(beam.stiffness.bend, beam.stiffness.axial);
  out.damping = times(out.by_rate, now.rate);
  return out;
}

/// An end that never yields has an unbounded law.
bool has_hinge(const BeamYields& yields, const Beam& beam, int end) {
  return std::isfinite(yields.hinge_laws[yields.hinged_beams[beam.yield_row][end]].sagging);
}

EndHingeMemory hinge_memory(std::span<const double> memory) {
  std::array<double, EndHingeMemory::size> words;
  std::copy_n(memory.begin(), words.size(), words.begin());
  return std::bit_cast<EndHingeMemory>(words);
}

/// Fibres have one status for the beam, reported at its end 0.
HingeStatus yield_status(const Beam& beam, std::span<const double> memory, int end) {
  if (beam.yield == BeamYield::at_hinges) return status_of(hinge_memory(memory), end);
  return end == 0 && memory[0] != 0 ? HingeStatus::yielded : HingeStatus::elastic;
}

}  // namespace trilith
