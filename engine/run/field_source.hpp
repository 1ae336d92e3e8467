// What the numbers that a recording adds to each frame (run/recorded_field_list.hpp) are found from.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "run/joints.hpp"
#include "run/stage.hpp"
#include "step/contact_resultants.hpp"

namespace trilith {

/// What the rows of a field belong to.
enum class RowsOf : std::uint8_t { joints, bodies };

/// What fields are found from, all of one instant.
struct FieldSource {
  const Instant<2>& now;
  std::span<const Joint> joints;
  std::span<const TouchingContact> touching;
  std::span<const JointDisplacement> joint_displacements;  ///< of each joint
};

}  // namespace trilith
