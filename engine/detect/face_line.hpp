// Faces of a mesh that lie in one line: where one alone is too short to tell, its neighbours do.
//
// Where two meshed bodies lie flat on each other, a face of the one meets not only the face across but, by the little
// that its nodes have slid, the next one too. That sliver is shorter than it is deep, and would be no pair of faces by
// FaceOverlap::is_flat, though it is part of a flat joint. So the depth is compared with the length that the faces
// share together with their neighbours in line (each one of them, on either side), if these are tilted by no more than
// faces may be:
//
//            b.1 ___________ b.0 ____________ before b.0
//                          |-|                           the sliver
//       before a.0 ______ a.0 ______________ a.1
//            |----------------------------------|        compared with the depth
//
// The pressure on the sliver is that of two faces, and slivers of a joint add up to its length. Faces in line that
// share no length are a pair of faces that does not touch.
#pragma once

#include "contact/face_overlap.hpp"
#include "world/model.hpp"
#include "world/work.hpp"

namespace trilith {

/// Model::skin_before and skin_after; null where no body has such faces.
struct FaceLine {
  const int *before = nullptr, *after = nullptr;
  [[nodiscard]] bool is_there() const { return after != nullptr; }
};
inline FaceLine face_line(const Model<2>& model) {
  if (model.skin_after.empty()) return {};
  return {model.skin_before.data(), model.skin_after.data()};
}

/// Whether the faces of a pair, which are no pair of faces by themselves, are flat with their neighbours in line.
/// `skin`: as Work is placed; `overlap`: of the two faces alone.
bool is_flat_in_line(const FaceLine& line, const SkinMotion<2>* skin, const NearPair& pair,
                     const FaceOverlap<double>& overlap);
bool is_flat_in_line(const FaceLine& line, const SkinMotion<2>* skin, const NearPair& pair);

/// How much longer the two faces get by their neighbours, at most [m].
double length_in_line(const FaceLine& line, const SkinMotion<2>* skin, int a0, int a1, int b0, int b1);

}  // namespace trilith
