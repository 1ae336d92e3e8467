// The report of a run: one HTML page without scripts for screen and print.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "results/file/time_origin.hpp"
#include "results/reading/reader.hpp"

namespace trilith::report {

/// Called repeatedly with the completed share, 0 to 1.
using ReportProgress = std::function<void(double)>;

/// The whole page, self-contained with its pictures: verdict, model, parameters, ground motion, stages, pictures at key
/// times, chain of events, histories, energy, damage by storey, seal, and commands to repeat the run. An unfinished run
/// is reported up to its last flush, with a note. Data that a file lacks are omitted or reported as missing. Throws
/// ResultsError if the file cannot be read.
///
/// `record_folders`: folders in which records of ground motions are searched by name, in this order. `origin`: origin
/// of times, which the page states. `units`: in which numbers are shown.
std::string report_page(const results::ResultsReader& reader,
                        const std::vector<std::filesystem::path>& record_folders = {},
                        const ReportProgress& progress = {}, const results::TimeOrigin& origin = {},
                        const UnitSystem& units = {});

}  // namespace trilith::report
