// Contacts of faces from arrays of any origin, for whom wants to know what rows would answer elsewhere.
#pragma once

#include <span>

#include "assembly/contact/face_contact_simd.hpp"
#include "law/contact/list.hpp"

namespace trilith {

/// Rows of one law: forces and flags go to `pass.kept`, one entry for each four of `rows`, memories to its arrays.
/// Work is not written. `rows` can be read by fours: beyond its end it holds its last row again.
void respond_face_rows(const FacePass& pass, const LawInUse& law, std::span<const int> rows);

}  // namespace trilith
