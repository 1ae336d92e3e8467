// trilith export RESULT --to vtk|csv|xlsx [-o FOLDER] [--frames FROM:TO:EVERY] [--table NAME] [--at T,...] [--units
// UNITS]
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "base/error.hpp"
#include "base/whole_file.hpp"
#include "program/comma_list.hpp"
#include "program/newer_run.hpp"
#include "program/output_folder.hpp"
#include "program/scene_options.hpp"
#include "program/share_status.hpp"
#include "program/spreadsheet.hpp"
#include "program/units_option.hpp"
#include "program/verbs.hpp"
#include "results/tables/csv_table.hpp"
#include "results/tables/run_tables.hpp"
#include "results/vtk/vtk_export.hpp"

namespace trilith::program {
namespace {

struct ExportOptions {
  std::string result, to = "vtk", out, frames, table, at = "end", units;
};

/// "10:200:5", "10:200", ":200", "::5", "7": range of frames, counted from 0, both ends included.
results::FrameRange frame_range(const std::string& text) {
  results::FrameRange range;
  const auto refuse = [&] {
    throw InputError(
        fmt::format("--frames: '{}' must be FROM:TO:EVERY, whole numbers counted from 0, each may be left out, FROM "
                    "not above TO and EVERY not 0",
                    text));
  };
  std::size_t part = 0;
  std::string digits;
  for (const char c : text + ":") {
    if (c >= '0' && c <= '9' && digits.size() < 9) {
      digits += c;
      continue;
    }
    if (c != ':' || part > 2) refuse();
    std::size_t* const number[] = {&range.from, &range.to, &range.every};
    if (!digits.empty()) *number[part] = std::stoul(digits);
    ++part;
    digits.clear();
  }
  if (part == 1) range.to = range.from;
  if (text.empty() || text == ":" || range.every == 0 || range.to < range.from) refuse();
  return range;
}

/// The folder of --output; by default the path of the results with an ending.
std::filesystem::path folder_of(const ExportOptions& options, const char* ending) {
  const std::filesystem::path result = options.result;
  return options.out.empty() ? result.parent_path() / (result.stem().string() + ending)
                             : std::filesystem::path(options.out);
}

/// Moments for the tables of bodies and bearings; empty without frames.
std::vector<double> table_times(const results::ResultsReader& reader, const std::string& at) {
  std::vector<double> times;
  if (reader.frame_times().empty()) return times;
  const SceneWindow window = scene_window(reader, {});
  for (const std::string& text : comma_list(at)) {
    times.push_back(scene_time(reader, window, text, "--at"));
    if (times.back() < reader.frame_times().front() || times.back() > reader.frame_times().back())
      throw InputError(fmt::format("--at: {:g} s is outside the frames of '{}', {:g} s to {:g} s", times.back(),
                                   reader.path().string(), reader.frame_times().front(), reader.frame_times().back()));
  }
  return times;
}

void refuse_frames(const ExportOptions& options) {
  if (!options.frames.empty())
    throw InputError(fmt::format("--frames: is for --to vtk; {} takes moments, --at T[,T...]", options.to));
}

int export_xlsx(const ExportOptions& options) {
  refuse_frames(options);
  const results::ResultsReader reader(options.result);
  const std::vector<double> times = table_times(reader, options.at);
  std::filesystem::path out = options.result;
  out = options.out.empty() ? out.replace_extension(".xlsx") : std::filesystem::path(options.out);
  if (out.extension() != ".xlsx") throw InputError(fmt::format("--output: '{}' must end in .xlsx", out.string()));
  make_folder_for(out);
  const UnitSystem units = shown_units(options.units, reader);
  Spreadsheet book(out);
  for (const std::string& name : options.table.empty() ? results::table_names() : std::vector{options.table}) {
    book.begin_sheet(name);
    results::write_table(reader, name, times, book, units);
  }
  book.close();
  fmt::print("{}\n", out.string());
  tell_of_newer_run(reader);
  return ended_well;
}

int export_csv(const ExportOptions& options) {
  refuse_frames(options);
  const results::ResultsReader reader(options.result);
  const std::vector<double> times = table_times(reader, options.at);
  const UnitSystem units = shown_units(options.units, reader);
  if (!options.table.empty()) {
    const std::string text = results::csv_table(reader, options.table, times, units);
    if (options.out.empty() || options.out == "-") {
      fmt::print("{}", text);
    } else {
      make_folder_for(options.out);
      write_whole_file(options.out, text);
      fmt::print("{}\n", options.out);
    }
    return ended_well;
  }
  const std::filesystem::path out = folder_of(options, "_csv");
  make_folder_for(out / "");
  for (const std::string& name : results::table_names()) {
    const std::filesystem::path path = out / (name + ".csv");
    write_whole_file(path, results::csv_table(reader, name, times, units));
    fmt::print("{}\n", path.string());
  }
  tell_of_newer_run(reader);
  return ended_well;
}

int export_results(const ExportOptions& options) {
  if (options.to == "csv") return export_csv(options);
  if (options.to == "xlsx") return export_xlsx(options);
  if (!options.table.empty()) throw InputError("--table: is for --to csv and --to xlsx");
  if (!options.units.empty()) throw InputError("--units: is for --to csv and --to xlsx; files for ParaView are in SI");
  const std::filesystem::path out = folder_of(options, "_vtk");
  const results::FrameRange range = options.frames.empty() ? results::FrameRange{} : frame_range(options.frames);
  const results::ResultsReader reader(options.result);
  ShareStatus status("writing frames");
  const auto written = results::export_vtk(reader, out, range, [&](double share) { status(share); });
  status.clear();
  for (const std::filesystem::path& path : written) fmt::print("{}\n", path.string());
  tell_of_newer_run(reader);
  return ended_well;
}

}  // namespace

void add_export(CLI::App& app, int& code) {
  auto o = std::make_shared<ExportOptions>();
  CLI::App* verb =
      app.add_subcommand("export", "Write a run for other programs: xlsx or csv for spreadsheets, vtk for ParaView");
  verb->add_option("result", o->result, "results file, also of a run that was killed or is in progress")
      ->required()
      ->type_name("RESULT");
  verb->add_option("--to", o->to, "the format")->check(CLI::IsMember({"vtk", "csv", "xlsx"}))->capture_default_str();
  verb->add_option("-o,--output", o->out,
                   "folder; default RESULT with _vtk or _csv; for xlsx, or with --table, a file, or - for here")
      ->type_name("FOLDER");
  verb->add_option("--frames", o->frames, "vtk: which frames, counted from 0, as in 0:300:10; default all")
      ->type_name("FROM:TO:EVERY");
  verb->add_option("--table", o->table, "csv, xlsx: only one table")->check(CLI::IsMember(results::table_names()));
  verb->add_option(
          "--at", o->at,
          "csv, xlsx: moments of the tables of bodies, bearings and members: seconds, 'start', 'end' or an event")
      ->type_name("T[,T...]")
      ->capture_default_str();
  add_units(*verb, o->units);
  verb->callback([o, &code] { code = export_results(*o); });
}

}  // namespace trilith::program
