// Readers of closed solids in files of other programs: OBJ, and STL as text or binary.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "build/space/solid_part.hpp"

namespace trilith {

/// How a file of solids is read.
struct SolidFile {
  std::string name = {};           ///< names of parts begin with it, and parts without one of their own have it
  double scale = 1;                ///< m for each unit of the file, above 0; 0.001 for mm
  bool y_up = false;               ///< the file's y is up: its (x, y, z) becomes (x, -z, y)
  bool shells_are_bodies = false;  ///< each closed shell becomes a body "name.1", "name.2", ..., not a piece of one
  double weld = 1e-7;              ///< corners nearer than this times the body's size are one, 0 to 0.01
  double flat = 1e-6;  ///< faces within this times the solid's size of one plane become one face, 1e-12 to 0.01. Single
                       ///< precision, as of binary STL, has about 1e-7
  std::vector<std::string> groups = {};  ///< of all parts
};

/// Solids of a Wavefront OBJ file, in its order. A body is an object ("o"), or a group ("g") where a group holds faces
/// of several objects, which then are its pieces, or where there are no objects. Faces of any number of corners;
/// negative indices; normals, textures, materials, points and lines are passed over. Each closed shell must be convex;
/// faces that run the wrong way are turned, coplanar ones joined, and corners brought onto the planes of their faces:
/// with notes, each of the first solid it is true of and how many more. Throws InputError with line and what is wrong
/// there, and for solids that are open, flat or hollow, cross themselves or have an edge with three faces, with their
/// name and the place.
SolidParts parse_obj(std::string_view text, const SolidFile& how, std::string_view owner);

/// Solids of an STL file, text or binary: one body for each "solid" of a text, one for a binary file. As parse_obj.
SolidParts parse_stl(std::string_view bytes, const SolidFile& how, std::string_view owner);

/// Reads a file, by its ending .obj or .stl, in any case. Throws InputError where it cannot be read, has another
/// ending, and as the above.
SolidParts read_solids(const std::filesystem::path& path, const SolidFile& how = {});

/// One body of a file: surfaces of one or more closed shells each.
struct NamedSurfaces {
  std::string name;
  std::vector<std::string> groups;
  std::vector<Polyhedron> surfaces;
};

/// Makes parts of what a reader has found, as parse_obj says. Names that come twice get ".2", ".3", ..., with a note.
SolidParts solids_of_file(const std::vector<NamedSurfaces>& bodies, const SolidFile& how, std::string_view owner);

/// What is wrong with a place that is farther out than tolerances have a meaning, 1e12 m; "" where nothing is.
std::string why_beyond_reach(const Vec3& place);

/// A place of the file in the axes and the unit of a model; throws InputError for a scale that is not above 0.
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
