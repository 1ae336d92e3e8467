// Results for ParaView: for each frame the bodies, the contact forces and the bearings, and a list of them over time.
//
// Bodies are cells of an unstructured grid, one of them a body (in space a VTK_POLYHEDRON, in the plane a polygon), and
// not faces of a surface: what belongs to a body is there once, a click picks a body, a threshold keeps whole ones,
// and a clip shows that they are solid. ParaView draws their outer faces as it draws those of any grid.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <limits>
#include <vector>

#include "results/reading/reader.hpp"

namespace trilith::results {

/// Frames `from`, `from + every`, ... up to and including `to`, counted from 0; those beyond the last are none.
struct FrameRange {
  std::size_t from = 0, to = std::numeric_limits<std::size_t>::max(), every = 1;
};

/// Writes `<name>_bodies.pvd`, `<name>_contacts.pvd` and, where there are bearings, `<name>_bearings.pvd` into
/// `folder`, which is made where it is not there, and the files they name into folders beside them. `name` is that of
/// the results file. Returns the .pvd files, which are written last. What each array is: docs/results.md. Throws
/// ResultsError where there is no frame in the range or a file cannot be read, InputError where one cannot be written.
/// `progress` is called with the share that is done.
std::vector<std::filesystem::path> export_vtk(const ResultsReader& reader, const std::filesystem::path& folder,
                                              const FrameRange& range = {},
                                              const std::function<void(double)>& progress = {});

}  // namespace trilith::results
