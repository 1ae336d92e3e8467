// Options of m:pushover.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bindings/core/keys.hpp"
#include "bindings/model/script_model.hpp"
#include "model/pushes.hpp"
#include "run/pushover.hpp"

namespace trilith::script {

/// Directions in which the pushed bodies are held from the push on.
enum class PushTop { free, level, locked };

template <int D>
struct PushOrder {
  std::vector<int> bodies;
  std::optional<Vec<D>> at;
  std::string place;
  Vec<D> direction = Vec<D>::UnitX();
  PushPattern pattern = PushPattern::mass;
  PushTop top = PushTop::free;  ///< level: without rotation; locked: without rotation and at their height
  double rate = 0;              ///< [m/s]; 0: chosen automatically so that inertia remains small
  double displacement = 0;
  int storey = 0, samples = 200;
  PushLimits limits;
  StageOptions stage;
  bool by_arc = false;  ///< without time, by equilibria; otherwise steadily in time
  double arc = 0;       ///< first arc [m]; 0: 1 % of the displacement
  int on_sample = 0;    ///< stack index of a function of the model and a sample; 0: none
};

/// Reads all keys without reporting unknown ones yet; Keys::finish reports errors. The function of `on_sample` remains
/// on the stack.
template <int D>
PushOrder<D> read_order(Keys& keys, const ScriptModel& m);

}  // namespace trilith::script
