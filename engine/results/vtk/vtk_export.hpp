// Export for ParaView: for each frame the bodies, the contact forces and the bearings, and a list of them over time.
//
// Each body is a cell of an unstructured grid (in space a VTK_POLYHEDRON, in the plane a polygon) instead of faces of a
// surface. So data of a body occur once, a click selects a body, a threshold keeps whole bodies, and a clip shows that
// they are solid. ParaView draws their outer faces as for any grid.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <limits>
#include <vector>

#include "results/reading/reader.hpp"

namespace trilith::results {

/// Frames `from`, `from + every`, ... up to and including `to`, counted from 0, up to the last frame.
struct FrameRange {
  std::size_t from = 0, to = std::numeric_limits<std::size_t>::max(), every = 1;
};

/// Writes `<name>_bodies.pvd`, `<name>_contacts.pvd` and, if there are bearings, `<name>_bearings.pvd` into `folder`,
/// which is created if necessary. The files they refer to are written into subfolders. `name` is the name of the
/// results file. Returns the .pvd files, which are written last. The arrays are described in docs/results.md. Throws
/// ResultsError if there is no frame in the range or a file cannot be read, InputError if one cannot be written.
/// `progress` is called with the completed share.
std::vector<std::filesystem::path> export_vtk(const ResultsReader& reader, const std::filesystem::path& folder,
                                              const FrameRange& range = {},
                                              const std::function<void(double)>& progress = {});

}  // namespace trilith::results
