#include "script_run.hpp"

#include <fmt/format.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <sstream>

#include "figures_reading.hpp"
#include "guard.hpp"
#include "open.hpp"
#include "record/picture_file.hpp"
#include "verbs.hpp"

namespace trilith::program {
namespace {

lua_State* volatile running_state = nullptr;
volatile std::sig_atomic_t was_interrupted = 0;

void raise_interrupt(lua_State* L, lua_Debug*) {
  lua_sethook(L, nullptr, 0, 0);
  lua_pushliteral(L, "interrupted");
  script::mark_whole(L);
  lua_error(L);
}

/// Sets a flag and a hook (lua_sethook may be called from a signal); running stages see the hook and end at the next
/// step border. A second interrupt ends the program at once.
extern "C" void on_interrupt(int signal) {
  std::signal(signal, SIG_DFL);
  was_interrupted = 1;
  lua_sethook(running_state, raise_interrupt, LUA_MASKCALL | LUA_MASKRET | LUA_MASKLINE | LUA_MASKCOUNT, 1);
}

class InterruptScope {
 public:
  explicit InterruptScope(lua_State* L) {
    running_state = L;
    previous_ = std::signal(SIGINT, on_interrupt);
  }
  InterruptScope(const InterruptScope&) = delete;
  InterruptScope& operator=(const InterruptScope&) = delete;
  ~InterruptScope() {
    std::signal(SIGINT, previous_);
    running_state = nullptr;
  }

 private:
  void (*previous_)(int);
};

struct CloseState {
  void operator()(lua_State* L) const { lua_close(L); }
};

/// os.exit(code): as in Lua, but the results say how the run ended.
int exit_script(lua_State* L) {
  const bool good =
      lua_isnoneornil(L, 1) || (lua_isboolean(L, 1) ? lua_toboolean(L, 1) != 0 : lua_tointeger(L, 1) == 0);
  const int code = good ? ended_well : lua_isinteger(L, 1) != 0 ? static_cast<int>(lua_tointeger(L, 1)) : wrong_input;
  static_cast<script::Host*>(lua_touserdata(L, lua_upvalueindex(1)))->finish(good ? "" : "the script called os.exit");
  std::exit(code);
}

/// print(...), on lines of its own: the status goes first. Upvalues: the host, and Lua's print.
int print_apart(lua_State* L) {
  const auto& host = *static_cast<script::Host*>(lua_touserdata(L, lua_upvalueindex(1)));
  if (host.observer != nullptr) host.observer->clear();
  lua_pushvalue(L, lua_upvalueindex(2));
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, 0);
  return 0;
}

int set_up(lua_State* L) {
  auto& host = *static_cast<script::Host*>(lua_touserdata(L, 1));
  luaL_openlibs(L);
  lua_pushlightuserdata(L, &host);
  lua_getglobal(L, "print");
  lua_pushcclosure(L, print_apart, 2);
  lua_setglobal(L, "print");
  script::set_host(L, host);
  lua_getglobal(L, "os");
  lua_pushlightuserdata(L, &host);
  lua_pushcclosure(L, script::guarded<exit_script>, 1);
  lua_setfield(L, -2, "exit");
  script::open_trilith(L);
  script::load_library_file(L, "prepare");
  lua_insert(L, -2);
  lua_pushstring(L, host.folder().string().c_str());
  lua_call(L, 2, 0);
  return 0;
}

std::string message_at_top(lua_State* L) {
  const char* text = lua_tostring(L, -1);
  return text != nullptr ? text : "an error without a message";
}

int report_error(script::Host& host, const std::string& message) {
  const bool stopped = was_interrupted != 0;
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

void list_parameters(const script::Host& host) {
  for (const auto& p : host.parameters) fmt::print("{:<16} {:>10} {:<6} {}\n", p.name, p.value, p.unit, p.text);
  if (host.parameters.empty()) fmt::print("{} declares no parameters\n", host.script);
}

bool read_text(script::Host& host) {
  std::ifstream in(host.script, std::ios::binary);
  std::stringstream text;
  if (in) text << in.rdbuf();
  host.script_text = text.str();
  return static_cast<bool>(in) && !text.fail();
}

}  // namespace

int run_script(script::Host& host) {
  if (!read_text(host)) {
    fmt::print(stderr, "trilith: cannot read script '{}'\n", host.script);
    return wrong_input;
  }
  const std::unique_ptr<lua_State, CloseState> state(luaL_newstate());
  if (!state) {
    fmt::print(stderr, "trilith: not enough memory\n");
    return wrong_input;
  }
  lua_State* L = state.get();
  lua_pushcfunction(L, script::add_traceback);
  lua_pushcfunction(L, set_up);
  lua_pushlightuserdata(L, &host);
  if (lua_pcall(L, 1, 0, 1) != LUA_OK) return report_error(host, message_at_top(L));
  const InterruptScope scope(L);
  std::string text = host.script_text;
  if (text.starts_with("#")) text.insert(0, "--");  // a first line for the shell
  const std::string chunk = "@" + host.script;
  if (luaL_loadbufferx(L, text.data(), text.size(), chunk.c_str(), "t") != LUA_OK)
    return report_error(host, message_at_top(L));
  bool good = lua_pcall(L, 0, 1, 1) == LUA_OK;
  if (host.list_parameters) {
    const std::string message = good ? "" : message_at_top(L);
    if (!good && message.find(script::parameters_listed) == std::string::npos) return report_error(host, message);
    list_parameters(host);
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
  if (was_interrupted != 0) return interrupted;
  write_figures(host);
  return ended_well;
}

std::string program_path() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error).string();
}

}  // namespace trilith::program
