// Response of fibres of one law, four at a time. A sum over fibres adds one after the other, so it has the same bits as
// a loop over single fibres.
#pragma once

#include <concepts>
#include <span>

#include "base/simd/lane_rows.hpp"
#include "base/simd/registers.hpp"
#include "law/fibre/concrete_lanes.hpp"

namespace trilith {

/// Sums of four quantities over fibres.
struct FourSums {
  Lanes sum;

  /// Adds the quantities of four fibres, each in its lane.
  TRILITH_INLINE void add(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d) {
    const FourByFour fibre(a, b, c, d);
    sum += fibre.v[0];
    sum += fibre.v[1];
    sum += fibre.v[2];
    sum += fibre.v[3];
  }
};

/// All whole fours of the fibres. `Sums` is made of the strain of the section and the response so far; it has
/// strain(four fibres) and add(four fibres, response), and take() returns the sums.
template <class Sums, class Envelope, class Fibre, class Strain, class Response>
TRILITH_INLINE void respond_by_fours(const ConcreteLanes<Envelope>& law, std::span<const Fibre> fibres,
                                     const Strain& strain, const double* before, double* after, Response& out) {
  Sums sums(strain, out);
  ConcreteFourResponse r;
  for (std::size_t i = 0; i + lane_count <= fibres.size(); i += lane_count) {
    const double* const from = before + i * concrete_memory;
    const FourByFour m(load_lanes(from), load_lanes(from + 4), load_lanes(from + 8), load_lanes(from + 12));
    law.respond(sums.strain(&fibres[i]), {m.v[0], m.v[1], m.v[2], m.v[3]}, r);
    const FourByFour rows(r.memory.strain, r.memory.stress, r.memory.squeezed, r.memory.opened);
    for (std::size_t k = 0; k < lane_count; ++k) store_lanes(after + (i + k) * concrete_memory, rows.v[k]);
    sums.add(&fibres[i], r);
  }
  sums.take(out);
}

// One copy for wide registers and one for any machine: the same operations, so the same bits.

template <class Sums, class Fibre, class Strain, class Response>
void respond_narrow(const KentPark& law, std::span<const Fibre> fibres, const Strain& strain, const double* before,
                    double* after, Response& out) {
  respond_by_fours<Sums>(ConcreteLanes(KentParkEnvelope(law)), fibres, strain, before, after, out);
}
#ifdef __x86_64__
template <class Sums, class Fibre, class Strain, class Response>
[[gnu::target("avx2")]] void respond_wide(const KentPark& law, std::span<const Fibre> fibres, const Strain& strain,
                                          const double* before, double* after, Response& out) {
  respond_by_fours<Sums>(ConcreteLanes(KentParkEnvelope(law)), fibres, strain, before, after, out);
}
#endif

/// Adds the response of all whole fours of the fibres to `out`; returns their number. 0 for a law without lanes.
template <class Sums, class L, class Fibre, class Strain, class Response>
std::size_t respond_in_lanes(const L& law, std::span<const Fibre> fibres, const Strain& strain, const double* before,
                             double* after, Response& out) {
  if constexpr (std::same_as<L, KentPark>) {
#ifdef __x86_64__
    static const bool wide = registers_here() != Registers::narrow;
    if (wide)
      respond_wide<Sums>(law, fibres, strain, before, after, out);
    else
#endif
      respond_narrow<Sums>(law, fibres, strain, before, after, out);
    return fibres.size() - fibres.size() % lane_count;
  } else {
    return 0;
  }
}

}  // namespace trilith
