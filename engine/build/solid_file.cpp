#include "build/solid_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>

#include "base/error.hpp"
#include "base/whole_file.hpp"
#include "shape/convex_hull.hpp"
#include "shape/cut_solid.hpp"
#include "shape/surface.hpp"

namespace trilith {
namespace {

constexpr std::size_t largest_solid_file = std::size_t{1} << 30;  // [bytes]

/// Checks of convexity go with faces times corners.
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
        out_.notes.push_back(
            fmt::format("{} has {} separate shells, which became pieces of one body; set "
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
    if (out_.parts.empty()) throw InputError(fmt::format("{}: there is no solid in it; it has no faces", owner_));
    if (planed_ > 0)
      out_.notes.push_back(fmt::format("{}: faces of {} solids were made plane, corners moved by up to {:.3g} m",
                                       owner_, planed_, moved_));
    if (hulls_ > 0)
      out_.notes.push_back(
          fmt::format("{}: {} solids with very narrow faces became the hulls of their corners, with "
                      "triangles where corners are in no plane",
                      owner_, hulls_));
    return std::move(out_);
  }

 private:
  /// Of its own in the file.
  std::string named(const std::string& given) {
    const std::string base = given.empty() ? std::string() : part_name(how_.name, given);
    const std::string wanted = !base.empty() ? base : how_.name.empty() ? std::string("solid") : how_.name;
    std::string name = wanted;
    for (int k = 2; !names_.insert(name).second; ++k) name = fmt::format("{}.{}", wanted, k);
    if (name != wanted && !given.empty())
      out_.notes.push_back(
          fmt::format("{}: there is a solid '{}' already, the next one became '{}'", owner_, wanted, name));
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

  /// Every shell as a convex solid of plane faces.
  std::vector<Polyhedron> closed_solids(const Polyhedron& surface, const std::string& title) {
    Polyhedron joined = with_joined_corners(surface, how_.weld * solid_size(surface.corners));
    if (joined.faces.count() == 0) throw InputError(fmt::format("{} has no face with an area", title));
    const std::vector<int> across = edges_across(joined.faces);
    const Shells shells = shells_of(joined, across);
    refuse_open(joined, across, shells, title);
    note_turned(shells, title);
    std::vector<Polyhedron> solids = solids_of(joined, shells);
    for (std::size_t i = 0; i < solids.size(); ++i)
      solids[i] = convex_of(solids[i], solids.size() == 1 ? title : fmt::format("{}, shell {}", title, i + 1));
    return solids;
  }

  static void refuse_open(const Polyhedron& surface, const std::vector<int>& across, const Shells& shells,
                          const std::string& title) {
    if (std::count(shells.whole.begin(), shells.whole.end(), 1) == shells.count) return;
    const auto open = std::count(across.begin(), across.end(), -1);
    if (open == 0)
      throw InputError(
          fmt::format("{} has no inside: its faces cannot be turned so that they agree, or more than two "
                      "share an edge; give each solid as an object of its own",
                      title));
    int face = 0;
    const auto first = static_cast<int>(std::find(across.begin(), across.end(), -1) - across.begin());
    while (surface.faces.start[static_cast<std::size_t>(face) + 1] <= first) ++face;
    const int next = first + 1 == surface.faces.start[static_cast<std::size_t>(face) + 1]
                         ? surface.faces.start[static_cast<std::size_t>(face)]
                         : first + 1;
    const auto corner = [&](int place) {
      return surface.corners[static_cast<std::size_t>(surface.faces.corner[static_cast<std::size_t>(place)])];
    };
    throw InputError(
        fmt::format("{} is open: {} edges belong to one face only, such as that from {} to {} m; close it "
                    "in the program it comes from",
                    title, open, place_text(corner(first)), place_text(corner(next))));
  }

  void note_turned(const Shells& shells, const std::string& title) {
    const auto turned = std::count(shells.turn.begin(), shells.turn.end(), 1);
    if (turned == static_cast<std::ptrdiff_t>(shells.turn.size()))
      out_.notes.push_back(fmt::format("{} was inside out; its faces were turned round", title));
    else if (turned > 0)
      out_.notes.push_back(
          fmt::format("{}: {} of {} faces ran the wrong way and were turned round", title, turned, shells.turn.size()));
  }

  Polyhedron convex_of(const Polyhedron& closed, const std::string& title) {
    Polyhedron solid = with_joined_faces(closed, how_.flat);
    const double size = solid_size(closed.corners);
    const HollowEdge hollow = hollow_edge(solid, edges_across(solid.faces));
    if (hollow.by > 4 * how_.flat * size)
      throw InputError(
          fmt::format("{} is not convex: a face's corner at {} m stands {:.3g} m out of the plane of the face "
                      "beside it; give it as several convex objects in one group",
                      title, place_text(hollow.at), hollow.by));
    if (solid.faces.count() > most_faces)
      throw InputError(fmt::format("{} has {} faces, at most {} are taken; make it coarser", title, solid.faces.count(),
                                   most_faces));
    if (is_rough(solid, size)) make_plane(solid, size, title);
    check_convex(solid, title);
    return solid;
  }

  /// Corners go to where planes meet. Where a face is so narrow that rounding has turned its plane, they would go far:
  /// then the solid becomes the hull of its corners, whose faces are triangles where four corners are in no plane.
  void make_plane(Polyhedron& solid, double size, const std::string& title) {
    PlanarSolid planar = with_plane_faces(solid);
    ++planed_;
    if (planar.moved <= 8 * how_.flat * size && is_convex_solid(planar.solid)) {
      moved_ = std::max(moved_, planar.moved);
      solid = std::move(planar.solid);
      return;
    }
    const double moved = planar.moved;
    if (solid.corners.size() > most_hull_corners ||
        !(become_hull(solid, kFlatFace / 4) || become_hull(solid, how_.flat) || become_hull(solid, 10 * how_.flat)))
      throw InputError(
          fmt::format("{} has faces that are not plane, by too much to put right: corners would move by "
                      "{:.3g} m; give it in double precision, or with fewer narrow faces",
                      title, moved));
    ++hulls_;
  }

  /// False where the hull of its corners is none that a body may have.
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

  /// Whether corners stand off or out of the planes of faces by more than a quarter of what a body may have.
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
  double moved_ = 0;
  int planed_ = 0, hulls_ = 0;
};

}  // namespace

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
    throw InputError(fmt::format("{}: its ending is '{}'; files of solids end with .obj or .stl", owner, ending));
  const std::string bytes = text_of_file(path, "solids", largest_solid_file);
  return ending == ".obj" ? parse_obj(bytes, how, owner) : parse_stl(bytes, how, owner);
}

}  // namespace trilith
