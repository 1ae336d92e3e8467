// trilith export RESULT --to vtk [-o FOLDER] [--frames FROM:TO:EVERY]
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "base/error.hpp"
#include "program/newer_run.hpp"
#include "program/share_status.hpp"
#include "program/verbs.hpp"
#include "results/vtk/vtk_export.hpp"

namespace trilith::program {
namespace {

struct ExportOptions {
  std::string result, to = "vtk", out, frames;
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

int export_results(const ExportOptions& options) {
  const std::filesystem::path result = options.result;
  const std::filesystem::path out = options.out.empty() ? result.parent_path() / (result.stem().string() + "_vtk")
                                                        : std::filesystem::path(options.out);
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
  CLI::App* verb = app.add_subcommand("export", "Write a run for other programs: ParaView reads vtk");
  verb->add_option("result", o->result, "results file, also of a run that was killed or is in progress")
      ->required()
      ->type_name("RESULT");
  verb->add_option("--to", o->to, "the format")->check(CLI::IsMember({"vtk"}))->capture_default_str();
  verb->add_option("-o,--output", o->out, "folder; default RESULT with _vtk")->type_name("FOLDER");
  verb->add_option("--frames", o->frames, "which frames, counted from 0, as in 0:300:10; default all")
      ->type_name("FROM:TO:EVERY");
  verb->callback([o, &code] { code = export_results(*o); });
}

}  // namespace trilith::program
