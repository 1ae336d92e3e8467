// trilith report RESULT [-o FILE]
#include "report/report.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "base/error.hpp"
#include "base/whole_file.hpp"
#include "bindings/core/host.hpp"
#include "program/newer_run.hpp"
#include "program/output_folder.hpp"
#include "program/share_status.hpp"
#include "program/since_option.hpp"
#include "program/units_option.hpp"
#include "program/verbs.hpp"

namespace trilith::program {
namespace {

struct ReportOptions {
  std::string result, out, since, units;
};

/// Folders that the script searched: its own folder and the project's.
std::vector<std::filesystem::path> record_folders_of(const results::ResultsReader& reader) {
  std::vector<std::filesystem::path> folders = script::record_folders();
  const std::filesystem::path script = reader.header().provenance.script_path;
  folders.insert(folders.begin(), script.has_parent_path() ? script.parent_path() : std::filesystem::path("."));
  return folders;
}

int report(const ReportOptions& options) {
  const std::filesystem::path out = options.out.empty()
                                        ? std::filesystem::path(options.result).replace_extension(".report.html")
                                        : std::filesystem::path(options.out);
  if (out.extension() != ".html" && out.extension() != ".htm")
    throw InputError(
        fmt::format("'{}': the name of a report must end with .html; a browser prints it to PDF", out.string()));
  const results::ResultsReader reader(options.result);
  const results::TimeOrigin origin = results::time_origin(reader, options.since);
  ShareStatus status("sealing frames");
  const std::string page = report::report_page(
      reader, record_folders_of(reader), [&](double share) { status(share); }, origin,
      shown_units(options.units, reader));
  status.clear();
  make_folder_for(out);
  write_whole_file(out, page);
  fmt::print("{}\n", out.string());
  tell_of_newer_run(reader);
  if (!reader.finished())
    fmt::print("the run {}: the report covers the part that was written\n",
               reader.running() ? "is in progress" : "was stopped");
  return ended_well;
}

}  // namespace

void add_report(CLI::App& app, int& code) {
  auto o = std::make_shared<ReportOptions>();
  CLI::App* verb = app.add_subcommand("report", "Write the report of a run: one printable page");
  verb->add_option("result", o->result, "results file, also of a run that was killed or is in progress")
      ->required()
      ->type_name("RESULT");
  verb->add_option("-o,--output", o->out, "the report, .html; default RESULT with .report.html")->type_name("FILE");
  add_since(*verb, o->since);
  add_units(*verb, o->units);
  verb->callback([o, &code] { code = report(*o); });
}

}  // namespace trilith::program
