// trilith [console] [SCRIPT] [NAME=VALUE ...]; trilith -i SCRIPT
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "base/bytes.hpp"
#include "base/terminal_text.hpp"
#include "bindings/core/guard.hpp"
#include "bindings/core/no_solution_error.hpp"
#include "console/console_session.hpp"
#include "program/assignment.hpp"
#include "program/interrupt.hpp"
#include "program/live.hpp"
#include "program/script/room_options.hpp"
#include "program/script/run.hpp"
#include "program/script/run_options.hpp"
#include "program/script/state.hpp"
#include "program/verbs.hpp"

namespace trilith::program {
namespace {

struct Options {
  std::string script, from;
  std::vector<std::string> given;
  bool quiet = false;
  RoomOptions room;
};

/// Options of the session that saved an instant: its script and parameters.
Options options_of(const Options& asked, const script::RestartFiles& instant) {
  const std::string bytes = instant.get("call");
  ByteReader in(bytes, "saved instant '" + asked.from + "'");
  const auto call = in.get<script::RestartCall>();
  if (!asked.script.empty()) throw InputError("console: --from determines the script; leave the script out");
  require_same(call);
  std::error_code error;
  std::filesystem::current_path(call.folder, error);
  if (error) throw InputError(fmt::format("console: folder '{}' of the script: {}", call.folder, error.message()));
  Options options = asked;
  options.script = call.script, options.given = call.given;
  ByteReader room(call.room, in.owner());
  room.item(options.room);
  return options;
}

/// Checkpoints of all stages stay in memory, so that instants can be saved.
script::RestartChoice restart_of(const Options& options, const script::Host& host) {
  script::RestartChoice restart;
  restart.in_memory = true;
  script::RestartCall& call = restart.call;
  std::error_code error;
  call.build = script::this_build();
  call.folder = std::filesystem::current_path(error).string();
  call.script = options.script, call.text = host.script_text, call.given = options.given;
  ByteWriter room;
  room.item(options.room);
  call.room = room.take();
  return restart;
}

/// Runs the script before the console; errors are printed, and the console opens in any case.
void run_before(lua_State* L, script::Host& host, ConsoleSession& session) {
  ConsoleSession::push_handler(L);
  bool good = load_script(L, host, ConsoleSession::prelude(L)) == LUA_OK;
  good = good && lua_pcall(L, 0, 0, -2) == LUA_OK;
  if (host.observer != nullptr) host.observer->clear();
  if (!good) {
    session.failure = message_at_top(L);
    session.no_solution = script::is_no_solution(L, session.failure);
    fmt::print(stderr, "{}\n", terminal_text(session.failure));
  } else if (!host.given_used && !host.given.empty()) {
    fmt::print(stderr, "{} declares no parameters, so '{}' cannot be set; see trilith.params\n", host.script,
               host.given.front());
  }
  lua_settop(L, 1);
}

int run(const Options& asked) {
  std::shared_ptr<const script::RestartFiles> from;
  if (!asked.from.empty())
    from = std::make_shared<const script::RestartFiles>(script::RestartFiles::opened(asked.from));
  const Options options = from ? options_of(asked, *from) : asked;
  Live live(stdout, EventLines(EventShow::important, slow_impact), options.quiet);
  script::Host host;
  host.script = options.script;
  host.given = host.arguments = options.given;
  host.study.program = program_path();
  host.records = script::record_folders();
  host.observer = &live;
  host.command_line = options.script.empty() ? "trilith" : "trilith -i " + options.script;
  for (const std::string& g : options.given) host.command_line += " " + g;
  set_room(host, options.room);
  if (!host.script.empty()) read_script(host);
  host.restart = restart_of(options, host);
  host.restart.from = from, host.restart.resumes = from != nullptr;
  const ScriptState state = new_script_state(host);
  lua_State* L = state.get();
  ConsoleSession session(L, host);
  host.console = &session;
  const InterruptScope scope(L, ConsoleSession::on_interrupt, 3);
  host.interrupted = is_interrupted;
  if (session.editor.terminal()) fmt::print("Trilith {}. `help` prints an overview, Ctrl-D leaves.\n", TRILITH_VERSION);
  if (!host.script.empty()) run_before(L, host, session);
  host.restart.script_ended = true;
  const bool before = session.failure.empty() || session.no_solution, good = session.top(L) && before;
  if (ending_signal() != 0) return close_by_signal(host);
  host.finish(session.failure);
  live.clear();
  if (!session.editor.terminal() && interrupts() > 0) return interrupted;
  if (session.editor.terminal()) return ended_well;
  return !good ? wrong_input : session.no_solution ? not_trusted : ended_well;
}

}  // namespace

void add_console(CLI::App& app, int& code) {
  auto options = std::make_shared<Options>();
  CLI::App* verb =
      app.add_subcommand("console", "Open a console; the same as trilith without arguments, and trilith -i");
  verb->add_option("script", options->script, "run this script first, then open the console")->type_name("SCRIPT");
  verb->add_option("parameters", options->given, "parameters that the script declares, as in pga=0.6g")
      ->type_name("NAME=VALUE")
      ->check(CLI::Validator(is_assignment, "", ""));
  verb->add_flag("--quiet,-q", options->quiet, "show neither events nor status");
  verb->add_option("--from", options->from,
                   "open an instant that `save` of the console has written; the script runs again up to it")
      ->type_name("FILE");
  add_room_options(*verb, options->room);
  verb->callback([options, &code] { code = run(*options); });
}

}  // namespace trilith::program
