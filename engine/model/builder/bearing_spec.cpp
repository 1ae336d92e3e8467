#include "model/builder/bearing_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "model/plausible_ranges.hpp"

namespace trilith {
namespace {

bool is_none(const DirectionLaw& law) {
  return std::holds_alternative<std::monostate>(law);
}

void check_direction(const DirectionLaw& law) {
  std::visit(
      [](const auto& l) {
        if constexpr (!std::is_same_v<std::decay_t<decltype(l)>, std::monostate>) check_parameters(l);
        if constexpr (requires { l.check(); }) l.check();
      },
      law);
}

void add_direction_notes(const DirectionLaw& law, const std::string& owner, std::vector<std::string>& notes) {
  std::visit(
      [&](const auto& l) {
        if constexpr (Declared<std::decay_t<decltype(l)>>) add_plausibility_notes(notes, owner, l);
      },
      law);
}

template <int D>
std::vector<DirectionLaw> all_laws(const BearingSpecOf<D>& spec) {
  std::vector<DirectionLaw> laws(spec.law.begin(), spec.law.end());
  if constexpr (D == 3) laws.push_back(spec.horizontal);
  return laws;
}

template <int D>
std::vector<double> all_limits(const BearingSpecOf<D>& spec) {
  std::vector<double> limits(spec.limit.begin(), spec.limit.end());
  if constexpr (D == 3) limits.push_back(spec.horizontal_limit);
  return limits;
}

/// True for a law that both horizontal directions may share.
bool is_horizontal(const DirectionLaw& law) {
  return std::visit([](const auto& l) { return HorizontalLaw<std::decay_t<decltype(l)>>; }, law);
}

/// Only some laws support both horizontal directions; along and across must then have no single laws.
void check_horizontal(const BearingSpecOf<3>& spec, const std::string& owner) {
  if (is_none(spec.horizontal)) return;
  if (!is_none(spec.law[0]) || !is_none(spec.law[1]))
    throw InputError(owner +
                     ": both horizontal and along or across are given; horizontal is the law of both, so keep "
                     "horizontal or the others");
  if (is_horizontal(spec.horizontal)) return;
  std::string names;
  DirectionLaws::for_each([&]<class L>() {
    if constexpr (HorizontalLaw<L>) names += fmt::format("{}{}", names.empty() ? "" : ", ", L::name);
  });
  const std::string_view given = std::visit(
      [](const auto& l) -> std::string_view {
        if constexpr (Declared<std::decay_t<decltype(l)>>)
          return std::decay_t<decltype(l)>::name;
        else
          return "nothing";
      },
      spec.horizontal);
  throw InputError(
      fmt::format("{}: horizontal is {}, which has no circular form for both directions; give it to along and to "
                  "across, or use one of {}",
                  owner, given, names));
}

/// The name of a law with a friction coefficient, which acts under the bearing's compression; else "".
std::string_view name_of_slider(const DirectionLaw& law) {
  return std::visit(
      [](const auto& l) -> std::string_view {
        if constexpr (requires { l.mu; })
          return std::decay_t<decltype(l)>::name;
        else
          return "";
      },
      law);
}

template <int D>
constexpr const char* words_of_laws = D == 2 ? "along, axial or turning" : "along, across, horizontal or axial";
template <int D>
constexpr const char* words_of_limits =
    D == 2 ? "{ along = }, axial or turning" : "{ along = }, across, horizontal or axial";

/// Checks that a bearing has an effect, and has a limit if it has a successor.
template <int D>
void check_purpose(const BearingSpecOf<D>& spec, const std::string& owner) {
  const std::vector<DirectionLaw> laws = all_laws(spec);
  if (std::all_of(laws.begin(), laws.end(), is_none))
    throw InputError(
        fmt::format("{}: has no law, so it transfers no force; give {} a law such as trilith.linear{{...}}", owner,
                    words_of_laws<D>));
  const std::string& next = spec.contact_after.empty() ? spec.becomes_bearing : spec.contact_after;
  const std::vector<double> limits = all_limits(spec);
  if (!next.empty() && std::all_of(limits.begin(), limits.end(), [](double l) { return l == unbounded; }))
    throw InputError(
        fmt::format("{}: becomes '{}' at its limit, but has none; give limit = {}", owner, next, words_of_limits<D>));
  if (spec.becomes_bearing.empty() && std::count(spec.next_from_here.begin(), spec.next_from_here.end(), true) > 0)
    throw InputError(
        fmt::format("{}: becomes_from is \"here\", but no bearing is its successor; name one under becomes", owner));
}

}  // namespace

void require_compression(std::span<const DirectionLaw> laws, const DirectionLaw& axial, const std::string& owner) {
  if (!is_none(axial) && name_of_slider(axial).empty()) return;
  const auto slider =
      std::find_if(laws.begin(), laws.end(), [](const DirectionLaw& l) { return !name_of_slider(l).empty(); });
  if (slider == laws.end()) return;
  throw InputError(fmt::format(
      "{}: {} slides under the compression of the axial law, {}, so it never transfers a force; give axial a law that "
      "carries compression, such as trilith.linear{{...}}",
      owner, name_of_slider(*slider), is_none(axial) ? "which is missing" : "which is itself a sliding law"));
}

template <int D>
void check_bearing(const BearingSpecOf<D>& spec, const std::string& owner) {
  bool finite = spec.point_a.allFinite() && spec.point_b.allFinite();
  for_each_number(spec.angle, [&](double v) { finite = finite && std::isfinite(v); });
  if (!finite) throw InputError(owner + ": point or angle is not finite");
  for (const double limit : all_limits(spec))
    if (!(limit > 0)) throw InputError(fmt::format("{}: limit displacement is {:g}, must be above 0", owner, limit));
  for (const DirectionLaw& law : all_laws(spec)) check_direction(law);
  if constexpr (D == 3) check_horizontal(spec, owner);
  check_purpose(spec, owner);
  require_compression(all_laws(spec), spec.law[Directions<D>::axial], owner);
}

template <int D>
void add_bearing_plausibility_notes(const BearingSpecOf<D>& spec, const std::string& owner,
                                    std::vector<std::string>& notes) {
  for (const DirectionLaw& law : all_laws(spec)) add_direction_notes(law, owner, notes);
  for (std::size_t k = 0; k < spec.limit.size(); ++k)
    add_plausibility_note_once(notes, owner, "limit", unit_of_direction<D>(static_cast<int>(k)), spec.limit[k]);
  if constexpr (D == 3) add_plausibility_note_once(notes, owner, "limit", "m", spec.horizontal_limit);
  if (spec.replaces_contact && is_none(spec.law[Directions<D>::axial]))
    notes.push_back(
        fmt::format("{}: replaces_contact removes the flat contact of its bodies, but there is no axial law to replace "
                    "it; give axial, or leave replaces_contact out",
                    owner));
}

template <int D>
Bearing<D> bearing_of(const BearingSpecOf<D>& spec, const std::vector<std::string>& law_names,
                      const std::vector<BearingSpecOf<D>>& all) {
  Bearing<D> b;
  b.name = spec.name;
  b.angle = spec.angle, b.law = spec.law, b.limit = spec.limit;
  if constexpr (D == 3) b.horizontal = spec.horizontal, b.horizontal_limit = spec.horizontal_limit;
  b.replaces_contact = spec.replaces_contact;
  b.next_from_here = spec.next_from_here;
  b.starts_waiting = spec.starts_waiting;
  const auto place = [&](const std::vector<std::string>& known, const std::string& name, std::string_view what) {
    const auto it = std::find(known.begin(), known.end(), name);
    if (it == known.end())
      throw InputError(fmt::format("bearing '{}': becomes {} '{}', which does not exist{}", spec.name, what, name,
                                   name_hint(name, known)));
    return static_cast<int>(it - known.begin());
  };
  if (!spec.contact_after.empty()) b.contact_after = place(law_names, spec.contact_after, "contact law");
  if (!spec.becomes_bearing.empty()) {
    std::vector<std::string> known;
    for (const BearingSpecOf<D>& other : all) known.push_back(other.name);
    b.becomes_bearing = place(known, spec.becomes_bearing, "bearing");
  }
  return b;
}

template <int D>
void check_successor(const std::vector<Bearing<D>>& bearings, std::size_t row) {
  const Bearing<D>& b = bearings[row];
  if (b.becomes_bearing < 0) return;
  const int self = static_cast<int>(row);
  if (b.becomes_bearing == self)
    throw InputError(fmt::format(
        "bearing '{}': becomes itself, which has failed by then; name another bearing that has waiting = true",
        b.name));
  const Bearing<D>& next = bearings[static_cast<std::size_t>(b.becomes_bearing)];
  if (!next.starts_waiting)
    throw InputError(fmt::format(
        "bearing '{}': becomes '{}', which is active from the start; give it waiting = true, or name another", b.name,
        next.name));
  int at = next.becomes_bearing;
  for (std::size_t i = 0; i < bearings.size() && at >= 0 && at != self; ++i)
    at = bearings[static_cast<std::size_t>(at)].becomes_bearing;
  if (at == self)
    throw InputError(
        fmt::format("bearing '{}': becomes '{}', which leads back to '{}', which has failed by then; let the last "
                    "bearing become a contact law, or nothing",
                    b.name, next.name, b.name));
}

template <int D>
void require_near(const Vec<D>& point, double distance, double size, const std::string& body,
                  const std::string& owner) {
  if (distance <= size) return;
  std::string at;
  for_each_number(point, [&](double v) { at += fmt::format("{}{:g}", at.empty() ? "" : ", ", v); });
  throw InputError(
      fmt::format("{}: its point ({}) is {:.3g} m away from body '{}', which is {:.3g} m large; give a point in it or "
                  "near it, in m",
                  owner, at, distance, body, size));
}

template <int D>
void require_in_reach(const Vec<D>& point, double distance, double size, double arm, const std::string& body,
                      const std::string& owner) {
  constexpr double rounding = 1 + 1e-9;
  if (distance <= std::max(size, arm * rounding)) return;
  if (arm > 0)
    throw InputError(fmt::format(
        "{}: its point is {:.6g} m away from body '{}', and arm is {:g} m; move the point, or give an arm of "
        "at least {:.6g} m",
        owner, distance, body, arm, distance));
  try {
    require_near<D>(point, distance, size, body, owner);
  } catch (const InputError& e) {
    throw InputError(fmt::format("{}; or give arm = {:.4g} for a rigid arm of that length", e.what(), distance));
  }
}

template void check_bearing(const BearingSpecOf<2>&, const std::string&);
template void check_bearing(const BearingSpecOf<3>&, const std::string&);
template void add_bearing_plausibility_notes(const BearingSpecOf<2>&, const std::string&, std::vector<std::string>&);
template void add_bearing_plausibility_notes(const BearingSpecOf<3>&, const std::string&, std::vector<std::string>&);
template Bearing<2> bearing_of(const BearingSpecOf<2>&, const std::vector<std::string>&,
                               const std::vector<BearingSpecOf<2>>&);
template Bearing<3> bearing_of(const BearingSpecOf<3>&, const std::vector<std::string>&,
                               const std::vector<BearingSpecOf<3>>&);
template void check_successor(const std::vector<Bearing<2>>&, std::size_t);
template void check_successor(const std::vector<Bearing<3>>&, std::size_t);
template void require_near<2>(const Vec2&, double, double, const std::string&, const std::string&);
template void require_near<3>(const Vec3&, double, double, const std::string&, const std::string&);
template void require_in_reach<2>(const Vec2&, double, double, double, const std::string&, const std::string&);
template void require_in_reach<3>(const Vec3&, double, double, double, const std::string&, const std::string&);

}  // namespace trilith
