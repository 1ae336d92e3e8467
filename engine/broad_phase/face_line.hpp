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

#include "law/contact/face_overlap.hpp"
#include "model/model.hpp"
#include "model/work.hpp"

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

/// From the ends of two faces to the next skin points in line, as columns; 0 where there are none [m].
template <class T>
struct NextInLine {
  T a0x, a0y, a1x, a1y, b0x, b0y, b1x, b1y;
  Mask<T> some;  ///< there is one
};

/// How far the neighbour at an end reaches along the common direction of the faces [m]; 0 where it is tilted too much.
template <class T>
TRILITH_INLINE T reach_in_line(const FaceOverlap<T>& o, T x, T y) {
  const T along = o.dx * x + o.dy * y, across = o.dy * x - o.dx * y;
  return select(magnitude(across) < face_pair_max_tilt * magnitude(along), along, T{});
}

/// Whether the faces of pairs, which are no pairs of faces by themselves, are flat with their neighbours in line.
/// `o`: of the faces alone; `corner`: see NearPair.
template <class T>
TRILITH_INLINE Mask<T> are_flat_in_line(const FaceOverlap<T>& o, const NextInLine<T>& next, T corner) {
  const T zero{};
  // They look at each other, and are nearly parallel.
  const Mask<T> look = (o.inv_a > zero) & (o.inv_b > zero) & (o.tilt < zero + face_pair_max_tilt);
  const T end_a = 1.0 / o.inv_a, end_b = o.sb1 + 1.0 / o.inv_b;
  // Along d the ends of A go on to lower s before a.0 and to higher s after a.1; B runs against it.
  const T low_a = smaller(reach_in_line(o, next.a0x, next.a0y), zero),
          low_b = o.sb1 + smaller(reach_in_line(o, next.b1x, next.b1y), zero),
          high_a = end_a + larger(reach_in_line(o, next.a1x, next.a1y), zero),
          high_b = end_b + larger(reach_in_line(o, next.b0x, next.b0y), zero);
  const T low = larger(low_b, low_a), high = smaller(high_b, high_a), depth = -smaller(o.gap_hi, o.gap_lo);
  return next.some & look & (high > low) & (depth * corner <= (high - low) * face_pair_max_depth);
}

/// The same of one pair, its skin as Work is placed.
bool is_flat_in_line(const FaceLine& line, const SkinMotion<2>* skin, const NearPair& pair);

/// How much longer the two faces get by their neighbours, at most [m].
double length_in_line(const FaceLine& line, const SkinMotion<2>* skin, int a0, int a1, int b0, int b1);

}  // namespace trilith
