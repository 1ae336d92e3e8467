// Data from which the fields of each frame are computed (run/record/recorded_field_list.hpp).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "assembly/contact/contact_resultants.hpp"
#include "run/record/face_joints.hpp"
#include "run/stage.hpp"

namespace trilith {

/// Objects to which the rows of a field belong.
enum class RowsOf : std::uint8_t { joints, bodies };

/// Input of the fields, all at one instant.
template <int D>
struct FieldSource {
  const Instant<D>& now;
  std::span<const JointOf<D>> joints;
  std::span<const TouchingContact> touching;               ///< in the plane only
  std::span<const JointDisplacement> joint_displacements;  ///< of each joint
};

}  // namespace trilith
