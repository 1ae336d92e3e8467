#include "results/reading/verdict.hpp"

#include "model/event_text.hpp"

namespace trilith::results {

Verdict results_verdict(const std::vector<EventRow>& events) {
  Verdict verdict;
  for (const EventRow& e : events)
    if (const auto type = event_type_called(e.type)) verdict.add(*type, e.time, e.first.value, e.text);
  return verdict;
}

}  // namespace trilith::results
