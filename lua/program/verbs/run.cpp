// trilith run SCRIPT [NAME=VALUE ...]
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>

#include "base/bytes.hpp"
#include "base/error.hpp"
#include "base/team.hpp"
#include "base/whole_file.hpp"
#include "bindings/restart/restart_files.hpp"
#include "program/assignment.hpp"
#include "program/positive.hpp"
#include "program/profile_text.hpp"
#include "program/script/run.hpp"
#include "program/script/run_options.hpp"
#include "program/since_option.hpp"
#include "program/verbs.hpp"

namespace trilith::program {
namespace {

/// True if the checkpoints in the folder of a case belong to this run; otherwise clears the folder.
bool is_of_this_run(const RunOptions& options, const script::RestartCall& now) {
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(options.folder, error)) {
    if (entry.path().extension() != ".restart") continue;
    try {
      const std::string bytes = script::RestartFiles(entry.path()).get("call");
      ByteReader in(bytes, "restart file 'call'");
      const auto before = in.get<script::RestartCall>();
      if (before.build == now.build && before.text == now.text && before.given == now.given &&
          before.number == now.number && before.folder == now.folder)
        return true;
    } catch (const InputError&) {  // damaged, or of another version
      continue;
    }
  }
  for (const auto& entry : std::filesystem::directory_iterator(options.folder, error)) {
    const std::string name = entry.path().filename().string();
    if (name != "log.txt" && name != "errors.txt") std::filesystem::remove_all(entry.path(), error);
  }
  return false;
}

/// The window of --check-step. Throws InputError for a text that is none.
std::optional<StepWindow> step_window(const std::string& text) {
  if (text.empty() || text == "false") return std::nullopt;
  StepWindow window;
  if (text == "true") return window;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%lf,%lf%c", &window.from, &window.to, &rest) == 2 && window.from >= 0 &&
      window.to > window.from)
    return window;
  throw InputError(
      fmt::format("--check-step={}: must be two times of the run in seconds, FROM,TO, such as 9,10", text));
}

/// Restart options, and how to run the script again.
script::RestartChoice restart_of(const RunOptions& options) {
  script::RestartChoice restart;
  restart.every = options.list ? 0 : options.checkpoint;
  script::RestartCall& call = restart.call;
  std::error_code error;
  call.build = script::this_build();
  call.folder = std::filesystem::current_path(error).string();
  call.script = options.script, call.named_results = options.results, call.case_folder = options.folder;
  if (options.goes_on) call.text = text_of_file(options.script, "script", script::largest_script);
  call.given = options.given, call.number = options.only;
  ByteWriter room;
  room.item(options.room);
  call.room = room.take();
  call.threads = options.threads, call.every = options.checkpoint;
  restart.resumes = options.resumes || (options.goes_on && is_of_this_run(options, call));
  return restart;
}

}  // namespace

int run_as_asked(const RunOptions& options) {
  Live live(stdout, EventLines(options.events, options.least_impact, options.since), options.quiet);
  script::Host host;
  host.script = options.script;
  host.given = host.arguments = options.given;
  host.case_folder = options.folder;
  host.study.program = program_path();
  host.study.only = options.only;
  host.list_parameters = options.list;
  host.results_file = options.results;
  host.profile.wanted = options.profile;
  host.check_step = step_window(options.check_step);
  host.threads = options.threads;
  host.records = script::record_folders();
  host.observer = options.list ? nullptr : &live;
  host.command_line = "trilith run " + options.script;
  for (const std::string& g : options.given) host.command_line += " " + g;
  set_room(host, options.room);
  host.restart = restart_of(options);
  const int code = run_script(host);
  live.clear();
  if (live.waits() && !options.list)
    fmt::print("note: --since: there was no stage and no event '{}'; times count from the start of the run\n",
               options.since);
  if (options.profile) fmt::print("{}", profile_text(host.profile));
  if (options.only > 0 && options.folder.empty()) fmt::print("{}", figures_text(host.figures));
  return code;
}

void add_checkpoint_option(CLI::App& verb, double& seconds, const std::string& usual) {
  verb.add_option("--checkpoint", seconds,
                  "wall clock between checkpoints, from which trilith resume continues [s]; 0: none; " + usual)
      ->type_name("SECONDS")
      ->check(CLI::Validator(is_not_negative, "", ""));
}

void add_run(CLI::App& app, int& code) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* verb = app.add_subcommand("run", "Run a Lua script");
  verb->add_option("script", options->script, "the script")->required()->type_name("SCRIPT");
  verb->add_option("parameters", options->given,
                   "parameters that the script declares, in their declared unit or with a unit, as in pga=0.6g")
      ->type_name("NAME=VALUE")
      ->check(CLI::Validator(is_assignment, "", ""));
  verb->add_option("--results", options->results, "write the results to FILE instead of the script's own")
      ->type_name("FILE");
  static const std::map<std::string, EventShow> shows{
      {"all", EventShow::all}, {"important", EventShow::important}, {"none", EventShow::none}};
  verb->add_option(
          "--events", options->events,
          "which events to show: all, important (no contacts made and lost, slow impacts or bodies at rest) or none")
      ->transform(CLI::CheckedTransformer(shows).description(""))
      ->type_name("all|important|none");
  verb->add_option("--impacts", options->least_impact,
                   "hide impacts slower than this [m/s], unless all events are shown")
      ->type_name("SPEED")
      ->capture_default_str();
  add_since(*verb, options->since);
  verb->add_flag("--quiet,-q", options->quiet, "show neither events nor status");
  verb->add_option("--folder", options->folder, "write all results, and the figures that the script returns, into DIR")
      ->type_name("DIR")
      ->check(CLI::ExistingDirectory);
  verb->add_option("--case", options->only, "run only this case of the script's study, here")
      ->type_name("NUMBER")
      ->check(CLI::Validator(is_positive, "", ""));
  verb->add_option(
          "--threads", options->threads,
          "threads of a step; results do not depend on it. Default: TRILITH_THREADS, the script, or the fastest "
          "number, which is measured")
      ->type_name("NUMBER")
      ->check(CLI::Range(1, most_threads));
  add_checkpoint_option(*verb, options->checkpoint, fmt::format("{:g} where not given", usual_checkpoint));
  verb->add_flag("--go-on", options->goes_on)->group("");
  verb->add_flag(
      "--check-step", options->check_step,
      "repeat the last second of the last shaking, or with =FROM,TO that window [s], with half the step, and "
      "report the difference");
  verb->add_flag("--profile", options->profile,
                 "print the computing time: parts of the step, contact laws, Lua callbacks");
  add_room_options(*verb, options->room);
  verb->add_flag("--params", options->list, "list the script's parameters and exit");
  verb->callback([options, &code] { code = run_as_asked(*options); });
}

}  // namespace trilith::program
