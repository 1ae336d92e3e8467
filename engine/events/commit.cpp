#include "events/commit.hpp"

#include <utility>

#include "events/find_events.hpp"

namespace trilith {

/// Finds the events first, by comparing the committed memories with the trial memories. Then the trial memories become
/// State, and so do the energy sums: `work.given` began as a copy of `state.given`.
template <int D>
void commit(const Model<D>& model, State<D>& state, Work<D>& work, StepTimes* times) {
  StepClock clock(times);
  find_events(model, state, work);
  // The old memories become the buffer of the next trial; inactive rows are empty in both.
  if (work.is_matched) std::swap(state.contacts, work.matched);
  std::swap(state.contacts, work.contacts);
  work.is_matched = false;
  state.bearing.swap(work.bearing);
  state.plastic.swap(work.plastic);
  state.beam_memory.swap(work.beam_memory);
  state.beam_memory.resize(static_cast<std::size_t>(model.beam_memory));  // see assembly/element/fibre_answers.hpp
  state.given = work.given;
  clock.mark(StepPart::events);
}

template void commit(const Model<2>&, State<2>&, Work<2>&, StepTimes*);
template void commit(const Model<3>&, State<3>&, Work<3>&, StepTimes*);

}  // namespace trilith
