// Events as text, for the terminal, the results file and plots.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "model/event.hpp"
#include "model/model.hpp"

namespace trilith {

/// "bearing S3.left failed at 50.8 mm", "S3 lost its seat on P3 (S3.right)", "S3 hit P3 at 4.2 m/s", "shaking ended
/// (rest)".
template <int D>
std::string event_text(const Event& event, const Model<D>& model);

/// The event type with this name in scripts and results; empty if there is none.
std::optional<EventType> event_type_called(std::string_view name);

/// Slower impacts are omitted too where minor events are [m/s].
inline constexpr double slow_impact = 2;

}  // namespace trilith
