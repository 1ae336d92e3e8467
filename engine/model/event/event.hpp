// Events of a run: typed, in a fixed order, each with its cause.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/space.hpp"

namespace trilith {

/// A new type comes before `count` and has a row in model/event/event_list.hpp.
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
  bond_skipped,
  joint_flooded,
  joint_drained,
  unit_cracked,
  count  ///< number of the types; stays last
};
inline constexpr int event_types = static_cast<int>(EventType::count);

/// Failure mode of a mortar joint; results store the number.
enum class JointMode : std::uint8_t { tension, shear, compression };
/// "tension", ...
constexpr std::string_view name_of(JointMode mode) {
  constexpr std::array<std::string_view, 3> names{"tension", "shear", "compression"};
  return names[static_cast<std::size_t>(mode)];
}

struct Event {
  EventType type{};
  std::int64_t id = -1;     ///< increasing from 0 within a run
  std::int64_t cause = -1;  ///< id of the event that caused this one, or -1
  double time = 0;          ///< [s]
  std::int64_t step = 0;
  int body_a = -1, body_b = -1, bearing = -1;
  double value = 0;            ///< see EventTypeInfo::value
  double x = 0, y = 0, z = 0;  ///< position [m]; z is up in space, and 0 in the plane
  JointMode mode{};            ///< for a joint
  std::string text;  ///< further text: element or member of its body, or why a stage diverged or did not settle

  void set_place(const Vec2& at) { x = at.x(), y = at.y(); }
  void set_place(const Vec3& at) { x = at.x(), y = at.y(), z = at.z(); }
};

}  // namespace trilith
