// Data of the program and its platform.
#pragma once

#include <string>

#include "results/file/results.hpp"

namespace trilith::results {

/// The commit of the build, with "+" if files had changed; empty outside of git. Written by cmake/git_commit.cmake at
/// each build.
const char* built_from();

/// "1.10.8": the HDF5 library at run time.
std::string hdf5_version();

/// Provenance with compiler, platform, git commit and start time (now, UTC); the caller adds script, program version
/// and command line.
Provenance provenance_here();

}  // namespace trilith::results
