// The report of a run: one HTML page without scripts that reads well on a screen and prints well.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "results/file/time_origin.hpp"
#include "results/reading/reader.hpp"

namespace trilith::report {

/// Called now and then with the share done, 0 to 1.
using ReportProgress = std::function<void(double)>;

/// The whole page, self-contained, with its pictures in it: verdict, model, parameters, ground motion, stages, pictures
/// at key times, chain of events, histories, energy, damage by storey, seal, how to run it again. A run that has not
/// finished is reported up to its last flush, and said to be so; what a file does not hold is left out or said to be
/// missing. Throws ResultsError where the file cannot be read.
///
/// `record_folders`: where records of ground motions are looked for by name, in this order. `origin`: what times count
/// from, which the page then says.
std::string report_page(const results::ResultsReader& reader,
                        const std::vector<std::filesystem::path>& record_folders = {},
                        const ReportProgress& progress = {}, const results::TimeOrigin& origin = {});

}  // namespace trilith::report
