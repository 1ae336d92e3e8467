// Strain and stress in one direction: a fibre of a beam, a bar. What goes into a law and what comes out.
//
// Signs: tension above 0, for strains and stresses. A law remembers a row of numbers of its own size; where they are
// all 0 it has never been strained. The first two are the strain and stress of the last step, in every law.
#pragma once

#include <array>

namespace trilith {

/// Places in a memory that every law has.
inline constexpr int last_strain = 0, last_stress = 1;

/// Answer of a law to a strain; `size` numbers are what it remembers.
template <int size>
struct UniaxialResponse {
  std::array<double, size> memory{};
  double tangent = 0;     ///< d stress / d strain for what is remembered from before [Pa]
  double stored = 0;      ///< elastic energy, that of the memory [J/m3]
  double dissipated = 0;  ///< of this step: work of its mean stress less what is stored [J/m3]
  bool yielding = false;  ///< in this step: steel flows, concrete crushes; cracks are none of it
  [[nodiscard]] double stress() const { return memory[last_stress]; }  ///< [Pa]
};

/// Books the step from `before` to `out.memory`, so that stored and dissipated together are its work. `stored_before`
/// [J/m3], as out.stored.
template <class Memory, int N>
void book_work(const Memory& before, double stored_before, UniaxialResponse<N>& out) {
  const double work =
      0.5 * (before[last_stress] + out.memory[last_stress]) * (out.memory[last_strain] - before[last_strain]);
  out.dissipated = work - (out.stored - stored_before);
}
template <class L>
void book_step(const L& law, const typename L::Memory& before, UniaxialResponse<L::memory_size>& out) {
  out.stored = law.stored(out.memory);
  book_work(before, law.stored(before), out);
}

}  // namespace trilith
