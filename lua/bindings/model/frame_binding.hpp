// Common readers of beams and frames in the plane and in space.
#pragma once

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "bindings/core/handles.hpp"
#include "bindings/core/keys.hpp"
#include "element/beam/end_hinge.hpp"

namespace trilith::script {

/// Initial position of a named joint, of a body in the plane or in space. Throws InputError if there is none.
template <class Spec>
auto joint_start(const Spec& spec, const std::string& joint) {
  std::vector<std::string> known;
  if (spec.frame)
    for (const auto& j : spec.frame->joints) {
      if (j.name == joint) return j.place;
      known.push_back(j.name);
    }
  throw InputError(fmt::format("point: body '{}' has no joint '{}'{}", spec.name, joint, name_hint(joint, known)));
}

/// hinge = for both ends of a member, from_hinge and to_hinge for one.
std::array<std::optional<HingeLaw>, 2> read_hinges(Keys& keys);
/// mass_matrix: true for "consistent".
bool read_mass_matrix(Keys& keys);
/// `state` in body:hinges.
const char* hinge_state_text(HingeStatus status);

}  // namespace trilith::script
