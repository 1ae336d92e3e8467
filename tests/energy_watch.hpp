// The ledger of a run relative to its first entry.
#pragma once

#include <optional>

#include "model/check/energy_check.hpp"
#include "run/simulation.hpp"

namespace trilith::testing {

/// Records the ledger of a run; must outlive it.
struct EnergyWatch {
  EnergyCheck check;
  std::optional<double> first;  ///< balance of the first entry [J]

  template <int D>
  void listen(RunListener<D>& listener) {
    listener.on_energy = [this](const Instant<D>&, const Energy& e) {
      if (!first) first = e.balance();
      check.add(e, e.balance() - *first);
    };
  }
};

}  // namespace trilith::testing
