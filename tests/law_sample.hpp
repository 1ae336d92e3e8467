// Laws for tests, made from their declarations: a new law is tested as soon as it is in the list of its room.
#pragma once

#include <algorithm>
#include <concepts>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/schema.hpp"

namespace trilith::testing {

/// A usual number for each unit, in one room.
using UsualNumbers = std::vector<std::pair<std::string_view, double>>;

/// `share` of the usual number for a parameter's unit, which is 1 if none is given, clamped to its range.
template <class L>
double usual_number(const Parameter<L>& p, const UsualNumbers& usual, double share = 1) {
  const auto row = std::find_if(usual.begin(), usual.end(), [&](const auto& u) { return u.first == p.unit; });
  const double number = std::clamp(share * (row == usual.end() ? 1.0 : row->second), p.least, p.most);
  if (p.allows(number)) return number;
  return p.most < unbounded ? 0.5 * (p.least + p.most) : p.least + 1;
}

/// A law with the usual number for each required parameter, and defaults otherwise. A law with undeclared numbers, or
/// with numbers that depend on each other, provides a `static L sample()` of its own.
template <Declared L>
L sample(const UsualNumbers& usual) {
  if constexpr (requires {
                  { L::sample() } -> std::same_as<L>;
                }) {
    return L::sample();
  } else {
    L law{};
    for (const Parameter<L>& p : L::parameters()) law.*(p.member) = p.required() ? usual_number(p, usual) : p.preset;
    return law;
  }
}

/// Whether the numbers of a law are consistent.
template <class L>
bool is_allowed(const L& law) {
  if constexpr (requires { law.check(); }) try {
      law.check();
    } catch (const InputError&) {
      return false;
    }
  return true;
}

/// The sample; one more law for each number with a default; and one with all of these changes, because some have an
/// effect only together. The changed number is half of the usual one, so that it stays below the required ones
/// (dilation below friction).
template <Declared L>
std::vector<L> samples(const UsualNumbers& usual) {
  std::vector<L> all{sample<L>(usual)};
  L changed = all.front();
  for (const Parameter<L>& p : L::parameters()) {
    const double number = usual_number(p, usual, 0.5);
    if (p.required() || number == p.preset) continue;
    L one = all.front();
    one.*(p.member) = number;
    if (!is_allowed(one)) {
      L with_others = changed;  // a number that needs another one
      with_others.*(p.member) = number;
      if (is_allowed(with_others))
        one = with_others;
      else
        one.*(p.member) = p.most;  // a choice between its ends
    }
    changed.*(p.member) = one.*(p.member);
    all.push_back(one);
  }
  if (all.size() > 2) all.push_back(changed);
  return all;
}

}  // namespace trilith::testing
