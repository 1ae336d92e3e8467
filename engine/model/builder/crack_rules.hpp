// Rules for bodies that crack, in the plane and in space: laws and names.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "model/contact/contact_rules.hpp"
#include "model/crack_planes.hpp"
#include "model/model.hpp"
#include "model/names.hpp"

namespace trilith {

/// Group of all parts of a body that has cracked, and of their parts.
std::string pieces_group(const std::string& body);

/// Throws InputError: "body 'u17': cracks: ...".
[[noreturn]] void refuse_cracks(const std::string& owner, const std::string& why);

/// Refuses planes on a body with a support, and planes without a law.
void check_crack_support(std::span<const Support> support, const std::string& law, const std::string& owner);

/// The reason why a law cannot serve planes: it does not exist, or has no bond with strength; "" if it can.
std::string crack_law_fault(const ContactRules& rules, const std::string& name);

/// Number of the i-th plane in the whole body.
template <int D>
int number_of(const CrackSpec<D>& cracks, std::size_t i) {
  return cracks.numbers.empty() ? static_cast<int>(i) + 1 : cracks.numbers[i];
}

/// A name that no body has: "u17.a", or "u17.a'" if that is taken.
template <class Specs>
std::string new_part_name(RowNames& known, const Specs& bodies, std::string name) {
  while (known.contains(bodies, name)) name += "'";
  return name;
}

}  // namespace trilith
