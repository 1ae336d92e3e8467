// Every contact law, from their list.
#pragma once

#include <string>
#include <vector>

#include "law/contact/list.hpp"
#include "law_sample.hpp"

namespace trilith::testing {

/// Typical values of mortar between blocks of some tonnes.
inline const UsualNumbers usual_in_contact{{"Pa/m", 1e9}, {"1", 0.3},    {"s", 1e-4},
                                           {"Pa", 1e5},   {"J/m2", 100}, {"m", 5e-3}};

struct ContactSample {
  std::string name;
  ContactLaw law;
};

inline std::vector<ContactSample> contact_samples() {
  std::vector<ContactSample> all;
  ContactLaws::for_each([&]<class L>() {
    for (const L& law : samples<L>(usual_in_contact)) all.push_back({describe(law), law});
  });
  return all;
}

}  // namespace trilith::testing
