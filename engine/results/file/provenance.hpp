// What the program knows of itself and of where it runs.
#pragma once

#include <string>

#include "results/file/results.hpp"

namespace trilith::results {

/// The commit this was built from, "+" behind it where files had changed since; empty outside of git. Written by
/// cmake/git_commit.cmake at each build.
const char* built_from();

/// "1.10.8": the HDF5 library that runs.
std::string hdf5_version();

/// Compiler, platform, git commit and start time (now, UTC) filled in; the rest, script, program version and command
/// line, is the caller's.
Provenance provenance_here();

}  // namespace trilith::results
