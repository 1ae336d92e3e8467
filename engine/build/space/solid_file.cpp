#include "build/space/solid_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <unordered_set>

#include "base/error.hpp"
#include "base/whole_file.hpp"
#include "geometry/space/convex_hull.hpp"
#include "geometry/space/crossing_faces.hpp"
#include "geometry/space/cut_solid.hpp"
#include "geometry/space/surface.hpp"

namespace trilith {
namespace {

constexpr std::size_t largest_solid_file = std::size_t{1} << 30;  // [bytes]

/// The run time of convexity checks grows with faces times corners.
constexpr int most_faces = 5000;
/// Hulls of more points take too long.
constexpr std::size_t most_hull_corners = 500;

double require_share(double value, double low, const std::string& what) {
  if (!(value >= low && value <= 0.01))
    throw InputError(fmt::format("{} is {:g}, must be from {:g} to 0.01 of the size", what, value, low));
  return value;
}

std::string place_text(const Vec3& p) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z());
}

/// An edge with an odd number of faces above one, and that number; 0 if there is none.
struct CrowdedEdge {
  int faces = 0, from = 0, to = 0;
};

CrowdedEdge crowded_edge(const FaceLoops& faces) {
  std::vector<std::array<int, 2>> sides;
  for (int f = 0; f < faces.count(); ++f)
    for (std::size_t k = 0; k < faces[f].size(); ++k) {
      const auto [low, high] = std::minmax(faces[f][k], faces[f][k + 1 == faces[f].size() ? 0 : k + 1]);
      sides.push_back({low, high});
    }
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    while (end < sides.size() && sides[end] == sides[i]) ++end;
    if (end - i > 1 && (end - i) % 2 == 1) return {static_cast<int>(end - i), sides[i][0], sides[i][1]};
  }
  return {};
}

/// Notes that may apply to many solids of a file and are reported for the first.
enum class FileNote { inside_out, partly_turned, shells, same_name, count };

class SolidMaker {
 public:
  SolidMaker(const SolidFile& how, std::string_view owner) : how_(how), owner_(owner) {
    require_share(how.weld, 0, owner_ + ": weld");
    require_share(how.flat, 1e-12, owner_ + ": flat");
  }

  void add(const NamedSurfaces& body) {
    const std::string title =
        body.name.empty() ? fmt::format("{}: its solid", owner_) : fmt::format("{}: solid '{}'", owner_, body.name);
    std::vector<Polyhedron> pieces;
    for (const Polyhedron& surface : body.surfaces) {
      std::vector<Polyhedron> solids = closed_solids(surface, title);
      if (solids.size() > 1 && !how_.shells_are_bodies)
        tell(FileNote::shells, fmt::format("{} has {} separate shells, which became pieces of one body; set "
                                           "shells_are_bodies to make each a body",
                                           title, solids.size()));
      for (Polyhedron& solid : solids) pieces.push_back(std::move(solid));
    }
    const std::string name = named(body.name);
    if (!how_.shells_are_bodies || pieces.size() == 1) {
      put(name, std::move(pieces), body.groups);
      return;
    }
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      std::vector<std::string> groups = body.groups;
      groups.push_back(name);
      put(fmt::format("{}.{}", name, i + 1), {std::move(pieces[i])}, groups);
    }
  }

  SolidParts take() {
    if (out_.parts.empty()) throw InputError(fmt::format("{}: there is no solid in the file: it has no faces", owner_));
    for (const ToldOnce& told : told_)
      if (told.more > 0) out_.notes[told.note] += fmt::format(" (and {} more of its solids likewise)", told.more);
    if (planed_ > 0)
      out_.notes.push_back(fmt::format("{}: faces of {} solids were made plane, corners moved by up to {:.3g} m",
                                       owner_, planed_, moved_));
    if (hulls_ > 0)
      out_.notes.push_back(
          fmt::format("{}: {} solids with very narrow or non-planar faces were replaced by the hulls of their corners, "
                      "with triangles where corners are not in a plane",
                      owner_, hulls_));
    return std::move(out_);
  }

 private:
  /// A file with a thousand equal solids gets one line, not a thousand.
  void tell(FileNote kind, const std::string& text) {
    ToldOnce& told = told_[static_cast<std::size_t>(kind)];
    if (++told.more > 0) return;
    told.note = out_.notes.size();
    out_.notes.push_back(text);
  }

  /// Makes the name unique in the file.
  std::string named(const std::string& given) {
    const std::string base = given.empty() ? std::string() : part_name(how_.name, given);
    const std::string wanted = !base.empty() ? base : how_.name.empty() ? std::string("solid") : how_.name;
    std::string name = wanted;
    for (int k = 2; !names_.insert(name).second; ++k) name = fmt::format("{}.{}", wanted, k);
    if (name != wanted && !given.empty())
      tell(FileNote::same_name,
           fmt::format("{}: there is already a solid '{}'; the next one is named '{}'", owner_, wanted, name));
    return name;
  }

  void put(const std::string& name, std::vector<Polyhedron> pieces, std::vector<std::string> groups) {
    groups.insert(groups.end(), how_.groups.begin(), how_.groups.end());
    if (!how_.name.empty()) groups.push_back(how_.name);
    std::vector<std::string> once;
    for (std::string& group : groups)
      if (std::find(once.begin(), once.end(), group) == once.end()) once.push_back(std::move(group));
    out_.parts.push_back({name, std::move(pieces), std::move(once)});
  }

  /// Every shell as a convex solid with plane faces.
  std::vector<Polyhedron> closed_solids(const Polyhedron& surface, const std::string& title) {
    Polyhedron joined = with_joined_corners(surface, how_.weld * solid_size(surface.corners));
    if (joined.faces.count() == 0) throw InputError(fmt::format("{} has no face with an area", title));
    const std::vector<int> across = edges_across(joined.faces);
    const Shells shells = shells_of(joined, across);
    if (!closes(shells)) refuse_open(joined, across, title, closing_weld(surface));
    note_turned(shells, title);
    std::vector<Polyhedron> solids = solids_of(joined, shells);
    for (std::size_t i = 0; i < solids.size(); ++i)
      solids[i] = convex_of(solids[i], solids.size() == 1 ? title : fmt::format("{}, shell {}", title, i + 1));
    return solids;
  }

  static void refuse_crowded(const Polyhedron& surface, const std::string& title) {
    if (const CrowdedEdge edge = crowded_edge(surface.faces); edge.faces > 0)
      throw InputError(
          fmt::format("{} has an edge with {} faces, from {} to {} m, but each edge of a solid has two; remove faces "
                      "that are given twice or lie inside it",
                      title, edge.faces, place_text(surface.corners[static_cast<std::size_t>(edge.from)]),
                      place_text(surface.corners[static_cast<std::size_t>(edge.to)])));
  }

  static bool closes(const Shells& shells) {
    return std::count(shells.whole.begin(), shells.whole.end(), 1) == shells.count;
  }

  /// The least weld of 1, 2 or 5 times a power of ten with which the surface closes; 0 if there is none.
  [[nodiscard]] double closing_weld(const Polyhedron& surface) const {
    constexpr int most_tried = 20000;  // faces: each try sorts them
    if (surface.faces.count() > most_tried) return 0;
    const double size = solid_size(surface.corners);
    for (const double weld :
         {1e-7, 2e-7, 5e-7, 1e-6, 2e-6, 5e-6, 1e-5, 2e-5, 5e-5, 1e-4, 2e-4, 5e-4, 1e-3, 2e-3, 5e-3}) {
      if (weld <= how_.weld) continue;
      const Polyhedron joined = with_joined_corners(surface, weld * size);
      if (joined.faces.count() < surface.faces.count() / 2) return 0;
      const std::vector<int> across = edges_across(joined.faces);
      if (joined.faces.count() > 0 && closes(shells_of(joined, across))) return weld;
    }
    return 0;
  }

  static void refuse_open(const Polyhedron& surface, const std::vector<int>& across, const std::string& title,
                          double weld) {
    const auto open = std::count(across.begin(), across.end(), -1);
    if (open == 0)
      throw InputError(
          fmt::format("{} encloses no volume: its faces cannot be oriented consistently, or more than two share an "
                      "edge; give each solid as its own object",
                      title));
    refuse_crowded(surface, title);
    int face = 0;
    const auto first = static_cast<int>(std::find(across.begin(), across.end(), -1) - across.begin());
    while (surface.faces.start[static_cast<std::size_t>(face) + 1] <= first) ++face;
    const int next = first + 1 == surface.faces.start[static_cast<std::size_t>(face) + 1]
                         ? surface.faces.start[static_cast<std::size_t>(face)]
                         : first + 1;
    const auto corner = [&](int place) {
      return surface.corners[static_cast<std::size_t>(surface.faces.corner[static_cast<std::size_t>(place)])];
    };
    throw InputError(fmt::format("{} is open: {} edges belong to one face only, such as the edge from {} to {} m; {}",
                                 title, open, place_text(corner(first)), place_text(corner(next)),
                                 weld > 0 ? fmt::format("its corners do not coincide exactly; weld = {:g} closes it "
                                                        "(corners within this share of its size are merged)",
                                                        weld)
                                          : "close it in the program that made it"));
  }

  void note_turned(const Shells& shells, const std::string& title) {
    const auto turned = std::count(shells.turn.begin(), shells.turn.end(), 1);
    if (turned == static_cast<std::ptrdiff_t>(shells.turn.size()))
      tell(FileNote::inside_out, fmt::format("{} was inside out; its faces were reversed", title));
    else if (turned > 0)
      tell(FileNote::partly_turned, fmt::format("{}: {} of {} faces had the wrong orientation and were reversed", title,
                                                turned, shells.turn.size()));
  }

  void refuse_crossing(const Polyhedron& closed, const std::string& title) const {
    const auto crossing = crossing_faces(closed, how_.flat * solid_size(closed.corners));
    if (!crossing) return;
    throw InputError(fmt::format(
        "{} intersects itself at {} m, where {}; give each convex part of it as its own object", title,
        place_text(crossing->at),
        crossing->a == crossing->b ? "two sides of one face cross" : "two of its faces pass through each other"));
  }

  /// A solid thinner than the planarity tolerance has no separate faces on its two sides.
  void refuse_flat(const Polyhedron& closed, const std::string& title) const {
    double surface = 0;
    for (int f = 0; f < closed.faces.count(); ++f) surface += area_vector(closed.corners, closed.faces[f]).norm();
    const double size = solid_size(closed.corners), thickness = 2 * solid_moments(closed).volume / surface;
    if (thickness > 4 * how_.flat * size) return;
    refuse_crossing(closed, title);
    throw InputError(
        fmt::format("{} is flat: {:.3g} m thick and {:.3g} m large, must be thicker than {:.3g} m; leave it out, or "
                    "give a smaller flat",
                    title, thickness, size, 4 * how_.flat * size));
  }

  Polyhedron convex_of(const Polyhedron& closed, const std::string& title) {
    refuse_flat(closed, title);
    Polyhedron solid = with_joined_faces(closed, how_.flat);
    const double size = solid_size(closed.corners);
    const HollowEdge hollow = hollow_edge(solid, edges_across(solid.faces));
    if (hollow.by > 4 * how_.flat * size) {
      refuse_crossing(closed, title);
      throw InputError(
          fmt::format("{} is not convex: a corner at {} m lies {:.3g} m outside the plane of the adjacent face; give "
                      "it as several convex objects in one group",
                      title, place_text(hollow.at), hollow.by));
    }
    if (solid.faces.count() > most_faces)
      throw InputError(fmt::format("{} has {} faces, at most {} are allowed; make it coarser", title,
                                   solid.faces.count(), most_faces));
    if (!is_convex_solid(solid)) refuse_crossing(closed, title);
    if (is_rough(solid, size)) make_plane(solid, size, title);
    check_convex(solid, title);
    return solid;
  }

  /// Moves corners to the intersections of planes. If a face is so narrow that rounding has rotated its plane, they
  /// would move far. Then the solid is replaced by the hull of its corners, with triangles where four corners lie in no
  /// plane.
  void make_plane(Polyhedron& solid, double size, const std::string& title) {
    PlanarSolid planar = with_plane_faces(solid);
    if (planar.moved <= 8 * how_.flat * size && is_convex_solid(planar.solid)) {
      ++planed_, moved_ = std::max(moved_, planar.moved);
      solid = std::move(planar.solid);
      return;
    }
    const double moved = planar.moved;
    if (solid.corners.size() > most_hull_corners ||
        !(become_hull(solid, kFlatFace / 4) || become_hull(solid, how_.flat) || become_hull(solid, 10 * how_.flat)))
      throw InputError(
          fmt::format("{} has faces that are too far from plane to be corrected: corners would move by {:.3g} m; "
                      "export it in double precision, or with fewer narrow faces",
                      title, moved));
    ++hulls_;
  }

  /// False if the hull of its corners is not valid for a body.
  static bool become_hull(Polyhedron& solid, double flat) {
    try {
      PlanarSolid hull{convex_hull(solid.corners, "", flat), 0};
      if (!is_convex_solid(hull.solid)) hull = with_plane_faces(hull.solid);
      if (!is_convex_solid(hull.solid)) return false;
      solid = std::move(hull.solid);
      return true;
    } catch (const InputError&) {
      return false;
    }
  }

  static bool is_convex_solid(const Polyhedron& solid) {
    try {
      check_convex(solid, "");
      return true;
    } catch (const InputError&) {
      return false;
    }
  }

  /// True if corners deviate from the planes of faces by more than a quarter of the limit for a body.
  static bool is_rough(const Polyhedron& solid, double size) {
    const std::vector<Vec3> normals = face_normals(solid);
    for (int f = 0; f < solid.faces.count(); ++f) {
      const auto loop = solid.faces[f];
      const Vec3& on = solid.corners[static_cast<std::size_t>(loop[0])];
      for (const int i : loop)
        if (std::abs(normals[static_cast<std::size_t>(f)].dot(solid.corners[static_cast<std::size_t>(i)] - on)) >
            kFlatFace / 4 * size)
          return true;
    }
    return hollow_edge(solid, edges_across(solid.faces)).out > kFlatFace / 4 * size;
  }

  const SolidFile& how_;
  std::string owner_;
  SolidParts out_;
  std::unordered_set<std::string> names_;
  struct ToldOnce {
    std::size_t note = 0;  ///< its index among the notes
    int more = -1;         ///< number of further solids; -1: not yet reported
  };
  std::array<ToldOnce, static_cast<std::size_t>(FileNote::count)> told_;
  double moved_ = 0;
  int planed_ = 0, hulls_ = 0;
};

}  // namespace

std::string why_beyond_reach(const Vec3& place) {
  if ((place.cwiseAbs().array() <= 1e12).all()) return {};
  return fmt::format("a point at {} m, must be within 1e12 m of the origin; check the file's unit and scale",
                     place_text(place));
}

FileAxes::FileAxes(const SolidFile& how, std::string_view owner)
    : scale_(require_positive(how.scale, fmt::format("{}: scale", owner), "m")), y_up_(how.y_up) {}

SolidParts solids_of_file(const std::vector<NamedSurfaces>& bodies, const SolidFile& how, std::string_view owner) {
  SolidMaker maker(how, owner);
  for (const NamedSurfaces& body : bodies)
    if (!body.surfaces.empty()) maker.add(body);
  return maker.take();
}

SolidParts read_solids(const std::filesystem::path& path, const SolidFile& how) {
  const std::string owner = fmt::format("file '{}'", path.string());
  std::string ending = path.extension().string();
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  if (ending != ".obj" && ending != ".stl")
    throw InputError(fmt::format("{}: its extension is '{}', must be .obj or .stl", owner, ending));
  const std::string bytes = text_of_file(path, "solids", largest_solid_file);
  if (bytes.empty()) throw InputError(fmt::format("{}: is empty; export it again", owner));
  return ending == ".obj" ? parse_obj(bytes, how, owner) : parse_stl(bytes, how, owner);
}

SolidParts SolidFile::parts() const {
  return read_solids(file, *this);
}

}  // namespace trilith
