// A restart of a run at an instant, so that freed parts have no last step.
#pragma once

#include <vector>

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Brings a state to the instant at which `work` is evaluated: the last step is committed, velocities refer to the
/// instant, no last step remains, and the ledger is complete. `work` is evaluated again. Changes are then made in a
/// state of explicit steps; go_on converts it back if it was implicit.
template <int D>
class RestartedRun {
 public:
  RestartedRun(const Model<D>& model, State<D>& state, Work<D>& work);
  /// Call it after the change, with `work` evaluated. Implicit steps continue from its accelerations.
  void go_on(const Model<D>& model, State<D>& state, const Work<D>& work) const;
  /// Events of the last step, to be reported.
  [[nodiscard]] const std::vector<Event>& events() const { return events_; }

 private:
  bool was_implicit_;
  double most_energy_;  // controls the length of implicit steps [J]
  std::vector<Event> events_;
};

}  // namespace trilith
