// Intact bonds of two faces in the plane: bounds of their distance from the peak, without the equations of their law.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "law/contact/bond_curve.hpp"
#include "law/contact/face_motion.hpp"
#include "law/contact/list.hpp"
#include "model/model.hpp"
#include "model/work.hpp"

namespace trilith {

/// Numbers that all intact bonds of a law share. The lengths are lower bounds.
struct IntactBonds {
  bool are_plain = false;        ///< the law bonds, and sliding does not open its joints
  double opening = 0, slip = 0;  ///< at the peaks in tension, and in shear without pressure [m]
  double weaker = 0;             ///< fall of `slip` for each opening [1]
  double compliance = 0;         ///< slip for each shear force per length [m2/N]
  double whole = 0;              ///< the smaller displacement over which an intact bond is lost [m]
  bool soften = false;
  std::size_t numbers = 0;  ///< of the law's memory of a contact
};

/// Bounds of one pair of faces.
struct IntactPlace {
  double room = 0;   ///< no bond is nearer to its peak [m]
  double speed = 0;  ///< no bond moves faster [m/s]
};

inline IntactBonds intact_bonds(const LawInUse& use) {
  return with_kernel(use, []<class K>(const K& law) {
    IntactBonds out;
    if constexpr (K::bonds) {
      constexpr double never = std::numeric_limits<double>::max();
      const BondCurve pulled = tension_curve(law, 1.0), sheared = shear_curve(law, 1.0, 0.0, 0.0);
      out.are_plain = pulled.top > 0, out.numbers = law_numbers<K>;
      if constexpr (K::softens) out.are_plain = out.are_plain && !(law.dilation > 0);
      const bool shears = sheared.top > 0;
      out.opening = pulled.peak, out.slip = shears ? sheared.peak : never;
      out.weaker = shears ? law.kn * law.tension_slope() / law.ks : 0, out.compliance = shears ? 1 / law.ks : 0;
      out.whole = shears ? std::min(pulled.whole, sheared.whole) : pulled.whole, out.soften = K::softens;
    }
    return out;
  });
}

/// The same for all laws of a model.
inline std::vector<IntactBonds> intact_bonds(const Model<2>& model) {
  std::vector<IntactBonds> out;
  for (const ContactLaw& law : model.laws) out.push_back(intact_bonds({law, model.thickness}));
  return out;
}

/// True where sliding does not open the joint, both halves of a contact are bonded and its law remembers nothing: no
/// damage, no crushed depth, and no mortar that fills a gap.
inline bool is_intact(const IntactBonds& law, const ContactHistory& history, std::size_t row) {
  if (!law.are_plain) return false;
  const ContactMemory& memory = history.memory[row];
  if (!memory.bonded(0) || !memory.bonded(1)) return false;
  const double* const numbers = history.law_numbers(row);
  return std::all_of(numbers, numbers + law.numbers, [](double v) { return v == 0; });
}

/// Bounds of an intact contact. The gap is linear along the shared length, so its ends bound it.
inline IntactPlace intact_place(const IntactBonds& law, const FaceOverlap<double>& overlap,
                                const FaceRates<double>& rates, const ContactMemory& memory) {
  const double widest = std::max(overlap.gap_lo, overlap.gap_hi), half = 0.5 * overlap.shared;
  const double force = std::max(std::abs(memory.shear_elastic[0]), std::abs(memory.shear_elastic[1]));
  const double in_shear = law.slip - law.weaker * std::max(widest, 0.0) - law.compliance * force / half;
  return {std::min(law.opening - widest, in_shear),
          std::max({std::abs(rates.gap_lo), std::abs(rates.gap_hi), std::abs(rates.slip_lo), std::abs(rates.slip_hi)})};
}

}  // namespace trilith
