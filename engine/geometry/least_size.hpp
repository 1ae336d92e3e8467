// Lower limit of the size of a solid.
#pragma once

namespace trilith {

/// Smallest size of a solid and smallest radius of a sphere [m]: masses and moments of inertia of smaller solids would
/// be close to underflow.
inline constexpr double kLeastSize = 1e-9;

}  // namespace trilith
