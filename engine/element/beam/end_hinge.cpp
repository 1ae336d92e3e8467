#include "element/beam/end_hinge.hpp"

#include <Eigen/LU>

#include <algorithm>

#include "element/beam/hinge_normal.hpp"

namespace trilith {

namespace {

// Nested searches:
//
//     flow_towards     one end, with N and the other end given: p along the linear pieces of its law
//     ends_at          both ends, with N given: in turn until neither changes
//     return_to_laws   N: the root of N - EA/L (u + L q - p_u), which increases with N (element/beam/hinge_normal.hpp)
//
// Then book_flow updates memory and energies, and returned_tangent gives the tangent. Signs here: bends and moments are
// positive where the bottom lengthens; at end 0 the sign is opposite to the beam's.

/// A hinge during one step.
struct HingeStep {
  const HingeLaw* law;
  double from;   ///< p before the step [rad]
  double reach;  ///< before the step [rad]
  double worn;   ///< D due to energy [1]
  bool gone;

  [[nodiscard]] double kept(double p) const { return gone ? 0.0 : worn * law->kept(std::max(reach, std::abs(p))); }
  /// dM/dc on the side `way` [N m].
  [[nodiscard]] double width(int way, double p) const {
    return kept(p) * law->width(way, std::max(reach, std::abs(p)));
  }
  /// Moment capacity towards `way` at p, positive in that direction [N m].
  [[nodiscard]] double most(int way, double p, double share) const {
    return kept(p) * way * law->back(p) + width(way, p) * share;
  }
};

/// Flow of a hinge.
struct HingeFlow {
  double p = 0;                       ///< [rad]
  int way = 0;                        ///< -1, 1; 0: no flow
  double slope = 0;                   ///< of the moment capacity towards `way`, by rotation in that direction [N m/rad]
  double width = 0, width_slope = 0;  ///< dM/dc [N m], and its derivative by rotation
};

/// p where `trial` - stiffness (p - from) equals the moment capacity towards `way`: exact on each linear piece of the
/// law.
HingeFlow flow_towards(const HingeStep& end, int way, double trial, double stiffness, double share) {
  // q = way p grows from the hinge's previous position. `gap` is the excess of the elastic moment, which falls along
  // the way, over the capacity `most`. The solution is at the zero of `gap`.
  //
  //     M |  .                     .   elastic: trial - stiffness (q - from)
  //       |     .  ___-o---.       o   most: bends at the cap, where r begins to grow, where softening ends
  //       | ___-o  .        `o---
  //       +---------------------- q
  const double cap = end.law->cap();
  std::array<double, 5> corner{-cap, cap, end.reach, -end.reach,
                               cap + (end.law->capping > 0 ? end.law->softening : 0.0)};
  std::sort(corner.begin(), corner.end());
  double q = way * end.from, most = end.most(way, end.from, share), gap = way * trial - most;
  const double step = std::max({1.0, 2 * std::abs(q), end.law->capping + end.law->softening, end.reach});
  HingeFlow out;
  out.way = way;
  bool found = false;
  const auto follow = [&](double to, bool last) {
    const double next = end.most(way, way * to, share), gap_next = gap - stiffness * (to - q) - (next - most);
    out.slope = (next - most) / (to - q);
    out.width_slope = (end.width(way, way * to) - end.width(way, way * q)) / (to - q);
    found = last || gap_next <= 0;
    q = found ? q + (to - q) * gap / (gap - gap_next) : to;
    most = next, gap = gap_next;
  };
  for (std::size_t i = 0; i < corner.size() && !found; ++i)
    if (std::isfinite(corner[i]) && corner[i] > q) follow(corner[i], false);
  if (!found) follow(q + step, true);  // the last piece is unbounded
  out.p = way * q;
  out.width = end.width(way, out.p);
  return out;
}

HingeFlow flow_of(const HingeStep& end, double trial, double stiffness, double share) {
  for (const int way : {1, -1})
    if (stiffness > 0 && way * trial > end.most(way, end.from, share))
      return flow_towards(end, way, trial, stiffness, share);
  return {.p = end.from};
}

/// The beam with signs where bends are positive as the bottom lengthens.
struct BeamOfStep {
  double axial;
  Eigen::Matrix2d bend, bow;  ///< K; second derivatives of L q
  double stretch;             ///< [m]
  Eigen::Vector2d turn;       ///< [rad]

  BeamOfStep(const BeamStiffness& k, const BeamStrain& d) : axial(k.axial), stretch(d[0]), turn(-d[1], d[2]) {
    bend << k.bend[0], -k.bend[1], -k.bend[1], k.bend[2];
    bow << 2 * k.bow[0], -k.bow[1], -k.bow[1], 2 * k.bow[2];
  }
  [[nodiscard]] double bowed(const Eigen::Vector2d& p) const { return 0.5 * (turn - p).dot(bow * (turn - p)); }
};

/// Both ends at a given normal force.
struct EndsAt {
  std::array<HingeFlow, 2> end;
  Eigen::Vector2d p, moment;
  double stretch = 0;  ///< plastic stretch due to the flow of both ends in this step [m]
  bool settled = true;
};

/// Bending by K + N d2(L q)/dtheta2: tension stiffens, compression softens.
EndsAt ends_at(const BeamOfStep& beam, const std::array<HingeStep, 2>& hinge, double normal) {
  constexpr int most_turns = 400;
  constexpr double done = 1e-14;
  const Eigen::Matrix2d k = beam.bend + normal * beam.bow;
  const std::array<double, 2> share{hinge[0].law->beside(normal).share, hinge[1].law->beside(normal).share};
  EndsAt out;
  out.p = {hinge[0].from, hinge[1].from};
  const double size = done * (beam.turn.cwiseAbs().sum() + out.p.cwiseAbs().sum());
  out.settled = false;
  for (int turn = 0; turn < most_turns && !out.settled; ++turn) {
    const Eigen::Vector2d was = out.p;
    for (const int i : {0, 1}) {
      const double trial = k(i, i) * (beam.turn[i] - hinge[i].from) + k(i, 1 - i) * (beam.turn[1 - i] - out.p[1 - i]);
      out.end[i] = flow_of(hinge[i], trial, k(i, i), share[i]);
      out.p[i] = out.end[i].p;
    }
    const Eigen::Vector2d gone = out.p - was;
    out.settled = gone.cwiseAbs().maxCoeff() <= size;
    // While both flow on the same linear pieces the changes form a geometric series, whose limit is known.
    const double ratio = k(0, 1) * k(0, 1) / ((k(0, 0) + out.end[0].slope) * (k(1, 1) + out.end[1].slope));
    if (turn > 0 && !out.settled && out.end[0].way != 0 && out.end[1].way != 0 && std::abs(ratio) < 0.99)
      out.p[1] += gone[1] * ratio / (1 - ratio);
  }
  out.moment = k * (beam.turn - out.p);
  for (const int i : {0, 1})
    for (const int way : {1, -1}) {
      const double most = hinge[i].most(way, out.p[i], share[i]);
      // A beam beyond its own buckling load has no stiffness for the return.
      if (way * out.moment[i] - most > 1e-9 * (std::abs(most) + hinge[i].law->sagging)) out.settled = false;
    }
  for (const int i : {0, 1})
    out.stretch -= hinge[i].law->beside(normal).slope * out.end[i].width * std::abs(out.p[i] - hinge[i].from);
  return out;
}

using Returned = ReturnedNormal<EndsAt>;

/// Increases with N; 0 where the normal force is that on the remaining elastic stretch.
double missing(const BeamOfStep& beam, double plastic, double normal, const EndsAt& ends) {
  return normal - beam.axial * (beam.stretch + beam.bowed(ends.p) - plastic - ends.stretch);
}

Returned return_to_laws(const BeamOfStep& beam, const std::array<HingeStep, 2>& hinge, double plastic, double trial) {
  return normal_beside_hinges(
      normal_range(*hinge[0].law, *hinge[1].law), trial, beam.axial * std::abs(beam.stretch),
      [&](double normal) { return ends_at(beam, hinge, normal); },
      [&](double normal, const EndsAt& ends) { return missing(beam, plastic, normal, ends); });
}

/// d (N, M_0, M_1) / d (u, theta_0, theta_1) after the return, in the signs of the step.
Eigen::Matrix3d returned_tangent(const BeamOfStep& beam, const std::array<HingeStep, 2>& hinge, const Returned& at) {
  const Eigen::Matrix2d k = beam.bend + at.normal * beam.bow;
  const Eigen::Vector2d arm = beam.bow * (beam.turn - at.ends.p);  // derivative of L q with respect to the bends
  if (at.ends.end[0].way == 0 && at.ends.end[1].way == 0 && !at.held) {
    const Eigen::Vector3d pulled(1, arm[0], arm[1]);
    Eigen::Matrix3d elastic = beam.axial * (pulled * pulled.transpose());
    elastic.bottomRightCorner<2, 2>() += k;
    return elastic;
  }
  // Unknown: dN, dp_0, dp_1. Given: du, dtheta_0, dtheta_1. Row 0: N = EA/L (u + L q - p_u), with p_u by the flow at
  // both ends; or dN = 0 at the apex. Row 1 + i: where end i flows, its moment stays at its capacity; otherwise dp_i =
  // 0.
  Eigen::Matrix3d left = Eigen::Matrix3d::Identity(), right = Eigen::Matrix3d::Zero();
  if (!at.held) {
    left.row(0) << 1, beam.axial * arm[0], beam.axial * arm[1];
    right.row(0) << beam.axial, beam.axial * arm[0], beam.axial * arm[1];
  }
  for (const int i : {0, 1}) {
    const HingeFlow& f = at.ends.end[i];
    if (f.way == 0) continue;
    const AxialShare c = hinge[i].law->beside(at.normal);
    const double slid = std::abs(f.p - hinge[i].from);
    if (!at.held) {
      left(0, 0) -= beam.axial * c.bend * f.width * slid;
      left(0, 1 + i) -= beam.axial * c.slope * f.way * (f.width + f.width_slope * slid);
    }
    left(1 + i, 0) = arm[i] - f.way * f.width * c.slope;
    left.block<1, 2>(1 + i, 1) = -k.row(i);
    left(1 + i, 1 + i) -= f.slope;
    right.block<1, 2>(1 + i, 1) = -k.row(i);
  }
  const Eigen::Matrix3d moved = left.partialPivLu().solve(right);
  Eigen::Matrix3d out;
  out.row(0) = moved.row(0);
  out.bottomRows<2>() = arm * moved.row(0) - k * moved.bottomRows<2>();
  out.bottomRightCorner<2, 2>() += k;
  return out;
}

double back_energy(const HingeStep& end, double p) {
  return end.kept(p) * end.law->stored(p);
}

HingeStep step_of(const HingeLaw& law, const EndHingeMemory& m, int i) {
  return {&law, m.turned[i], m.reach[i], law.worn(m.dissipated[i]), m.gone[i] != 0};
}

/// Memory and energies after the return; `normal` and the moments hold at the end of the step. The work on the flow, by
/// mean moments and mean N, is the increase of the energy stored by hardening plus the dissipated energy. Dissipation
/// wears the hinge from the next step on.
void book_flow(const std::array<HingeStep, 2>& hinge, const Returned& at, double stretch, const EndHingeMemory& before,
               EndHingeResponse& out) {
  EndHingeMemory& m = out.memory;
  const double pull = 0.5 * (at.normal + before.normal), by_flow = at.ends.stretch;
  m.normal = at.normal, m.stretch = stretch;
  // Half of the stretch added at a corner of the surface is assigned to each end.
  const double corner = stretch - before.stretch - by_flow;
  for (const int i : {0, 1}) {
    const HingeFlow& f = at.ends.end[i];
    const double turned = f.p - hinge[i].from;
    const double slid = 0.5 * corner - hinge[i].law->beside(at.normal).slope * f.width * std::abs(turned);
    m.moment[i] = at.ends.moment[i], m.turned[i] = f.p;
    m.reach[i] = std::max(before.reach[i], std::abs(f.p));
    const double stored_before = back_energy(hinge[i], before.turned[i]);
    const double work = 0.5 * (m.moment[i] + before.moment[i]) * turned + pull * slid;
    m.dissipated[i] += std::max(0.0, work - (back_energy(hinge[i], f.p) - stored_before));
    const HingeLaw& law = *hinge[i].law;
    if ((law.ultimate > 0 && m.reach[i] > law.ultimate) || law.kept(m.reach[i]) * law.worn(m.dissipated[i]) <= 0)
      m.gone[i] = 1;
    out.yielding = out.yielding || f.way != 0;
    const double stored = back_energy(step_of(law, m, i), f.p);
    out.stored += stored, out.dissipated += work - (stored - stored_before);
  }
}

}  // namespace

HingeStatus status_of(const EndHingeMemory& memory, int end) {
  if (memory.gone[end] > 1) return HingeStatus::removed;
  if (memory.gone[end] != 0) return HingeStatus::lost;
  // The stretch belongs to both ends. The energy dissipated by an end shows whether its own law let it flow; rounding
  // leaves the other end a trace of it.
  constexpr double trace = 1e-6;
  const double own = memory.dissipated[end], other = memory.dissipated[1 - end];
  return memory.reach[end] > 0 || own > trace * other ? HingeStatus::yielded : HingeStatus::elastic;
}

/// Bends that belong to the moments: (K + N d2(L q)) b = M, without pinned ends.
double held_energy(const BeamStiffness& stiffness, const EndHingeMemory& memory) {
  if (memory.gone[0] > 1) return 0;
  const BeamOfStep beam(stiffness, {});
  const Eigen::Matrix2d k = beam.bend + memory.normal * beam.bow;
  const Eigen::Vector2d moment(memory.moment[0], memory.moment[1]);
  Eigen::Vector2d bent = Eigen::Vector2d::Zero();
  if (k(0, 0) > 0 && k(1, 1) > 0)
    bent = k.inverse() * moment;
  else
    for (const int i : {0, 1}) bent[i] = k(i, i) > 0 ? moment[i] / k(i, i) : 0;
  return 0.5 * (memory.normal * memory.normal / beam.axial + bent.dot(beam.bend * bent));
}

namespace {

/// A beam that is removed before or in this step: its elastic energy and the energy stored by hardening are dissipated.
EndHingeResponse removed(const BeamStiffness& stiffness, const std::array<const HingeLaw*, 2>& law,
                         const EndHingeMemory& before) {
  EndHingeResponse out;
  out.memory = before;
  out.memory.normal = 0, out.memory.moment = {}, out.memory.gone = {2, 2};
  if (before.gone[0] > 1) return out;
  out.dissipated = held_energy(stiffness, before);
  for (const int i : {0, 1}) out.dissipated += back_energy(step_of(*law[i], before, i), before.turned[i]);
  return out;
}

}  // namespace

EndHingeResponse respond(const BeamStiffness& stiffness, const std::array<const HingeLaw*, 2>& law,
                         const BeamStrain& strain, const EndHingeMemory& before) {
  if ((law[0]->removes && before.gone[0] != 0) || (law[1]->removes && before.gone[1] != 0) || before.gone[0] > 1)
    return removed(stiffness, law, before);
  const BeamOfStep beam(stiffness, strain);
  const std::array<HingeStep, 2> hinge{step_of(*law[0], before, 0), step_of(*law[1], before, 1)};
  const Eigen::Vector2d p(before.turned[0], before.turned[1]);
  const double trial = beam.axial * (beam.stretch + beam.bowed(p) - before.stretch);
  const Returned at = return_to_laws(beam, hinge, before.stretch, trial);
  EndHingeResponse out;
  out.memory = before;
  const double stretch = beam.stretch + beam.bowed(at.ends.p) - at.normal / beam.axial;
  const bool flowed = at.ends.end[0].way != 0 || at.ends.end[1].way != 0 || at.normal != trial;
  const bool stretches = law[0]->has_axial() || law[1]->has_axial();
  book_flow(hinge, at, flowed && stretches ? stretch : before.stretch, before, out);
  out.yielding = flowed;
  out.settled = at.ends.settled && (!at.held || stretches);
  const Eigen::Vector2d bent = beam.turn - at.ends.p;
  out.stored += 0.5 * (at.normal * at.normal / beam.axial + bent.dot(beam.bend * bent));
  out.stress = {at.normal, -at.ends.moment[0], at.ends.moment[1]};
  out.tangent = returned_tangent(beam, hinge, at);
  // Back to the beam's signs.
  out.tangent.row(1) *= -1, out.tangent.col(1) *= -1;
  return out;
}

}  // namespace trilith
