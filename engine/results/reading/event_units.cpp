#include "results/reading/event_units.hpp"

#include <array>

#include "base/exact_message.hpp"

namespace trilith::results {

std::string text_in(const EventRow& event, const UnitSystem& units) {
  const std::array exact{ExactNumber{event.first.value, event.first.unit},
                         ExactNumber{event.second.value, event.second.unit}};
  return exact_message(units, event.text, exact);
}

}  // namespace trilith::results
