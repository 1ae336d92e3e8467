// Parts of a model that engineering results refer to: joints, storeys and base, as found at its start.
#pragma once

#include <vector>

#include "run/record/face_joints.hpp"
#include "run/record/storeys.hpp"

namespace trilith {

template <int D>
struct Findings {
  std::vector<JointOf<D>> joints;
  std::vector<Storey> storeys;
  std::vector<int> base;  ///< bodies that the structure stands on

  explicit Findings(const Model<D>& model)
      : joints(find_joints(model)), storeys(find_storeys(model)), base(find_base(model)) {}
};

}  // namespace trilith
