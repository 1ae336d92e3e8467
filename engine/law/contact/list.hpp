// The contact laws. A new law is its own file and a row here.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <variant>

#include "law/contact/bonded.hpp"
#include "law/contact/cohesive.hpp"
#include "law/contact/frictional.hpp"
#include "law/contact/law_forms.hpp"
#include "law/contact/power.hpp"

namespace trilith {

using ContactLaws = TypeList<Frictional, Bonded, Cohesive, Power>;
using ContactLaw = ContactLaws::Variant;

/// Memory of a contact for a law with kernel K: a row of numbers, in pairs.
template <class K>
using LawMemory = typename K::template Memory<double>;
template <class K>
inline constexpr std::size_t law_numbers = std::is_empty_v<LawMemory<K>> ? 0 : sizeof(LawMemory<K>) / sizeof(double);
/// From the row where it is stored, and back.
template <class K>
LawMemory<K> law_memory(const double* row) {
  LawMemory<K> memory;
  if constexpr (law_numbers < K >> 0) std::memcpy(static_cast<void*>(&memory), row, sizeof memory);
  return memory;
}
template <class K>
void keep_law_memory(const LawMemory<K>& memory, double* row) {
  if constexpr (law_numbers < K >> 0) std::memcpy(row, &memory, sizeof memory);
}

/// Size of the memory of each law in the list.
inline constexpr auto law_number_counts = [] {
  std::array<std::uint32_t, ContactLaws::size> counts{};
  std::size_t place = 0;
  ContactLaws::for_each(
      [&]<class L>() { counts[place++] = static_cast<std::uint32_t>(law_numbers<typename L::Kernel>); });
  return counts;
}();

/// The law whose memory a contact has, and its location.
struct LawRow {
  std::uint32_t place = 0;  ///< of the law in ContactLaws
  std::uint32_t first = 0;  ///< of its numbers in State::law_memory
};

/// Requirements of a law: declared parameters, including the stiffness at small overlaps, and equations; see
/// law/contact/coulomb.hpp.
template <class L>
concept ContactLawType = Declared<L> && requires(const L& law) {
  { law.kn } -> std::convertible_to<double>;
  { law.ks } -> std::convertible_to<double>;
  { law.mu } -> std::convertible_to<double>;
  { law.beta } -> std::convertible_to<double>;
  requires std::derived_from<typename L::Kernel, Coulomb>;
  requires std::constructible_from<typename L::Kernel, const L&, double, double>;
  requires law_numbers<typename L::Kernel>
  % 2 == 0;
};
/// A law in use: between bodies of some thickness [m], for a step [s].
struct LawInUse {
  const ContactLaw& law;
  double thickness = 1, dt = 0;
  double held = 0;  ///< depth up to which a bearing replaces the contact: deeper overlap carries pressure [m]
};

/// True for a callable with an argument of one fixed type.
template <class F>
inline constexpr bool takes_one_type = requires {
  &std::remove_cvref_t<F>::operator();
};

/// Calls f(kernel) with the kernel of a law. `f` must accept its exact type, because a base class lacks its equations.
template <class F>
decltype(auto) with_kernel(const LawInUse& use, F&& f) {
  static_assert(!takes_one_type<F>, "take the kernel by `const auto&` or by a template parameter: a base slices it");
  return std::visit(
      [&](const auto& law) -> decltype(auto) {
        return f(typename std::decay_t<decltype(law)>::Kernel(law, use.thickness, use.dt));
      },
      use.law);
}

/// The parameters for closed forms: as if pressure were proportional to the overlap and friction were Coulomb's. Valid
/// for laws for which this is true where they are not bonded, see has_closed_form.
inline PlainFriction plain_friction(const LawInUse& use) {
  return std::visit([&](const auto& law) { return PlainFriction(law, use.thickness, use.dt); }, use.law);
}

/// True for laws with linear pressure and Coulomb friction wherever they have no bond and nothing is crushed.
inline bool has_closed_form(const ContactLaw& law) {
  return std::visit([]<class L>(const L&) { return L::Kernel::linear && !has_own_friction<typename L::Kernel>; }, law);
}

/// True where the law can bond faces.
inline bool may_bond(const ContactLaw& law) {
  return std::visit([](const auto& l) { return std::decay_t<decltype(l)>::Kernel::bonds; }, law);
}

/// True where mortar under the law loses depth permanently once its pressure exceeds the strength.
inline bool may_crush(const ContactLaw& law) {
  return with_kernel({law}, []<class K>(const K& kernel) {
    if constexpr (K::crushes) return kernel.crushing > 0;
    return false;
  });
}

/// Calls f.template operator()<K>() for the kernel type of the law at an index of the list.
template <class F>
decltype(auto) with_kernel_type(std::size_t place, F&& f) {
  return ContactLaws::at(place,
                         [&]<class L>() -> decltype(auto) { return f.template operator()<typename L::Kernel>(); });
}

}  // namespace trilith
