// The table of a study: one HDF5 file with a row for each case.
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "results/file/results.hpp"

namespace trilith::results {

/// One column: numbers (NaN: no value), integers or texts, one for each case.
struct StudyColumn {
  std::string name, unit, description;
  std::variant<std::vector<double>, std::vector<std::int32_t>, std::vector<std::string>> values;
};

/// Unit of a flag column with 1 and 0; NaN: no value.
inline constexpr const char* flag_unit = "flag";
/// Descriptions that mark the columns of parameters and of figures.
inline constexpr const char *parameter_text = "parameter", *figure_text = "figure that the case gave";
inline bool is_flag(const StudyColumn& column) {
  return column.unit == flag_unit;
}

/// Names of the parameters and of the figures, in their order.
struct StudyNames {
  std::vector<std::string> parameters, figures;
};
StudyNames study_names(const std::vector<StudyColumn>& columns);

/// The column called `name` among `known`. Throws InputError, with the nearest name, if there is none; `kind` is
/// "parameter" or "figure" in the message.
const StudyColumn& study_column(const std::vector<StudyColumn>& columns, const std::string& name,
                                const std::vector<std::string>& known, const char* kind);

/// The values of a column of numbers. Throws InputError for a column of texts.
const std::vector<double>& study_numbers(const StudyColumn& column);

/// The value of row `row` as text: "0.4", "true", "rocking"; "" if there is none.
std::string study_text(const StudyColumn& column, std::size_t row);

/// True if `path` is the table of a study.
bool is_study_table(const std::filesystem::path& path);

/// All columns, in their order; integers are read as numbers too. Throws ResultsError.
std::vector<StudyColumn> read_study_table(const std::filesystem::path& path);

/// Throws ResultsError if `path` cannot be written, or is a file that is not the table of a study.
void require_study_path(const std::filesystem::path& path);

/// Writes table /cases and group /provenance; all columns have the same length. `complete`: every case has been run.
/// The file is written to a temporary name and renamed when complete. Throws ResultsError.
void write_study_table(const std::filesystem::path& path, const std::vector<StudyColumn>& columns,
                       const Provenance& provenance, bool complete);

}  // namespace trilith::results
