// State of Lua's random numbers (math.random), which a resumed run restores.
#pragma once

#include <array>
#include <cstdint>
#include <string>

struct lua_State;

namespace trilith::script {

/// The four words of Lua's generator; `known` is false where this Lua has another one.
struct RandomState {
  std::array<std::uint64_t, 4> words{};
  bool known = false;
};

/// Finds the generator of math.random; called before a script can replace that function.
void find_random_state(lua_State* L);
RandomState random_state(lua_State* L);
void set_random_state(lua_State* L, const RandomState& state);

template <class File>
void each_field(File& file, RandomState& s) {
  file.item(s.known);
  for (std::uint64_t& word : s.words) file.item(word);
}

/// The state of a script for a resumed run: its random numbers, and the bytes of the tables of m:keep.
std::string packed(const RandomState& random, const std::string& tables);
/// Sets the random numbers, and returns the bytes of the tables.
std::string unpacked(lua_State* L, const std::string& kept);

}  // namespace trilith::script
