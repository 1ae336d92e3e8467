// Four concrete fibres at once: concrete_cycle.hpp and kent_park.hpp in SIMD lanes.
//
// Each lane executes the operations of the scalar law in the same order, so it has the same bits
// (tests/law/material/concrete_lanes_test.cpp). Both sides of a branch are computed and one is selected; parts that no
// lane needs are left out.
#pragma once

#include "base/simd/lanes.hpp"
#include "law/fibre/kent_park.hpp"

namespace trilith {

/// Memories of four fibres, see concrete_cycle.hpp.
struct ConcreteFour {
  Lanes strain, stress, squeezed, opened;
};

struct ConcreteFourResponse {
  ConcreteFour memory;
  Lanes tangent, stored, dissipated;  ///< as in UniaxialResponse
  LaneMask yielding;
};

/// The envelope of KentPark, with the constants of a law.
class KentParkEnvelope {
 public:
  explicit KentParkEnvelope(const KentPark& law)
      : initial(law.initial()),
        peak(law.peak_strain()),
        tension(law.tension),
        tension_end(law.tension_end),
        top_(law.confinement * law.strength),
        ultimate_(law.ultimate),
        rest_(law.residual * top_),
        slope_((law.residual - 1) * top_ / (law.ultimate - peak)) {}

  const double initial, peak, tension, tension_end;  // initial modulus [Pa], strain at the peak, and of the law

  /// Stress and slope at the compressive strain `e`, with `x` = e / peak.
  TRILITH_INLINE Lanes stress(const Lanes& e, const Lanes& x) const {
    const Lanes falling = select(e >= Lanes{} + ultimate_, Lanes{} + rest_, top_ + slope_ * (e - peak));
    return select(x <= Lanes{} + 1.0, top_ * (2.0 - x) * x, falling);
  }
  TRILITH_INLINE Lanes slope(const Lanes& e, const Lanes& x) const {
    const Lanes falling = select(e >= Lanes{} + ultimate_, Lanes{}, Lanes{} + slope_);
    return select(x <= Lanes{} + 1.0, initial * (1.0 - x), falling);
  }

 private:
  double top_, ultimate_, rest_, slope_;
};

/// The cycles of ConcreteCycle within an envelope.
template <class Envelope>
class ConcreteLanes {
 public:
  explicit ConcreteLanes(const Envelope& envelope) : envelope_(envelope) {}

  /// ConcreteCycle::respond.
  TRILITH_INLINE void respond(const Lanes& strain, const ConcreteFour& before, ConcreteFourResponse& out) const {
    const Lanes most = before.squeezed, x = most / envelope_.peak, pressed = -strain;
    const Lanes on_envelope = select(-before.strain == most, -before.stress, envelope_.stress(most, x));
    const Lanes left_before = plastic(most, x, on_envelope);
    const LaneMask loads = pressed > most;
    Lanes left = left_before;
    out.memory.strain = strain, out.memory.squeezed = most, out.memory.opened = before.opened;
    unload(strain, left, on_envelope, out);
    out.yielding = LaneMask{};
    if (any(loads)) {
      const Lanes ahead = pressed / envelope_.peak, stress = envelope_.stress(pressed, ahead);
      out.memory.squeezed = select(loads, pressed, most);
      out.memory.opened = select(loads, before.opened, out.memory.opened);
      out.memory.stress = select(loads, -stress, out.memory.stress);
      out.tangent = select(loads, envelope_.slope(pressed, ahead), out.tangent);
      out.yielding = loads & (pressed > Lanes{} + envelope_.peak);
      left = select(loads, plastic(pressed, ahead, stress), left);
    }
    out.stored = 0.5 * out.memory.stress * (strain + left);
    const Lanes work = 0.5 * (before.stress + out.memory.stress) * (strain - before.strain);
    out.dissipated = work - (out.stored - 0.5 * before.stress * (before.strain + left_before));
  }

 private:
  /// ConcreteCycle::plastic, with `x` = most / peak.
  TRILITH_INLINE Lanes plastic(const Lanes& most, const Lanes& x, const Lanes& stress) const {
    const Lanes share = select(x < Lanes{} + 2.0, (0.145 * x + 0.13) * x, 0.84 + 0.707 * (x - 2.0));
    const Lanes shared = share * envelope_.peak, elastic = most - stress / envelope_.initial;
    return select(elastic < shared, elastic, shared);
  }
  /// The line from the greatest compression, and beyond it tension.
  TRILITH_INLINE void unload(const Lanes& strain, const Lanes& left, const Lanes& on_envelope,
                             ConcreteFourResponse& out) const {
    const Lanes most = out.memory.squeezed, open = strain + left;
    const Lanes modulus = select(most > Lanes{}, on_envelope / (most - left), Lanes{} + envelope_.initial);
    out.tangent = modulus, out.memory.stress = modulus * open;
    const LaneMask pulls = open > Lanes{};
    if (any(pulls)) pull(pulls, open, modulus, out);
  }
  /// Stress of a crack; its slope is minus its first factor.
  struct CrackLine {
    Lanes height;
    double end, length;

    TRILITH_INLINE Lanes at(const Lanes& e) const {
      return select(e < Lanes{} + end, height * (end - e) / length, Lanes{});
    }
  };
  /// ConcreteCycle::pull in the lanes `pulls`.
  TRILITH_INLINE void pull(const LaneMask& pulls, const Lanes& open, const Lanes& modulus,
                           ConcreteFourResponse& out) const {
    const double first = envelope_.tension / envelope_.initial, end = envelope_.tension_end;
    const Lanes most = out.memory.opened, limit = select(most < Lanes{} + first, Lanes{} + first, most);
    const LaneMask opens = pulls & (open > limit), reopens = pulls & flip(open > limit) & (most > Lanes{} + first);
    Lanes stress{}, slope{}, secant{};
    if (end > 0) {  // otherwise a crack carries nothing
      const Lanes share = modulus / envelope_.initial;
      const CrackLine line{envelope_.tension * share, end, end - first};
      stress = line.at(open), slope = select(open < Lanes{} + end, -envelope_.tension * share / (end - first), Lanes{});
      secant = line.at(most) / most;
    }
    out.memory.opened = select(opens, open, most);
    out.tangent = select(opens, slope, select(reopens, secant, out.tangent));
    out.memory.stress = select(opens, stress, select(reopens, secant * open, out.memory.stress));
  }

  Envelope envelope_;
};

}  // namespace trilith
