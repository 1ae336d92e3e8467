// Tables of a run as comma-separated values, for spreadsheets and statistics programs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "results/reading/reader.hpp"

namespace trilith::results {

/// Names of the tables, in the order of export: "histories", "energy", "events", "stages", "bodies", "bearings",
/// "members", ...
const std::vector<std::string>& csv_table_names();

/// The table `name`: a header with units in square brackets, then the rows, '\n' ended. Numbers have a decimal point
/// and are exact; a missing value is empty. A text with a comma, a quote or a line break is quoted (RFC 4180). `times`
/// [s]: moments of the tables "bodies" and "bearings", interpolated between frames, and of "members", of the nearest
/// frame. Throws InputError for an unknown
/// name, ResultsError if the file cannot be read or has no frame.
std::string csv_table(const ResultsReader& reader, std::string_view name, const std::vector<double>& times);

}  // namespace trilith::results
