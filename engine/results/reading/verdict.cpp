#include "results/reading/verdict.hpp"

#include "model/event/event_list.hpp"

namespace trilith::results {

Verdict results_verdict(const ResultsReader& reader, const std::vector<EventRow>& events) {
  Verdict verdict;
  for (const EventRow& e : events)
    if (const EventTypeInfo* const row = event_info(e.type)) verdict.add(row->type, e.time, e.first.value, e.text);
  for (const SealRow& row : reader.seal())
    if (row.failed() && row.check != penetration_check) verdict.fail(row.valid_until, seal_text(row));
  return verdict;
}

}  // namespace trilith::results
