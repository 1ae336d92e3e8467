// The contact laws there are: a new one is its own file and a row here.
#pragma once

#include <variant>
#include <vector>

#include "contact/bonded.hpp"
#include "contact/cohesive.hpp"
#include "contact/frictional.hpp"

namespace trilith {

using ContactLaws = TypeList<Frictional, Bonded, Cohesive>;
using ContactLaw = std::variant<Frictional, Bonded, Cohesive>;
static_assert(std::variant_size_v<ContactLaw> == ContactLaws::size);

/// What every law has: it fills the general contact of corners, where no bond can hold.
template <class L>
concept ContactLawType = Declared<L> && requires(const L& law) {
  { law.kn } -> std::convertible_to<double>;
  { law.ks } -> std::convertible_to<double>;
  { law.mu } -> std::convertible_to<double>;
  { law.beta } -> std::convertible_to<double>;
  { L::bond } -> std::convertible_to<Bond>;
};
static_assert(ContactLawType<Frictional> && ContactLawType<Bonded> && ContactLawType<Cohesive>);

/// What its faces can hold beside friction.
inline Bond bond_of(const ContactLaw& law) {
  return std::visit([](const auto& l) { return std::decay_t<decltype(l)>::bond; }, law);
}

}  // namespace trilith
