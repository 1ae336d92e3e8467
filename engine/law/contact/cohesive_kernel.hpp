// The equations of softening mortar, see law/contact/cohesive.hpp: opening, crushing, the step of two faces.
#pragma once

#include "law/contact/cohesive.hpp"

namespace trilith {

// Opening.

/// Mean of the parts of a half.
template <class T>
TRILITH_INLINE T mean_of_parts(const T* parts) {
  return (1.0 / bond_parts) * ((parts[0] + parts[1]) + (parts[2] + parts[3]));
}

/// True where some part of a half has lost strength.
template <class T>
TRILITH_INLINE Mask<T> lost_by_parts(const T* strengths) {
  const T one = T{} + 1.0;
  return smaller(smaller(strengths[0], strengths[1]), smaller(strengths[2], strengths[3])) < one;
}

/// Stress over kn that an intact bond adds to part i of a half with linear overlap from c0 to c1. It is the stress of
/// the whole part and of the mortar that fills it, without the closed length.
template <class T>
TRILITH_INLINE LinearStress<T> beyond_closed(const HalfState<T>& h, T c0, T c1, const HalfSpan<T>& closed, int i) {
  const T zero{}, begin = zero + part_start(i), end = zero + part_start(i + 1);
  const T from = smaller(larger(closed.from, begin), end), to = larger(from, smaller(closed.to, end));
  LinearStress<T> stress = HalfStress<T>::between(c0, c1, begin, end);
  const LinearStress<T> pressed = HalfStress<T>::between(c0, c1, from, to);
  const LinearStress<T> mortar = h.filling.within(part_start(i), part_start(i + 1)).stress();
  stress.sum += mortar.sum - pressed.sum, stress.moment += mortar.moment - pressed.moment;
  return stress;
}

/// Reduces strength and stiffness of a half by its openings. `damage`: of its parts before; `damaged` false: it is 0 in
/// all. Each part has the strength at which it carries the mean of the softening stresses over its open length. A half
/// without damage that opens nowhere beyond the elastic limit keeps its strength, and its parts are not visited.
template <class T>
TRILITH_INLINE void Cohesive::Kernel::soften_by_opening(HalfState<T>& h, const T* damage, bool damaged) const {
  const T zero{}, one = zero + 1.0, first = zero + first_opening();
  const bool opens = any(h.bonded & (h.widest() > first));
  h.damaged = damaged || opens;
  if (!h.damaged) {
    h.strength = select(h.bonded, one, zero);
    h.hold = select(h.bonded, zero + intact_hold, zero);
    return;
  }
  for (int i = 0; i < bond_parts; ++i) h.strengths[i] = one - damage[i];
  if (opens) {
    const T b0 = h.bond0(), rise = h.bond1() - b0;
    for (int i = 0; i < bond_parts; ++i) {
      const T from = b0 + rise * part_start(i), to = b0 + rise * part_start(i + 1);
      const T left = strength_left_over(smaller(from, to), larger(from, to), h.strengths[i]);
      h.strengths[i] = select(larger(from, to) > first, left, h.strengths[i]);
    }
  }
  h.strength = mean_of_parts(h.strengths);
  h.bonded = h.bonded & (h.strength > zero);
  h.strength = select(h.bonded, h.strength, zero);
  h.hold = held(h.strength);
}

/// Energy dissipated by an open half as its stiffness falls: exact for the mean of the forces at both ends of the step
/// [J]. `last`: opening by dilation that acts since this step [m].
template <class T>
TRILITH_INLINE T Cohesive::Kernel::opening_loss(const HalfState<T>& h, const T* damage, Mask<T> was_bonded,
                                                T last) const {
  const T zero{}, one = zero + 1.0, p0 = h.g0 - dt * h.m0 + last, p1 = h.g1 - dt * h.m1 + last;
  T lost = zero;
  Mask<T> falls = h.strengths[0] != one - damage[0];
  for (int i = 1; i < bond_parts; ++i) falls |= h.strengths[i] != one - damage[i];
  if (!any(was_bonded & falls)) return lost;
  for (int i = 0; i < bond_parts; ++i) {
    const T before = select(was_bonded, held(one - damage[i]), zero);
    const T fall = before - held(h.strengths[i]);
    lost += 0.5 * kn * fall * open_product(h, p0, p1, part_start(i), part_start(i + 1));
  }
  return lost;
}

// Crushing.

/// Crushes a half as its gaps require, and sets its gaps and rates to the elastic part. Returns the depth; `before`: so
/// far [m].
template <class T>
TRILITH_INLINE T Cohesive::Kernel::crush_half(HalfState<T>& h, T before) const {
  // Mortar that fills a half is also pressed in the filled part.
  const T c0 = select(h.bonded, -h.bond0(), -h.g0), c1 = select(h.bonded, -h.bond1(), -h.g1);
  T pressed_whole = 0.5 * (c0 + c1) - crushing, pressed_at_end = larger(c0, c1) - 2.0 * crushing;
  if (crush_slope > 0) {
    // The depth at which the mean overlap, which falls with it, meets the softened strength or its residual.
    pressed_whole = smaller(pressed_whole * (1.0 / (1.0 - crush_slope)), 0.5 * (c0 + c1) - crush_floor);
    pressed_at_end = smaller(pressed_at_end * (1.0 / (1.0 - 2.0 * crush_slope)), larger(c0, c1) - 2.0 * crush_floor);
  }
  const T most = T{} + crushing_depth;
  const T depth = larger(before, smaller(larger(pressed_whole, pressed_at_end), most));
  const T rate = (depth - before) * (dt > 0 ? 1.0 / dt : 0.0);
  h.g0 += depth, h.g1 += depth;
  h.r0 += rate, h.r1 += rate;
  h.m0 += rate, h.m1 += rate;
  return depth;
}

/// Mean elastic pressure over kn of a half with the gaps g0 and g1 at its ends. Where `bonded`, the bond of each part
/// carries its share over the whole part [m].
template <class T>
TRILITH_INLINE T Cohesive::Kernel::mean_overlap(const HalfState<T>& h, T g0, T g1, const T* strengths,
                                                Mask<T> bonded) const {
  const T zero{};
  const PositivePart<T> closed(-g0, -g1);
  T sum = HalfStress<T>::between(-g0, -g1, closed.from, closed.to).sum;
  for (int i = 0; i < bond_parts; ++i)
    sum += select(bonded, held(strengths[i]), zero) * beyond_closed<T>(h, -g0, -g1, {closed.from, closed.to}, i).sum;
  return sum;
}

/// As above before the step; `last`: see opening_loss.
template <class T>
TRILITH_INLINE T Cohesive::Kernel::overlap_before(const HalfState<T>& h, const T* damage, Mask<T> was_bonded,
                                                  T last) const {
  const T one = T{} + 1.0;
  T strengths[bond_parts];
  for (int i = 0; i < bond_parts; ++i) strengths[i] = one - damage[i];
  return mean_overlap(h, h.g0 - dt * h.m0 + last, h.g1 - dt * h.m1 + last, strengths, was_bonded);
}

/// Energy dissipated by a half whose crushed depth grows by `deeper` [m], with the mean pressure of both ends of the
/// step. `damage`: of its bond before the step; `last`: see opening_loss [J].
template <class T>
TRILITH_INLINE T Cohesive::Kernel::crushing_loss(const HalfState<T>& h, T deeper, const T* damage, Mask<T> was_bonded,
                                                 T last) const {
  const T before = overlap_before(h, damage, was_bonded, last);
  const T now = mean_overlap(h, h.g0, h.g1, h.strengths, h.bonded);
  return 0.5 * kn * h.length * deeper * (before + now);
}

/// An increase `deeper` of the crushed depth, cut where the strength reaches its residual: the search for the depth
/// takes the slope of one side of it.
inline double Cohesive::Kernel::up_to_residual(double depth, double deeper) const {
  if (!(crush_slope > 0)) return deeper;
  const double left = (crushing - crush_floor) / crush_slope - depth;
  return left > 1e-9 * crushing ? std::min(deeper, left) : deeper;
}

template <class Excess>
double Cohesive::Kernel::crush(double before, Excess&& excess) const {
  if (!(crushing > 0)) return before;
  double depth = before, over = excess(depth), fall = 1;
  for (int i = 0; i < 20 && over > 1e-9 * crushing; ++i) {
    // The mean overlap falls by as much as the depth grows where faces are parallel, by half as much at corners.
    const double deeper = up_to_residual(depth, over / fall), left = excess(depth + deeper);
    fall = std::clamp((over - left) / deeper, 0.3, 1.0);
    depth += deeper, over = left;
    if (crush_slope > 0 && !(crushing - crush_slope * depth > crush_floor)) fall = 1;  // it falls faster from here on
  }
  return std::max(before, std::min(depth, crushing_depth));
}

/// Uses the mean of the crushing force before and now, as the force at which overlap energy is dissipated.
inline double Cohesive::Kernel::crushed_by(const Memory<double>& own, double depth, double force, bool touched,
                                           bool general, Memory<double>& after) {
  const bool known = general && own.crushing_force > 0;  // otherwise it is assumed to equal the present force
  const double last = !touched ? 0.0 : known ? own.crushing_force : force;
  const double deeper = depth - crushed(own);
  after.crushing_force = force;
  for (double& half : after.crushed) half = depth;
  return 0.5 * (last + force) * deeper;
}

// The step of two faces.

/// State of softening mortar before its stresses: opened by dilation, crushed, and with the strength left by its
/// opening.
template <class T>
TRILITH_INLINE T Cohesive::Kernel::begin(FaceHalves<T>& halves, const FaceMemory<T>& before, const Memory<T>& own,
                                         Memory<T>& after) const {
  fill(halves, own.set);
  for (const int end : {0, 1}) after.set[end] = own.set[end];
  after.worn = own.worn;
  if (dilation > 0) halves.open_by(dilated(before.slip, own.worn));
  for (const int h : {0, 1}) {
    if (crushing > 0) after.crushed[h] = crush_half(halves.half[h], own.crushed[h]);
    soften_by_opening(halves.half[h], own.damage + h * bond_parts, own.may_be_damaged());
  }
  return T{};
}

/// Takes another stress where `which`.
template <class T>
TRILITH_INLINE void take(LinearStress<T>& stress, const LinearStress<T>& other, Mask<T> which) {
  stress.sum = select(which, other.sum, stress.sum);
  stress.moment = select(which, other.moment, stress.moment);
}

/// Stress over kn of a half with linear overlap from c0 to c1 whose parts hold different shares. `stress`: of its
/// closed length.
template <class T>
TRILITH_INLINE LinearStress<T> Cohesive::Kernel::bond_by_parts(const HalfState<T>& h, T c0, T c1,
                                                               const HalfSpan<T>& closed,
                                                               LinearStress<T> stress) const {
  for (int i = 0; i < bond_parts; ++i) {
    const T hold = held(h.strengths[i]);
    const LinearStress<T> more = beyond_closed(h, c0, c1, closed, i);
    stress.sum += hold * more.sum, stress.moment += hold * more.moment;
  }
  return stress;
}

/// The bond's share acts over the whole half, the rest on the closed part only. Halves of equal strength take one
/// share, others one for each part.
template <class T>
TRILITH_INLINE void Cohesive::Kernel::press(const HalfState<T>* halves, T* active, HalfResponse<T>* out) const {
  const T zero{}, one = zero + 1.0;
  PressedHalves<T> areas(halves, beta);
  if (crushing > 0) areas.apart(halves, beta);
  for (const int h : {0, 1}) {
    const HalfState<T>& half = halves[h];
    const T from = areas.from(h), to = areas.to(h);
    HalfStress<T> stress(half, beta, areas.closed.from[h], areas.closed.to[h], from, to);
    const LinearStress<T> mortar = half.filling.stress();
    LinearStress<T> bond(-half.g0, -half.g1, zero, one);
    LinearStress<T> bond_total(-half.g0 - beta * half.r0, -half.g1 - beta * half.r1, zero, one);
    add(bond, mortar, half.bonded), add(bond_total, mortar, half.bonded);
    const HalfStress<T> closed = stress;
    mix(stress.elastic, bond, half.hold);
    mix(stress.total, bond_total, half.hold);
    const Mask<T> by_parts = half.damaged ? half.bonded & lost_by_parts(half.strengths) : Mask<T>{};
    if (any(by_parts)) {
      const HalfSpan<T> shut{areas.closed.from[h], areas.closed.to[h]}, pressed{from, to};
      take(stress.elastic, bond_by_parts(half, -half.g0, -half.g1, shut, closed.elastic), by_parts);
      take(stress.total,
           bond_by_parts(half, -half.g0 - beta * half.r0, -half.g1 - beta * half.r1, pressed, closed.total), by_parts);
    }
    active[h] = select(half.bonded, one, areas.closed.to[h] - areas.closed.from[h]);
    stress.write(half, kn, out[h]);
  }
}

/// The shear slider of a half, bonded or not: its limit, and the spring and strength after sliding.
template <class T>
struct SofteningSlider {
  T limit;     ///< before sliding [N]
  T held;      ///< magnitude of the force where it slides [N]
  T elastic;   ///< its elastic part [N]
  T strength;  ///< remaining share of the strength
  T cohesive;  ///< energy dissipated by cohesion [J]

  /// `kept`, `move`: elastic force [N] and slip of the step [m], both along the trial force.
  TRILITH_INLINE SofteningSlider(const HalfState<T>& h, const Cohesive::Kernel& law, T normal, T compliance, T kept,
                                 T move) {
    const T zero{};
    const T friction = law.mu * larger(normal, zero) - law.tension_slope() * larger(-normal, zero);
    const T full = law.cohesion * h.length;
    limit = larger(zero, friction + full * h.strength);
    const double lag = law.dt + law.beta, rate = 1.0 / law.last_slip;
    const double loss = law.ks > 0 ? law.cohesion * rate / law.ks : 0.0;  // below 1: no snap-back
    const T drive = friction + full * (h.strength - rate * move) - kept;
    elastic = kept + drive * (law.dt > 0 ? law.dt / (lag - law.dt * loss) : 0.0);
    T slip = move - (elastic - kept) * compliance;
    strength = h.strength - rate * slip;
    held = friction + full * strength;
    // Where this step uses up cohesion, or tension leaves no strength, friction alone remains.
    const Mask<T> spent = flip(h.bonded) | (strength <= zero) | (held <= zero);
    held = select(spent, larger(zero, friction), held);
    elastic = select(spent, kept + (held - kept) * (law.dt > 0 ? law.dt / lag : 0.0), elastic);
    slip = larger(zero, move - (elastic - kept) * compliance);
    strength = select(h.bonded, smaller(h.strength, larger(zero, h.strength - rate * slip)), zero);
    cohesive = larger(zero, 0.5 * full * (h.strength + strength) + smaller(zero, friction)) * slip;
  }
};

/// Shear of a half with a softening bond; reduces the bond's strength. Returns the energy dissipated by cohesion [J].
template <class T>
TRILITH_INLINE T Cohesive::Kernel::slide(HalfState<T>& h, T active, const ShearBefore<T>& before,
                                         HalfResponse<T>& out) const {
  const T zero{}, one = zero + 1.0;
  const ShearTrial<T> trial(h, ks, beta, dt, active, before);
  const T sign = select(trial.total < zero, -one, one);
  const SofteningSlider<T> slider(h, *this, out.normal, trial.compliance.now, sign * trial.kept, sign * trial.move);
  const Mask<T> slides = magnitude(trial.total) > slider.limit;
  end_shear(trial, active, before, slides, sign * slider.held, sign * slider.elastic, out);
  // Slip takes the same share of the strength of all parts.
  if (any(slides & h.bonded)) {
    const T share = slider.strength * inverse_or_zero(h.strength);
    for (T& part : h.strengths) {
      const T had = h.damaged ? part : one;
      part = select(slides, had * share, had);
    }
    h.damaged = true;
  }
  h.strength = select(slides, slider.strength, h.strength);
  const T cohesive = select(slides, slider.cohesive, zero);
  out.lost_friction -= cohesive;
  return cohesive;
}

/// Strengths of the parts of a half after the step, 0 where it is no longer `bonded`, and their damage.
template <class T>
TRILITH_INLINE void Cohesive::Kernel::end_bond(HalfState<T>& h, Mask<T> bonded, T* damage) const {
  const T zero{}, one = zero + 1.0;
  for (int i = 0; i < bond_parts; ++i) {
    h.strengths[i] = h.damaged ? select(bonded, h.strengths[i], zero) : select(bonded, one, zero);
    damage[i] = h.damaged ? select(bonded, one - h.strengths[i], zero) : zero;
  }
}

/// Bonds after the stresses: the remaining strength, and the energy dissipated by bonds and crushing [J].
template <class T>
TRILITH_INLINE T Cohesive::Kernel::end(const FaceHalves<T>& halves, const FaceMemory<T>& before, const Memory<T>& own,
                                       FaceMemory<T>& memory, Memory<T>& after) const {
  const T zero{}, last = larger(zero, zero - own.worn);
  T lost = zero;
  after.set_damaged(halves.half[0].damaged || halves.half[1].damaged);
  for (const int k : {0, 1}) {
    const HalfState<T>& now = halves.half[k];
    const T deeper = after.crushed[k] - own.crushed[k];
    const bool crushes_now = crushing > 0 && any(deeper > zero);
    memory.bonds[k] = now.bonded & (now.strength > zero);
    if (!now.damaged && !crushes_now) continue;  // no damage, nothing lost; the state is not copied
    HalfState<T> h = now;
    const T* const damage = own.damage + k * bond_parts;
    end_bond(h, memory.bonds[k], after.damage + k * bond_parts);
    if (crushes_now) lost += crushing_loss(h, deeper, damage, before.bonds[k], last);
    if (h.damaged) lost += opening_loss(h, damage, before.bonds[k], last);
  }
  return lost;
}

/// Sliding does work against the pressure as it opens the joint. It is taken from friction.
///
/// The pressure P of an instant acts with the opening by the slip up to the step before, and so does its energy: P = kn
/// A u, E = kn A u^2 / 2. In the next step the opening d by the last slip is added to the overlap u, and the faces part
/// under the mean of both pressures. The sum of energies is constant if friction loses d (P + P') / 2. Where the faces
/// part in this step, P' is 0: energy that the joint has not received yet is not lost.
template <class T>
TRILITH_INLINE T Cohesive::Kernel::lifting(const FaceHalves<T>& halves, const FaceMemory<T>& before,
                                           const FaceMemory<T>& memory, const Memory<T>& own, const HalfResponse<T>* s,
                                           Memory<T>& after) const {
  if (!(dilation > 0)) return T{};
  const T zero{}, opened = dilated(memory.slip, own.worn) - dilated(before.slip, own.worn);
  const T last = larger(zero, zero - own.worn);
  T pressure = s[0].normal - s[0].damping + s[1].normal - s[1].damping;
  for (const int k : {0, 1}) {
    const HalfState<T>& h = halves.half[k];
    pressure += kn * h.length * overlap_before(h, own.damage + k * bond_parts, before.bonds[k], last);
  }
  after.worn = select(own.worn > zero, own.worn, zero - opened);
  return 0.5 * last * pressure;
}

/// Largest damage of all parts of a bond.
template <class T>
TRILITH_INLINE T most_damage(const Cohesive::Kernel::Memory<T>& m) {
  T most{};
  for (const T& part : m.damage) most = larger(most, part);
  return most;
}

/// A bond lost, first damage of a bond, or first crushing.
template <class T>
TRILITH_INLINE Mask<T> Cohesive::Kernel::changes(const FaceMemory<T>& before, const Memory<T>& own,
                                                 const FaceMemory<T>& memory, const Memory<T>& after) {
  const T none{};
  Mask<T> turns = (before.bonds[0] != memory.bonds[0]) | (before.bonds[1] != memory.bonds[1]);
  if (after.may_be_damaged()) turns |= (most_damage(own) <= none) & (most_damage(after) > none);
  turns |= (larger(own.crushed[0], own.crushed[1]) <= none) & (larger(after.crushed[0], after.crushed[1]) > none);
  return turns;
}

}  // namespace trilith
