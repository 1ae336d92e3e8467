#include "build/space/check_solids.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.hpp"
#include "geometry/hierarchical_hash_grid.hpp"
#include "geometry/space/overlap_3d.hpp"
#include "geometry/space/separation_3d.hpp"
#include "geometry/space/surface.hpp"

namespace trilith {
namespace {

/// Limit of the work for one pair of pieces: faces of one times corners of the other.
constexpr double most_pair_work = 1e8;
/// The distance of edges is not computed for solids with more faces.
constexpr int most_faces_for_edges = 200;

/// Reason for which a surface is not a closed solid, or "".
std::string broken_loops(const Polyhedron& solid) {
  if (solid.faces.count() < 4) return fmt::format("has {} faces, needs at least 4", solid.faces.count());
  for (const Vec3& p : solid.corners)
    if (!(p.cwiseAbs().array() <= 1e12).all()) return "has a corner that is not finite or beyond 1e12 m";
  for (int f = 0; f < solid.faces.count(); ++f) {
    if (solid.faces[f].size() < 3) return fmt::format("has face {} with {} corners", f + 1, solid.faces[f].size());
    for (const int i : solid.faces[f])
      if (i < 0 || i >= static_cast<int>(solid.corners.size()))
        return fmt::format("has face {} with corner {}, which does not exist", f + 1, i + 1);
  }
  return {};
}

/// A valid piece, as input of the pair search.
struct SoundPiece {
  int part, piece;
  ConvexSolid solid;
  PlacedSolid placed;
  FatBox<3> box;
  double volume;
};

class SolidChecker {
 public:
  SolidChecker(std::vector<SolidPart>& parts, const SolidCheck& check) : parts_(parts), check_(check) {
    require_not_negative(check.flat, "check of solids: flat", "of the size");
    require_not_negative(check.overlap, "check of solids: overlap", "of the smaller volume");
    require_not_negative(check.sliver, "check of solids: sliver", "of the size");
    require_not_negative(check.edge, "check of solids: edge", "of the size");
    require_not_negative(check.reach, "check of solids: reach", "of the size");
  }

  std::vector<SolidFinding> run() {
    for (int p = 0; p < static_cast<int>(parts_.size()); ++p) {
      const auto& pieces = parts_[static_cast<std::size_t>(p)].pieces;
      for (int k = 0; k < static_cast<int>(pieces.size()); ++k) look_at(p, k);
    }
    for (SoundPiece& s : sound_) s.placed.solid = &s.solid;  // addresses are final
    pairs();
    if (check_.touching && parts_.size() > 1) lonely();
    std::stable_sort(found_.begin(), found_.end(), [](const auto& a, const auto& b) { return a.part < b.part; });
    return std::move(found_);
  }

 private:
  [[nodiscard]] std::string title(int part, int piece) const {
    const SolidPart& p = parts_[static_cast<std::size_t>(part)];
    return p.pieces.size() == 1 ? fmt::format("solid '{}'", p.name)
                                : fmt::format("solid '{}', piece {}", p.name, piece + 1);
  }

  void find(SolidFault fault, int part, int piece, double value, const std::string& text, int other = -1,
            bool repaired = false) {
    found_.push_back({fault, part, piece, other, value, repaired, fmt::format("{} {}", title(part, piece), text)});
  }

  void look_at(int part, int piece) {
    Polyhedron& solid = parts_[static_cast<std::size_t>(part)].pieces[static_cast<std::size_t>(piece)];
    if (const std::string why = broken_loops(solid); !why.empty())
      return find(SolidFault::degenerate, part, piece, 0, why);
    const double size = solid_size(solid.corners);
    std::vector<int> across = edges_across(solid.faces);
    const auto open = std::count(across.begin(), across.end(), -1);
    if (open > 0)
      return find(SolidFault::open, part, piece, static_cast<double>(open),
                  fmt::format("is open: {} edges belong to one face only", open));
    const Shells shells = shells_of(solid, across);
    if (shells.count > 1 || shells.whole[0] == 0)
      return find(SolidFault::hollow, part, piece, 0,
                  shells.count > 1 ? fmt::format("is {} separate shells, not one solid", shells.count)
                                   : std::string("encloses no volume: its faces cannot be oriented consistently"));
    if (!turned(solid, shells, part, piece)) return;
    if (check_.repair) across = edges_across(solid.faces);
    if (has_no_measure(solid, size, part, piece)) return;
    const HollowEdge hollow = hollow_edge(solid, across);
    if (hollow.out > check_.flat * size)
      return find(SolidFault::hollow, part, piece, hollow.out,
                  fmt::format("is not convex: by {:.3g} m at ({:.6g}, {:.6g}, {:.6g}) m", hollow.out, hollow.at.x(),
                              hollow.at.y(), hollow.at.z()));
    slivers(solid, size, part, piece);
    keep(solid, size, part, piece);
  }

  /// False if faces are inverted and are not repaired.
  bool turned(Polyhedron& solid, const Shells& shells, int part, int piece) {
    const auto wrong = std::count(shells.turn.begin(), shells.turn.end(), 1);
    if (wrong == 0) return true;
    const auto all = static_cast<std::ptrdiff_t>(shells.turn.size());
    const std::string what = wrong == all ? std::string("is inside out")
                                          : fmt::format("has {} of {} faces with the wrong orientation", wrong, all);
    find(SolidFault::inverted, part, piece, static_cast<double>(wrong),
         what + (check_.repair ? "; they were reversed" : "; give their corners in the opposite order"), -1,
         check_.repair);
    if (check_.repair) {
      // in place, so that corners keep their indices
      FaceLoops faces;
      for (int f = 0; f < solid.faces.count(); ++f) {
        std::vector<int> loop(solid.faces[f].begin(), solid.faces[f].end());
        if (shells.turn[static_cast<std::size_t>(f)] != 0) std::reverse(loop.begin() + 1, loop.end());
        faces.add(loop);
      }
      solid.faces = std::move(faces);
    }
    return check_.repair;
  }

  bool has_no_measure(const Polyhedron& solid, double size, int part, int piece) {
    for (int f = 0; f < solid.faces.count(); ++f)
      if (!(area_vector(solid.corners, solid.faces[f]).norm() > 1e-16 * size * size)) {
        find(SolidFault::degenerate, part, piece, 0, fmt::format("has face {} without an area", f + 1));
        return true;
      }
    const double volume = solid_moments(solid).volume;
    if (volume > kFlatFace * size * size * size) return false;
    find(SolidFault::degenerate, part, piece, volume,
         fmt::format("has a volume of {:.3g} m3, too small for a solid", volume));
    return true;
  }

  void slivers(const Polyhedron& solid, double size, int part, int piece) {
    double surface = 0, shortest = size;
    for (int f = 0; f < solid.faces.count(); ++f) {
      const auto loop = solid.faces[f];
      surface += area_vector(solid.corners, loop).norm();
      for (std::size_t k = 0; k < loop.size(); ++k)
        shortest = std::min(shortest, (solid.corners[static_cast<std::size_t>(loop[k])] -
                                       solid.corners[static_cast<std::size_t>(loop[k + 1 == loop.size() ? 0 : k + 1])])
                                          .norm());
    }
    const double thickness = 2 * solid_moments(solid).volume / surface;
    if (thickness < check_.sliver * size)
      find(SolidFault::sliver, part, piece, thickness,
           fmt::format("is a sliver: {:.3g} m thick and {:.3g} m long", thickness, size));
    else if (shortest < check_.edge * size)
      find(SolidFault::sliver, part, piece, shortest,
           fmt::format("has an edge of {:.3g} m, too short for its size of {:.3g} m", shortest, size));
  }

  void keep(const Polyhedron& solid, double size, int part, int piece) {
    sound_.push_back(
        {part, piece, {solid, face_normals(solid), {}, {}, {}, size}, {}, {}, solid_moments(solid).volume});
    SoundPiece& s = sound_.back();
    s.placed.corners = solid.corners, s.placed.normals = s.solid.normals;
    if (solid.faces.count() <= most_faces_for_edges) s.solid.edges = solid_edges(solid.faces);
    Vec3 low = solid.corners[0], high = low;
    for (const Vec3& p : solid.corners) low = low.cwiseMin(p), high = high.cwiseMax(p);
    for (int k = 0; k < 3; ++k) {
      const auto i = static_cast<std::size_t>(k);
      s.box.low[i] = low[k] - check_.reach * size, s.box.high[i] = high[k] + check_.reach * size;
    }
  }

  /// Largest distance of b over the planes of a's faces.
  static double over_faces(const PlacedSolid& a, const PlacedSolid& b, double enough) {
    double most = -INFINITY;
    for (int f = 0; f < a.solid->shape.faces.count() && most <= enough; ++f) {
      const auto i = static_cast<std::size_t>(f);
      const Vec3& on = a.corners[static_cast<std::size_t>(a.solid->shape.faces[f][0])];
      double least = INFINITY;
      for (const Vec3& p : b.corners) {
        least = std::min(least, a.normals[i].dot(p - on));
        if (least <= most) break;  // another face does better
      }
      most = std::max(most, least);
    }
    return most;
  }

  /// Lower bound of the distance of two pieces; exact if a face is nearest, or if edges were tested.
  static double distance(const SoundPiece& a, const SoundPiece& b, double enough) {
    const double by_faces = std::max(over_faces(a.placed, b.placed, enough), over_faces(b.placed, a.placed, enough));
    if (by_faces > enough || a.solid.edges.empty() || b.solid.edges.empty()) return by_faces;
    if (by_faces > -1e-9 * std::min(a.solid.size, b.solid.size)) return by_faces;  // they touch at a face
    return std::max(by_faces, separation(a.placed, b.placed, enough).distance);
  }

  void pairs() {
    boxes_.reset(static_cast<int>(sound_.size()));
    touched_.assign(parts_.size(), 0);
    std::vector<int> near;
    for (int i = 0; i < static_cast<int>(sound_.size()); ++i) {
      const FatBox<3>& box = sound_[static_cast<std::size_t>(i)].box;
      near.clear();
      boxes_.for_meeting(box, [&](int j) { near.push_back(j); });
      std::sort(near.begin(), near.end());
      for (const int j : near) pair(sound_[static_cast<std::size_t>(j)], sound_[static_cast<std::size_t>(i)]);
      boxes_.put(i, box);
    }
  }

  void pair(const SoundPiece& a, const SoundPiece& b) {
    const double work = static_cast<double>(a.solid.shape.faces.count()) * static_cast<double>(b.placed.corners.size());
    if (work > most_pair_work) {
      touch(a, b);
      return find(SolidFault::unchecked, b.part, b.piece, 0,
                  fmt::format("and {} have so many faces that their overlap was not checked", title(a.part, a.piece)),
                  a.part);
    }
    const double size = std::min(a.solid.size, b.solid.size), apart = distance(a, b, check_.reach * size);
    if (apart > check_.reach * size) return;
    touch(a, b);
    // pieces with a shared volume overlap by more than the rounding of corners
    if (apart > -1e-12 * size) return;
    const double shared = solid_overlap(a.placed, b.placed, buffer_).volume, least = std::min(a.volume, b.volume);
    if (shared > check_.overlap * least)
      find(SolidFault::overlapping, b.part, b.piece, shared,
           fmt::format("shares {:.3g} m3, {:.3g} of the smaller, with {}", shared, shared / least,
                       title(a.part, a.piece)),
           a.part);
  }

  void touch(const SoundPiece& a, const SoundPiece& b) {
    if (a.part == b.part) return;
    touched_[static_cast<std::size_t>(a.part)] = touched_[static_cast<std::size_t>(b.part)] = 1;
  }

  void lonely() {
    std::vector<char> sound(parts_.size(), 0);
    for (const SoundPiece& s : sound_) sound[static_cast<std::size_t>(s.part)] = 1;
    for (std::size_t p = 0; p < parts_.size(); ++p)
      if (sound[p] != 0 && touched_[p] == 0)
        found_.push_back({SolidFault::touching_nothing, static_cast<int>(p), 0, -1, 0, false,
                          fmt::format("solid '{}' touches nothing", parts_[p].name)});
  }

  std::vector<SolidPart>& parts_;
  const SolidCheck& check_;
  std::vector<SoundPiece> sound_;
  std::vector<SolidFinding> found_;
  HierarchicalHashGrid<3> boxes_;
  std::vector<char> touched_;
  SolidOverlapBuffer buffer_;
};

}  // namespace

const char* name_of(SolidFault fault) {
  constexpr std::array<const char*, 8> names{"degenerate",  "open",   "inverted",         "hollow",
                                             "overlapping", "sliver", "touching nothing", "unchecked"};
  return names[static_cast<std::size_t>(fault)];
}

std::vector<SolidFinding> check_solids(std::vector<SolidPart>& parts, const SolidCheck& check) {
  return SolidChecker(parts, check).run();
}

}  // namespace trilith
