// What the numbers that a recording adds to each frame (run/record/recorded_field_list.hpp) are found from.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "assembly/contact/contact_resultants.hpp"
#include "run/record/face_joints.hpp"
#include "run/stage.hpp"

namespace trilith {

/// What the rows of a field belong to.
enum class RowsOf : std::uint8_t { joints, bodies };

/// What fields are found from, all of one instant.
template <int D>
struct FieldSource {
  const Instant<D>& now;
  std::span<const JointOf<D>> joints;
  std::span<const TouchingContact> touching;               ///< in the plane
  std::span<const JointDisplacement> joint_displacements;  ///< of each joint
};

}  // namespace trilith
