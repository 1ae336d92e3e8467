// A table as comma-separated values.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "results/reading/reader.hpp"

namespace trilith::results {

/// The table `name` of run_tables.hpp: rows end with '\n', numbers have a decimal point and are exact, a missing value
/// is empty. A text with a comma, a quote or a line break is quoted (RFC 4180). Throws as write_table.
std::string csv_table(const ResultsReader& reader, std::string_view name, const std::vector<double>& times,
                      const UnitSystem& units = {});

}  // namespace trilith::results
