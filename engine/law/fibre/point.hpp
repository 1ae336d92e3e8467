// Uniaxial strain and stress of a beam fibre or a bar: input and output of a law.
//
// Signs: tension is positive, for strains and stresses. A law has a memory of its own size; all zeros mean that it was
// never strained. In every law the first two numbers are strain and stress of the last step.
#pragma once

#include <array>

namespace trilith {

/// Indices of the memory common to all laws.
inline constexpr int last_strain = 0, last_stress = 1;

/// Response of a law to a strain; `size` is the size of its memory.
template <int size>
struct UniaxialResponse {
  std::array<double, size> memory{};
  double tangent = 0;     ///< d stress / d strain at the given memory [Pa]
  double stored = 0;      ///< elastic energy of the new memory [J/m3]
  double dissipated = 0;  ///< in this step: work of the mean stress minus the change of stored energy [J/m3]
  bool yielding = false;  ///< in this step: steel yields or concrete crushes; cracks do not count
  [[nodiscard]] double stress() const { return memory[last_stress]; }  ///< [Pa]
};

/// Accounts for the step from `before` to `out.memory`, so that stored and dissipated energy add up to its work.
/// `stored_before` [J/m3], as out.stored.
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
