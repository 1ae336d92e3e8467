// Readers of closed solids in files of other programs: OBJ, and STL as text or binary.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "build/space/solid_part.hpp"

namespace trilith {

/// Options for reading a file of solids.
struct SolidFile {
  std::string name = {};           ///< prefix of the names of parts, and name of parts without one
  double scale = 1;                ///< [m] for each unit of the file, above 0; 0.001 for mm
  bool y_up = false;               ///< the file's y is up: its (x, y, z) becomes (x, -z, y)
  bool shells_are_bodies = false;  ///< each closed shell becomes a body "name.1", "name.2", ... instead of a piece of
                                   ///< one
  double weld = 1e-7;              ///< corners nearer than this times the body's size are merged, 0 to 0.01
  double flat = 1e-6;  ///< faces within this times the solid's size of one plane are merged, 1e-12 to 0.01. Single
                       ///< precision, as in binary STL, has about 1e-7
  std::vector<std::string> groups = {};  ///< of all parts
  std::filesystem::path file = {};       ///< for parts()

  static constexpr std::string_view kind = "solids";
  static constexpr std::string_view sentence = "solids of an OBJ or STL file";
  static constexpr bool is_single = false;
  static constexpr auto keys() {
    using K = KeysOf<SolidFile>;
    return std::tuple(K::Path{&SolidFile::file, "file", "path, relative to the folder of the script"},
                      K::Number{&SolidFile::scale, "scale", "1", "metres for each unit of the file", above_zero},
                      K::Flag{&SolidFile::y_up, "y_up", "y is the vertical axis of the file"},
                      K::Flag{&SolidFile::shells_are_bodies, "shells_are_bodies",
                              "each closed shell is a body, instead of a piece of one"},
                      K::Number{&SolidFile::weld,
                                "weld",
                                "1",
                                "distance below which corners are merged, as a share of the size",
                                {0, 0.01}},
                      K::Number{&SolidFile::flat,
                                "flat",
                                "1",
                                "distance from a plane below which faces are in it, over the size",
                                {1e-12, 0.01}});
  }
  /// read_solids.
  [[nodiscard]] SolidParts parts() const;
};

/// Reads the solids of a Wavefront OBJ file, in its order. A body is an object ("o"). It is a group ("g") if the file
/// has no objects, or if a group contains faces of several objects, which are then its pieces. Faces may have any
/// number of corners and negative indices; normals, textures, materials, points and lines are skipped. Each closed
/// shell must be convex. Inverted faces are reversed, coplanar ones are merged, and corners are moved onto the planes
/// of their faces. Each kind of repair gives one note, with the first solid and the number of others. Throws InputError
/// with the line and the error, and with name and place for solids that are open, flat or hollow, self-intersecting, or
/// with an edge of three faces.
SolidParts parse_obj(std::string_view text, const SolidFile& how, std::string_view owner);

/// Reads the solids of an STL file, text or binary: one body for each "solid" of a text, one for a binary file. As
/// parse_obj.
SolidParts parse_stl(std::string_view bytes, const SolidFile& how, std::string_view owner);

/// Reads a file, by its extension .obj or .stl in upper or lower case. Throws InputError if it cannot be read or has
/// another extension, and as the functions above.
SolidParts read_solids(const std::filesystem::path& path, const SolidFile& how = {});

/// One body of a file: surfaces, each of one or more closed shells.
struct NamedSurfaces {
  std::string name;
  std::vector<std::string> groups;
  std::vector<Polyhedron> surfaces;
};

/// Makes parts from the surfaces that a reader has found, see parse_obj. Duplicate names get ".2", ".3", ..., with a
/// note.
SolidParts solids_of_file(const std::vector<NamedSurfaces>& bodies, const SolidFile& how, std::string_view owner);

/// Error text for a point beyond 1e12 m, where tolerances have no meaning; "" for a valid point.
std::string why_beyond_reach(const Vec3& place);

/// Transforms a point of the file to the axes and the unit of a model; throws InputError for a scale that is not above
/// 0.
class FileAxes {
 public:
  FileAxes(const SolidFile& how, std::string_view owner);
  [[nodiscard]] Vec3 place(double x, double y, double z) const {
    return scale_ * (y_up_ ? Vec3(x, -z, y) : Vec3(x, y, z));
  }

 private:
  double scale_;
  bool y_up_;
};

}  // namespace trilith
