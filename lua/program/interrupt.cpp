#include "interrupt.hpp"

#include <csignal>

#include "guard.hpp"

namespace trilith::program {
namespace {

lua_State* volatile watched_state = nullptr;
lua_Hook volatile watched_hook = nullptr;
volatile std::sig_atomic_t count = 0, most = 1;

extern "C" void on_interrupt(int signal) {
  count = count + 1;
  if (count >= most) std::signal(signal, SIG_DFL);
  if (watched_state != nullptr)
    lua_sethook(watched_state, watched_hook, LUA_MASKCALL | LUA_MASKRET | LUA_MASKLINE | LUA_MASKCOUNT, 1);
}

}  // namespace

InterruptScope::InterruptScope(lua_State* L, lua_Hook hook, int patience) {
  count = 0;
  most = patience;
  watched_hook = hook;
  watched_state = L;
  previous_ = std::signal(SIGINT, on_interrupt);
}

InterruptScope::~InterruptScope() {
  std::signal(SIGINT, previous_);
  watched_state = nullptr;
}

int interrupts() {
  return count;
}

void forget_interrupts() {
  if (watched_state != nullptr && lua_gethook(watched_state) == watched_hook) lua_sethook(watched_state, nullptr, 0, 0);
  count = 0;
  if (watched_state != nullptr) std::signal(SIGINT, on_interrupt);
}

void raise_interrupt(lua_State* L, lua_Debug*) {
  lua_sethook(L, nullptr, 0, 0);
  lua_pushliteral(L, "interrupted");
  script::mark_whole(L);
  lua_error(L);
}

}  // namespace trilith::program
