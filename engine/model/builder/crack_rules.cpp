#include "model/builder/crack_rules.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "law/contact/list.hpp"

namespace trilith {
namespace {

/// Contact laws that a crack can use have a bond with strength.
bool has_strength(const ContactLaw& law) {
  return with_kernel({law}, []<class K>(const K& kernel) {
    if constexpr (K::bonds) return kernel.tension > 0 && kernel.cohesion > 0;
    return false;
  });
}

}  // namespace

std::string pieces_group(const std::string& body) {
  return "pieces of " + body;
}

void refuse_cracks(const std::string& owner, const std::string& why) {
  throw InputError(fmt::format("{}: cracks: {}", owner, why));
}

void check_crack_support(std::span<const Support> support, const std::string& law, const std::string& owner) {
  for (const Support s : support)
    if (s != Support::free)
      refuse_cracks(owner,
                    "the body is held, and where its support acts inside it is not known; hold another body, and join "
                    "this one to it by a bonded contact or a bearing, or give cracks = false");
  if (law.empty())
    refuse_cracks(owner,
                  "crack_law is missing, the name of a contact law with tension and cohesion: trilith.bonded{...}, or "
                  "trilith.cohesive{...} with fracture energies");
}

std::string crack_law_fault(const ContactRules& rules, const std::string& name) {
  const int law = rules.law_row(name);
  if (law < 0) return fmt::format("there is no contact law '{}'{}", name, name_hint(name, rules.law_names()));
  if (has_strength(rules.laws()[static_cast<std::size_t>(law)].second)) return "";
  return fmt::format(
      "'{}' has no strength: a crack needs tension and cohesion above 0; give a bonded law, or a cohesive "
      "law with fracture energies",
      name);
}

}  // namespace trilith
