// How well the ledger closes over a run: the largest residual against the energy that went through the structure.
#pragma once

#include <algorithm>
#include <cmath>

#include "model/energy.hpp"

namespace trilith {

/// Feed it every sample of the ledger.
class EnergyCheck {
 public:
  /// `residual`: balance of the ledger less the balance at the start [J].
  void add(const Energy& energy, double residual) {
    double held = 0;
    for (int i = 0; i < energy_terms; ++i)
      if (energy_term_info[i].sign > 0 && static_cast<EnergyTerm>(i) != EnergyTerm::gravity) held += energy.value[i];
    input_ = std::max(input_, held);
    residual_ = std::max(residual_, std::abs(residual));
    last_ = energy;
  }

  /// Largest sum of all energy held or given off, the weight's apart [J]: what start, ground, loads and falling weight
  /// had put in by then.
  [[nodiscard]] double input() const { return input_; }
  /// Largest residual of either sign [J].
  [[nodiscard]] double residual() const { return residual_; }
  /// The second over the first; 0 where nothing was put in.
  [[nodiscard]] double share() const { return input_ > 0 ? residual_ / input_ : 0; }
  /// The ledger as it was fed last.
  [[nodiscard]] const Energy& last() const { return last_; }

 private:
  double input_ = 0, residual_ = 0;
  Energy last_;
};

}  // namespace trilith
