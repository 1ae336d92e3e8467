// Events of a run: typed, in a fixed order, each with its cause.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/space.hpp"

namespace trilith {

enum class EventType : int {
  stage_begun,
  stage_ended,
  bond_cracked,
  bond_broken,
  joint_crushed,
  bearing_yielded,
  bearing_failed,
  bearing_changed,
  member_yielded,
  member_failed,
  member_removed,
  contact_made,
  contact_lost,
  seat_lost,
  impact,
  body_at_rest,
  body_left,
  body_passed,
  element_overstrained,
  stage_diverged,
  stage_unsettled,
  integrator_changed,
  body_added,
  body_removed,
  bearing_added,
  bearing_removed,
};
inline constexpr int event_types = 26;

/// Failure mode of a mortar joint; results store the number.
enum class JointMode : std::uint8_t { tension, shear, compression };
/// "tension", ...
constexpr std::string_view name_of(JointMode mode) {
  constexpr std::array<std::string_view, 3> names{"tension", "shear", "compression"};
  return names[static_cast<std::size_t>(mode)];
}

/// Properties of an event type, combined by |.
enum EventTrait : unsigned {
  has_place = 1,   ///< Event::x and y are its position
  of_joint = 2,    ///< of a mortar joint: Event::mode is its failure mode
  can_cause = 4,   ///< other events may follow from it
  is_minor = 8,    ///< omitted where only notable events are printed
  spoils_run = 16  ///< the run is not, or not entirely, reliable; see model/verdict.hpp
};

struct EventTypeInfo {
  std::string_view name;        ///< as in scripts and results
  std::string_view heading;     ///< a short description
  std::string_view value_name;  ///< meaning of Event::value
  std::string_view value_unit;
  unsigned traits;
};

/// In the order of EventType.
inline constexpr std::array<EventTypeInfo, event_types> event_type_info{{
    {"stage.begun", "stage begun", "", "", 0},
    {"stage.ended", "stage ended", "", "", 0},
    {"bond.cracked", "bond cracked", "force", "N", has_place | of_joint | can_cause},
    {"bond.broken", "bond broken", "force", "N", has_place | of_joint | can_cause},
    {"joint.crushed", "joint crushed", "force", "N", has_place | of_joint | can_cause},
    {"bearing.yielded", "bearing yielded", "displacement", "m", has_place},
    {"bearing.failed", "bearing failed", "displacement", "m", has_place | can_cause},
    {"bearing.changed", "bearing changed", "displacement", "m", has_place | can_cause},
    {"member.yielded", "member yielded", "moment", "N m", has_place},
    {"member.failed", "member failed", "rotation", "rad", has_place | can_cause},
    {"member.removed", "member removed", "energy", "J", has_place | can_cause},
    {"contact.made", "contact made", "closing speed", "m/s", has_place | is_minor},
    {"contact.lost", "contact lost", "", "", is_minor},
    {"seat.lost", "seat lost", "speed", "m/s", has_place | can_cause},
    {"impact", "impact", "closing speed", "m/s", has_place | can_cause},
    {"body.rest", "body at rest", "", "", is_minor},
    {"body.left", "body left", "speed", "m/s", has_place | can_cause | spoils_run},
    {"body.passed", "body passed", "overlap", "m", has_place | can_cause | spoils_run},
    {"element.overstrained", "overstrained", "strain", "1", has_place | can_cause},
    {"stage.diverged", "diverged", "sound until", "s", spoils_run},
    {"stage.unsettled", "not at rest", "unbalanced", "1", spoils_run},
    {"integrator.changed", "integrator changed", "step", "s", is_minor},
    {"body.added", "body added", "", "", has_place | can_cause},
    {"body.removed", "body removed", "speed", "m/s", has_place | can_cause},
    {"bearing.added", "bearing added", "", "", has_place | can_cause},
    {"bearing.removed", "bearing removed", "", "", has_place | can_cause},
}};

constexpr const EventTypeInfo& info_of(EventType type) {
  return event_type_info[static_cast<std::size_t>(type)];
}
constexpr bool has_trait(EventType type, EventTrait trait) {
  return (info_of(type).traits & trait) != 0;
}

struct Event {
  EventType type{};
  std::int64_t id = -1;     ///< increasing from 0 within a run
  std::int64_t cause = -1;  ///< id of the event that caused this one, or -1
  double time = 0;          ///< [s]
  std::int64_t step = 0;
  int body_a = -1, body_b = -1, bearing = -1;
  double value = 0;            ///< see EventTypeInfo
  double x = 0, y = 0, z = 0;  ///< position [m]; z is up in space, and 0 in the plane
  JointMode mode{};            ///< for a joint
  std::string text;  ///< further text: element or member of its body, or why a stage diverged or did not settle

  void set_place(const Vec2& at) { x = at.x(), y = at.y(); }
  void set_place(const Vec3& at) { x = at.x(), y = at.y(), z = at.z(); }
};

}  // namespace trilith
