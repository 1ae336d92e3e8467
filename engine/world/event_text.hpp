// Events in plain words, for the terminal, the results file and pictures alike.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "world/event.hpp"
#include "world/model.hpp"

namespace trilith {

/// "bearing S3.left failed at 50.8 mm", "S3 lost its seat on P3 (S3.right)", "S3 hit P3 at 4.2 m/s", "shaking ended
/// (rest)".
std::string event_text(const Event& event, const Model<2>& model);

/// The type that scripts and results call `name`; nothing where there is none.
std::optional<EventType> event_type_called(std::string_view name);

/// "seat lost", "bearing failed", ...: an event type as a short heading.
std::string_view event_heading(EventType type);

/// True for what a reader of a run wants to see at once: everything but contacts made and lost, and bodies at rest.
bool is_important(EventType type);

/// Impacts slower than this are left out as well where there is a choice [m/s].
inline constexpr double slow_impact = 2;

}  // namespace trilith
