// Common part of concrete fibres: cycles within an envelope in compression, cracks in tension.
//
// Compression follows the law's envelope. Unloading and reloading follow one line from the envelope at the greatest
// compression e_c to the plastic strain e_p, where it closes and opens. With r = e_c / e_0:
//
//     e_p / e_0 = 0.145 r^2 + 0.13 r up to r = 2,  beyond 0.84 + 0.707 (r - 2),  at most (e_c - s_c / E) / e_0
//
// Source: Karsan and Jirsa, "Behavior of concrete under compressive loadings", J. Struct. Div. ASCE 95(12), 1969 (with
// 0.834, which would jump at r = 2). From e_p on it carries tension with the modulus E_u of that line, up to the strain
// tension/E. So concrete that was crushed has also lost tensile strength. The crack then opens along a line down to 0
// at `tension_end` (at once where this is not beyond), and closes along a line to e_p.
//
// Not modelled: strain rate; contact of rough crack faces before the crack is closed; degradation by many cycles below
// e_c. Memory: strain, stress, e_c, greatest opening of the crack beyond e_p.
#pragma once

#include <algorithm>
#include <array>

#include "base/portable.hpp"
#include "base/schema.hpp"
#include "law/fibre/point.hpp"

namespace trilith {

/// Stress and slope of an envelope, positive in compression [Pa].
struct EnvelopePoint {
  double stress, slope;
};

inline constexpr int concrete_memory = 4;

/// `L` has initial() [Pa] (initial slope of its envelope, the stiffest), peak_strain() [1], envelope(strain) for
/// strains from 0 on.
template <class L>
struct ConcreteCycle {
  using Memory = std::array<double, concrete_memory>;
  static constexpr int squeezed = 2, opened = 3;  ///< indices in the memory

  /// Plastic strain after the greatest compression `most`, where the envelope has `stress` [Pa].
  static double plastic(const L& law, double most, double stress) {
    const double r = most / law.peak_strain();
    const double share = r < 2 ? (0.145 * r + 0.13) * r : 0.84 + 0.707 * (r - 2);
    return std::min(share * law.peak_strain(), most - stress / law.initial());
  }
  /// Energy recovered along the unloading line. `left`: plastic strain.
  static double stored_on_line(const Memory& m, double left) { return 0.5 * m[last_stress] * (m[last_strain] + left); }
  static double stored(const L& law, const Memory& m) {
    return stored_on_line(m, plastic(law, m[squeezed], law.envelope(m[squeezed]).stress));
  }

  /// The envelope may be expensive. A fibre that was last at its greatest compression has its stress in the memory.
  static UniaxialResponse<concrete_memory> respond(const L& law, double strain, const Memory& before) {
    UniaxialResponse<concrete_memory> out;
    Memory& m = out.memory = before;
    m[last_strain] = strain;
    const double most = before[squeezed],
                 on_envelope = -before[last_strain] == most ? -before[last_stress] : law.envelope(most).stress;
    const double left_before = plastic(law, most, on_envelope);
    double left = left_before;
    if (-strain > most) {
      const EnvelopePoint p = law.envelope(-strain);
      m[squeezed] = -strain, m[last_stress] = -p.stress, out.tangent = p.slope;
      out.yielding = -strain > law.peak_strain();
      left = plastic(law, -strain, p.stress);
    } else {
      const double open = strain + left, modulus = most > 0 ? on_envelope / (most - left) : law.initial();
      out.tangent = modulus, m[last_stress] = modulus * open;
      if (open > 0) pull(law, open, modulus, out);
    }
    out.stored = stored_on_line(m, left);
    book_work(before, stored_on_line(before, left_before), out);
    return out;
  }

 private:
  /// Tension at `open` beyond e_p.
  static void pull(const L& law, double open, double modulus, UniaxialResponse<concrete_memory>& out) {
    const double first = law.tension / law.initial(), end = law.tension_end, share = modulus / law.initial();
    const auto line = [&](double e) { return e < end ? law.tension * share * (end - e) / (end - first) : 0.0; };
    double& most = out.memory[opened];
    if (open > std::max(most, first)) {
      most = open;
      out.memory[last_stress] = line(open);
      out.tangent = open < end ? -law.tension * share / (end - first) : 0;
    } else if (most > first) {
      out.tangent = line(most) / most;
      out.memory[last_stress] = out.tangent * open;
    }
  }
};

}  // namespace trilith
