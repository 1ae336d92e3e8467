// trilith view RESULT [-o FILE]
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "base/error.hpp"
#include "base/whole_file.hpp"
#include "program/newer_run.hpp"
#include "program/output_folder.hpp"
#include "program/share_status.hpp"
#include "program/since_option.hpp"
#include "program/units_option.hpp"
#include "program/verbs.hpp"
#include "view/data.hpp"

namespace trilith::program {
namespace {

struct ViewOptions {
  std::string result, out, since, units;
};

int view(const ViewOptions& options) {
  const std::filesystem::path out = options.out.empty()
                                        ? std::filesystem::path(options.result).replace_extension(".html")
                                        : std::filesystem::path(options.out);
  if (out.extension() != ".html" && out.extension() != ".htm")
    throw InputError(fmt::format("'{}': the name of a page must end with .html", out.string()));
  const results::ResultsReader reader(options.result);
  const results::TimeOrigin origin = results::time_origin(reader, options.since);
  ShareStatus status("reading frames");
  const std::string data = view::view_data(
      reader, {}, [&](double share) { status(share); }, origin, shown_units(options.units, reader));
  status.clear();
  const std::string title = reader.title();
  make_folder_for(out);
  write_whole_file(out, view::view_page(data, title));
  fmt::print("{}\n", out.string());
  tell_of_newer_run(reader);
  if (!reader.finished())
    fmt::print("the run {}: the page shows the part that was written\n",
               reader.running() ? "is in progress" : "was stopped");
  return ended_well;
}

}  // namespace

void add_view(CLI::App& app, int& code) {
  auto o = std::make_shared<ViewOptions>();
  CLI::App* verb = app.add_subcommand("view", "Write a page that plays the run in any browser");
  verb->add_option("result", o->result, "results file, also of a run that was killed or is in progress")
      ->required()
      ->type_name("RESULT");
  verb->add_option("-o,--output", o->out, "the page, .html; default RESULT with .html")->type_name("FILE");
  add_since(*verb, o->since);
  add_units(*verb, o->units);
  verb->callback([o, &code] { code = view(*o); });
}

}  // namespace trilith::program
