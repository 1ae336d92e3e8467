// Samples of every law of a bearing direction, from their list.
#pragma once

#include <string>
#include <vector>

#include "law/bearing/list.hpp"
#include "law_sample.hpp"

namespace trilith::testing {

/// Numbers for which displacements of some centimetres under about 10 kN of compression pass yield, gap and sliding.
inline const UsualNumbers usual_in_bearings{{"N/m", 1e6}, {"N", 3e3}, {"m", 0.02}, {"1", 0.3}, {"N s/m", 0}};

struct DirectionSample {
  std::string name;
  DirectionLaw law;
};

/// Samples of every law, with `damping` [N s/m] if the law has a dashpot.
inline std::vector<DirectionSample> direction_samples(double damping) {
  std::vector<DirectionSample> all;
  DirectionLaws::for_each([&]<class L>() {
    for (L& law : samples<L>(usual_in_bearings)) {
      for (const Parameter<L>& p : L::parameters())
        if (p.unit == "N s/m") law.*(p.member) = damping;
      all.push_back({describe(law), law});
    }
  });
  return all;
}

}  // namespace trilith::testing
