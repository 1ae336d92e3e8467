// Laws to test with, made from what they declare: a new law is tested by standing in the list of its room.
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

/// `share` of the usual number for a parameter's unit, which is 1 where there is none, moved into its range.
template <class L>
double usual_number(const Parameter<L>& p, const UsualNumbers& usual, double share = 1) {
  const auto row = std::find_if(usual.begin(), usual.end(), [&](const auto& u) { return u.first == p.unit; });
  const double number = std::clamp(share * (row == usual.end() ? 1.0 : row->second), p.least, p.most);
  if (p.allows(number)) return number;
  return p.most < unbounded ? 0.5 * (p.least + p.most) : p.least + 1;
}

/// A law with the usual number for whatever must be given, and all else as preset. A law that has numbers beside those
/// it declares, or numbers that must fit each other, says what it is like by a `static L sample()` of its own.
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

/// Whether the numbers of a law go together.
template <class L>
bool is_allowed(const L& law) {
  if constexpr (requires { law.check(); }) try {
      law.check();
    } catch (const InputError&) {
      return false;
    }
  return true;
}

/// The sample; for each number with a preset one more law, which has half the usual number there, so that it stays
/// below those that must be given (dilation below friction); and one with all of those, as some only matter together.
template <Declared L>
std::vector<L> samples(const UsualNumbers& usual) {
  std::vector<L> all{sample<L>(usual)};
  L changed = all.front();
  for (const Parameter<L>& p : L::parameters()) {
    const double number = usual_number(p, usual, 0.5);
    if (p.required() || number == p.preset) continue;
    L one = all.front();
    one.*(p.member) = number;
    if (!is_allowed(one)) one.*(p.member) = p.most;  // a choice between its ends
    changed.*(p.member) = one.*(p.member);
    all.push_back(one);
  }
  if (all.size() > 2) all.push_back(changed);
  return all;
}

}  // namespace trilith::testing
