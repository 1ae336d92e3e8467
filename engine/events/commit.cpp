#include "events/commit.hpp"

#include <utility>

#include "events/find_events.hpp"

namespace trilith {

/// First the events, which compare the memories of before with those of the trial; then the trial's become State. Sums
/// of energy too: `work.given` began as a copy of `state.given`.
template <int D>
void commit(const Model<D>& model, State<D>& state, Work<D>& work, StepTimes* times) {
  StepClock clock(times);
  find_events(model, state, work);
  // The memories of before go where the next trial is written: rows that are not worked on are empty in both.
  if (work.is_matched) std::swap(state.contacts, work.matched);
  std::swap(state.contacts, work.contacts);
  work.is_matched = false;
  state.bearing.swap(work.bearing);
  state.plastic.swap(work.plastic);
  state.beam_memory.swap(work.beam_memory);
  state.given = work.given;
  clock.mark(StepPart::events);
}

template void commit(const Model<2>&, State<2>&, Work<2>&, StepTimes*);
template void commit(const Model<3>&, State<3>&, Work<3>&, StepTimes*);

}  // namespace trilith
