// What happens in a run: typed, in a fixed order, each with its cause.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

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
};
inline constexpr int event_types = 18;

/// Of a mortar joint: its Event::text is the mode, a name of joint_modes.
constexpr bool is_of_joint(EventType type) {
  return type == EventType::bond_cracked || type == EventType::bond_broken || type == EventType::joint_crushed;
}
/// How a joint fails; results hold the place in this list.
inline constexpr std::array<std::string_view, 3> joint_modes{"tension", "shear", "compression"};

struct EventTypeInfo {
  std::string_view name;        ///< as in scripts and results
  std::string_view value_name;  ///< what Event::value is
  std::string_view value_unit;
};

inline constexpr std::array<EventTypeInfo, event_types> event_type_info{{
    {"stage.begun", "", ""},
    {"stage.ended", "", ""},
    {"bond.cracked", "force", "N"},
    {"bond.broken", "force", "N"},
    {"joint.crushed", "force", "N"},
    {"bearing.yielded", "displacement", "m"},
    {"bearing.failed", "displacement", "m"},
    {"bearing.changed", "displacement", "m"},
    {"contact.made", "closing speed", "m/s"},
    {"contact.lost", "", ""},
    {"seat.lost", "speed", "m/s"},
    {"impact", "closing speed", "m/s"},
    {"body.rest", "", ""},
    {"body.left", "speed", "m/s"},
    {"body.passed", "overlap", "m"},
    {"element.overstrained", "strain", "1"},
    {"stage.diverged", "sound until", "s"},
    {"stage.unsettled", "unbalanced", "1"},
}};

struct Event {
  EventType type{};
  std::int64_t id = -1;     ///< rising from 0 within a run
  std::int64_t cause = -1;  ///< id of the event that led to this one, or -1
  double time = 0;          ///< [s]
  std::int64_t step = 0;
  int body_a = -1, body_b = -1, bearing = -1;
  double value = 0;     ///< see EventTypeInfo
  double x = 0, y = 0;  ///< where [m]
  std::string text;     ///< the rest in words: the mode of a joint's failure (tension, shear or compression), which
                        ///< element of its body, why a stage diverged or did not settle
};

}  // namespace trilith
