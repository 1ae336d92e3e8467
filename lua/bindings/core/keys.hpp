// Reads the table argument of a constructor, and finds all its errors.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/schema.hpp"
#include "base/space.hpp"
#include "bindings/core/kind.hpp"
#include "geometry/plane/polygon.hpp"

namespace trilith::script {

/// The keys of a table argument. Each read marks a key as known. Nothing throws before finish(), which reports an
/// unknown key first (with the nearest known name), then the first missing or wrong one. Use the values only after
/// finish().
class Keys {
 public:
  /// `owner` begins every message: "body". Throws InputError if the value at `index` is not a table.
  Keys(lua_State* L, int index, std::string owner);

  [[nodiscard]] lua_State* lua() const { return L_; }
  [[nodiscard]] const std::string& owner() const { return owner_; }
  /// From now on messages begin with "body 'S3'".
  void name_owner(const std::string& name);

  [[nodiscard]] bool has(std::string_view key);  ///< marks the key as known too
  /// Rejects a key that is not used here with a separate message; it is marked as known only if it is given.
  void refuse(std::string_view key, const std::string& why);

  double number(std::string_view key, std::string_view unit);  ///< required
  double number(std::string_view key, std::string_view unit, double preset);
  std::optional<double> maybe_number(std::string_view key, std::string_view unit);
  int count(std::string_view key, int preset);  ///< `preset` also if it is wrong
  bool flag(std::string_view key, bool preset);
  std::string text(std::string_view key);  ///< required
  std::string text(std::string_view key, const std::string& preset);
  Vec2 point(std::string_view key);  ///< {x, y}; required
  Vec2 point(std::string_view key, const Vec2& preset);
  std::optional<Vec2> maybe_point(std::string_view key);
  /// {{x, y}, ...}; required
  std::vector<Vec2> points(std::string_view key);
  Vec3 vector(std::string_view key);  ///< {x, y, z}; required
  Vec3 vector(std::string_view key, const Vec3& preset);
  /// {{x, y, z}, ...}; required
  std::vector<Vec3> vectors(std::string_view key);
  std::vector<std::string> names(std::string_view key);  ///< "a" or {"a", "b"}; empty if not given
  /// Index of the text under `key` among `choices`; `preset` if not given.
  std::size_t choice(std::string_view key, const std::vector<std::string>& choices, std::size_t preset);

  /// The handle under `key`, or nullptr if it is not given or (a problem) of another kind. It remains alive as long as
  /// the table.
  template <class H>
  H* maybe_handle(std::string_view key) {
    const int type = push(key);
    H* h = type == LUA_TNIL ? nullptr : test_handle<H>(L_, -1);
    if (type != LUA_TNIL && h == nullptr) wrong(key, fmt::format("a {}", Kind<H>::name));
    lua_pop(L_, 1);
    return h;
  }
  /// A type's declared numbers (base/schema.hpp).
  template <Declared T>
  void declared(T& value) {
    for (const Parameter<T>& p : T::parameters()) {
      value.*(p.member) = p.required() ? number(p.name, p.unit) : number(p.name, p.unit, p.preset);
      if (value.*(p.member) != p.preset && !p.allows(value.*(p.member)))
        problem(fmt::format("'{}' is {:g}{}{}, must be {}", p.name, value.*(p.member), p.unit == "1" ? "" : " ",
                            p.unit == "1" ? "" : p.unit, p.range()));
    }
  }

  /// Pushes the value under `key`, marks it as known, and returns its type.
  int push(std::string_view key);
  /// Marks keys as known that are read elsewhere or not at all.
  void know(std::initializer_list<std::string_view> keys);
  /// Permits entries 1, 2, ...; otherwise they are unknown keys.
  void allow_list() { list_allowed_ = true; }
  /// Stores `"owner: what"` as the error, unless there is one already.
  void problem(const std::string& what);
  void missing(std::string_view key, std::string_view wanted);
  /// Problem "'key' is a string, must be `wanted`" about the value on top of the stack.
  void wrong(std::string_view key, std::string_view wanted);
  /// Throws InputError if there is any error.
  void finish();

 private:
  /// The text on top of the stack, from `key`; a problem if it contains control characters.
  std::string printable(std::string_view key);
  double read_number(std::string_view key, std::string_view unit);
  void report_unknown() const;

  lua_State* L_;
  int index_;
  std::string owner_;
  std::vector<std::string> known_;
  std::string problem_;
  bool list_allowed_ = false;
};

/// "a number", "a string 'abc'", "nil": description of the value at `index` for messages.
std::string what_is(lua_State* L, int index);

/// The integer at `index`; none for other values, or beyond +-1e9.
std::optional<int> count_at(lua_State* L, int index);

/// Reads {x, y} or {x, y, z} at `index`; none unless it has two, or three, finite numbers.
std::optional<Vec2> point_at(lua_State* L, int index);
std::optional<Vec3> vector_at(lua_State* L, int index);

}  // namespace trilith::script
