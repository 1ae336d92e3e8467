// Reads the one table that a constructor takes, and finds everything that is wrong with it.
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

/// The keys of a table argument. Each read names a key that is known; nothing throws before finish(), which reports an
/// unknown key first (with the nearest known name), then the first that is missing or wrong. So use what was read only
/// after finish().
class Keys {
 public:
  /// `owner` begins every message: "body". Throws InputError where the value at `index` is no table.
  Keys(lua_State* L, int index, std::string owner);

  [[nodiscard]] lua_State* lua() const { return L_; }
  [[nodiscard]] const std::string& owner() const { return owner_; }
  /// From now on messages begin with "body 'S3'".
  void name_owner(const std::string& name);

  [[nodiscard]] bool has(std::string_view key);  ///< names the key as known too
  /// A key that is of no use here and has a message of its own: named as known only where it is given.
  void refuse(std::string_view key, const std::string& why);

  double number(std::string_view key, std::string_view unit);  ///< must be there
  double number(std::string_view key, std::string_view unit, double preset);
  std::optional<double> maybe_number(std::string_view key, std::string_view unit);
  int count(std::string_view key, int preset);  ///< `preset` too where it is wrong
  bool flag(std::string_view key, bool preset);
  std::string text(std::string_view key);  ///< must be there
  std::string text(std::string_view key, const std::string& preset);
  Vec2 point(std::string_view key);  ///< {x, y}; must be there
  Vec2 point(std::string_view key, const Vec2& preset);
  std::optional<Vec2> maybe_point(std::string_view key);
  /// {{x, y}, ...}; must be there
  std::vector<Vec2> points(std::string_view key);
  Vec3 vector(std::string_view key);  ///< {x, y, z}; must be there
  Vec3 vector(std::string_view key, const Vec3& preset);
  /// {{x, y, z}, ...}; must be there
  std::vector<Vec3> vectors(std::string_view key);
  std::vector<std::string> names(std::string_view key);  ///< "a" or {"a", "b"}; empty where it is not there
  /// Index of the text under `key` among `choices`; `preset` where it is not there.
  std::size_t choice(std::string_view key, const std::vector<std::string>& choices, std::size_t preset);

  /// The handle under `key`, or nullptr where it is not there or (a problem) of another kind. It stays alive as long
  /// as the table does.
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
      if (!p.allows(value.*(p.member)))
        problem(fmt::format("'{}' is {:g}{}{}, must be {}", p.name, value.*(p.member), p.unit == "1" ? "" : " ",
                            p.unit == "1" ? "" : p.unit, p.range()));
    }
  }

  /// Pushes the value under `key`, names it as known, and gives its type.
  int push(std::string_view key);
  /// Names keys as known that are read elsewhere or not at all.
  void know(std::initializer_list<std::string_view> keys);
  /// Entries 1, 2, ... are meant; without this they are unknown keys.
  void allow_list() { list_allowed_ = true; }
  /// Remembers "owner: what", unless something else is wrong already.
  void problem(const std::string& what);
  void missing(std::string_view key, std::string_view wanted);
  /// Problem "'key' is a string, must be `wanted`" about the value on top of the stack.
  void wrong(std::string_view key, std::string_view wanted);
  /// Throws InputError where anything is wrong.
  void finish();

 private:
  /// The text on top of the stack, which is under `key`; a problem where it holds control characters.
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

/// "a number", "a string 'abc'", "nil": what the value at `index` is, for messages.
std::string what_is(lua_State* L, int index);

/// The whole number at `index`; nothing where it is none, or not within -1e9 and 1e9.
std::optional<int> count_at(lua_State* L, int index);

/// Reads {x, y} at `index`, or {x, y, z}; nothing where it is not two, or three, finite numbers.
std::optional<Vec2> point_at(lua_State* L, int index);
std::optional<Vec3> vector_at(lua_State* L, int index);

}  // namespace trilith::script
