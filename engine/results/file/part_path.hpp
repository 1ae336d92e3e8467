// Names of the file of a run that has not finished, and whether its run still writes it. Needs no HDF5.
#pragma once

#include <filesystem>

namespace trilith::results {

/// `<name>.part`: file of the rows until the run finishes.
std::filesystem::path part_path(const std::filesystem::path& name);

/// `<name>.part.before`: the rows while they are copied to a new part file that has more bodies.
std::filesystem::path replaced_part_path(const std::filesystem::path& name);

/// True while another writer holds the part file at `path`. Its contents are not read, so they may be incomplete.
bool is_being_written(const std::filesystem::path& path);

}  // namespace trilith::results
