// Integrals over triangles with linear pressure, four at a time.
//
// Input: triangles of the pressed faces of two solids (contact/space/solid_pressure.hpp), each in one cell, with the
// depth at its corners, and the relative motion. Output: force, moments, power and spread of the pressure d + beta c
// where positive, and the moments of the area. With l the barycentric coordinates of the corners p_i, u the sum of the
// corners' arms, s the sum of a linear function f at the corners, and A the area:
//
//     integral f l_i = A / 12 (s + f_i)             integral f x = sum of p_i (integral f l_i)
//     integral f l_i l_j = A / 60 (s + f_i + f_j), twice that for i = j
//     integral x x' = A / 12 (u u' + sum of p_i p_i')
//
// A triangle on which the pressure changes its sign has the same integrals with other moments f l_i and f l_i l_j.
#pragma once

#include <span>

#include "contact/space/triangle_sums.hpp"

namespace trilith {

/// `beta`: damping time [s]. `along`: see solid_pressure.
PressedSums pressed_triangles(std::span<const FourTriangles> triangles, double beta, const ClosingMotion& motion,
                              const Vec3* along = nullptr);

}  // namespace trilith
