// Collinear faces of a mesh: where one face is too short to classify a contact, its neighbours are included.
//
// If two meshed bodies lie flat on each other, a face of one meets the opposite face and also, because nodes slide
// slightly, the next one. That sliver is shorter than it is deep, so `FaceOverlap::is_flat` would reject it although it
// belongs to a flat joint. Therefore the depth is compared with the length that the faces share together with their
// collinear neighbours, one on each side. The neighbours' tilt must be within the limit for faces.
//
//            b.1 ___________ b.0 ____________ before b.0
//                          |-|                           the sliver
//       before a.0 ______ a.0 ______________ a.1
//            |----------------------------------|        compared with the depth
//
// The pressure on the sliver is computed as for two faces, and the slivers of a joint add up to its length. Collinear
// faces that share no length are a face pair without contact.
#pragma once

#include "law/contact/face_overlap.hpp"
#include "model/model.hpp"
#include "model/work.hpp"

namespace trilith {

/// Model::skin_before and skin_after; null if no body has such faces.
struct FaceLine {
  const int *before = nullptr, *after = nullptr;
  [[nodiscard]] bool is_there() const { return after != nullptr; }
};
inline FaceLine face_line(const Model<2>& model) {
  if (model.skin_after.empty()) return {};
  return {model.skin_before.data(), model.skin_after.data()};
}

/// Vectors from the ends of two faces to the next collinear skin points, as columns; 0 where there are none [m].
template <class T>
struct NextInLine {
  T a0x, a0y, a1x, a1y, b0x, b0y, b1x, b1y;
  Mask<T> some;  ///< there is a neighbour
};

/// Extent of the neighbour at an end along the common direction of the faces [m]; 0 where its tilt exceeds the limit.
template <class T>
TRILITH_INLINE T reach_in_line(const FaceOverlap<T>& o, T x, T y) {
  const T along = o.dx * x + o.dy * y, across = o.dy * x - o.dx * y;
  return select(magnitude(across) < face_pair_max_tilt * magnitude(along), along, T{});
}

/// Whether face pairs that are not flat by themselves are flat together with their collinear neighbours. `o`: overlap
/// of the faces alone; `corner`: see NearPair.
template <class T>
TRILITH_INLINE Mask<T> are_flat_in_line(const FaceOverlap<T>& o, const NextInLine<T>& next, T corner) {
  const T zero{};
  // The faces oppose each other and are nearly parallel.
  const Mask<T> look = (o.inv_a > zero) & (o.inv_b > zero) & (o.tilt < zero + face_pair_max_tilt);
  const T end_a = 1.0 / o.inv_a, end_b = o.sb1 + 1.0 / o.inv_b;
  // Along d, A's face continues to lower s before a.0 and to higher s after a.1; B runs the other way.
  const T low_a = smaller(reach_in_line(o, next.a0x, next.a0y), zero),
          low_b = o.sb1 + smaller(reach_in_line(o, next.b1x, next.b1y), zero),
          high_a = end_a + larger(reach_in_line(o, next.a1x, next.a1y), zero),
          high_b = end_b + larger(reach_in_line(o, next.b0x, next.b0y), zero);
  const T low = larger(low_b, low_a), high = smaller(high_b, high_a), depth = -smaller(o.gap_hi, o.gap_lo);
  return next.some & look & (high > low) & (depth * corner <= (high - low) * face_pair_max_depth);
}

/// For one pair, with the skin of a placed Work.
bool is_flat_in_line(const FaceLine& line, const SkinMotion<2>* skin, const NearPair& pair);

/// Upper bound of the length that the neighbours add to the two faces [m].
double length_in_line(const FaceLine& line, const SkinMotion<2>* skin, int a0, int a1, int b0, int b1);

}  // namespace trilith
