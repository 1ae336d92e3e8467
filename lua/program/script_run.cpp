#include "script_run.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "figures_reading.hpp"
#include "guard.hpp"
#include "interrupt.hpp"
#include "parameter_list.hpp"
#include "record/picture_file.hpp"
#include "script_state.hpp"
#include "verbs.hpp"

namespace trilith::program {
namespace {

int report_error(script::Host& host, const std::string& message) {
  const bool stopped = interrupts() > 0;
  if (host.observer != nullptr) host.observer->clear();
  host.finish(stopped ? "interrupted" : message);
  fmt::print(stderr, "{}\n", message);
  return stopped ? interrupted : wrong_input;
}

/// Keeps what the script came to in the folder of its case.
void write_figures(const script::Host& host) {
  if (!host.case_folder.empty()) write_whole_file(host.case_folder / figures_file, figures_text(host.figures));
}

/// (host, what the script gave)
int take_figures(lua_State* L) {
  static_cast<script::Host*>(lua_touserdata(L, 1))->figures = script::figures_at(L, 2);
  return 0;
}

}  // namespace

int run_script(script::Host& host) {
  if (!read_script(host)) {
    fmt::print(stderr, "trilith: cannot read script '{}'\n", host.script);
    return wrong_input;
  }
  const ScriptState state = new_script_state(host);
  lua_State* L = state.get();
  const InterruptScope scope(L, raise_interrupt);
  if (load_script(L, host) != LUA_OK) return report_error(host, message_at_top(L));
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
  if (!good) return report_error(host, message_at_top(L));
  if (host.study.only > 0 && !host.study.begun)
    return report_error(host, fmt::format("{} has no study, so no case {}", host.script, host.study.only));
  if (!host.given_used && !host.given.empty())
    return report_error(host, fmt::format("{} declares no parameters, so '{}' has no place; see trilith.params",
                                          host.script, host.given.front()));
  host.finish("");
  if (interrupts() > 0) return interrupted;
  write_figures(host);
  return ended_well;
}

std::string program_path() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error).string();
}

}  // namespace trilith::program
