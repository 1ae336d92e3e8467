#include "bindings/restart/random_state.hpp"

#include <cstring>
#include <lua.hpp>

#include "base/bytes.hpp"

namespace trilith::script {
namespace {

const char random_key = 0;

/// The generator, or nothing. Lua keeps it as the only upvalue of math.random.
void* generator(lua_State* L) {
  lua_rawgetp(L, LUA_REGISTRYINDEX, &random_key);
  void* const found = lua_rawlen(L, -1) == sizeof(RandomState::words) ? lua_touserdata(L, -1) : nullptr;
  lua_pop(L, 1);
  return found;
}

}  // namespace

void find_random_state(lua_State* L) {
  lua_getglobal(L, "math");
  lua_getfield(L, -1, "random");
  if (lua_iscfunction(L, -1) != 0 && lua_getupvalue(L, -1, 1) != nullptr)
    lua_rawsetp(L, LUA_REGISTRYINDEX, &random_key);
  lua_pop(L, 2);
}

RandomState random_state(lua_State* L) {
  RandomState state;
  if (const void* const found = generator(L)) {
    std::memcpy(state.words.data(), found, sizeof state.words);
    state.known = true;
  }
  return state;
}

void set_random_state(lua_State* L, const RandomState& state) {
  if (void* const found = generator(L); found != nullptr && state.known)
    std::memcpy(found, state.words.data(), sizeof state.words);
}

std::string packed(const RandomState& random, const std::string& tables) {
  ByteWriter out;
  out.item(random), out.item(tables);
  return out.take();
}

std::string unpacked(lua_State* L, const std::string& kept) {
  ByteReader in(kept, "state of the script");
  const auto random = in.get<RandomState>();
  std::string tables = in.get<std::string>();
  in.done();
  set_random_state(L, random);
  return tables;
}

}  // namespace trilith::script
