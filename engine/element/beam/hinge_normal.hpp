// The normal force of a beam with hinges, in the plane and in space: the root of one increasing equation, or the apex
// of the surface. The caller computes the ends for each normal force.
#pragma once

#include <algorithm>
#include <cmath>

#include "element/beam/hinge_law.hpp"

namespace trilith {

struct NormalRange {
  double low = -unbounded, high = unbounded;  ///< [N]
};

/// Normal forces at which every hinge with a surface still carries some moment.
inline NormalRange normal_range(const HingeLaw& first, const HingeLaw& second) {
  NormalRange out;
  for (const HingeLaw* const law : {&first, &second})
    if (law->has_axial())
      out.low = std::max(out.low, law->least_normal()), out.high = std::min(out.high, law->most_normal());
  return out;
}

/// N and both ends; `held` where N is at a corner of the surface, whatever the stretch.
template <class Ends>
struct ReturnedNormal {
  double normal;  ///< [N]
  Ends ends;
  bool held = false;
};

/// The zero of `missing` between `at.low` (negative) and `at.high` (positive): false position, with bisection where
/// that is slow. `size` [N]: scale of the forces, for rounding.
template <class Ends, class EndsAt, class Missing>
ReturnedNormal<Ends> find_normal(NormalRange at, double below, double above, double size, ReturnedNormal<Ends> out,
                                 const EndsAt& ends_at, const Missing& missing) {
  double width = at.high - at.low, last = 0;
  for (int i = 0; i < 200; ++i) {
    const double now = missing(out.normal, out.ends);
    if (now == 0 || std::abs(now) <= 2e-15 * size) return out;
    if (i > 0 && (now < 0) == (last < 0)) (now < 0 ? above : below) *= 0.5;  // Illinois method
    (now < 0 ? at.low : at.high) = out.normal;
    (now < 0 ? below : above) = last = now;
    if (at.high - at.low <= 4e-16 * size) break;
    double next = at.low - below * (at.high - at.low) / (above - below);
    if (i % 3 == 2 && at.high - at.low > 0.25 * width) next = 0.5 * (at.low + at.high);
    if (i % 3 == 2) width = at.high - at.low;
    if (!(next > at.low && next < at.high)) next = 0.5 * (at.low + at.high);
    if (next == at.low || next == at.high) break;
    out = {next, ends_at(next)};
  }
  out.held = std::abs(missing(out.normal, out.ends)) > 1e-9 * size;
  return out;
}

/// Starts from `trial` [N], the elastic normal force clipped to the range. If that is not the solution, finds a bracket
/// from there and its root. `ends_at(N)` computes the ends at N. `missing(N, ends)` [N] increases with N and is 0 where
/// N is the force of the remaining elastic stretch. `pull` [N]: the force of the whole stretch, for rounding.
template <class EndsAt, class Missing>
auto normal_beside_hinges(const NormalRange& range, double trial, double pull, const EndsAt& ends_at,
                          const Missing& missing) {
  using Returned = ReturnedNormal<decltype(ends_at(trial))>;
  const double first = std::clamp(trial, range.low, range.high);
  Returned at{first, ends_at(first)};
  const double now = missing(first, at.ends);
  const double rounding = 2e-15 * (std::abs(trial) + pull);
  if (std::abs(now) <= rounding) return at;
  // The sign of `now` gives the side of the root: at the end of the range, or found by a growing step.
  double other = first, there = now, step = std::abs(now);
  for (int i = 0; i < 200 && there * now > 0; ++i) {
    const double next = std::clamp(first - std::copysign(step, now), range.low, range.high);
    if (next == other) return Returned{next, ends_at(next), true};  // the apex
    other = next, there = missing(other, ends_at(other)), step *= 4;
  }
  if (there * now > 0) return at.ends.settled = false, at;
  const bool up = now < 0;
  const NormalRange between{up ? first : other, up ? other : first};
  const double below = up ? now : there, above = up ? there : now;
  const double start = between.low - below * (between.high - between.low) / (above - below);
  const double size = std::max({std::abs(between.low), std::abs(between.high), pull});
  return find_normal(between, below, above, size, Returned{start, ends_at(start)}, ends_at, missing);
}

}  // namespace trilith
