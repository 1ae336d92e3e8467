#include "body/beam_yield.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <bit>
#include <cmath>

namespace trilith {
namespace {

Eigen::Matrix3d matrix_of(const std::array<double, 3>& bend, double axial) {
  Eigen::Matrix3d k = Eigen::Matrix3d::Zero();
  k(0, 0) = axial;
  k(1, 1) = bend[0], k(1, 2) = k(2, 1) = bend[1], k(2, 2) = bend[2];
  return k;
}

/// K where hinges let ends go: their bends follow without moment.
Eigen::Matrix3d stiffness_beside(const BeamStiffness& k, const std::array<bool, 2>& let_go) {
  std::array<double, 3> left = k.bend;
  for (const int end : {0, 1}) {
    if (!let_go[end]) continue;
    double &own = left[2 * end], &other = left[2 * (1 - end)];
    if (own > 0) other -= left[1] * left[1] / own;
    own = left[1] = 0;
  }
  return matrix_of(left, k.axial);
}

/// The part of a tangent that resists.
Eigen::Matrix3d resisting(const Eigen::Matrix3d& tangent) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(0.5 * (tangent + tangent.transpose()));
  return modes.eigenvectors() * modes.eigenvalues().cwiseMax(0).asDiagonal() * modes.eigenvectors().transpose();
}

BeamStress times(const Eigen::Matrix3d& m, const BeamStrain& v) {
  const Eigen::Vector3d out = m * Eigen::Vector3d(v[0], v[1], v[2]);
  return {out[0], out[1], out[2]};
}

FibreBeamResponse respond_fibres(const BeamYields& yields, const Beam& beam, const BeamNow& now,
                                 std::span<const double> before, std::span<double> after) {
  const FibreBeamRow& row = yields.fibre_beams[beam.yield_row];
  return respond(row.beam, yields.sections[row.section], now.strain, before.subspan(1), after.subspan(1));
}

EndHingeResponse respond_hinges(const BeamYields& yields, const Beam& beam, const BeamNow& now,
                                const EndHingeMemory& before) {
  const auto [first, second] = yields.hinged_beams[beam.yield_row];
  return respond(beam.stiffness, {&yields.hinge_laws[first], &yields.hinge_laws[second]}, now.strain, before);
}

/// What is left of K while ends flow or are lost.
Eigen::Matrix3d left_stiffness(const Beam& beam, const EndHingeMemory& before, const EndHingeMemory& after) {
  std::array<bool, 2> let_go{};
  for (const int end : {0, 1}) let_go[end] = after.gone[end] != 0 || after.turned[end] != before.turned[end];
  return stiffness_beside(beam.stiffness, let_go);
}

/// Of an elastic beam: K, and what the bow's normal force adds.
Eigen::Matrix3d elastic_tangent(const BeamStiffness& k, const BeamStrain& d, double normal) {
  Eigen::Matrix3d out = matrix_of(k.bend, 0);
  const Eigen::Vector3d stretch(1, 2 * k.bow[0] * d[1] + k.bow[1] * d[2], 2 * k.bow[2] * d[2] + k.bow[1] * d[1]);
  out += k.axial * stretch * stretch.transpose();
  out(1, 1) += 2 * normal * k.bow[0], out(2, 2) += 2 * normal * k.bow[2];
  out(1, 2) += normal * k.bow[1], out(2, 1) += normal * k.bow[1];
  return out;
}

}  // namespace

int memory_size(const BeamYields& yields, const Beam& beam) {
  switch (beam.yield) {
    case BeamYield::never:
      return 0;
    case BeamYield::in_fibres: {
      const FibreBeamRow& row = yields.fibre_beams[beam.yield_row];
      return 1 + row.beam.memory_size(yields.sections[row.section]);
    }
    case BeamYield::at_hinges:
      return EndHingeMemory::size;
  }
  return 0;
}

BeamResponse respond(const BeamYields& yields, const Beam& beam, const BeamNow& now, std::span<const double> before,
                     std::span<double> after) {
  BeamResponse out;
  Eigen::Matrix3d by_rate = Eigen::Matrix3d::Zero();
  if (beam.yield == BeamYield::in_fibres) {
    const FibreBeamResponse r = respond_fibres(yields, beam, now, before, after);
    after[0] = before[0] != 0 || r.yielding ? 1 : 0;
    out = {r.stress, {}, r.stored, r.dissipated};
    if (beam.damping > 0) by_rate = resisting(r.tangent);
  } else {
    const EndHingeMemory was = hinge_memory(before);
    const EndHingeResponse r = respond_hinges(yields, beam, now, was);
    std::ranges::copy(std::bit_cast<std::array<double, EndHingeMemory::size>>(r.memory), after.begin());
    out = {r.stress, {}, r.stored, r.dissipated};
    if (beam.damping > 0) by_rate = left_stiffness(beam, was, r.memory);
  }
  if (beam.damping > 0) out.damping = times(beam.damping * by_rate, now.rate);
  return out;
}

BeamTangent tangent_of(const BeamYields& yields, const Beam& beam, const BeamNow& now, std::span<const double> before) {
  BeamTangent out;
  if (beam.yield == BeamYield::in_fibres) {
    std::vector<double> after(before.size());
    const FibreBeamResponse r = respond_fibres(yields, beam, now, before, after);
    out.stress = r.stress, out.by_strain = r.tangent, out.by_rate = resisting(r.tangent);
  } else if (beam.yield == BeamYield::at_hinges) {
    const EndHingeMemory was = hinge_memory(before);
    const EndHingeResponse r = respond_hinges(yields, beam, now, was);
    out.stress = r.stress, out.by_strain = r.tangent, out.by_rate = left_stiffness(beam, was, r.memory);
  } else {
    out.stress = stress_of(beam.stiffness, now.strain);
    out.by_strain = elastic_tangent(beam.stiffness, now.strain, out.stress[0]);
    out.by_rate = matrix_of(beam.stiffness.bend, beam.stiffness.axial);
  }
  out.by_rate *= beam.damping;
  out.damping = times(out.by_rate, now.rate);
  return out;
}

bool has_hinge(const BeamYields& yields, const Beam& beam, int end) {
  return std::isfinite(yields.hinge_laws[yields.hinged_beams[beam.yield_row][end]].sagging);
}

EndHingeMemory hinge_memory(std::span<const double> memory) {
  std::array<double, EndHingeMemory::size> words;
  std::copy_n(memory.begin(), words.size(), words.begin());
  return std::bit_cast<EndHingeMemory>(words);
}

HingeStatus yield_status(const Beam& beam, std::span<const double> memory, int end) {
  if (beam.yield == BeamYield::at_hinges) return status_of(hinge_memory(memory), end);
  return end == 0 && memory[0] != 0 ? HingeStatus::yielded : HingeStatus::elastic;
}

}  // namespace trilith
