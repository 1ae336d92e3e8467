// trilith study SCRIPT [NAME=VALUE ...] [--over NAME=V1,V2,...]
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>

#include "base/error.hpp"
#include "bindings/study/study_order.hpp"
#include "program/assignment.hpp"
#include "program/comma_list.hpp"
#include "program/interrupt.hpp"
#include "program/live.hpp"
#include "program/positive.hpp"
#include "program/script/room_options.hpp"
#include "program/script/run.hpp"
#include "program/script/run_options.hpp"
#include "program/verbs.hpp"

namespace trilith::program {
namespace {

struct StudyOptions {
  std::string script, out;
  std::vector<std::string> given, over;
  std::string ida, stop, on, cases;
  script::StudyChoice choice;
  bool quiet = false;
  RoomOptions room;
};

/// "0.4", "0.4 g": a number, and an optional unit after it.
bool read_number(const std::string& text, double& value, std::string& unit) {
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) return false;
  unit.assign(stop, text.data() + text.size());
  unit.erase(0, unit.find_first_not_of(' '));
  return true;
}

/// "1..8" as integers, "0.1..0.5:5" as five evenly spaced numbers; false for other text.
bool read_range(const std::string& text, std::vector<StudyValue>& values) {
  const std::size_t dots = text.find("..");
  if (dots == std::string::npos) return false;
  const std::size_t colon = std::min(text.find(':', dots), text.size());
  const std::string what = fmt::format("study: '{}'", text);
  const double from = number_of(text.substr(0, dots), what),
               to = number_of(text.substr(dots + 2, colon - dots - 2), what);
  if (!(to >= from)) throw InputError(what + ": the second number must be above the first");
  const auto is_whole = [](double v) { return v == std::floor(v); };
  if (colon == text.size() && !(is_whole(from) && is_whole(to)))
    throw InputError(fmt::format("{} has no number of values; write {}:5 for five, evenly spaced", what, text));
  const double count = colon == text.size() ? to - from + 1 : number_of(text.substr(colon + 1), what);
  if (count == 1 && from == to) return values.emplace_back(from), true;
  if (!(is_whole(count) && count >= 2 && count <= 1e6))
    throw InputError(fmt::format("{}: {:g} values, must be a whole number from 2 to 1000000", what, count));
  // 12 digits, so that the decimal 0.3 is not 0.30000000000000004.
  for (double i = 0, last = count - 1; i < count; ++i)
    values.emplace_back(number_of(fmt::format("{:.12g}", (from * (last - i) + to * i) / last), what));
  return true;
}

/// "mu=0.2,0.4,0.6", "copy=1..8", "zeta=0.1..0.5:5", "base=rocking,bonded", "pga=0.4g,0.6g".
StudyParameter parameter_of(const std::string& text) {
  StudyParameter p{text.substr(0, text.find('=')), "", {}};
  const std::string list = text.substr(p.name.size() + 1);
  if (read_range(list, p.values)) return p;
  const std::vector<std::string> parts = comma_list(list);
  std::vector<double> numbers(parts.size());
  std::vector<std::string> units(parts.size());
  bool all = true;
  for (std::size_t i = 0; i < parts.size(); ++i)
    all = all && read_number(parts[i], numbers[i], units[i]) && units[i] == units[0];
  if (all) p.unit = units[0];
  for (std::size_t i = 0; i < parts.size(); ++i)
    p.values.push_back(all ? StudyValue(numbers[i]) : StudyValue(parts[i]));
  return p;
}

StudyOrder order_of(const StudyOptions& o) {
  std::vector<StudyParameter> parameters;
  for (const std::string& text : o.over) parameters.push_back(parameter_of(text));
  script::CasesOfScript cases;
  cases.program = program_path();
  cases.script = o.script;
  cases.fixed = o.given;
  cases.checkpoint = o.choice.checkpoint;
  cases.trust = o.room.trust;
  cases.memory = std::max(o.room.memory, 0.0), cases.seconds = std::max(o.room.seconds, 0.0);
  StudyOrder order = script::study_order(product_plan(parameters), cases);
  order.file = o.out.empty() ? std::filesystem::path(o.script).stem().string() + "_study.h5" : o.out;
  script::take_choice(o.choice, order);
  order.provenance.command_line = "trilith study " + o.script;
  for (const std::string& g : o.given) order.provenance.command_line += " " + g;
  for (const std::string& v : o.over) order.provenance.command_line += " --over " + v;
  return order;
}

/// Command of this study for a task, to which its cases are appended.
std::vector<std::string> own_command(const StudyOptions& o) {
  std::vector<std::string> words{program_path(), "study", o.script};
  for (const std::string& w : o.room.words()) words.push_back(w);
  if (o.choice.checkpoint >= 0) words.push_back(fmt::format("--checkpoint={:.17g}", o.choice.checkpoint));
  words.insert(words.end(), o.given.begin(), o.given.end());
  for (const std::string& v : o.over) words.insert(words.end(), {"--over", v});
  if (!o.out.empty()) words.insert(words.end(), {"--output", o.out});
  if (!o.ida.empty()) words.insert(words.end(), {"--ida", o.ida, "--stop", o.stop});
  return words;
}

/// The script runs a case; the varied parameters are on the command line.
int run_over(const StudyOptions& o) {
  const StudyOrder order = order_of(o);
  if (o.choice.list) {
    script::list_cases(order);
    return ended_well;
  }
  Live live(stdout, EventLines(), o.quiet);
  const InterruptScope scope(nullptr, nullptr);
  StudyWatch watch;
  watch.line = [&live](const std::string& text, bool strong) { live.line(text, strong); };
  watch.status = [&live](const std::string& text) { live.status(text); };
  watch.goes_on = [] { return signal_code() == 0; };
  const std::vector<StudyOutcome> outcomes = run_study(order, watch);
  live.clear();
  if (signal_code() != 0) return signal_code();
  return any_failed(outcomes) ? wrong_input : ended_well;
}

/// The script describes the study.
int run_own(const StudyOptions& o) {
  if (!o.out.empty()) throw InputError("study: --output needs --over; the script's own study names its file");
  Live live(stdout, EventLines(), o.quiet);
  script::Host host;
  host.script = o.script;
  host.given = host.arguments = o.given;
  host.records = script::record_folders();
  host.observer = &live;
  host.study = o.choice;
  host.study.program = program_path();
  host.command_line = "trilith study " + o.script;
  for (const std::string& g : o.given) host.command_line += " " + g;
  set_room(host, o.room);
  const int code = run_script(host);
  live.clear();
  if (code == ended_well && !host.study.begun)
    throw InputError(
        fmt::format("{} has no study (trilith.study); give a parameter to vary, as in --over mu=0.2,0.4", o.script));
  return code == ended_well && host.study.failed ? wrong_input : code;
}

}  // namespace

void add_study(CLI::App& app, int& code) {
  auto o = std::make_shared<StudyOptions>();
  CLI::App* verb = app.add_subcommand(
      "study", "Run many cases of a script, each in its own process; the exit code is 1 if one has failed");
  verb->add_option("script", o->script, "a script with trilith.study, or with --over a script that runs a case")
      ->required()
      ->type_name("SCRIPT");
  verb->add_option("parameters", o->given, "parameters that are the same in all cases")
      ->type_name("NAME=VALUE")
      ->check(CLI::Validator(is_assignment, "", ""));
  verb->add_option("--over", o->over,
                   "a parameter and its values, as in mu=0.2,0.4 or copy=1..8 or zeta=0.1..0.5:5 (how many); if "
                   "repeated, all combinations are run")
      ->type_name("NAME=VALUES")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->check(CLI::Validator(is_assignment, "", ""));
  verb->add_option("-o,--output", o->out, "the table, with --over; default SCRIPT_study.h5")->type_name("FILE");
  verb->add_option("-j,--jobs", o->choice.jobs, "cases at a time; default the number of processors")
      ->type_name("N")
      ->check(CLI::Validator(is_count, "", ""));
  verb->add_option("--on", o->on,
                   "where the cases run: local (processes here), or slurm (an array job, followed until it has ended; "
                   "after an interruption, the same command follows the job or runs the missing cases)")
      ->type_name("WHERE")
      ->check(CLI::IsMember({"local", "slurm"}));
  verb->add_option("--per-task", o->choice.per_task,
                   "with --on slurm: cases of a task; default as many as take some minutes")
      ->type_name("N")
      ->check(CLI::Validator(is_count, "", ""));
  verb->add_option("--cases", o->cases, "run only these cases, and write no table: a task of a cluster")
      ->type_name("N[,N...]");
  verb->add_option("--ida", o->ida, "incremental analysis: from the lowest value of this parameter up, with --stop")
      ->type_name("PARAMETER");
  verb->add_option("--stop", o->stop, "with --ida: a flag of the cases; if it is true, higher values are passed over")
      ->type_name("FIGURE");
  add_room_options(*verb, o->room);
  add_checkpoint_option(*verb, o->choice.checkpoint, "of each case; as for trilith run where not given");
  verb->add_flag("--fresh", o->choice.fresh, "run finished cases again too");
  verb->add_flag("--list", o->choice.list, "print the command of each case and exit");
  verb->add_flag("--quiet,-q", o->quiet, "show only errors");
  verb->callback([o, &code] {
    if (o->ida.empty() != o->stop.empty()) throw InputError("study: --ida needs --stop, and --stop needs --ida");
    if (!o->ida.empty()) o->choice.rise = StudyRise{o->ida, o->stop};
    for (const std::string& number : o->cases.empty() ? std::vector<std::string>() : comma_list(o->cases))
      o->choice.some.push_back(static_cast<int>(number_of(number, "--cases")));
    if (o->choice.per_task > 0 && o->on != "slurm") throw InputError("study: --per-task needs --on slurm");
    if (o->on == "slurm") o->choice.on_slurm = own_command(*o);
    code = o->over.empty() ? run_own(*o) : run_over(*o);
  });
}

}  // namespace trilith::program
