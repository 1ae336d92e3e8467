// Descriptions of supports, ground motions and bearings in a results file.
#pragma once

#include <array>
#include <string>

#include "model/model.hpp"
#include "results/file/results.hpp"

namespace trilith {

/// "fixed", "moved", "free", or each degree of freedom separately: "x moved, y free, rotation free".
std::string support_text(const std::array<Support, 3>& support);
std::string support_text(const std::array<Support, 6>& support);

/// True for the drive of a body's first node, which represents the drives of all its nodes.
template <int D>
bool leads(const Model<D>& model, const Drive& drive);

/// Description of the ground motion of one degree of freedom: "El Centro ... on 'left ground' (x), from t = 3.2 s".
template <int D>
std::string drive_text(const Model<D>& model, const Drive& drive);

/// The ground motion with its samples, for the results file.
template <int D>
results::MotionRow motion_row(const Model<D>& model, const Drive& drive);

/// Laws of a bearing by direction, its limits and its successor.
template <int D>
std::string bearing_text(const Model<D>& model, const Bearing<D>& bearing);

}  // namespace trilith
