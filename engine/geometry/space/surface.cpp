#include "geometry/space/surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace trilith {
namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

// Faces are loops of corners, one after the other in one array. An index in the array denotes the edge from that corner
// to the next of its loop. The index across it denotes the edge between the same two corners in the neighbouring loop.
//
//      d ____ c      faces.corner  a b c d | b e c
//       | f  |\ .
//       |____|_\ .
//      a    b g e
//
// The edge b-c of f has index 1, and across it is c-b of g with index 6. It runs the other way, so both faces are
// oriented alike, outwards or inwards.

/// The face and the next corner for each index of `faces.corner`.
struct LoopPlaces {
  std::vector<int> face, next;  ///< [indices of `faces.corner`]

  explicit LoopPlaces(const FaceLoops& faces) {
    for (int f = 0; f < faces.count(); ++f)
      for (int k = faces.start[at(f)]; k < faces.start[at(f) + 1]; ++k) {
        face.push_back(f);
        next.push_back(faces.corner[at(k + 1 == faces.start[at(f) + 1] ? faces.start[at(f)] : k + 1)]);
      }
  }
};

}  // namespace

/// Edges of all faces sorted by their two corners, the lower first. Occurrences of one edge are then adjacent and are
/// paired two by two, whatever their direction.
std::vector<int> edges_across(const FaceLoops& faces) {
  struct Side {
    int low, high, place;
  };
  const LoopPlaces places(faces);
  std::vector<Side> sides;
  sides.reserve(faces.corner.size());
  for (int k = 0; k < static_cast<int>(faces.corner.size()); ++k) {
    const int from = faces.corner[at(k)], to = places.next[at(k)];
    sides.push_back({std::min(from, to), std::max(from, to), k});
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::array{a.low, a.high, a.place} < std::array{b.low, b.high, b.place};
  });
  std::vector<int> across(sides.size(), -1);
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const Side &a = sides[i], &b = sides[i + 1];
    if (a.low != b.low || a.high != b.high) continue;
    across[at(a.place)] = b.place, across[at(b.place)] = a.place;
    ++i;
  }
  return across;
}

namespace {

/// Neighbour search for points: a grid whose cells are twice as wide as the search distance.
class PointGrid {
 public:
  PointGrid(double within, std::size_t points) : within_(within), per_cell_(0.5 / within) { cells_.reserve(points); }

  // A point within `within_` of p lies in one of the cells of the eight corners of the cube of that half width.
  /// The first inserted point near `p`, or -1.
  [[nodiscard]] int near(const Vec3& p, const std::vector<Vec3>& points) const {
    int found = -1;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 side((corner & 1) != 0 ? within_ : -within_, (corner & 2) != 0 ? within_ : -within_,
                      (corner & 4) != 0 ? within_ : -within_);
      const auto cell = cells_.find(key(p + side));
      if (cell == cells_.end()) continue;
      for (const int i : cell->second)
        if ((found < 0 || i < found) && (points[at(i)] - p).norm() <= within_) found = i;
    }
    return found;
  }
  void put(const Vec3& p, int number) { cells_[key(p)].push_back(number); }

 private:
  [[nodiscard]] std::uint64_t key(const Vec3& p) const {
    std::uint64_t h = 0;
    for (int k = 0; k < 3; ++k) {
      const double cell = std::clamp(std::floor(p[k] * per_cell_), -4e18, 4e18);
      h = (h ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(cell))) * 0xd6e8feb86659fd93U;
      h ^= h >> 32;
    }
    return h;
  }
  double within_, per_cell_;
  std::unordered_map<std::uint64_t, std::vector<int>> cells_;
};

}  // namespace

/// A point within `within` of an earlier one is merged with it, and faces with fewer than three distinct corners are
/// removed. STL files give each triangle its own corners.
Polyhedron with_joined_corners(const Polyhedron& surface, double within) {
  Polyhedron made;
  PointGrid grid(std::max(within, 1e-300), surface.corners.size());
  std::vector<int> number(surface.corners.size(), -1);
  for (int f = 0; f < surface.faces.count(); ++f) {
    std::vector<int> loop;
    for (const int corner : surface.faces[f]) {
      int& n = number[at(corner)];
      const Vec3& p = surface.corners[at(corner)];
      if (n < 0) n = grid.near(p, made.corners);
      if (n < 0) {
        n = static_cast<int>(made.corners.size());
        made.corners.push_back(p);
        grid.put(p, n);
      }
      if (loop.empty() || loop.back() != n) loop.push_back(n);
    }
    while (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
    if (loop.size() > 2) made.faces.add(loop);
  }
  return made;
}

namespace {

/// Traverses the faces across their edges.
class ShellWalk {
 public:
  ShellWalk(const Polyhedron& surface, std::span<const int> across)
      : surface_(surface), across_(across), places_(surface.faces) {}

  Shells run() {
    const auto faces = at(surface_.faces.count());
    out_.of.assign(faces, -1), out_.turn.assign(faces, 0);
    for (std::size_t f = 0; f < faces; ++f)
      if (out_.of[f] < 0) walk(static_cast<int>(f));
    outwards();
    return std::move(out_);
  }

 private:
  /// Assigns a new shell number to the faces reachable from `first`, and orients each one like its neighbour.
  void walk(int first) {
    const int shell = out_.count++;
    out_.whole.push_back(1);
    std::vector<int> open{first};
    out_.of[at(first)] = shell;
    while (!open.empty()) {
      const int f = open.back();
      open.pop_back();
      for (int k = surface_.faces.start[at(f)]; k < surface_.faces.start[at(f) + 1]; ++k) {
        const int other = across_[at(k)];
        if (other < 0) {
          out_.whole[at(shell)] = 0;
          continue;
        }
        const int g = places_.face[at(other)];
        const bool same_way = surface_.faces.corner[at(k)] == surface_.faces.corner[at(other)];
        const char turn = static_cast<char>((out_.turn[at(f)] != 0) != same_way ? 1 : 0);
        if (out_.of[at(g)] < 0) {
          out_.of[at(g)] = shell, out_.turn[at(g)] = turn;
          open.push_back(g);
        } else if (out_.turn[at(g)] != turn) {
          out_.whole[at(shell)] = 0;  // one-sided, such as a Moebius strip
        }
      }
    }
  }

  // Volume by the divergence theorem up to a positive factor, as sum of (position . area): only its sign is used.
  /// Reverses shells with a negative volume.
  void outwards() {
    std::vector<double> volume(at(out_.count), 0);
    std::vector<int> first(at(out_.count), -1);
    for (int f = 0; f < surface_.faces.count(); ++f) {
      const auto shell = at(out_.of[at(f)]);
      const auto loop = surface_.faces[f];
      if (first[shell] < 0) first[shell] = loop[0];
      const Vec3& origin = surface_.corners[at(first[shell])];
      const Vec3 arm = surface_.corners[at(loop[0])] - origin;
      volume[shell] += (out_.turn[at(f)] != 0 ? -1 : 1) * arm.dot(area_vector(surface_.corners, loop));
    }
    for (std::size_t f = 0; f < out_.turn.size(); ++f)
      if (volume[at(out_.of[f])] < 0) out_.turn[f] = static_cast<char>(1 - out_.turn[f]);
  }

  const Polyhedron& surface_;
  std::span<const int> across_;
  LoopPlaces places_;
  Shells out_;
};

}  // namespace

/// Faces connected across edges form one shell. A face that runs along a common edge in the same direction as its
/// neighbour is reversed. A shell that cannot be oriented, or has an edge without a neighbour, is not whole.
Shells shells_of(const Polyhedron& surface, std::span<const int> across) {
  return ShellWalk(surface, across).run();
}

/// Each shell with its own corners, numbered in the order of its faces, and all faces outwards.
std::vector<Polyhedron> solids_of(const Polyhedron& surface, const Shells& shells) {
  std::vector<Polyhedron> solids(at(shells.count));
  std::vector<int> number(surface.corners.size(), -1), in(surface.corners.size(), -1);
  // shell by shell, because shells may share corners
  std::vector<std::vector<int>> faces(at(shells.count));
  for (int f = 0; f < surface.faces.count(); ++f) faces[at(shells.of[at(f)])].push_back(f);
  for (int s = 0; s < shells.count; ++s) {
    Polyhedron& solid = solids[at(s)];
    for (const int f : faces[at(s)]) {
      std::vector<int> loop;
      for (const int corner : surface.faces[f]) {
        if (in[at(corner)] != s) {
          in[at(corner)] = s, number[at(corner)] = static_cast<int>(solid.corners.size());
          solid.corners.push_back(surface.corners[at(corner)]);
        }
        loop.push_back(number[at(corner)]);
      }
      if (shells.turn[at(f)] != 0) std::reverse(loop.begin(), loop.end());
      solid.faces.add(loop);
    }
  }
  return solids;
}

namespace {

/// Merges coplanar faces of one solid.
class FaceJoiner {
 public:
  FaceJoiner(const Polyhedron& solid, double flat)
      : solid_(solid),
        within_(flat * solid_size(solid.corners)),
        across_(edges_across(solid.faces)),
        places_(solid.faces) {
    for (int f = 0; f < solid.faces.count(); ++f) areas_.push_back(area_vector(solid.corners, solid.faces[f]));
  }

  // Input: a closed surface. Output: the surface with coplanar neighbours merged, without corners that then lie inside
  // an edge.
  Polyhedron run() {
    std::vector<int> order(areas_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
    std::vector<double> size;
    for (const Vec3& a : areas_) size.push_back(a.norm());
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return size[at(a)] > size[at(b)]; });
    joined_.assign(areas_.size(), -1);
    for (const int seed : order)
      if (joined_[at(seed)] < 0) spread(seed);
    return without_unused();
  }

 private:
  /// Adds all connected faces in the plane of the first face.
  void spread(int seed) {
    const int number = count_++;
    const Vec3 normal = areas_[at(seed)].normalized();
    const double height = normal.dot(solid_.corners[at(solid_.faces[seed][0])]);
    std::vector<int> members{seed};
    joined_[at(seed)] = number;
    for (std::size_t m = 0; m < members.size(); ++m)
      for (int k = solid_.faces.start[at(members[m])]; k < solid_.faces.start[at(members[m]) + 1]; ++k) {
        if (across_[at(k)] < 0) continue;
        const int g = places_.face[at(across_[at(k)])];
        if (joined_[at(g)] >= 0 || normal.dot(areas_[at(g)]) < 0 || !lies_in(g, normal, height)) continue;
        joined_[at(g)] = number;
        members.push_back(g);
      }
    add_rim(members, number);
  }

  [[nodiscard]] bool lies_in(int face, const Vec3& normal, double height) const {
    const auto loop = solid_.faces[face];
    return std::all_of(loop.begin(), loop.end(),
                       [&](int i) { return std::abs(normal.dot(solid_.corners[at(i)]) - height) <= within_; });
  }

  /// Adds the loop around the members; keeps the members separate if there is more than one loop.
  void add_rim(const std::vector<int>& members, int number) {
    // Edges with a member on both sides are inner ones; the others, followed from corner to corner, form the rim.
    std::unordered_map<int, int> next;
    std::size_t edges = 0;
    for (const int f : members)
      for (int k = solid_.faces.start[at(f)]; k < solid_.faces.start[at(f) + 1]; ++k) {
        const bool inner = across_[at(k)] >= 0 && joined_[at(places_.face[at(across_[at(k)])])] == number;
        if (!inner) next[solid_.faces.corner[at(k)]] = places_.next[at(k)], ++edges;
      }
    std::vector<int> loop;
    if (!next.empty()) {
      const int first = std::min_element(next.begin(), next.end())->first;
      for (int i = first; loop.size() < edges;) {
        loop.push_back(i);
        const auto to = next.find(i);
        if (to == next.end()) break;
        i = to->second;
        if (i == first) break;
      }
    }
    if (loop.size() == edges && edges > 2) {
      loops_.add(loop);
      return;
    }
    for (const int f : members) loops_.add(solid_.faces[f]);
  }

  /// A corner with fewer than three faces lies on a straight edge or belongs to no face any more.
  [[nodiscard]] Polyhedron without_unused() const {
    std::vector<int> uses(solid_.corners.size(), 0), number(solid_.corners.size(), -1);
    for (const int i : loops_.corner) ++uses[at(i)];
    Polyhedron made;
    for (std::size_t i = 0; i < uses.size(); ++i)
      if (uses[i] >= 3) number[i] = static_cast<int>(made.corners.size()), made.corners.push_back(solid_.corners[i]);
    for (int f = 0; f < loops_.count(); ++f) {
      std::vector<int> loop;
      for (const int i : loops_[f])
        if (number[at(i)] >= 0) loop.push_back(number[at(i)]);
      if (loop.size() > 2) made.faces.add(loop);
    }
    return made;
  }

  const Polyhedron& solid_;
  double within_;
  std::vector<int> across_;
  LoopPlaces places_;
  std::vector<Vec3> areas_;
  std::vector<int> joined_;
  int count_ = 0;
  FaceLoops loops_;
};

}  // namespace

/// Coplanar triangles become one face. The largest come first, because their planes are the most accurate.
Polyhedron with_joined_faces(const Polyhedron& solid, double flat) {
  return FaceJoiner(solid, flat).run();
}

/// For each edge, the heights of both faces over each other's planes: if both are positive the edge is a dent, as deep
/// as the smaller one.
HollowEdge hollow_edge(const Polyhedron& solid, std::span<const int> across) {
  const LoopPlaces places(solid.faces);
  const std::vector<Vec3> normals = face_normals(solid);
  struct Outside {
    double by = 0;
    int corner = 0;
  };
  // height of the face with edge k outside of the plane of the face across it
  const auto outside = [&](std::size_t k) {
    const auto beside = at(places.face[at(across[k])]);
    const Vec3& on = solid.corners[at(solid.faces.corner[k])];
    Outside most;
    for (const int i : solid.faces[places.face[k]]) {
      const double by = normals[beside].dot(solid.corners[at(i)] - on);
      if (by > most.by) most = {by, i};
    }
    return most;
  };
  HollowEdge worst;
  bool has_dent = false;
  for (std::size_t k = 0; k < across.size(); ++k) {
    if (across[k] < 0 || at(across[k]) < k) continue;
    const Outside a = outside(k), b = outside(at(across[k]));
    const Outside &more = a.by > b.by ? a : b, &less = a.by > b.by ? b : a;
    if (more.by > worst.out) {
      worst.out = more.by;
      if (!has_dent) worst.at = solid.corners[at(more.corner)];
    }
    if (less.by > worst.by) worst.by = less.by, worst.at = solid.corners[at(less.corner)], has_dent = true;
  }
  return worst;
}

}  // namespace trilith
