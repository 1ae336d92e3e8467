// How small a solid may be.
#pragma once

namespace trilith {

/// Smallest size of a solid and smallest radius of a sphere, m: masses and moments of inertia of smaller ones are lost
/// among numbers next to 0.
inline constexpr double kLeastSize = 1e-9;

}  // namespace trilith
