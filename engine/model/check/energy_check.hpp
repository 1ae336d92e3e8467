// Closure of the ledger over a run: the largest residual relative to the energy input of the structure.
#pragma once

#include <algorithm>
#include <cmath>

#include "model/energy.hpp"

namespace trilith {

/// Call add() for every sample of the ledger.
class EnergyCheck {
 public:
  /// `residual`: balance of the ledger minus the balance at the start [J].
  void add(const Energy& energy, double residual) {
    double held = 0;
    for (int i = 0; i < energy_terms; ++i)
      if (energy_term_info[i].sign > 0 && static_cast<EnergyTerm>(i) != EnergyTerm::gravity) held += energy.value[i];
    input_ = std::max(input_, held);
    residual_ = std::max(residual_, std::abs(residual));
    last_ = energy;
  }

  /// Largest sum of all stored and dissipated energy without the potential energy of weight [J]: the energy supplied so
  /// far by the initial state, ground, loads and falling weight.
  [[nodiscard]] double input() const { return input_; }
  /// Largest magnitude of the residual [J].
  [[nodiscard]] double residual() const { return residual_; }
  /// residual() / input(); 0 without input.
  [[nodiscard]] double share() const { return input_ > 0 ? residual_ / input_ : 0; }
  /// The last sample of the ledger.
  [[nodiscard]] const Energy& last() const { return last_; }
  /// Calls each(number) for all members.
  template <class Each>
  void each_number(Each&& each) {
    each(input_), each(residual_);
    for (double& term : last_.value) each(term);
  }

 private:
  double input_ = 0, residual_ = 0;
  Energy last_;
};

}  // namespace trilith
