// A mesh from a file in the table of a script: { file = "x.msh", scale = 1 }.
#pragma once

#include <filesystem>
#include <string>

#include "bindings/core/bindings.hpp"

namespace trilith::script {

/// The mesh that `read` finds in `file`, relative to the folder of the script. `scale` of the table, above 0,
/// multiplies its coordinates. Ends the reading of the table.
template <class M>
M mesh_of_file(Keys& keys, const std::string& file, M (*read)(const std::filesystem::path&)) {
  const double scale = keys.number("scale", "1", 1);
  if (!(scale > 0)) keys.problem(fmt::format("'scale' is {:g}, must be above 0", scale));
  keys.finish();
  const std::filesystem::path path = file;
  M mesh = read(path.is_absolute() ? path : host(keys.lua()).folder() / path);
  if (scale != 1)
    for (auto& node : mesh.node) node *= scale;
  return mesh;
}

}  // namespace trilith::script
