// Tables of a run, for spreadsheets and statistics programs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "results/reading/reader.hpp"
#include "results/tables/table_sink.hpp"

namespace trilith::results {

/// Names of the tables, in the order of export: "histories", "energy", "events", "stages", "bodies", "bearings",
/// "members", ...
const std::vector<std::string>& table_names();

/// Writes the table `name` in `units`: a header with units in square brackets, then the rows. `times` [s]: moments of
/// the tables "bodies" and "bearings", interpolated between frames, and of "members", of the nearest frame. Throws
/// InputError for an unknown name, ResultsError if the file cannot be read or has no frame.
void write_table(const ResultsReader& reader, std::string_view name, const std::vector<double>& times, TableSink& out,
                 const UnitSystem& units = {});

}  // namespace trilith::results
