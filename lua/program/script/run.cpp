#include "program/script/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "base/terminal_text.hpp"
#include "base/whole_file.hpp"
#include "bindings/core/bindings.hpp"
#include "bindings/core/guard.hpp"
#include "bindings/core/no_solution_error.hpp"
#include "bindings/core/parameter_list.hpp"
#include "bindings/model/script_model.hpp"
#include "bindings/readings/figures_reading.hpp"
#include "interrupt.hpp"
#include "program/script/state.hpp"
#include "verbs.hpp"

namespace trilith::program {
namespace {

/// The verdict without the reason that the error already gave.
std::string shortened(const std::string& line, const std::string& error) {
  constexpr std::string_view no_rest = "did not come to rest";
  const std::size_t at = line.find(no_rest);
  const bool repeats = at != std::string::npos && error.find(no_rest) != std::string::npos;
  return repeats ? line.substr(0, at + no_rest.size()) : line;
}

/// Reports runs that are not reliable; true if there are any. `error`: the message printed before.
bool report_untrusted_runs(const script::Host& host, const std::string& error = "") {
  const std::vector<std::string> untrusted_runs = host.untrusted_runs();
  if (host.observer != nullptr) host.observer->clear();
  for (const std::string& line : untrusted_runs) fmt::print(stderr, "{}\n", shortened(line, error));
  return !untrusted_runs.empty();
}

int report_error(script::Host& host, const std::string& message) {
  if (signal_code() != 0) return close_by_signal(host);
  if (host.observer != nullptr) host.observer->clear();
  host.finish(message);
  fmt::print(stderr, "{}\n", terminal_text(message));
  return report_untrusted_runs(host, message) ? not_trusted : wrong_input;
}

/// The verdict where no run of the script has one of its own.
constexpr const char* no_solution_verdict =
    "not reliable: the script ended because its model has no solution; the line above gives the reason";

/// Exit code of a script that an error has ended, maybe a search without a solution.
int report_failure(lua_State* L, script::Host& host) {
  const std::string message = message_at_top(L);
  const int code = report_error(host, message);
  if (code != wrong_input || !script::is_no_solution(L, message)) return code;
  fmt::print(stderr, "{}\n", no_solution_verdict);
  return not_trusted;
}

/// A hook. No script can catch the end of the program; an interrupt is an error, and so is a signal within a stage,
/// which must end first.
void on_signal(lua_State* L, lua_Debug* at) {
  script::Host& host = script::host(L);
  // A handler may finish, so that the checkpoint contains a whole step; one that hangs is interrupted.
  constexpr double patience = 2;  // [s]
  const auto finishes = [](const auto& model) { return model->finishes_step(); };
  if (since_interrupt() < patience && std::ranges::any_of(host.recorded, finishes))
    return wait_with_interrupt(L, 10000);
  if (ending_signal() != 0 && host.running == 0) end_by_signal(host);
  raise_interrupt(L, at);
}

/// Stores the script's figures in the folder of its case.
void write_figures(const script::Host& host) {
  if (!host.case_folder.empty()) write_whole_file(host.case_folder / figures_file, figures_text(host.figures));
}

/// Arguments: host, result of the script.
int take_figures(lua_State* L) {
  static_cast<script::Host*>(lua_touserdata(L, 1))->figures = script::figures_at(L, 2);
  return 0;
}

}  // namespace

int run_script(script::Host& host) {
  read_script(host);
  host.restart.call.text = host.script_text;
  const ScriptState state = new_script_state(host);
  lua_State* L = state.get();
  const InterruptScope scope(L, on_signal);
  host.interrupted = is_interrupted;
  if (load_script(L, host) != LUA_OK) return report_failure(L, host);
  bool good = lua_pcall(L, 0, 1, 1) == LUA_OK;
  if (host.list_parameters) {
    const std::string message = good ? "" : message_at_top(L);
    if (!good && message.find(script::parameters_listed) == std::string::npos) return report_error(host, message);
    fmt::print("{}", script::parameter_lines(host, host.script));
    return ended_well;
  }
  if (good && !host.case_folder.empty()) {
    lua_pushcfunction(L, script::guarded<take_figures>);
    lua_insert(L, -2);
    lua_pushlightuserdata(L, &host);
    lua_insert(L, -2);
    good = lua_pcall(L, 2, 0, 1) == LUA_OK;
  }
  if (!good && (host.study.only > 0 || host.study.list))
    good = message_at_top(L).find(script::script_is_done) != std::string::npos;
  if (!good) return report_failure(L, host);
  if (host.study.only > 0 && !host.study.begun)
    return report_error(host, fmt::format("{} has no study, so there is no case {}", host.script, host.study.only));
  if (!host.given_used && !host.given.empty())
    return report_error(host, fmt::format("{} declares no parameters, so '{}' cannot be set; see trilith.params",
                                          host.script, host.given.front()));
  if (signal_code() != 0) return close_by_signal(host);
  host.finish("");
  write_figures(host);
  return report_untrusted_runs(host) ? not_trusted : ended_well;
}

int close_by_signal(script::Host& host) {
  if (host.observer != nullptr) host.observer->clear();
  const std::vector<std::string> kept = host.close(signal_text());
  fmt::print(stderr, "{}\n", signal_text());
  for (const std::string& line : kept) fmt::print(stderr, "{}\n", line);
  return signal_code();
}

void end_by_signal(script::Host& host) {
  std::exit(close_by_signal(host));
}

std::string program_path() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error).string();
}

}  // namespace trilith::program
