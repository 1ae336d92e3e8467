// The touching contacts of a simulation at this instant, for scripts.
#pragma once

#include <vector>

#include "assembly/contact/contact_resultants.hpp"
#include "assembly/contact/solid_resultants.hpp"
#include "run/simulation.hpp"

namespace trilith::script {

inline std::vector<TouchingContact> touching_now(const Simulation<2>& s) {
  std::vector<TouchingContact> touching;
  contact_resultants(s.model(), s.state(), s.work(), touching);
  return touching;
}
inline std::vector<SolidResultant> touching_now(const Simulation<3>& s) {
  std::vector<SolidResultant> touching;
  for (std::size_t i = 0; i < s.work().general_touching.size(); ++i)
    touching.push_back(solid_resultant(s.model(), s.state(), s.work(), i));
  return touching;
}

}  // namespace trilith::script
