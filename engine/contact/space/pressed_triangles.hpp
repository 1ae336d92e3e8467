// Integrals over triangles with linear pressure, four at a time.
//
// Input: triangles of the pressed faces of two solids (contact/space/solid_pressure.hpp), each in one cell, with the
// depth at its corners, and the relative motion. Output: force, moments, power and spread of the pressure d + beta c
// where positive, and the moments of the area. With u = p + q + r the sum of the arms of its corners, s = f(p) + f(q) +
// f(r) the sum of a linear function at them, and A its area:
//
//     integral f = A s / 3                   integral f x = A / 12 (s u + f(p) p + f(q) q + f(r) r)
//     integral x x' = A / 12 (u u' + p p' + q q' + r r')
//     integral f x x' = A / 60 (s u u' + u w' + w u' + (s + 2 f(p)) p p' + ...),   w = f(p) p + f(q) q + f(r) r
#pragma once

#include <span>

#include "contact/space/triangle_sums.hpp"

namespace trilith {

/// `beta`: damping time [s]. `along`: see solid_pressure.
PressedSums pressed_triangles(std::span<const FourTriangles> triangles, double beta, const ClosingMotion& motion,
                              const Vec3* along = nullptr);

}  // namespace trilith
