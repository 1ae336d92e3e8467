// Reads a builder's table by its declared keys (build/builder_keys.hpp), and writes their lines for the manual.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bindings/geometry/part_reading.hpp"
#include "build/builder_keys.hpp"

namespace trilith::script {

template <class T>
inline constexpr bool is_flag = std::is_same_v<T, bool>;

template <DeclaresKeys B>
void read_declared_keys(Keys& k, B& value);

/// The entries of a list of tables; an entry whose EachCount has several numbers is made once for each.
template <DeclaresKeys Entry>
void read_entries(Keys& k, std::string_view key, const std::string& owner, std::vector<Entry>& entries) {
  read_list(k, key, owner, [&](Keys& own) {
    Entry entry;
    read_declared_keys(own, entry);
    bool is_several = false;
    for_each_key<Entry>([&](const auto& each) {
      if constexpr (std::is_same_v<std::decay_t<decltype(each)>, typename KeysOf<Entry>::EachCount>) {
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
template <DeclaresKeys Entry>
void read_count_or_entries(Keys& k, std::string_view key, const std::string& owner, int most,
                           std::vector<Entry>& entries) {
  const int type = k.push(key);
  lua_pop(k.lua(), 1);
  if (type == LUA_TTABLE) return read_entries(k, key, owner, entries);
  const int count = k.count(key, 1);
  if (count < 1 || count > most)
    k.problem(fmt::format("'{}' is {}, must be from 1 to {}, or a list", key, count, most));
  entries.assign(static_cast<std::size_t>(std::clamp(count, 1, most)), Entry{});
}

/// One declared key, from the table into the member.
template <class B, class Key>
void read_key(Keys& k, B& value, const Key& key) {
  using Kinds = KeysOf<B>;
  auto& member = value.*(key.member);
  if constexpr (std::is_same_v<Key, typename Kinds::Number>)
    member = key.preset.is_required ? k.number(key.name, key.unit) : k.number(key.name, key.unit, member);
  else if constexpr (std::is_same_v<Key, typename Kinds::MaybeNumber>)
    member = k.maybe_number(key.name, key.unit);
  else if constexpr (std::is_same_v<Key, typename Kinds::Count>)
    member = k.count(key.name, member);
  else if constexpr (std::is_same_v<Key, typename Kinds::Flag>)
    member = k.flag(key.name, member);
  else if constexpr (std::is_same_v<Key, typename Kinds::Text>)
    member = k.text(key.name, member);
  else if constexpr (std::is_same_v<Key, typename Kinds::Point>)
    member = k.point(key.name, member);
  else if constexpr (std::is_same_v<Key, typename Kinds::Points>)
    member = k.points(key.name);
  else if constexpr (requires { key.texts; })
    member = static_cast<std::decay_t<decltype(member)>>(
        k.choice(key.name, {key.texts.begin(), key.texts.end()}, static_cast<std::size_t>(member)));
  else if constexpr (requires { key.most; })
    read_count_or_entries(k, key.name, std::string(key.entry), key.most, member);
  else if constexpr (requires { key.entry; })
    read_entries(k, key.name, std::string(key.entry), member);
}

/// A rule about several keys, after all of them have been read.
template <class Rule>
void check_rule(Keys& k, const Rule& rule) {
  if constexpr (std::is_same_v<Rule, Together>) {
    if (k.has(rule.one) != k.has(rule.other))
      k.problem(fmt::format("{} and {} are given together; give both or neither", rule.one, rule.other));
  } else if constexpr (std::is_same_v<Rule, Instead>) {
    bool is_double = false;
    for (const std::string_view other : rule.of) is_double = is_double || k.has(other);
    if (is_double && k.has(rule.key))
      k.problem(fmt::format("{} define the same shape as {}; keep one of the two", rule.what, rule.others));
  }
}

template <DeclaresKeys B>
void read_declared_keys(Keys& k, B& value) {
  // First, so that its reason comes before a message on a missing key.
  for_each_key<B>([&](const auto& key) {
    if constexpr (std::is_same_v<std::decay_t<decltype(key)>, Refused>) k.refuse(key.name, std::string(key.why));
  });
  for_each_key<B>([&](const auto& key) {
    if constexpr (requires { key.member; }) read_key(k, value, key);
  });
  for_each_key<B>([&](const auto& rule) { check_rule(k, rule); });
}

/// Default of a key, for the manual: " = 0.4"; "" where it must be given.
template <class B, class Key>
std::string preset_text(const B& usual, const Key& key) {
  using Kinds = KeysOf<B>;
  if constexpr (requires { key.preset; }) {
    if (key.preset.is_required) return "";
    if (!key.preset.text.empty()) return fmt::format(" = {}", key.preset.text);
  }
  const auto& member = usual.*(key.member);
  if constexpr (std::is_same_v<Key, typename Kinds::Number>)
    return fmt::format(" = {:g}", member);
  else if constexpr (std::is_same_v<Key, typename Kinds::Count>)
    return fmt::format(" = {}", member);
  else if constexpr (std::is_same_v<Key, typename Kinds::Flag>)
    return member ? " = true" : " = false";
  else if constexpr (std::is_same_v<Key, typename Kinds::Text>)
    return fmt::format(" = \"{}\"", member);
  else if constexpr (std::is_same_v<Key, typename Kinds::Point>)
    return fmt::format(" = {{{:g}, {:g}}}", member.x(), member.y());
  else if constexpr (requires { key.texts; })
    return fmt::format(" = \"{}\"", key.texts[static_cast<std::size_t>(member)]);
  else if constexpr (requires { key.most; })
    return " = 1";
  return "";
}

/// The kind of a key as printed in the manual.
template <class B, class Key>
std::string_view kind_text(const Key& key) {
  using Kinds = KeysOf<B>;
  if constexpr (std::is_same_v<Key, typename Kinds::Number>) return "number";
  if constexpr (std::is_same_v<Key, typename Kinds::MaybeNumber>) return "number";
  if constexpr (std::is_same_v<Key, typename Kinds::Count>) return "integer";
  if constexpr (std::is_same_v<Key, typename Kinds::Flag>) return "flag";
  if constexpr (std::is_same_v<Key, typename Kinds::Point>) return "point";
  if constexpr (std::is_same_v<Key, typename Kinds::Points>) return "points";
  if constexpr (std::is_same_v<Key, typename Kinds::Text> || requires { key.texts; }) return "text";
  if constexpr (requires { key.entry; }) return requires {
      key.most;
    }
  ? key.name : "list";
}

/// The allowed numbers of a key, as the manual has them at the end of a line: "  <above 0>"; "" where any is allowed.
template <class B, class Key>
std::string range_text(const Key& key) {
  using Kinds = KeysOf<B>;
  if constexpr (std::is_same_v<Key, typename Kinds::Number> || std::is_same_v<Key, typename Kinds::MaybeNumber>)
    return key.range.least == -unbounded ? "" : fmt::format("  <{}>", key.range.text());
  else if constexpr (std::is_same_v<Key, typename Kinds::Count>)
    return key.least == -any_count ? ""
           : key.most == any_count ? fmt::format("  <at least {}>", key.least)
                                   : fmt::format("  <from {} to {}>", key.least, key.most);
  return "";
}

/// The keys of a builder as a page of the manual: a line each of name, kind, sentence and range.
template <DeclaresKeys B>
std::string declared_key_lines() {
  const B usual;
  std::string text;
  for_each_key<B>([&](const auto& key) {
    if constexpr (requires { key.member; }) {
      using Key = std::decay_t<decltype(key)>;
      std::string unit, optional, choices;
      if constexpr (requires { key.unit; }) unit = key.unit == "1" ? "" : fmt::format(" {}", key.unit);
      if constexpr (std::is_same_v<Key, typename KeysOf<B>::MaybeNumber>) optional = "?";
      if constexpr (
          requires { key.entry; } && !requires { key.most; })
        optional = "?";
      if constexpr (requires { key.texts; }) choices = fmt::format(": \"{}\"", fmt::join(key.texts, "\" or \""));
      text += fmt::format("{}{}  {}{}{}{}  {}{}{}", text.empty() ? "" : "\n", key.name, kind_text<B>(key), unit,
                          optional, preset_text(usual, key), key.sentence, choices, range_text<B>(key));
    }
  });
  return text;
}

}  // namespace trilith::script
