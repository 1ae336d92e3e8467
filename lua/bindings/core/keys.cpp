#include "bindings/core/keys.hpp"

#include <algorithm>
#include <cmath>

#include "base/terminal_text.hpp"
#include "bindings/core/unit_door.hpp"

namespace trilith::script {
namespace {

/// As a script would print it, except for the sign of NaN, which has no meaning.
std::string number_text(double value) {
  return std::isnan(value) ? "nan" : fmt::format("{}", value);
}

constexpr lua_Unsigned longest_shown = 6;  ///< numbers of a list that messages print

/// "{1, nan, 1}" for a short list of numbers and similar, "a table" for others.
std::string table_text(lua_State* L, int index) {
  const lua_Unsigned length = lua_rawlen(L, index);
  if (length == 0 || length > longest_shown) return "a table";
  const int table = lua_absindex(L, index);
  std::string text;
  for (lua_Unsigned i = 1; i <= length; ++i) {
    const int type = lua_rawgeti(L, table, static_cast<lua_Integer>(i));
    const bool plain = type == LUA_TNUMBER || type == LUA_TNIL || type == LUA_TBOOLEAN;
    if (plain) text += fmt::format("{}{}", text.empty() ? "{" : ", ", what_is(L, -1));
    lua_pop(L, 1);
    if (!plain) return "a table";
  }
  std::vector<std::string> names;  // sorted, because a Lua table has no order
  for (lua_pushnil(L); lua_next(L, table) != 0; lua_pop(L, 1))
    if (lua_type(L, -2) == LUA_TSTRING) names.push_back(one_line(text_at(L, -2)));
  std::sort(names.begin(), names.end());
  for (const std::string& name : names) text += fmt::format(", {} = ...", name);
  return text + "}";
}

}  // namespace

std::string what_is(lua_State* L, int index) {
  switch (lua_type(L, index)) {
    case LUA_TNUMBER:
      return number_text(lua_tonumber(L, index));
    case LUA_TSTRING:
      return fmt::format("the text '{}'", text_at(L, index));
    case LUA_TBOOLEAN:
      return lua_toboolean(L, index) != 0 ? "true" : "false";
    case LUA_TNIL:
    case LUA_TNONE:
      return "nil";
    case LUA_TTABLE:
      return table_text(L, index);
    case LUA_TUSERDATA: {
      if (luaL_getmetafield(L, index, "__metatable") == LUA_TSTRING) {
        const std::string kind = fmt::format("a {}", lua_tostring(L, -1));
        lua_pop(L, 1);
        return kind;
      }
      return "a userdata";
    }
    default:
      return fmt::format("a {}", luaL_typename(L, index));
  }
}

namespace {

/// A list at `index` with as many finite numbers as V has.
template <class V>
std::optional<V> numbers_at(lua_State* L, int index) {
  V p = V::Zero();
  if (lua_type(L, index) != LUA_TTABLE || lua_rawlen(L, index) != static_cast<lua_Unsigned>(p.size())) return {};
  const int table = lua_absindex(L, index);
  bool good = true;
  for (int i = 0; i < p.size(); ++i) {
    good = lua_rawgeti(L, table, i + 1) == LUA_TNUMBER && good;
    if (good) p[i] = lua_tonumber(L, -1);
    lua_pop(L, 1);
  }
  // A named key is not part of a list: it was probably meant for the surrounding table.
  for (lua_pushnil(L); lua_next(L, table) != 0; lua_pop(L, 1)) good = good && lua_isinteger(L, -2) != 0;
  if (!good || !p.allFinite()) return {};
  count_quantity();
  return p;
}

}  // namespace

std::optional<Vec2> point_at(lua_State* L, int index) {
  return numbers_at<Vec2>(L, index);
}
std::optional<Vec3> vector_at(lua_State* L, int index) {
  return numbers_at<Vec3>(L, index);
}

std::optional<int> count_at(lua_State* L, int index) {
  constexpr lua_Integer most = 1000000000;
  int whole = 0;
  const lua_Integer value = lua_type(L, index) == LUA_TNUMBER ? lua_tointegerx(L, index, &whole) : 0;
  if (whole == 0 || value < -most || value > most) return {};
  return static_cast<int>(value);
}

Keys::Keys(lua_State* L, int index, std::string owner)
    : L_(L), index_(lua_absindex(L, index)), owner_(std::move(owner)) {
  if (lua_type(L, index) != LUA_TTABLE)
    throw InputError(
        fmt::format("{}: takes one table, as in {}{{ ... }}; this is {}", owner_, owner_, what_is(L, index)));
  lua_checkstack(L, 20);
}

void Keys::name_owner(const std::string& name) {
  // A name that is too long is rejected with a separate message.
  if (!name.empty() && name.size() <= longest_name) owner_ = fmt::format("{} '{}'", owner_, one_line(name));
}

void Keys::problem(const std::string& what) {
  if (problem_.empty()) problem_ = what;
}

void Keys::missing(std::string_view key, std::string_view wanted) {
  problem(fmt::format("'{}' is missing; give {}", key, wanted));
}

void Keys::wrong(std::string_view key, std::string_view wanted) {
  problem(fmt::format("'{}' is {}, must be {}", key, what_is(L_, -1), wanted));
}

void Keys::know(std::initializer_list<std::string_view> keys) {
  for (const std::string_view key : keys)
    if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.emplace_back(key);
}

int Keys::push(std::string_view key) {
  know({key});
  lua_pushlstring(L_, key.data(), key.size());
  return lua_rawget(L_, index_);
}

bool Keys::has(std::string_view key) {
  const bool is = push(key) != LUA_TNIL;
  lua_pop(L_, 1);
  return is;
}

void Keys::refuse(std::string_view key, const std::string& why) {
  lua_pushlstring(L_, key.data(), key.size());
  const bool is = lua_rawget(L_, index_) != LUA_TNIL;
  lua_pop(L_, 1);
  if (!is) return;
  know({key});
  problem(why);
}

namespace {

/// Smaller magnitudes are errors: products and quotients of such numbers underflow or overflow.
constexpr double least_number = 1e-300;

}  // namespace

double Keys::read_number(std::string_view key, std::string_view unit) {
  double value = 0;
  if (unit != "1") count_quantity();
  if (lua_type(L_, -1) == LUA_TNUMBER) {
    value = lua_tonumber(L_, -1);
    if (value != 0 && std::abs(value) < least_number)
      problem(
          fmt::format("'{}' is {}, too small for any quantity; give a size of at least {:g}{}, or 0 where it may be 0",
                      key, number_text(value), least_number, unit == "1" ? "" : fmt::format(" {}", unit)));
    if (!std::isfinite(value))
      problem(fmt::format("'{}' is {}, must be a finite number{}", key, number_text(value),
                          unit == "1" ? "" : fmt::format(" in {}", unit)));
  } else {
    wrong(key, unit == "1" ? "a number" : fmt::format("a number in {}", unit));
  }
  lua_pop(L_, 1);
  return value;
}

std::optional<double> Keys::maybe_number(std::string_view key, std::string_view unit) {
  if (push(key) != LUA_TNIL) return read_number(key, unit);
  lua_pop(L_, 1);
  return {};
}

double Keys::number(std::string_view key, std::string_view unit) {
  if (const auto value = maybe_number(key, unit)) return *value;
  missing(key, unit == "1" ? "a number" : fmt::format("a number in {}", unit));
  return 0;
}

double Keys::number(std::string_view key, std::string_view unit, double preset) {
  return maybe_number(key, unit).value_or(preset);
}

int Keys::count(std::string_view key, int preset) {
  if (push(key) == LUA_TNIL) {
    lua_pop(L_, 1);
    return preset;
  }
  const std::optional<int> value = count_at(L_, -1);
  const double given = lua_type(L_, -1) == LUA_TNUMBER ? lua_tonumber(L_, -1) : 0.5;
  if (!value) wrong(key, std::floor(given) == given ? "within -1e9 and 1e9" : "a whole number");
  lua_pop(L_, 1);
  return value.value_or(preset);
}

bool Keys::flag(std::string_view key, bool preset) {
  const int type = push(key);
  if (type != LUA_TNIL && type != LUA_TBOOLEAN) wrong(key, "true or false");
  const bool value = type == LUA_TNIL ? preset : lua_toboolean(L_, -1) != 0;
  lua_pop(L_, 1);
  return value;
}

std::string Keys::printable(std::string_view key) {
  std::string text = text_at(L_, -1);
  try {
    const bool names = key == "name" || key == "group";
    require_printable(text, fmt::format("'{}'", key), names ? longest_name : longest_text);
  } catch (const InputError& e) {
    problem(e.what());
  }
  return text;
}

std::string Keys::text(std::string_view key) {
  if (!has(key)) missing(key, "a text");
  return text(key, "");
}

std::string Keys::text(std::string_view key, const std::string& preset) {
  const int type = push(key);
  if (type != LUA_TNIL && type != LUA_TSTRING) wrong(key, "a text");
  const std::string value = type == LUA_TSTRING ? printable(key) : preset;
  lua_pop(L_, 1);
  return value;
}

std::optional<Vec2> Keys::maybe_point(std::string_view key) {
  std::optional<Vec2> p;
  if (push(key) != LUA_TNIL) {
    p = point_at(L_, -1);
    if (!p) wrong(key, "{x, y}, two finite numbers");
  }
  lua_pop(L_, 1);
  return p;
}

Vec2 Keys::point(std::string_view key) {
  if (!has(key)) missing(key, "{x, y}");
  return point(key, Vec2::Zero());
}

Vec2 Keys::point(std::string_view key, const Vec2& preset) {
  return maybe_point(key).value_or(preset);
}

std::vector<Vec2> Keys::points(std::string_view key) {
  std::vector<Vec2> list;
  const int type = push(key);
  if (type == LUA_TNIL) missing(key, "a list of points {{x, y}, ...}");
  if (type != LUA_TNIL && type != LUA_TTABLE) wrong(key, "a list of points {{x, y}, ...}");
  if (type == LUA_TTABLE) {
    const auto count = static_cast<lua_Integer>(lua_rawlen(L_, -1));
    for (lua_Integer i = 1; i <= count; ++i) {
      lua_rawgeti(L_, -1, i);
      const auto p = point_at(L_, -1);
      if (!p)
        problem(fmt::format("point {} of '{}' is {}, must be {{x, y}}, two finite numbers", i, key, what_is(L_, -1)));
      list.push_back(p.value_or(Vec2::Zero()));
      lua_pop(L_, 1);
    }
  }
  lua_pop(L_, 1);
  return list;
}

Vec3 Keys::vector(std::string_view key) {
  if (!has(key)) missing(key, "{x, y, z}");
  return vector(key, Vec3::Zero());
}

Vec3 Keys::vector(std::string_view key, const Vec3& preset) {
  std::optional<Vec3> v;
  if (push(key) != LUA_TNIL) {
    v = vector_at(L_, -1);
    if (!v) wrong(key, "{x, y, z}, three finite numbers");
  }
  lua_pop(L_, 1);
  return v.value_or(preset);
}

std::vector<Vec3> Keys::vectors(std::string_view key) {
  std::vector<Vec3> list;
  const int type = push(key);
  if (type == LUA_TNIL) missing(key, "a list { {x, y, z}, ... }");
  if (type != LUA_TNIL && type != LUA_TTABLE) wrong(key, "a list { {x, y, z}, ... }");
  const auto count = type == LUA_TTABLE ? static_cast<lua_Integer>(lua_rawlen(L_, -1)) : 0;
  for (lua_Integer i = 1; i <= count; ++i) {
    lua_rawgeti(L_, -1, i);
    const auto v = vector_at(L_, -1);
    if (!v)
      problem(
          fmt::format("point {} of '{}' is {}, must be {{x, y, z}}, three finite numbers", i, key, what_is(L_, -1)));
    list.push_back(v.value_or(Vec3::Zero()));
    lua_pop(L_, 1);
  }
  lua_pop(L_, 1);
  return list;
}

std::vector<std::string> Keys::names(std::string_view key) {
  std::vector<std::string> list;
  const int type = push(key);
  if (type == LUA_TSTRING) list.push_back(printable(key));
  if (type != LUA_TNIL && type != LUA_TSTRING && type != LUA_TTABLE) wrong(key, "a name or a list of names");
  if (type == LUA_TTABLE) {
    const auto count = static_cast<lua_Integer>(lua_rawlen(L_, -1));
    for (lua_Integer i = 1; i <= count; ++i) {
      if (lua_rawgeti(L_, -1, i) != LUA_TSTRING)
        problem(fmt::format("name {} of '{}' is {}, must be a text", i, key, what_is(L_, -1)));
      else
        list.push_back(printable(key));
      lua_pop(L_, 1);
    }
  }
  lua_pop(L_, 1);
  return list;
}

std::size_t Keys::choice(std::string_view key, const std::vector<std::string>& choices, std::size_t preset) {
  if (!has(key)) return preset;
  const std::string given = text(key, "");
  const auto it = std::find(choices.begin(), choices.end(), given);
  if (it == choices.end())
    problem(fmt::format("'{}' is '{}', must be one of {}", key, given, fmt::join(choices, ", ")));
  return it == choices.end() ? preset : static_cast<std::size_t>(it - choices.begin());
}

void Keys::report_unknown() const {
  std::string first;  // sorted by name, so that the message does not depend on the order of a hash
  bool any = false;
  for (lua_pushnil(L_); lua_next(L_, index_) != 0; lua_pop(L_, 1)) {
    if (lua_type(L_, -2) != LUA_TSTRING) {
      if (list_allowed_ && lua_isinteger(L_, -2) != 0) continue;
      const std::string what = what_is(L_, -1);
      lua_pop(L_, 2);
      throw InputError(fmt::format("{}: {} is given without a key; write key = value", owner_, what));
    }
    const std::string key = text_at(L_, -2);
    if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
    if (!any || key < first) first = key;
    any = true;
  }
  if (any) throw InputError(fmt::format("{}: unknown key '{}'{}", owner_, first, name_hint(first, known_)));
}

void Keys::finish() {
  report_unknown();
  if (!problem_.empty()) throw InputError(fmt::format("{}: {}", owner_, problem_));
}

}  // namespace trilith::script
