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

/// Kinds of keys of a builder B.
template <class B>
struct KeysOf {
  struct Number {
    double B::*member;
    std::string_view name, unit, sentence;
    Range range = any_number;
    Preset preset = {};
  };
  /// A number that may be absent.
  struct MaybeNumber {
    std::optional<double> B::*member;
    std::string_view name, unit, sentence;
    Range range = any_number;
  };
  struct Count {
    int B::*member;
    std::string_view name, sentence;
    int least = -any_count, most = any_count;
    Preset preset = {};
  };
  /// Of an entry of a list: a number, or several of them, each of which makes an entry.
  struct EachCount {
    int B::*member;
    std::string_view name, sentence;
  };
  struct Flag {
    bool B::*member;
    std::string_view name, sentence;
  };
  struct Text {
    std::string B::*member;
    std::string_view name, sentence;
  };
  struct Point {
    Vec2 B::*member;
    std::string_view name, sentence;
  };
  struct Points {
    Polygon B::*member;
    std::string_view name, sentence;
  };
  /// One of several texts; their values are 0, 1, ...
  template <class E, std::size_t count>
  struct Choice {
    E B::*member;
    std::string_view name, sentence;
    std::array<std::string_view, count> texts;
  };
  /// A list of tables, whose keys the type of an entry declares.
  template <class Entry>
  struct List {
    std::vector<Entry> B::*member;
    std::string_view name, entry, sentence;
  };
  /// A list of tables, or a number of entries that give nothing.
  template <class Entry>
  struct CountOrList {
    std::vector<Entry> B::*member;
    std::string_view name, entry, sentence;
    int most;  ///< entries given by their number
  };
};

/// Two keys that go together: both or neither.
struct Together {
  std::string_view one, other;
};
/// A key that is given instead of others; `what` and `others` begin and complete the message.
struct Instead {
  std::string_view key;
  std::array<std::string_view, 3> of;
  std::string_view what, others;
};
/// A key that belongs elsewhere and has a message of its own.
struct Refused {
  std::string_view name, why;
};

/// A type whose keys are declared.
template <class B>
concept DeclaresKeys = std::is_class_v<B> && requires {
  std::tuple_size<decltype(B::keys())>::value;
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

/// Throws InputError where a number of `value` or of its entries is outside its range. `owner` begins the message.
template <DeclaresKeys B>
void check_keys(const B& value, const std::string& owner);

template <class B, class Key>
void check_key(const B& value, const std::string& owner, const Key& key) {
  using Kinds = KeysOf<B>;
  const auto& member = value.*(key.member);
  if constexpr (std::is_same_v<Key, typename Kinds::Number>) {
    check_number(owner, key.name, member, key.unit, key.range);
  } else if constexpr (std::is_same_v<Key, typename Kinds::MaybeNumber>) {
    if (member) check_number(owner, key.name, *member, key.unit, key.range);
  } else if constexpr (std::is_same_v<Key, typename Kinds::Count>) {
    if (member < key.least || member > key.most)
      throw InputError(fmt::format("{}: {} is {}, must be a whole number from {} to {}", owner, key_words(key.name),
                                   member, key.least, key.most));
  } else if constexpr (std::is_same_v<Key, typename Kinds::Point>) {
    if (!member.allFinite()) throw InputError(fmt::format("{}: {} must be finite", owner, key_words(key.name)));
  } else if constexpr (requires { key.entry; }) {
    int number = 0;
    for (const auto& entry : member) check_keys(entry, fmt::format("{}, {} {}", owner, key.entry, ++number));
  }
}

template <DeclaresKeys B>
void check_keys(const B& value, const std::string& owner) {
  for_each_key<B>([&](const auto& key) {
    if constexpr (requires { key.member; }) check_key(value, owner, key);
  });
}

}  // namespace trilith
