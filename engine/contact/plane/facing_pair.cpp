// The only pair of faces of two solids that may lie flat, and the motion for which no other pair can.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

#include "base/simd/lane_bits.hpp"
#include "base/simd/lane_vectors.hpp"
#include "contact/plane/opposed_faces.hpp"
#include "contact/space/solid_faces.hpp"
#include "geometry/plane/edge_overlap.hpp"

namespace trilith {
namespace {

/// Two faces, and the amount by which the product of their normals exceeds the limit of flat faces.
struct PairOfFaces {
  int f = 0, g = 0;
  double beyond = unbounded;
};

/// Among the pairs beyond the limit the nearest to it.
PairOfFaces least_to_turn(const PlacedSolid& a, const PlacedSolid& b) {
  PairOfFaces least;
  for (int f = 0; f < a.solid->shape.faces.count(); ++f)
    for (int g = 0; g < b.solid->shape.faces.count(); ++g) {
      const double beyond = opposed(a, f, b, g) - opposed_enough;
      const bool is_less = (beyond > 0) & (beyond < least.beyond);
      least = {is_less ? f : least.f, is_less ? g : least.g, is_less ? beyond : least.beyond};
    }
  return least;
}

/// Amount by which the products of all normals of two solids with few faces exceed the limit of flat faces, eight for
/// each face of a.
struct BeyondOpposed {
  static constexpr std::size_t most = few_faces;
  std::array<std::array<Lanes, 2>, most> of;
  std::size_t faces;  // number of faces of a
  double least;       // least positive value

  TRILITH_INLINE BeyondOpposed(const PlacedSolid& a, const PlacedSolid& b) : faces(a.normals.size()) {
    std::array<Triple<Lanes>, 2> n;
    for (std::size_t g = 0; g < most; ++g) {
      const Vec3& v = b.normals[std::min(g, b.normals.size() - 1)];
      const auto lane = static_cast<int>(g % lane_count);
      n[g / lane_count].x[lane] = v.x(), n[g / lane_count].y[lane] = v.y(), n[g / lane_count].z[lane] = v.z();
    }
    Lanes smallest = Lanes{} + unbounded;
    for (std::size_t f = 0; f < faces; ++f)
      for (std::size_t half = 0; half < 2; ++half) {
        const Vec3& m = a.normals[f];
        const Triple<Lanes>& v = n[half];
        const Lanes beyond = (m.x() * v.x + (m.y() * v.y + m.z() * v.z)) - opposed_enough;
        of[f][half] = beyond;
        smallest = select(beyond > 0.0, smaller<Lanes>(smallest, beyond), smallest);
      }
    least = smaller(smaller(smallest[0], smallest[1]), smaller(smallest[2], smallest[3]));
  }
  /// Calls f(face of a, face of b, beyond) for all values not above 0, and for those below the current value of
  /// `enough`.
  template <class F>
  TRILITH_INLINE void for_below(std::size_t faces_of_b, const double& enough, F&& f) const {
    for (std::size_t i = 0; i < faces; ++i) {
      const Lanes &first = of[i][0], &rest = of[i][1];
      unsigned bits = lane_bits((first <= 0.0) | (first < enough), (rest <= 0.0) | (rest < enough));
      for (bits &= (1U << faces_of_b) - 1; bits != 0; bits &= bits - 1) {
        const int g = std::countr_zero(bits);
        const double beyond = g < lane_count ? first[g] : rest[g - lane_count];
        if (beyond <= 0 || beyond < enough) f(static_cast<int>(i), g, beyond);
      }
    }
  }
  /// The two faces with the least rotation to the limit.
  [[nodiscard]] TRILITH_INLINE PairOfFaces nearest() const {
    for (std::size_t f = 0; f < faces; ++f)
      if (const unsigned bits = lane_bits(of[f][0] == least, of[f][1] == least); bits != 0)
        return {static_cast<int>(f), std::countr_zero(bits), least};
    return {};
  }
};

/// Corner indices of a face in its solid, the last one repeated; false where there are too many.
bool list_few(const ConvexSolid& solid, int face, std::array<std::uint8_t, few_corners>& corner) {
  const std::span<const int> loop = solid.shape.faces[face];
  if (loop.size() > corner.size()) return false;
  for (std::size_t k = 0; k < corner.size(); ++k) {
    const int c = loop[std::min(k, loop.size() - 1)];
    if (c > std::numeric_limits<std::uint8_t>::max()) return false;
    corner[k] = static_cast<std::uint8_t>(c);
  }
  return true;
}

/// Sets the data that belong to the two faces found.
void describe(const PlacedSolid& a, const PlacedSolid& b, FacePair& found) {
  found.near = near_faces(a, b), found.b_is_larger = a.solid->size < b.solid->size;
  found.few = list_few(*a.solid, found.a, found.corner_a) && list_few(*b.solid, found.b, found.corner_b);
}

FacePair none_yet() {
  FacePair found;
  found.a = found.b = FacePair::none, found.until = unbounded;
  return found;
}

/// State of the search for the pair of faces of two solids that may lie flat.
///
/// If corners have moved by at most t, a body of inner radius r (ConvexSolid) has rotated by so little that a unit
/// vector fixed in it has changed by at most t / r. So with the sum t of both bodies, and r the smaller inner radius,
/// the product of two normals changes by at most t / r. The depth of a corner x below a plane through c changes by at
/// most t + |c - x| t / r. A pair that is not flat stays so until one of these changes reaches its limit.
struct FacePairSearch {
  const PlacedSolid &a, &b;
  double near = near_faces(a, b), turns = 1 / std::min(a.solid->inner_radius, b.solid->inner_radius);
  FacePair found = none_yet();
  double enough = unbounded;  // motion after which another pair may be flat
  bool several = false;

  void may_become_one(double beyond, const PlaneDistance& distance) {
    const double by_turn = beyond / turns, by_way = (distance.depth - near) / (1 + distance.corner * turns);
    found.until = std::min(found.until, std::max(by_turn, by_way)), enough = found.until * turns;
  }
  /// Starts with the pair that needs the least rotation: most other pairs are then known to need more.
  void begin_with(const PairOfFaces& nearest) {
    if (nearest.beyond < unbounded && fits_faces(a, nearest.f) && fits_faces(b, nearest.g))
      may_become_one(nearest.beyond, PlaneDistance(a, nearest.f, b, nearest.g));
  }
  void look_at(int f, int g, double beyond) {
    if (several || (beyond > 0 && beyond >= enough) || !fits_faces(a, f) || !fits_faces(b, g)) return;
    const PlaneDistance distance(a, f, b, g);
    if (beyond > 0 || distance.depth > near) return may_become_one(beyond, distance);
    several = found.a >= 0;
    found.a = f, found.b = g;
  }
  [[nodiscard]] FacePair result(double way) const {
    if (several) return {};
    FacePair out = found;
    out.until = way + (1 - 1e-6) * found.until;
    if (out.a >= 0) describe(a, b, out);
    return out;
  }
};

[[gnu::target_clones("avx2", "default")]] void search_few(FacePairSearch& search) {
  const BeyondOpposed beyond(search.a, search.b);
  search.begin_with(beyond.nearest());
  beyond.for_below(search.b.normals.size(), search.enough, [&](int f, int g, double by) { search.look_at(f, g, by); });
}

}  // namespace

FacePair facing_pair(const PlacedSolid& a, const PlacedSolid& b, double way) {
  FacePairSearch search{a, b};
  if (has_few_faces(*a.solid) && has_few_faces(*b.solid)) {
    search_few(search);
    return search.result(way);
  }
  search.begin_with(least_to_turn(a, b));
  for (int f = 0; f < a.solid->shape.faces.count(); ++f)
    for (int g = 0; g < b.solid->shape.faces.count(); ++g) search.look_at(f, g, opposed(a, f, b, g) - opposed_enough);
  return search.result(way);
}

}  // namespace trilith
