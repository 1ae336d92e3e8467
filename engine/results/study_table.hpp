// The table of a study: one HDF5 file with a row for each case.
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "results/results.hpp"

namespace trilith::results {

/// One column: numbers (NaN: this case has none), whole numbers or texts, one for each case.
struct StudyColumn {
  std::string name, unit, description;
  std::variant<std::vector<double>, std::vector<std::int32_t>, std::vector<std::string>> values;
};

/// True where `path` is the table of a study.
bool is_study_table(const std::filesystem::path& path);

/// The columns of numbers, in their order; texts are left out. Throws ResultsError.
std::vector<StudyColumn> read_study_table(const std::filesystem::path& path);

/// Throws ResultsError where `path` cannot be written, or is a file that is not the table of a study.
void require_study_path(const std::filesystem::path& path);

/// Writes table /cases and group /provenance; all columns have the same length. `complete`: every case has been run.
/// The file takes its name when it is whole. Throws ResultsError.
void write_study_table(const std::filesystem::path& path, const std::vector<StudyColumn>& columns,
                       const Provenance& provenance, bool complete);

}  // namespace trilith::results
