#include "edit/restart.hpp"

#include "assembly/evaluate.hpp"
#include "events/commit.hpp"
#include "integrate/implicit/implicit_step.hpp"

namespace trilith {

/// Explicit velocities lag half a step behind positions, and laws use them for the path of the step. Without a restart,
/// a freed node would have half a step of its acceleration too much, or would have slid while it was fixed.
template <int D>
RestartedRun<D>::RestartedRun(const Model<D>& model, State<D>& state, Work<D>& work)
    : was_implicit_(state.implicit()), most_energy_(state.most_energy) {
  commit(model, state, work);
  events_ = work.events;
  begin_implicit(model, state, work);
  begin_explicit(model, state, work);
  evaluate(model, state, work, 0);
}

template <int D>
void RestartedRun<D>::go_on(const Model<D>& model, State<D>& state, const Work<D>& work) const {
  if (!was_implicit_) return;
  begin_implicit(model, state, work);
  state.most_energy = most_energy_;
}

template class RestartedRun<2>;
template class RestartedRun<3>;

}  // namespace trilith
