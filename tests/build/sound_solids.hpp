// Invariants of the parts of every builder in space, for the builders' tests.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "build/space/solid_part.hpp"
#include "geometry/space/facing_faces.hpp"
#include "geometry/space/overlap_3d.hpp"
#include "near.hpp"

namespace trilith::testing {

inline double total_volume(const std::vector<SolidPart>& parts) {
  double volume = 0;
  for (const SolidPart& part : parts) volume += volume_of(part);
  return volume;
}

/// All contact pieces of parts, and the part of each.
struct StandingPieces {
  std::vector<ConvexSolid> solids;
  std::vector<PlacedSolid> placed;
  std::vector<std::size_t> part;
  std::vector<Vec3> low, high;

  explicit StandingPieces(const std::vector<SolidPart>& parts) {
    for (std::size_t i = 0; i < parts.size(); ++i)
      for (const Polyhedron& piece : parts[i].pieces)
        solids.push_back(convex_solid(piece, parts[i].name)), part.push_back(i);
    placed.resize(solids.size());
    for (std::size_t k = 0; k < solids.size(); ++k) {
      place(solids[k], Turn3(UnitQuaternion{}), Vec3::Zero(), placed[k]);
      Vec3 lowest = placed[k].corners[0], highest = lowest;
      for (const Vec3& p : placed[k].corners) lowest = lowest.cwiseMin(p), highest = highest.cwiseMax(p);
      low.push_back(lowest), high.push_back(highest);
    }
  }
  [[nodiscard]] bool near_each_other(std::size_t a, std::size_t b) const {
    return ((low[a] - high[b]).array() <= 1e-6).all() && ((low[b] - high[a]).array() <= 1e-6).all();
  }
};

/// Contact area of the faces of two pieces [m2], and the largest distance between their planes [m].
struct FlushFaces {
  double area = 0, off = 0;
};

/// Faces count as in contact within a millionth of the size, so that `off` shows their accuracy.
inline void add_flush_faces(const PlacedSolid& a, const PlacedSolid& b, FlushFaces& out) {
  FaceRoom room_a, room_b;
  const double within = 1e-6 * a.solid->size;
  for (int f = 0; f < a.solid->shape.faces.count(); ++f)
    for (int g = 0; g < b.solid->shape.faces.count(); ++g) {
      const PlacedFace p = face_of(a, f, room_a), q = face_of(b, g, room_b);
      if (p.normal.dot(q.normal) > -1 + 1e-10 || std::abs(p.normal.dot(q.corners[0] - p.corners[0])) > within) continue;
      FaceOverlap3 shared;
      if (!face_overlap(p, q, shared)) continue;
      const double area = integrals_over_all(shared).area;
      if (area < 1e-9) continue;
      out.area += area;
      for (const Vec3& corner : q.corners) out.off = std::max(out.off, std::abs(p.normal.dot(corner - p.corners[0])));
    }
}

/// Sums over all pairs of pieces.
inline FlushFaces flush_faces(const StandingPieces& pieces) {
  FlushFaces out;
  for (std::size_t i = 0; i < pieces.placed.size(); ++i)
    for (std::size_t j = i + 1; j < pieces.placed.size(); ++j)
      if (pieces.near_each_other(i, j)) add_flush_faces(pieces.placed[i], pieces.placed[j], out);
  return out;
}

/// Largest overlap volume of two pieces [m3].
inline double largest_overlap(const StandingPieces& pieces) {
  SolidOverlapBuffer buffer;
  double largest = 0;
  for (std::size_t i = 0; i < pieces.placed.size(); ++i)
    for (std::size_t j = i + 1; j < pieces.placed.size(); ++j)
      if (pieces.near_each_other(i, j))
        largest = std::max(largest, solid_overlap(pieces.placed[i], pieces.placed[j], buffer).volume);
  return largest;
}

/// Checks for convex closed pieces with contact faces, unique names, at least one group, no overlap volume, and face
/// contacts flat to 1e-13 m. Returns the total face contact area [m2].
inline double check_sound(const std::vector<SolidPart>& parts) {
  std::set<std::string> names;
  for (const SolidPart& part : parts) {
    CHECK_FALSE(part.groups.empty());
    CHECK_FALSE(part.pieces.empty());
    CHECK(names.insert(part.name).second);
    for (const Polyhedron& piece : part.pieces)
      for (int f = 0; f < piece.faces.count(); ++f)
        CHECK(piece.faces[f].size() <= static_cast<std::size_t>(max_face_corners));
  }
  const StandingPieces pieces(parts);
  CHECK(largest_overlap(pieces) < 1e-12);
  const FlushFaces flush = flush_faces(pieces);
  CHECK(flush.off < 1e-13);
  return flush.area;
}

inline const SolidPart& named(const std::vector<SolidPart>& parts, const std::string& name) {
  const auto found = std::find_if(parts.begin(), parts.end(), [&](const SolidPart& part) { return part.name == name; });
  REQUIRE(found != parts.end());
  return *found;
}

inline int count_in_group(const std::vector<SolidPart>& parts, const std::string& group) {
  return static_cast<int>(std::count_if(parts.begin(), parts.end(), [&](const SolidPart& part) {
    return std::count(part.groups.begin(), part.groups.end(), group) > 0;
  }));
}

}  // namespace trilith::testing
