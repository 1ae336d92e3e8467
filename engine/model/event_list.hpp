// The types of events: one row for each. All readers of events take name, severity, fields and sentence from here.
#pragma once

#include <array>
#include <string_view>

#include "model/event_row.hpp"

namespace trilith {

/// In the order of EventType.
inline constexpr auto event_type_info = std::to_array<EventTypeInfo>({
    {.type = EventType::stage_begun,
     .name = "stage.begun",
     .heading = "stage begun",
     .severity = Severity::notice,
     .doc = "a stage began",
     .sentence = "{text} began"},
    {.type = EventType::stage_ended,
     .name = "stage.ended",
     .heading = "stage ended",
     .severity = Severity::routine,
     .text_doc = "the ending",
     .doc = "a stage ended",
     .sentence = "{ended}"},
    {.type = EventType::bond_cracked,
     .name = "bond.cracked",
     .heading = "bond cracked",
     .severity = Severity::damage,
     .traits = has_place | of_joint | can_cause,
     .value = {"force", "N", "force of the bond at that time"},
     .doc = "the bond of a joint opened on a part of its face",
     .sentence = "bond of {a} and {b} cracked{mode}"},
    {.type = EventType::bond_broken,
     .name = "bond.broken",
     .heading = "bond broken",
     .severity = Severity::failure,
     .traits = has_place | of_joint | can_cause,
     .value = {"force", "N", "its last force"},
     .text_doc = "a couple or stress at which it broke",
     .doc = "the bond of a joint is lost",
     .sentence = "bond of {a} and {b} broke{mode}"},
    {.type = EventType::joint_crushed,
     .name = "joint.crushed",
     .heading = "joint crushed",
     .severity = Severity::damage,
     .traits = has_place | of_joint | can_cause,
     .value = {"force", "N", "force"},
     .doc = "a joint reached its compressive strength",
     .sentence = "joint of {a} and {b} crushed{mode}"},
    {.type = EventType::bearing_yielded,
     .name = "bearing.yielded",
     .heading = "bearing yielded",
     .severity = Severity::damage,
     .traits = has_place,
     .value = {"displacement", "m"},
     .doc = "a bearing left its elastic range for the first time",
     .sentence = "bearing {bearing} yielded{at}"},
    {.type = EventType::bearing_failed,
     .name = "bearing.failed",
     .heading = "bearing failed",
     .severity = Severity::loss,
     .traits = has_place | can_cause,
     .value = {"displacement", "m"},
     .doc = "a bearing reached a limit; it carries nothing more, or its successor takes over",
     .sentence = "bearing {bearing} failed{at}"},
    {.type = EventType::bearing_changed,
     .name = "bearing.changed",
     .heading = "bearing changed",
     .severity = Severity::change,
     .traits = has_place | can_cause,
     .value = {"displacement", "m"},
     .doc = "a bearing was replaced by its successor (`becomes`)",
     .sentence = "bearing {bearing} {becomes}"},
    {.type = EventType::member_yielded,
     .name = "member.yielded",
     .heading = "member yielded",
     .severity = Severity::damage,
     .traits = has_place,
     .value = {"moment", "N m"},
     .doc = "a member of a frame yielded at an end for the first time",
     .sentence = "{a}: {text} yielded under {value}"},
    {.type = EventType::member_failed,
     .name = "member.failed",
     .heading = "member failed",
     .severity = Severity::loss,
     .traits = has_place | can_cause,
     .value = {"rotation", "rad"},
     .doc = "a member of a frame separated or lost its moment capacity",
     .sentence = "{a}: {text} lost its moment capacity after {value}"},
    {.type = EventType::member_removed,
     .name = "member.removed",
     .heading = "member removed",
     .severity = Severity::loss,
     .traits = has_place | can_cause,
     .value = {"energy", "J", "its energy"},
     .doc = "a member of a frame was removed by its hinge",
     .sentence = "{a}: {text} was removed and released {value}"},
    {.type = EventType::contact_made,
     .name = "contact.made",
     .heading = "contact made",
     .severity = Severity::routine,
     .traits = has_place,
     .value = {"closing speed", "m/s"},
     .doc = "two bodies came into contact",
     .sentence = "{a} touched {b}"},
    {.type = EventType::contact_lost,
     .name = "contact.lost",
     .heading = "contact lost",
     .severity = Severity::routine,
     .doc = "two bodies separated",
     .sentence = "{a} left {b}"},
    {.type = EventType::seat_lost,
     .name = "seat.lost",
     .heading = "seat lost",
     .severity = Severity::loss,
     .traits = has_place | can_cause,
     .value = {"speed", "m/s"},
     .doc = "the end of a span left its seat; seat: the seat",
     .sentence = "{body_a} lost its seat on {body_b} ({text})"},
    {.type = EventType::impact,
     .name = "impact",
     .heading = "impact",
     .severity = Severity::notice,
     .traits = has_place | can_cause,
     .value = {"closing speed", "m/s", "closing speed"},
     .doc = "two bodies collided faster than the model's impact_speed",
     .sentence = "{a} hit {b} at {value}"},
    {.type = EventType::body_at_rest,
     .name = "body.rest",
     .heading = "body at rest",
     .severity = Severity::routine,
     .doc = "a body came to rest",
     .sentence = "{a} came to rest"},
    {.type = EventType::body_left,
     .name = "body.left",
     .heading = "body left",
     .severity = Severity::notice,
     .traits = has_place | can_cause,
     .value = {"speed", "m/s"},
     .doc = "a body left the bounds and is no longer part of the model",
     .sentence = "{a} left the bounds at {value}"},
    {.type = EventType::body_passed,
     .name = "body.passed",
     .heading = "body passed",
     .severity = Severity::invalid,
     .traits = has_place | can_cause,
     .value = {"overlap", "m"},
     .doc = "a body was found inside another; the run is not valid from here",
     .sentence = "{a} penetrated {b}: {value} deep {text}"},
    {.type = EventType::element_overstrained,
     .name = "element.overstrained",
     .heading = "overstrained",
     .severity = Severity::loss,
     .traits = has_place | can_cause,
     .value = {"strain", "1"},
     .doc = "an element exceeded the strain limit of its material",
     .sentence = "{text} of {a} {strain}"},
    {.type = EventType::stage_diverged,
     .name = "stage.diverged",
     .heading = "diverged",
     .severity = Severity::invalid,
     .traits = valid_until,
     .value = {"sound until", "s", "last valid time"},
     .text_doc = "reason",
     .doc = "a stage was ended by divergence",
     .sentence = "diverged because {text}"},
    {.type = EventType::stage_unsettled,
     .name = "stage.unsettled",
     .heading = "not at rest",
     .severity = Severity::invalid,
     .value = {"unbalanced", "1", "out-of-balance ratio"},
     .doc = "a consolidation did not come to rest near its start",
     .sentence = "did not come to rest: {text}"},
    {.type = EventType::integrator_changed,
     .name = "integrator.changed",
     .heading = "integrator changed",
     .severity = Severity::routine,
     .value = {"step", "s", "its time step"},
     .doc = "the integrator changed",
     .sentence = "{text}"},
    {.type = EventType::body_added,
     .name = "body.added",
     .heading = "body added",
     .severity = Severity::change,
     .traits = has_place | can_cause,
     .doc = "a body was added or returned",
     .sentence = "{a} was added"},
    {.type = EventType::body_removed,
     .name = "body.removed",
     .heading = "body removed",
     .severity = Severity::change,
     .traits = has_place | can_cause,
     .value = {"speed", "m/s", "its speed"},
     .doc = "a body was removed",
     .sentence = "{a} was removed"},
    {.type = EventType::bearing_added,
     .name = "bearing.added",
     .heading = "bearing added",
     .severity = Severity::change,
     .traits = has_place | can_cause,
     .value = {"displacement", "m"},
     .doc = "a bearing was added or returned",
     .sentence = "bearing {bearing} was added{at}"},
    {.type = EventType::bearing_removed,
     .name = "bearing.removed",
     .heading = "bearing removed",
     .severity = Severity::change,
     .traits = has_place | can_cause,
     .value = {"displacement", "m"},
     .doc = "a bearing was removed",
     .sentence = "bearing {bearing} was removed{at}"},
    {.type = EventType::bond_skipped,
     .name = "bond.skipped",
     .heading = "bond skipped",
     .severity = Severity::invalid,
     .traits = can_cause,
     .value = {"missing work", "J", "missing work"},
     .doc = "a given dt skipped work of a bond; the run is not valid from here",
     .sentence = "bond of {a} and {b} was skipped: {text}"},
});

constexpr bool rows_match_types() {
  for (std::size_t i = 0; i < event_type_info.size(); ++i)
    if (event_type_info[i].type != static_cast<EventType>(i) || !is_complete(event_type_info[i])) return false;
  return event_type_info.size() == event_types;
}
static_assert(rows_match_types(), "each EventType has one complete row here, in the order of the enumeration");

constexpr const EventTypeInfo& info_of(EventType type) {
  return event_type_info[static_cast<std::size_t>(type)];
}
constexpr bool has_trait(EventType type, EventTrait trait) {
  return (info_of(type).traits & trait) != 0;
}
constexpr Severity severity_of(EventType type) {
  return info_of(type).severity;
}

/// The row of a type by its name in scripts and results; null for a name that this program does not know.
constexpr const EventTypeInfo* event_info(std::string_view name) {
  for (const EventTypeInfo& row : event_type_info)
    if (row.name == name) return &row;
  return nullptr;
}

/// Severity of an event of a results file. A type that this program does not know is a notice.
constexpr Severity severity_of(std::string_view name) {
  const EventTypeInfo* const row = event_info(name);
  return row == nullptr ? Severity::notice : row->severity;
}

/// Impacts slower than this are omitted where only important events are shown [m/s].
inline constexpr double slow_impact = 2;

/// Whether an event is important and is shown in short lists. `value`: Event::value, the speed of an impact.
constexpr bool is_of_note(std::string_view name, double value) {
  const bool is_slow = name == info_of(EventType::impact).name && value < slow_impact;
  return severity_of(name) != Severity::routine && !is_slow;
}

}  // namespace trilith
