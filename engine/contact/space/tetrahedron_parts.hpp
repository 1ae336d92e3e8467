// Parts of the faces of a shared solid that is a tetrahedron: a corner below a face, or an edge across an edge. These
// are half of the contacts in a heap. The parts are those in contact/plane/nearest_parts.hpp, in closed form.
//
//                 C
//                /|\ .
//               / | \.
//             E1--|--E3        P = d (E1/h1 + E2/h2 + E3/h3)
//               \ | /          1/d = 1/h1 + 1/h2 + 1/h3
//                 E2
//
// A corner C of one solid is below one face g of the other. On the faces at C, the face g is nearest. On the face E1 E2
// E3, each of the three faces at C is nearest next to its own edge, up to the point P where they meet. Here hk is the
// depth of Ek below the face at the corner that does not contain it.
//
// For two edges each face has both ends X, Y of one edge's part and one end Z of the other's. X and Z have zero depth
// below one of the two faces of the other solid, Y and Z below the other. The two regions meet in Z S:
//
//   S = X + t (Y - X),   t = hx / (hx + hy),   d = t hy.
//
// Here hx and hy are the depths of X and Y below the face that does not contain them.
#pragma once

#include <bit>
#include <limits>

#include "base/simd/lane_sums.hpp"
#include "geometry/plane/edge_overlap.hpp"
#include "geometry/space/triangle_lanes.hpp"

namespace trilith {

/// A shared solid of four corners and four faces, some of each of the two solids.
class TetrahedronParts {
 public:
  TRILITH_INLINE explicit TetrahedronParts(const EdgeOverlap& shared)
      : shared_(shared),
        faces_{shared.faces & ((1U << few_faces) - 1), shared.faces >> few_faces},
        count_{std::popcount(faces_[0]), std::popcount(faces_[1])} {}

  [[nodiscard]] TRILITH_INLINE bool is_one() const {
    return shared_.points == 4 && count_[0] + count_[1] == 4 && count_[0] > 0 && count_[1] > 0;
  }

  /// Adds the parts of a face. Returns false, and adds nothing, where another face of the other solid may be nearest.
  TRILITH_INLINE bool add_to(TriangleLanes& triangles, const Lanes& face, std::size_t loop) const {
    const std::size_t own = loop / few_faces;
    const Corners of(shared_, shared_.loop[loop], 1 - own, faces_[1 - own]);
    switch (count_[own]) {
      case 3:
        return add_below_one(triangles, face, of);
      case 2:
        return add_below_two(triangles, face, of);
      default:
        return add_below_three(triangles, face, of);
    }
  }

 private:
  /// The corners of a face: arms, and depths below the other solid's face in the tetrahedron that does not contain
  /// them, if any; below all its other faces at least `least` [m].
  struct Corners {
    std::array<Lanes, 3> arm;
    std::array<double, lane_count> depth;
    double least;

    /// `faces`: bits of the other solid's faces in the tetrahedron.
    TRILITH_INLINE Corners(const EdgeOverlap& shared, const EdgeOverlap::Loop& rim, std::size_t other, unsigned faces) {
      const LaneMask bits = LaneMask{} + static_cast<std::int64_t>(faces);
      const std::array<LaneMask, 2> is_other{(bits & LaneMask{1, 2, 4, 8}) == 0,
                                             (bits & LaneMask{16, 32, 64, 128}) == 0};
      Lanes nearest = Lanes{} + std::numeric_limits<double>::infinity();
      std::array<Lanes, 3> sum;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t point = rim.point[k];
        arm[k] = shared.arm[point], sum[k] = Lanes{};
        for (std::size_t half = 0; half < 2; ++half) {
          Lanes row;
          __builtin_memcpy(&row, shared.depth[other][point].below.data() + half * lane_count, sizeof row);
          sum[k] += select(is_other[half], Lanes{}, row);
          nearest = smaller<Lanes>(nearest, select(is_other[half], row, nearest));
        }
      }
      const Lanes depths = larger<Lanes>(Lanes{}, over_four(sum[0], sum[1], sum[2], sum[2]));
      __builtin_memcpy(depth.data(), &depths, sizeof depths);
      least = smaller(smaller(nearest[0], nearest[1]), smaller(nearest[2], nearest[3]));
    }
    [[nodiscard]] TRILITH_INLINE Lanes at(std::size_t k, double below) const {
      Lanes v = arm[k];
      v[3] = below;
      return v;
    }
  };

  TRILITH_INLINE static bool add_below_one(TriangleLanes& triangles, const Lanes& face, const Corners& of) {
    if (!(larger(larger(of.depth[0], of.depth[1]), of.depth[2]) <= of.least)) return false;
    triangles.add(face, of.at(0, of.depth[0]), of.at(1, of.depth[1]), of.at(2, of.depth[2]));
    return true;
  }

  TRILITH_INLINE static bool add_below_two(TriangleLanes& triangles, const Lanes& face, const Corners& of) {
    const std::size_t z = of.depth[0] == 0   ? 0
                          : of.depth[1] == 0 ? 1
                                             : 2,
                      x = z == 2 ? 0 : z + 1, y = x == 2 ? 0 : x + 1;
    const double hx = of.depth[x], hy = of.depth[y], t = hx / (hx + hy), d = t * hy;
    if (!(of.depth[z] == 0 && hx > 0 && hy > 0 && d <= of.least)) return false;
    const Lanes at_x = of.at(x, 0), at_y = of.at(y, 0), at_z = of.at(z, 0);
    Lanes middle = at_x + t * (at_y - at_x);
    middle[3] = d;
    triangles.add(face, at_z, at_x, middle), triangles.add(face, at_z, middle, at_y);
    return true;
  }

  TRILITH_INLINE static bool add_below_three(TriangleLanes& triangles, const Lanes& face, const Corners& of) {
    const double d = 1 / (1 / of.depth[0] + 1 / of.depth[1] + 1 / of.depth[2]);
    if (!(d > 0 && d <= of.least)) return false;
    const Lanes first = of.at(0, 0), second = of.at(1, 0), third = of.at(2, 0);
    Lanes middle = (d / of.depth[0]) * first + (d / of.depth[1]) * second + (d / of.depth[2]) * third;
    middle[3] = d;
    triangles.add(face, first, second, middle), triangles.add(face, second, third, middle);
    triangles.add(face, third, first, middle);
    return true;
  }

  const EdgeOverlap& shared_;
  std::array<unsigned, 2> faces_;  // [solid] bits of the faces that are part of the tetrahedron
  std::array<int, 2> count_;       // [solid] number of these
};

}  // namespace trilith
