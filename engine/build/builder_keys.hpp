// The declaration of a builder: each key once. From it come reading, checks, reference and completion.
//
//     static constexpr auto keys() {
//       using K = KeysOf<Stack>;
//       return std::tuple(K::Point{&Stack::at, "at", "middle of the foot"},
//                         K::List<StackBlock>{&Stack::blocks, "blocks", "block", "from the foot up"});
//     }
//
// A default is the value of the member.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

#include "base/error.hpp"
#include "base/schema.hpp"
#include "base/space.hpp"
#include "geometry/plane/polygon.hpp"

namespace trilith {

/// Allowed numbers: from `least` to `most`, `least` itself only where it is included.
struct Range {
  double least = -unbounded, most = unbounded;
  bool includes_least = true;

  [[nodiscard]] bool allows(double v) const {
    return std::isfinite(v) && (includes_least ? v >= least : v > least) && v <= most;
  }
  [[nodiscard]] std::string text() const {
    if (least == -unbounded) return "a finite number";
    if (most == unbounded) return fmt::format("finite and {} {:g}", includes_least ? "not below" : "above", least);
    return includes_least ? fmt::format("from {:g} to {:g}", least, most)
                          : fmt::format("above {:g} and at most {:g}", least, most);
  }
};
inline constexpr int any_count = 1'000'000'000;
inline constexpr Range any_number{}, above_zero{0, unbounded, false}, not_below_zero{0, unbounded, true};

/// Default of a key as printed in the reference; empty: the member's own default.
struct Preset {
  std::string_view text = {};
  bool is_required = false;
};
inline constexpr Preset must_be_given{{}, true};

/// Kind of a declared key, for the functions that read, check and describe it.
enum class KeyKind {
  number,
  maybe_number,
  number_or_range,
  count,
  maybe_count,
  each_count,
  flag,
  text,
  path,
  point,
  maybe_point,
  points,
  vector,
  vectors,
  choice,
  list,
  count_or_list,
  one_or_list,
  table,
  within,
  rule
};

/// Kinds of keys of a builder B. A `Decl` declares the keys of a member whose own type does not.
template <class B>
struct KeysOf {
  struct Number {
    static constexpr KeyKind kind = KeyKind::number;
    double B::*member;
    std::string_view name, unit, sentence;
    Range range = any_number;
    Preset preset = {};
  };
  /// A number that may be absent.
  struct MaybeNumber {
    static constexpr KeyKind kind = KeyKind::maybe_number;
    std::optional<double> B::*member;
    std::string_view name, unit, sentence;
    Range range = any_number;
  };
  /// A number for both members, or a list of two: the least and the greatest.
  struct NumberOrRange {
    static constexpr KeyKind kind = KeyKind::number_or_range;
    double B::*low;
    double B::*high;
    std::string_view name, unit, sentence;
    Range range = any_number;
  };
  struct Count {
    static constexpr KeyKind kind = KeyKind::count;
    int B::*member;
    std::string_view name, sentence;
    int least = -any_count, most = any_count;
    Preset preset = {};
  };
  /// A count that may be absent.
  struct MaybeCount {
    static constexpr KeyKind kind = KeyKind::maybe_count;
    std::optional<int> B::*member;
    std::string_view name, sentence;
    int least = -any_count, most = any_count;
  };
  /// Of an entry of a list: a number, or several of them, each of which makes an entry.
  struct EachCount {
    static constexpr KeyKind kind = KeyKind::each_count;
    int B::*member;
    std::string_view name, sentence;
  };
  struct Flag {
    static constexpr KeyKind kind = KeyKind::flag;
    bool B::*member;
    std::string_view name, sentence;
  };
  struct Text {
    static constexpr KeyKind kind = KeyKind::text;
    std::string B::*member;
    std::string_view name, sentence;
  };
  /// A file, searched in the folder of the script. It must be given.
  struct Path {
    static constexpr KeyKind kind = KeyKind::path;
    std::filesystem::path B::*member;
    std::string_view name, sentence;
  };
  struct Point {
    static constexpr KeyKind kind = KeyKind::point;
    Vec2 B::*member;
    std::string_view name, sentence;
    Preset preset = {};
  };
  struct MaybePoint {
    static constexpr KeyKind kind = KeyKind::maybe_point;
    std::optional<Vec2> B::*member;
    std::string_view name, sentence;
  };
  struct Points {
    static constexpr KeyKind kind = KeyKind::points;
    Polygon B::*member;
    std::string_view name, sentence;
    Preset preset = must_be_given;
  };
  /// A point in space.
  struct Vector {
    static constexpr KeyKind kind = KeyKind::vector;
    Vec3 B::*member;
    std::string_view name, sentence;
    Preset preset = {};
  };
  /// Points in space. They must be given.
  struct Vectors {
    static constexpr KeyKind kind = KeyKind::vectors;
    std::vector<Vec3> B::*member;
    std::string_view name, sentence;
  };
  /// One of several texts; their values are 0, 1, ...
  template <class E, std::size_t count>
  struct Choice {
    static constexpr KeyKind kind = KeyKind::choice;
    E B::*member;
    std::string_view name, sentence;
    std::array<std::string_view, count> texts;
    Preset preset = {};
  };
  /// A list of tables, whose keys the type of an entry declares.
  template <class Entry, class Decl = Entry>
  struct List {
    static constexpr KeyKind kind = KeyKind::list;
    using Declares = Decl;
    std::vector<Entry> B::*member;
    std::string_view name, entry, sentence;
    Preset preset = {};
  };
  /// A list of tables, or a number of entries that give nothing.
  template <class Entry, class Decl = Entry>
  struct CountOrList {
    static constexpr KeyKind kind = KeyKind::count_or_list;
    using Declares = Decl;
    std::vector<Entry> B::*member;
    std::string_view name, entry, sentence;
    int most;  ///< entries given by their number
  };
  /// One table, a list of them, or false for none. The member is a list, or one that may be absent.
  template <class Entry, class Rows = std::optional<std::vector<Entry>>>
  struct OneOrList {
    static constexpr KeyKind kind = KeyKind::one_or_list;
    using Declares = Entry;
    Rows B::*member;
    std::string_view name, entry, wanted, sentence;
  };
  /// A table with keys of its own, which may be absent. `wanted` shows them.
  template <class Fields, class Decl = Fields>
  struct OwnTable {
    static constexpr KeyKind kind = KeyKind::table;
    using Declares = Decl;
    Fields B::*member;
    std::string_view name, wanted, sentence;
  };
  /// Keys of a member, in addition to the builder's own.
  template <class Fields, class Decl = Fields>
  struct Within {
    static constexpr KeyKind kind = KeyKind::within;
    using Declares = Decl;
    Fields B::*member;
  };
};

// Rules about several keys.

/// Two keys that go together: both or neither.
struct Together {
  static constexpr KeyKind kind = KeyKind::rule;
  std::string_view one, other;
};
/// A key that is given instead of others; `what` and `others` begin and complete the message.
struct Instead {
  static constexpr KeyKind kind = KeyKind::rule;
  std::string_view key;
  std::array<std::string_view, 3> of;
  std::string_view what, others;
};
/// At least one of two keys. `wanted` completes "'one' is missing; give". With `excludes` only one of the two; it
/// completes "both one and other are given; keep one".
struct OneOf {
  static constexpr KeyKind kind = KeyKind::rule;
  std::string_view one, other, wanted;
  std::optional<std::string_view> excludes = {};
};
/// A key that needs another one. `wanted` completes "'other' is missing; give".
struct Needs {
  static constexpr KeyKind kind = KeyKind::rule;
  std::string_view key, other, wanted;
};
/// A key that belongs elsewhere and has a message of its own.
struct Refused {
  static constexpr KeyKind kind = KeyKind::rule;
  std::string_view name, why;
};

/// A type whose keys are declared.
template <class B>
concept DeclaresKeys = std::is_class_v<B> && requires {
  std::tuple_size<decltype(B::keys())>::value;
};

/// A builder: its name in scripts, a sentence, whether it always makes one part, its keys, and the parts. One with
/// `is_named = false` has no key `name`.
template <class B>
concept DeclaredBuilder = DeclaresKeys<B> && std::default_initializable<B> && requires(const B& builder) {
  { B::kind } -> std::convertible_to<std::string_view>;
  { B::sentence } -> std::convertible_to<std::string_view>;
  { B::is_single } -> std::convertible_to<bool>;
  { builder.name } -> std::convertible_to<std::string>;
  builder.parts();
};
/// Calls f(key) for each declared key and rule, in their order.
template <DeclaresKeys B, class F>
constexpr void for_each_key(F&& f) {
  std::apply([&](const auto&... key) { (f(key), ...); }, B::keys());
}

/// "unit length" from "unit_length": a key in messages.
inline std::string key_words(std::string_view key) {
  std::string words(key);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

inline void check_number(const std::string& owner, std::string_view key, double v, std::string_view unit,
                         const Range& range) {
  if (range.allows(v)) return;
  throw InputError(fmt::format("{}: {} is {}{}{}, must be {}", owner, key_words(key),
                               std::isnan(v) ? "nan" : fmt::format("{:g}", v), unit == "1" ? "" : " ",
                               unit == "1" ? "" : unit, range.text()));
}

inline void check_count(const std::string& owner, std::string_view key, int v, int least, int most) {
  if (v >= least && v <= most) return;
  throw InputError(
      fmt::format("{}: {} is {}, must be a whole number from {} to {}", owner, key_words(key), v, least, most));
}

// The list of a member that may be absent; nullptr if it is.
template <class T>
const std::vector<T>* list_in(const std::vector<T>& list) {
  return &list;
}
template <class T>
const std::vector<T>* list_in(const std::optional<std::vector<T>>& list) {
  return list ? &*list : nullptr;
}

/// Throws InputError where a number of `value` or of its entries is outside its range. `owner` begins the message.
/// `Decl` declares the keys.
template <DeclaresKeys Decl, class B>
void check_keys_of(const B& value, const std::string& owner);

template <class B, class Key>
void check_key(const B& value, const std::string& owner, const Key& key) {
  if constexpr (Key::kind == KeyKind::number) {
    check_number(owner, key.name, value.*(key.member), key.unit, key.range);
  } else if constexpr (Key::kind == KeyKind::maybe_number) {
    if (value.*(key.member)) check_number(owner, key.name, *(value.*(key.member)), key.unit, key.range);
  } else if constexpr (Key::kind == KeyKind::number_or_range) {
    for (const double v : {value.*(key.low), value.*(key.high)}) check_number(owner, key.name, v, key.unit, key.range);
  } else if constexpr (Key::kind == KeyKind::count) {
    check_count(owner, key.name, value.*(key.member), key.least, key.most);
  } else if constexpr (Key::kind == KeyKind::maybe_count) {
    if (value.*(key.member)) check_count(owner, key.name, *(value.*(key.member)), key.least, key.most);
  } else if constexpr (Key::kind == KeyKind::point || Key::kind == KeyKind::vector) {
    if (!(value.*(key.member)).allFinite())
      throw InputError(fmt::format("{}: {} must be finite", owner, key_words(key.name)));
  } else if constexpr (Key::kind == KeyKind::list || Key::kind == KeyKind::count_or_list) {
    int number = 0;
    for (const auto& entry : value.*(key.member))
      check_keys_of<typename Key::Declares>(entry, fmt::format("{}, {} {}", owner, key.entry, ++number));
  } else if constexpr (Key::kind == KeyKind::one_or_list) {
    int number = 0;
    if (const auto* const rows = list_in(value.*(key.member)))
      for (const auto& entry : *rows)
        check_keys_of<typename Key::Declares>(entry, fmt::format("{}, {} {}", owner, key.entry, ++number));
  } else if constexpr (Key::kind == KeyKind::within) {
    check_keys_of<typename Key::Declares>(value.*(key.member), owner);
  }
}

template <DeclaresKeys Decl, class B>
void check_keys_of(const B& value, const std::string& owner) {
  for_each_key<Decl>([&](const auto& key) { check_key(value, owner, key); });
}

template <DeclaresKeys B>
void check_keys(const B& value, const std::string& owner) {
  check_keys_of<B>(value, owner);
}

}  // namespace trilith
