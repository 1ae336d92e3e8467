// A run that begins anew at an instant of it, so that what is free from then on has no step behind it.
#pragma once

#include <vector>

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Brings a state to the instant that `work` is evaluated at: what the step behind has led to is committed, velocities
/// are those of now, no step lies behind, and the ledger is up to it. `work` is evaluated again. What changes then
/// changes in a state of explicit steps; go_on makes it one of implicit steps where it was that.
template <int D>
class RestartedRun {
 public:
  RestartedRun(const Model<D>& model, State<D>& state, Work<D>& work);
  /// After the change: `work` is evaluated with it. Implicit steps go on from the accelerations that it gives.
  void go_on(const Model<D>& model, State<D>& state, const Work<D>& work) const;
  /// Of the step behind, to be told.
  [[nodiscard]] const std::vector<Event>& events() const { return events_; }

 private:
  bool was_implicit_;
  double most_energy_;  // which the length of implicit steps goes by [J]
  std::vector<Event> events_;
};

}  // namespace trilith
