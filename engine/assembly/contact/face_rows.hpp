// Contacts of faces from arrays of any origin, to evaluate rows in positions other than the present one.
#pragma once

#include <span>

#include "assembly/contact/face_contact_simd.hpp"
#include "law/contact/list.hpp"

namespace trilith {

/// Evaluates rows of one law. Forces and flags are written to `pass.kept`, one entry for each four of `rows`, and
/// memories to its arrays. Work is not modified. `rows` is padded for reading in groups of four: beyond its end it
/// repeats its last row.
void respond_face_rows(const FacePass& pass, const LawInUse& law, std::span<const int> rows);

}  // namespace trilith
