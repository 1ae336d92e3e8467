// A single fibre law with prescribed strains and its energies.
#pragma once

#include <algorithm>

#include "law/fibre/list.hpp"
#include "law_sample.hpp"

namespace trilith::testing {

/// Numbers for which strains of a few thousandths pass yield, peak and crack.
inline const UsualNumbers usual_in_fibres{{"Pa", 2e11}, {"1", 0.3}};
inline constexpr double usual_yield = 3e8;

/// Samples of a law, intact, with a yield stress where the law has one.
template <UniaxialLawType L>
std::vector<L> fibre_samples() {
  std::vector<L> all = samples<L>(usual_in_fibres);
  std::erase_if(all, [](L& law) {
    if constexpr (requires { law.yield; }) law.yield = usual_yield;
    if constexpr (requires { law.check(); }) {
      try {
        law.check();
      } catch (const InputError&) {
        return true;
      }
    }
    return false;
  });
  return all;
}

/// `work` is the work of the mean stress of each step.
template <UniaxialLawType L>
struct LedFibre {
  L law;
  UniaxialResponse<L::memory_size> now = {};
  double at = 0, work = 0, lost = 0, least_loss = 0, most_stored = 0;

  void to(double strain) {
    const auto next = law.respond(strain, now.memory);
    work += 0.5 * (next.stress() + now.stress()) * (strain - at);
    lost += next.dissipated;
    least_loss = std::min(least_loss, next.dissipated);
    most_stored = std::max(most_stored, next.stored);
    at = strain, now = next;
  }
  void along(double strain, int steps = 400) {
    for (int i = 1, left = steps; i <= steps; ++i, --left) to(i == steps ? strain : at + (strain - at) / left);
  }
  [[nodiscard]] double unbooked() const { return work - now.stored - lost; }
};

}  // namespace trilith::testing
