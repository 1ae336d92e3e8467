// What m:pushover is asked for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bindings/core/keys.hpp"
#include "bindings/model/script_model.hpp"
#include "model/pushes.hpp"
#include "run/pushover.hpp"

namespace trilith::script {

template <int D>
struct PushOrder {
  std::vector<int> bodies;
  std::optional<Vec<D>> at;
  std::string place;
  Vec<D> direction = Vec<D>::UnitX();
  PushPattern pattern = PushPattern::mass;
  double rate = 0;  ///< [m/s]; 0: so slow that inertia stays small
  double displacement = 0;
  int storey = 0, samples = 200;
  PushLimits limits;
  StageOptions stage;
  bool by_arc = false;  ///< in no time, by equilibria; else steadily in time
  double arc = 0;       ///< first arc [m]; 0: a hundredth of the displacement
};

/// Reads all keys but says nothing of unknown ones yet; what is wrong is told by Keys::finish.
template <int D>
PushOrder<D> read_order(Keys& keys, const ScriptModel& m);

}  // namespace trilith::script
