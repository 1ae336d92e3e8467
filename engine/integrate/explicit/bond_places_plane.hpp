// Points of bonds in the plane: for each half of two faces, the middle in shear, and in tension the wider end of the
// half, or of each of its parts once they have softened.
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "assembly/contact/contact_rows.hpp"
#include "integrate/explicit/bond_places.hpp"
#include "law/contact/face_motion.hpp"
#include "law/contact/list.hpp"

namespace trilith {

/// Velocities of two faces; after an implicit step, the mean velocities over the step.
inline FaceRates<double> bond_rates(const Work<2>& work, const NearPair& p, const FaceOverlap<double>& overlap) {
  FaceEnds<double> a = face_ends(work, p.a0, p.a1), b = face_ends(work, p.b0, p.b1);
  if (!work.skin_mean.empty()) {
    const auto over_step = [&](int from, int to, FaceEnds<double>& ends) {
      const Vec2 &u = work.skin_mean[from], &v = work.skin_mean[to];
      ends.u0 = u.x(), ends.v0 = u.y(), ends.u1 = v.x(), ends.v1 = v.y();
    };
    over_step(p.a0, p.a1, a), over_step(p.b0, p.b1, b);
  }
  return {overlap, a, b};
}

/// The ends of a half or of a part of it, with openings `end` [m] and their rates [m/s]: the wider end, and where the
/// motion ahead is asked for, the faster one.
template <class F>
void bonds_of_ends(const std::array<double, 2>& end, const std::array<double, 2>& rate, double dt_behind,
                   PlacedBond bond, F&& f) {
  const std::size_t wider = end[1] + dt_behind * rate[1] > end[0] + dt_behind * rate[0] ? 1 : 0;
  bond.at = end[wider], bond.rate = rate[wider], f(bond);
  if (dt_behind == 0 && rate[1 - wider] > rate[wider]) bond.at = end[1 - wider], bond.rate = rate[1 - wider], f(bond);
}

/// Points of one half face of `length` [m]. `left`: remaining strength shares of its parts, or of all of it; `rate`: of
/// the gap at both ends [m/s]; `slip`: slip rate at the middle [m/s].
template <class K, class F>
void bonds_of_half(const K& law, const HalfGaps& gaps, std::span<const double> left, double elastic, double length,
                   const std::array<double, 2>& rate, double slip, double dt_behind, PlacedBond bond, F&& f) {
  const std::array<double, 2> end = {gaps.g0 - gaps.filling.end0, gaps.g1 - gaps.filling.end1};
  const double parts = static_cast<double>(left.size());
  const double share = bond.share;
  bond.share = share / parts;
  double strength = 0;
  for (std::size_t i = 0; i < left.size(); ++i) {
    strength += left[i] / parts;
    if (!(left[i] > 0)) continue;
    const double a = static_cast<double>(i) / parts, b = static_cast<double>(i + 1) / parts;
    const auto at = [&](const std::array<double, 2>& v, double s) { return (1 - s) * v[0] + s * v[1]; };
    bond.curve = tension_curve(law, left[i]);
    bonds_of_ends({at(end, a), at(end, b)}, {at(rate, a), at(rate, b)}, dt_behind, bond, f);
  }
  bond.share = share;
  const double mean = 0.5 * (end[0] + end[1]);
  bond.curve = shear_curve(law, strength, std::max(-mean, 0.0), std::max(mean, 0.0));
  if (!(bond.curve.top > 0) || !(length > 0)) return;
  const double u = elastic / (law.ks * length);
  bond.at = u * slip < 0 ? -std::abs(u) : std::abs(u), bond.rate = std::abs(slip);
  f(bond);
}

/// Calls f for the points of the bonds of one pair of faces, see each_bond. `law`: kernel of the pair's law.
template <class K, class F>
void bonds_of_row(const K& law, const ContactHistory& history, std::size_t row, const FaceOverlap<double>& overlap,
                  const FaceRates<double>& r, double back, PlacedBond bond, F&& f) {
  const ContactMemory& memory = history.memory[row];
  const auto own = law_memory<K>(history.law_numbers(row));
  const std::array<HalfGaps, 2> gaps = law.gaps(overlap, memory, own);
  const double middle = 0.5 * (r.gap_lo + r.gap_hi);
  for (const int h : {0, 1}) {
    if (!memory.bonded(h)) continue;
    const std::array<double, 2> rate = {h == 0 ? r.gap_lo : middle, h == 0 ? middle : r.gap_hi};
    HalfGaps then = gaps[h];
    then.g0 -= back * rate[0], then.g1 -= back * rate[1];
    std::array<double, K::parts> left;
    left.fill(1);
    if constexpr (K::softens)
      for (int i = 0; i < K::parts; ++i) left[i] = 1 - own.damage[h * K::parts + i];
    // While a half is intact its wider end reaches the strength first.
    const bool whole = *std::min_element(left.begin(), left.end()) >= 1;
    const double slip = (h == 0 ? 0.75 : 0.25) * r.slip_lo + (h == 0 ? 0.25 : 0.75) * r.slip_hi;
    bonds_of_half(law, then, {left.data(), whole ? 1 : left.size()}, memory.shear_elastic[h], 0.5 * overlap.shared,
                  rate, slip, back, bond, f);
  }
}

/// Calls f(PlacedBond) as each_bond does, but not for pairs of faces for which skips(row, bond, overlap, rates) is
/// true.
template <class Skips, class F>
void each_bond_but(const Model<2>& model, const State<2>& state, const Work<2>& work, bool after, double dt,
                   Skips&& skips, F&& f) {
  const ContactHistory& history = after ? work.contacts : contacts_before(state, work);
  for (std::size_t row = 0; row < work.pairs.size(); ++row) {
    if (history.memory[row].bonds == 0) continue;
    const NearPair& p = work.pairs[row];
    const FaceOverlap<double> overlap = face_overlap(work, p);
    if (!(overlap.shared > 0)) continue;
    const FaceRates<double> r = bond_rates(work, p, overlap);
    PlacedBond bond;
    bond.share = 0.5, bond.row = static_cast<int>(row);
    bond.size = overlap.shared, bond.body_a = model.piece_body[p.piece_a], bond.body_b = model.piece_body[p.piece_b];
    if (skips(row, bond, overlap, r)) continue;
    with_kernel(law_in_use(model, p.law, dt), [&]<class K>(const K& law) {
      if constexpr (K::bonds) bonds_of_row(law, history, row, overlap, r, after ? 0 : dt, bond, f);
    });
  }
}

template <class F>
void each_bond(const Model<2>& model, const State<2>& state, const Work<2>& work, bool after, double dt, F&& f) {
  each_bond_but(
      model, state, work, after, dt, [](const auto&...) { return false; }, f);
}

}  // namespace trilith
