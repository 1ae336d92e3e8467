#include "element/beam/end_hinge_3d.hpp"

#include <Eigen/LU>

#include <algorithm>

#include "element/beam/hinge_ends_3d.hpp"
#include "element/beam/hinge_normal.hpp"

namespace trilith {
namespace {

using SpaceReturned = ReturnedNormal<SpaceEnds>;

/// The search for N; each iteration starts from the result of the previous one.
SpaceReturned return_in_space(const SpaceBeamOfStep& beam, const Hinges& hinge, double plastic, double trial) {
  SpaceEnds near;
  bool has_near = false;
  const auto ends_at = [&](double normal) {
    SpaceEnds out = ends_beside(beam, hinge, normal, has_near ? &near : nullptr);
    for (const std::size_t i : {0, 1})
      if (out.flows[i]) out.stretch -= hinge[i].law->beside(normal).slope * out.flow[i].work;
    near = out, has_near = true;
    return out;
  };
  const auto missing = [&](double normal, const SpaceEnds& ends) {
    return normal - beam.axial * (beam.stretch + beam.bowed(ends.p) - plastic - ends.stretch);
  };
  return normal_beside_hinges(normal_range(*hinge[0].law, *hinge[1].law), trial, beam.axial * std::abs(beam.stretch),
                              ends_at, missing);
}

/// d (N, moments) / d (u, bends) after the return, scaled. Unknown: dN, then amount and direction of each flowing end.
///   Row 0: N = EA/L (u + L q - p_u), with p_u by the flow at both ends; or dN = 0 at the apex.
///   Rows of an end: its moments stay at its capacity.
Eigen::Matrix<double, 5, 5> tangent_in_space(const SpaceBeamOfStep& beam, const Hinges& hinge,
                                             const SpaceReturned& at) {
  using Matrix5 = Eigen::Matrix<double, 5, 5>;
  const Eigen::Matrix4d k = beam.bend + at.normal * beam.bow;
  const Eigen::RowVector4d arm = (beam.bow * (beam.turn - at.ends.p)).transpose();  // of L q by the bends
  Matrix5 left = Matrix5::Identity(), right = Matrix5::Zero();
  Eigen::Matrix4d p_by = Eigen::Matrix4d::Zero();  // with respect to the unknowns
  for (const int i : {0, 1})
    if (at.ends.flows[static_cast<std::size_t>(i)])
      p_by.block<2, 2>(2 * i, 2 * i) = at.ends.flow[static_cast<std::size_t>(i)].p_by;
  if (!at.held) {
    left.block<1, 4>(0, 1) = beam.axial * arm * p_by;
    right(0, 0) = beam.axial, right.block<1, 4>(0, 1) = beam.axial * arm;
  }
  for (const int i : {0, 1}) {
    const auto end = static_cast<std::size_t>(i);
    if (!at.ends.flows[end]) continue;
    const SpaceFlow& f = at.ends.flow[end];
    const AxialShare c = hinge[end].law->beside(at.normal);
    const int row = 1 + 2 * i;
    if (!at.held) {
      left(0, 0) -= beam.axial * c.bend * f.work;
      left.block<1, 2>(0, row) -= beam.axial * c.slope * f.work_by;
    }
    left.block<2, 1>(row, 0) = arm.segment<2>(2 * i).transpose() - c.slope * f.outward;
    left.block<2, 4>(row, 1) = -k.middleRows<2>(2 * i) * p_by;
    left.block<2, 2>(row, row) -= f.most_by;
    right.block<2, 4>(row, 1) = -k.middleRows<2>(2 * i);
  }
  const Matrix5 moved = left.partialPivLu().solve(right);
  Matrix5 out;
  out.row(0) = moved.row(0);
  out.bottomRows<4>() = arm.transpose() * moved.row(0) - k * p_by * moved.bottomRows<4>();
  out.bottomRightCorner<4, 4>() += k;
  return out;
}

double scale_of(const HingeLaw& law) {
  return law.across > 0 && std::isfinite(law.sagging) ? std::sqrt(law.across / law.sagging) : 1;
}

SpaceHinge hinge_of(const HingeLaw& law, const EndHingeMemory3& m, std::size_t i) {
  const double scale = scale_of(law);
  const Eigen::Vector2d from(scale * m.turned[i][0], m.turned[i][1]);
  return {&law, scale, from, m.reach[i], law.worn(m.dissipated[i]), m.gone[i] != 0};
}

/// Energy stored by hardening: X . dp is its change, because rotations are scaled.
double back_energy(const HingeLaw& law, const EndHingeMemory3& m, std::size_t i) {
  if (m.gone[i] != 0 || !std::isfinite(law.sagging)) return 0;
  const double p = portable::hypot(scale_of(law) * m.turned[i][0], m.turned[i][1]);
  return law.worn(m.dissipated[i]) * law.kept(m.reach[i]) * law.stored(p);
}

/// Memory and energies after the return, as in the plane. The work on the flow, by mean moments and mean N, is the
/// increase of the energy stored by hardening plus the dissipated energy, which wears the hinge from the next step on.
void book_in_space(const Hinges& hinge, const SpaceReturned& at, double stretch, const EndHingeMemory3& before,
                   EndHingeResponse3& out) {
  EndHingeMemory3& m = out.memory;
  const double pull = 0.5 * (at.normal + before.normal);
  // Half of the stretch added at a corner of the surface is assigned to each end.
  const double corner = stretch - before.stretch - at.ends.stretch;
  m.normal = at.normal, m.stretch = stretch;
  for (const std::size_t i : {0, 1}) {
    const HingeLaw& law = *hinge[i].law;
    const auto row = 2 * static_cast<Eigen::Index>(i);
    m.moment[i] = {hinge[i].scale * at.ends.moment[row], at.ends.moment[row + 1]};
    double work = 0;
    if (at.ends.flows[i]) {
      const SpaceFlow& f = at.ends.flow[i];
      m.turned[i] = {f.p[0] / hinge[i].scale, f.p[1]};
      m.reach[i] = std::max(before.reach[i], portable::hypot(f.p[0], f.p[1]));
      for (const std::size_t a : {0, 1})
        work += 0.5 * (m.moment[i][a] + before.moment[i][a]) * (m.turned[i][a] - before.turned[i][a]);
      work -= pull * law.beside(at.normal).slope * f.work;
    }
    work += 0.5 * corner * pull;
    const double stored_before = back_energy(law, before, i);
    m.dissipated[i] += std::max(0.0, work - (back_energy(law, m, i) - stored_before));
    if ((law.ultimate > 0 && m.reach[i] > law.ultimate) || law.kept(m.reach[i]) * law.worn(m.dissipated[i]) <= 0)
      m.gone[i] = 1;
    out.flowing[i] = at.ends.flows[i] || m.gone[i] != 0;
    const double stored = back_energy(law, m, i);
    out.stored += stored, out.dissipated += work - (stored - stored_before);
  }
}

/// A beam that is removed before or in this step: its elastic energy and the energy stored by hardening are dissipated.
EndHingeResponse3 removed_in_space(const BeamStiffness3& stiffness, const std::array<const HingeLaw*, 2>& law,
                                   const EndHingeMemory3& before) {
  EndHingeResponse3 out;
  out.memory = before;
  out.memory.normal = 0, out.memory.moment = {}, out.memory.gone = {2, 2}, out.flowing = {true, true};
  if (before.gone[0] > 1) return out;
  out.dissipated = held_energy(stiffness, before);
  for (const std::size_t i : {0, 1}) out.dissipated += back_energy(*law[i], before, i);
  return out;
}

}  // namespace

HingeStatus status_of(const EndHingeMemory3& memory, int end) {
  const auto i = static_cast<std::size_t>(end);
  if (memory.gone[i] > 1) return HingeStatus::removed;
  if (memory.gone[i] != 0) return HingeStatus::lost;
  constexpr double trace = 1e-6;  // as in the plane
  const double own = memory.dissipated[i], other = memory.dissipated[1 - i];
  return memory.reach[i] > 0 || own > trace * other ? HingeStatus::yielded : HingeStatus::elastic;
}

/// Bends that belong to the moments: (K + N d2(L q)) b = M about each axis, without pinned ends.
double held_energy(const BeamStiffness3& stiffness, const EndHingeMemory3& memory) {
  if (memory.gone[0] > 1) return 0;
  double sum = 0.5 * memory.normal * memory.normal / stiffness.axial;
  for (const std::size_t axis : {0, 1}) {
    EndHingeMemory plane;
    plane.normal = memory.normal, plane.moment = {memory.moment[0][axis], memory.moment[1][axis]};
    sum += held_energy(stiffness.bend[axis], plane) - 0.5 * memory.normal * memory.normal / stiffness.bend[axis].axial;
  }
  return sum;
}

EndHingeResponse3 respond(const BeamStiffness3& stiffness, const std::array<const HingeLaw*, 2>& law,
                          const BeamStrain3& strain, const EndHingeMemory3& before) {
  if ((law[0]->removes && before.gone[0] != 0) || (law[1]->removes && before.gone[1] != 0) || before.gone[0] > 1)
    return removed_in_space(stiffness, law, before);
  const Hinges hinge{hinge_of(*law[0], before, 0), hinge_of(*law[1], before, 1)};
  const SpaceBeamOfStep beam(stiffness, strain, {hinge[0].scale, hinge[1].scale});
  Bends p;
  p << hinge[0].from, hinge[1].from;
  const double trial = beam.axial * (beam.stretch + beam.bowed(p) - before.stretch);
  const SpaceReturned at = return_in_space(beam, hinge, before.stretch, trial);
  EndHingeResponse3 out;
  out.memory = before;
  const double stretch = beam.stretch + beam.bowed(at.ends.p) - at.normal / beam.axial;
  const bool flowed = at.ends.flows[0] || at.ends.flows[1] || at.normal != trial;
  const bool stretches = law[0]->has_axial() || law[1]->has_axial();
  book_in_space(hinge, at, flowed && stretches ? stretch : before.stretch, before, out);
  out.settled = at.ends.settled && (!at.held || stretches);
  const Bends bent = beam.turn - at.ends.p, moment = beam.factor.cwiseProduct(at.ends.moment);
  const double torque = stiffness.torsion * strain[5];
  out.stored += 0.5 * (at.normal * at.normal / beam.axial + bent.dot(beam.bend * bent) + torque * strain[5]);
  out.stress = {at.normal, moment[0], moment[1], moment[2], moment[3], torque};
  Eigen::Matrix<double, 5, 1> factor;
  factor << 1, beam.factor;
  out.tangent.topLeftCorner<5, 5>() = factor.asDiagonal() * tangent_in_space(beam, hinge, at) * factor.asDiagonal();
  out.tangent(5, 5) = stiffness.torsion;
  return out;
}

double gauge_of(const HingeLaw& law, const EndHingeMemory3& memory, int end, double worn) {
  if (!std::isfinite(law.sagging)) return 0;
  const auto i = static_cast<std::size_t>(end);
  SpaceHinge hinge = hinge_of(law, memory, i);
  hinge.worn = worn;
  return gauge(hinge, {memory.moment[i][0] / hinge.scale, memory.moment[i][1]}, law.beside(memory.normal).share);
}

}  // namespace trilith
