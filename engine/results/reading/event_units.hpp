// Texts of events in other units.
#pragma once

#include <string>

#include "base/unit_system.hpp"
#include "results/file/results.hpp"

namespace trilith::results {

/// The sentence of an event with its numbers in these units, converted from the exact figures of the event.
std::string text_in(const EventRow& event, const UnitSystem& units);

}  // namespace trilith::results
