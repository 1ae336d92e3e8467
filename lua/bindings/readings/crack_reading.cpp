#include "bindings/readings/crack_reading.hpp"

#include <optional>
#include <string>

#include "bindings/geometry/part_reading.hpp"

namespace trilith::script {
namespace {

/// The values that `cracks` may have, and the form of one plane.
template <int D>
constexpr const char* wanted_cracks =
    D == 2 ? "\"mid\", \"quarter\", \"diagonals\", a number of planes, a list { { point = "
             "{x, y}, normal = {x, y} }, ... } or false"
           : "\"mid\", \"quarter\", a number of planes, a list { { point = {x, y, z}, "
             "normal = {x, y, z} }, ... } or false";
template <int D>
constexpr const char* wanted_plane =
    D == 2 ? "must be { point = {x, y}, normal = {x, y} }" : "must be { point = {x, y, z}, normal = {x, y, z} }";

template <int D>
Vec<D> plane_vector(Keys& keys, const char* key) {
  if constexpr (D == 2)
    return keys.point(key);
  else
    return keys.vector(key);
}

template <int D>
std::optional<Vec<D>> numbers_at(lua_State* L) {
  if constexpr (D == 2)
    return point_at(L, -1);
  else
    return vector_at(L, -1);
}

/// { point = , normal = } or { {...}, {...} } on top of the stack.
template <int D>
CrackPlane<D> plane_at(Keys& keys, lua_Integer number) {
  lua_State* L = keys.lua();
  Keys own(L, -1, fmt::format("plane {}", number));
  CrackPlane<D> plane;
  if (lua_rawlen(L, -1) == 0) {
    plane.point = plane_vector<D>(own, "point"), plane.normal = plane_vector<D>(own, "normal");
  } else {
    own.allow_list();
    for (const int i : {1, 2}) {
      lua_rawgeti(L, -1, i);
      const auto given = numbers_at<D>(L);
      if (!given) own.problem(wanted_plane<D>);
      (i == 1 ? plane.point : plane.normal) = given.value_or(Vec<D>::UnitX());
      lua_pop(L, 1);
    }
  }
  own.finish();
  return plane;
}

/// The list of planes on top of the stack.
template <int D>
void read_planes(Keys& keys, CrackSpec<D>& cracks) {
  lua_State* L = keys.lua();
  const auto count = static_cast<lua_Integer>(lua_rawlen(L, -1));
  if (count == 0) keys.wrong("cracks", wanted_cracks<D>);
  for (lua_Integer i = 1; i <= count; ++i) {
    lua_rawgeti(L, -1, i);
    try {
      cracks.planes.push_back(plane_at<D>(keys, i));
    } catch (const InputError& e) {
      keys.problem(fmt::format("cracks: {}", e.what()));
    }
    lua_pop(L, 1);
  }
}

/// Planes by name or by number.
template <int D>
void read_pattern(Keys& keys, CrackSpec<D>& cracks) {
  lua_State* L = keys.lua();
  const std::string name = lua_type(L, -1) == LUA_TSTRING ? text_at(L, -1) : "";
  const int count = name == "mid" ? 1 : name == "quarter" ? 3 : name.empty() ? count_at(L, -1).value_or(0) : 0;
  const bool diagonals = D == 2 && name == "diagonals";
  cracks.pattern = diagonals ? CrackPattern::diagonals : CrackPattern::equal;
  cracks.count = count;
  if (diagonals) return;
  if (!name.empty() && count == 0) keys.problem(fmt::format("'cracks' is '{}', must be {}", name, wanted_cracks<D>));
  if (name.empty() && (count < 1 || count > 100))
    keys.problem(fmt::format("'cracks' is {}, must be 1 to 100 planes, or {}", what_is(L, -1), wanted_cracks<D>));
}

template <int D>
void read_all(Keys& keys, CrackSpec<D>& cracks) {
  lua_State* L = keys.lua();
  const int type = keys.push("cracks");
  const std::string law = cracks.law;
  if (type != LUA_TNIL) cracks = {};
  if (type == LUA_TTABLE)
    read_planes(keys, cracks);
  else if (type == LUA_TSTRING || type == LUA_TNUMBER)
    read_pattern(keys, cracks);
  else if (type != LUA_TNIL && (type != LUA_TBOOLEAN || lua_toboolean(L, -1) != 0))
    keys.wrong("cracks", wanted_cracks<D>);
  lua_pop(L, 1);
  cracks.law = keys.text("crack_law", law);
  if (keys.has("crack_law") && cracks.empty() && type == LUA_TNIL)
    keys.problem("'crack_law' is given without 'cracks', the planes that it acts on; give both");
}

}  // namespace

void read_cracks(Keys& keys, CrackSpec<2>& cracks) {
  read_all(keys, cracks);
}
void read_cracks(Keys& keys, CrackSpec<3>& cracks) {
  read_all(keys, cracks);
}

}  // namespace trilith::script
