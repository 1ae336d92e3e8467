// Reads a builder's table by its declared keys (build/builder_keys.hpp), and writes their lines for the manual.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bindings/core/bindings.hpp"
#include "bindings/geometry/part_reading.hpp"
#include "build/builder_keys.hpp"

namespace trilith::script {

/// Reads the keys that `Decl` declares into `value`.
template <DeclaresKeys Decl, class B>
void read_keys_of(Keys& k, B& value);

/// The entries of a list of tables; an entry whose EachCount has several numbers is made once for each.
template <DeclaresKeys Decl, class Entry>
void read_entries(Keys& k, std::string_view key, const std::string& owner, std::vector<Entry>& entries) {
  read_list(k, key, owner, [&](Keys& own) {
    Entry entry;
    read_keys_of<Decl>(own, entry);
    bool is_several = false;
    for_each_key<Decl>([&](const auto& each) {
      if constexpr (std::decay_t<decltype(each)>::kind == KeyKind::each_count) {
        is_several = true;
        for (const int number : read_counts(own, each.name, entry.*(each.member))) {
          entries.push_back(entry);
          entries.back().*(each.member) = number;
        }
      }
    });
    if (!is_several) entries.push_back(entry);
  });
}

/// A list of tables, or so many entries that give nothing; one where the key is absent.
template <DeclaresKeys Decl, class Entry>
void read_count_or_entries(Keys& k, std::string_view key, const std::string& owner, int most,
                           std::vector<Entry>& entries) {
  const int type = k.push(key);
  lua_pop(k.lua(), 1);
  if (type == LUA_TTABLE) return read_entries<Decl>(k, key, owner, entries);
  const int count = k.count(key, 1);
  if (count < 1 || count > most)
    k.problem(fmt::format("'{}' is {}, must be from 1 to {}, or a list", key, count, most));
  entries.assign(static_cast<std::size_t>(std::clamp(count, 1, most)), Entry{});
}

/// The table on top of the stack, from `key`, by the keys of `Decl`.
template <DeclaresKeys Decl, class Fields>
void read_table_on_top(Keys& k, std::string_view key, Fields& fields) {
  try {
    Keys own(k.lua(), -1, std::string(key));
    read_keys_of<Decl>(own, fields);
    own.finish();
  } catch (const InputError& e) {
    k.problem(e.what());
  }
}

/// A table with keys of its own, which may be absent.
template <DeclaresKeys Decl, class Fields>
void read_table(Keys& k, std::string_view key, std::string_view wanted, Fields& fields) {
  const int type = k.push(key);
  if (type == LUA_TTABLE)
    read_table_on_top<Decl>(k, key, fields);
  else if (type != LUA_TNIL)
    k.wrong(key, fmt::format("a table {}", wanted));
  lua_pop(k.lua(), 1);
}

/// One table, a list of them, or false for none; nothing where the key is absent.
template <DeclaresKeys Entry>
std::optional<std::vector<Entry>> read_one_or_list(Keys& k, std::string_view key, const std::string& entry,
                                                   std::string_view wanted) {
  lua_State* L = k.lua();
  const int type = k.push(key);
  std::optional<std::vector<Entry>> entries;
  if (type != LUA_TNIL) entries.emplace();
  const bool is_one = type == LUA_TTABLE && lua_rawlen(L, -1) == 0;
  if (type != LUA_TNIL && type != LUA_TTABLE && (type != LUA_TBOOLEAN || lua_toboolean(L, -1) != 0))
    k.wrong(key, fmt::format("a table {}, a list of such tables, or false for none", wanted));
  if (is_one) read_table_on_top<Entry>(k, key, entries->emplace_back());
  lua_pop(L, 1);
  if (type == LUA_TTABLE && !is_one) read_entries<Entry>(k, key, entry, *entries);
  return entries;
}

/// A number for both, or { least, greatest }.
inline void read_number_or_range(Keys& k, std::string_view key, std::string_view unit, double& low, double& high) {
  lua_State* L = k.lua();
  const bool is_range = k.push(key) == LUA_TTABLE;
  if (is_range) {
    const std::optional<Vec2> range = point_at(L, -1);
    if (!range) k.wrong(key, fmt::format("a number [{}], or {{ least, most }}", unit));
    if (range) low = range->x(), high = range->y();
  }
  lua_pop(L, 1);
  if (!is_range) low = high = k.number(key, unit);
}

/// A file, relative to the folder of the script.
inline std::filesystem::path read_path(Keys& k, std::string_view key) {
  const std::filesystem::path path = k.text(key);
  return path.is_absolute() ? path : host(k.lua()).folder() / path;
}

// A point in the plane or in space, required or with a default.
inline Vec2 read_place(Keys& k, std::string_view key, const Vec2& preset, bool is_required) {
  return is_required ? k.point(key) : k.point(key, preset);
}
inline Vec3 read_place(Keys& k, std::string_view key, const Vec3& preset, bool is_required) {
  return is_required ? k.vector(key) : k.vector(key, preset);
}

template <class E, class Choice>
E read_choice(Keys& k, const Choice& key, E preset) {
  if (key.preset.is_required && !k.has(key.name))
    k.missing(key.name, fmt::format("\"{}\": {}", fmt::join(key.texts, "\" or \""), key.sentence));
  return static_cast<E>(k.choice(key.name, {key.texts.begin(), key.texts.end()}, static_cast<std::size_t>(preset)));
}

/// A key whose value is a number, a text, a flag, a point or a choice.
template <class B, class Key>
void read_plain_key(Keys& k, B& value, const Key& key) {
  auto& member = value.*(key.member);
  if constexpr (Key::kind == KeyKind::number)
    member = key.preset.is_required ? k.number(key.name, key.unit) : k.number(key.name, key.unit, member);
  else if constexpr (Key::kind == KeyKind::maybe_number)
    member = k.maybe_number(key.name, key.unit);
  else if constexpr (Key::kind == KeyKind::count)
    member = k.count(key.name, member);
  else if constexpr (Key::kind == KeyKind::maybe_count)
    member = k.has(key.name) ? std::optional(k.count(key.name, 1)) : std::nullopt;
  else if constexpr (Key::kind == KeyKind::flag)
    member = k.flag(key.name, member);
  else if constexpr (Key::kind == KeyKind::text)
    member = k.text(key.name, member);
  else if constexpr (Key::kind == KeyKind::path)
    member = read_path(k, key.name);
  else if constexpr (Key::kind == KeyKind::point || Key::kind == KeyKind::vector)
    member = read_place(k, key.name, member, key.preset.is_required);
  else if constexpr (Key::kind == KeyKind::maybe_point)
    member = k.maybe_point(key.name);
  else if constexpr (Key::kind == KeyKind::points)
    member = key.preset.is_required || k.has(key.name) ? k.points(key.name) : Polygon();
  else if constexpr (Key::kind == KeyKind::vectors)
    member = k.vectors(key.name);
  else if constexpr (Key::kind == KeyKind::choice)
    member = read_choice(k, key, member);
}

/// One declared key, from the table into the member. Counts of which each makes an entry are read with their list.
template <class B, class Key>
void read_key(Keys& k, B& value, const Key& key) {
  if constexpr (Key::kind == KeyKind::list) {
    if (key.preset.is_required && !k.has(key.name)) k.missing(key.name, fmt::format("a list {}", key.sentence));
    read_entries<typename Key::Declares>(k, key.name, std::string(key.entry), value.*(key.member));
  } else if constexpr (Key::kind == KeyKind::count_or_list) {
    read_count_or_entries<typename Key::Declares>(k, key.name, std::string(key.entry), key.most, value.*(key.member));
  } else if constexpr (Key::kind == KeyKind::one_or_list) {
    if (auto rows = read_one_or_list<typename Key::Declares>(k, key.name, std::string(key.entry), key.wanted))
      value.*(key.member) = std::move(*rows);
  } else if constexpr (Key::kind == KeyKind::table) {
    read_table<typename Key::Declares>(k, key.name, key.wanted, value.*(key.member));
  } else if constexpr (Key::kind == KeyKind::within) {
    read_keys_of<typename Key::Declares>(k, value.*(key.member));
  } else if constexpr (Key::kind == KeyKind::number_or_range) {
    read_number_or_range(k, key.name, key.unit, value.*(key.low), value.*(key.high));
  } else if constexpr (Key::kind != KeyKind::each_count) {
    read_plain_key(k, value, key);
  }
}

inline void check_rule(Keys& k, const Together& rule) {
  if (k.has(rule.one) != k.has(rule.other))
    k.problem(fmt::format("{} and {} are given together; give both or neither", rule.one, rule.other));
}
inline void check_rule(Keys& k, const Instead& rule) {
  bool is_double = false;
  for (const std::string_view other : rule.of) is_double = is_double || k.has(other);
  if (is_double && k.has(rule.key))
    k.problem(fmt::format("{} define the same shape as {}; keep one of the two", rule.what, rule.others));
}
inline void check_rule(Keys& k, const OneOf& rule) {
  const bool one = k.has(rule.one), other = k.has(rule.other);
  if (!one && !other) k.missing(rule.one, rule.wanted);
  if (one && other && rule.excludes)
    k.problem(fmt::format("both {} and {} are given; keep one{}", rule.one, rule.other, *rule.excludes));
}
inline void check_rule(Keys& k, const Needs& rule) {
  if (k.has(rule.key) && !k.has(rule.other)) k.missing(rule.other, rule.wanted);
}
inline void check_rule(Keys& /*k*/, const Refused& /*rule*/) {}

template <DeclaresKeys Decl, class B>
void read_keys_of(Keys& k, B& value) {
  // First, so that its reason comes before a message on a missing key.
  for_each_key<Decl>([&](const auto& key) {
    if constexpr (std::is_same_v<std::decay_t<decltype(key)>, Refused>) k.refuse(key.name, std::string(key.why));
  });
  for_each_key<Decl>([&](const auto& key) {
    if constexpr (std::decay_t<decltype(key)>::kind != KeyKind::rule) read_key(k, value, key);
  });
  for_each_key<Decl>([&](const auto& rule) {
    if constexpr (std::decay_t<decltype(rule)>::kind == KeyKind::rule) check_rule(k, rule);
  });
}

/// Kind of a key as the manual says it.
template <class Key>
std::string_view kind_text(const Key& key) {
  switch (Key::kind) {
    case KeyKind::number:
    case KeyKind::maybe_number:
      return "number";
    case KeyKind::number_or_range:
      return "number or list";
    case KeyKind::count:
    case KeyKind::maybe_count:
      return "integer";
    case KeyKind::flag:
      return "flag";
    case KeyKind::point:
    case KeyKind::maybe_point:
      return "point";
    case KeyKind::points:
      return "points";
    case KeyKind::vector:
      return "vector";
    case KeyKind::vectors:
      return "vectors";
    case KeyKind::text:
    case KeyKind::path:
    case KeyKind::choice:
      return "text";
    case KeyKind::list:
      return "list";
    case KeyKind::count_or_list:
      return key.name;
    case KeyKind::one_or_list:
    case KeyKind::table:
      return "table";
    case KeyKind::each_count:
    case KeyKind::within:
    case KeyKind::rule:
      break;
  }
  return "";
}

/// Default of a key, for the manual: " = 0.4"; "?" where it may be absent; "" where it must be given.
template <class B, class Key>
std::string preset_text(const B& usual, const Key& key) {
  if constexpr (requires { key.preset; }) {
    if (key.preset.is_required) return "";
    if (!key.preset.text.empty()) return fmt::format(" = {}", key.preset.text);
  }
  if constexpr (Key::kind == KeyKind::number)
    return fmt::format(" = {:g}", usual.*(key.member));
  else if constexpr (Key::kind == KeyKind::count)
    return fmt::format(" = {}", usual.*(key.member));
  else if constexpr (Key::kind == KeyKind::flag)
    return usual.*(key.member) ? " = true" : " = false";
  else if constexpr (Key::kind == KeyKind::text)
    return fmt::format(" = \"{}\"", usual.*(key.member));
  else if constexpr (Key::kind == KeyKind::point || Key::kind == KeyKind::vector)
    return fmt::format(" = {{{:g}}}", fmt::join((usual.*(key.member)).begin(), (usual.*(key.member)).end(), ", "));
  else if constexpr (Key::kind == KeyKind::choice)
    return fmt::format(" = \"{}\"", key.texts[static_cast<std::size_t>(usual.*(key.member))]);
  else if constexpr (Key::kind == KeyKind::count_or_list)
    return " = 1";
  else if constexpr (Key::kind == KeyKind::path || Key::kind == KeyKind::vectors ||
                     Key::kind == KeyKind::number_or_range)
    return "";
  return "?";
}

/// The allowed numbers of a key, as the manual has them at the end of a line: "  <above 0>"; "" where any is allowed.
template <class Key>
std::string range_text(const Key& key) {
  if constexpr (requires { key.range; })
    return key.range.least == -unbounded ? "" : fmt::format("  <{}>", key.range.text());
  if constexpr (Key::kind == KeyKind::count || Key::kind == KeyKind::maybe_count)
    return key.least == -any_count ? ""
           : key.most == any_count ? fmt::format("  <at least {}>", key.least)
                                   : fmt::format("  <from {} to {}>", key.least, key.most);
  return "";
}

/// The keys that `Decl` declares as a page of the manual: a line each of name, kind, sentence and range.
template <DeclaresKeys Decl, class B>
std::string key_lines_of(const B& usual) {
  std::string text;
  for_each_key<Decl>([&](const auto& key) {
    using Key = std::decay_t<decltype(key)>;
    const std::string_view begin = text.empty() ? "" : "\n";
    if constexpr (Key::kind == KeyKind::within) {
      text += fmt::format("{}{}", begin, key_lines_of<typename Key::Declares>(usual.*(key.member)));
    } else if constexpr (Key::kind != KeyKind::rule) {
      std::string unit, choices;
      if constexpr (requires { key.unit; }) unit = key.unit == "1" ? "" : fmt::format(" {}", key.unit);
      if constexpr (Key::kind == KeyKind::choice) choices = fmt::format(": \"{}\"", fmt::join(key.texts, "\" or \""));
      text += fmt::format("{}{}  {}{}{}  {}{}{}", begin, key.name, kind_text(key), unit, preset_text(usual, key),
                          key.sentence, choices, range_text(key));
    }
  });
  return text;
}

template <DeclaresKeys B>
std::string declared_key_lines() {
  return key_lines_of<B>(B{});
}

}  // namespace trilith::script
