#include "model/check/missing_laws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/error.hpp"

namespace trilith {
namespace {

/// Largest number of pairs that are listed.
constexpr std::size_t most_listed = 5;

/// Bodies of one surface: statements do not distinguish them.
struct SurfaceBodies {
  int moving[2] = {-1, -1}, held[2] = {-1, -1};  ///< up to two bodies of each kind, -1: none

  void add(int body, bool moves) {
    int* const of = moves ? moving : held;
    if (of[0] < 0)
      of[0] = body;
    else if (of[1] < 0)
      of[1] = body;
  }
  [[nodiscard]] int any() const { return moving[0] >= 0 ? moving[0] : held[0]; }
};

/// Two bodies of these surfaces, at least one of which moves, the moving one first; -1: there are none.
std::pair<int, int> may_meet(const SurfaceBodies& a, const SurfaceBodies& b) {
  if (a.moving[0] >= 0) return {a.moving[0], b.any()};
  return {b.moving[0], a.moving[0] < 0 && b.moving[0] < 0 ? -1 : a.any()};
}
std::pair<int, int> may_meet(const SurfaceBodies& a) {
  return {a.moving[0], a.moving[1] >= 0 ? a.moving[1] : a.held[0]};
}

/// A body without pieces has no contact.
template <int D>
std::vector<SurfaceBodies> bodies_by_surface(const Model<D>& model) {
  std::vector<SurfaceBodies> out(static_cast<std::size_t>(model.surfaces));
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    if (model.bodies[b].pieces > 0)
      out[static_cast<std::size_t>(model.bodies[b].surface)].add(static_cast<int>(b),
                                                                 model.body_moves(static_cast<int>(b)));
  return out;
}

/// Its material in a statement, or its name if it has none.
const std::string& side_of(const Body& body) {
  return body.material.empty() ? body.name : body.material;
}

std::string line_of(const Body& a, const Body& b, const std::string& left, const std::string& right, bool special) {
  const auto described = [](const Body& body) {
    return body.material.empty() ? fmt::format("'{}'", body.name) : fmt::format("'{}' ({})", body.name, body.material);
  };
  return fmt::format(
      "{} and {} have no contact law and would pass through each other; add m:contact {{ between = {{ \"{}\", \"{}\" "
      "}}, "
      "law = trilith.frictional {{ kn = , ks = , mu = }} }}, or law = \"none\" if that is intended{}",
      described(a), described(b), left, right,
      special ? ", before the calls for groups and bodies: the last call that fits a pair takes precedence" : "");
}

using Sides = std::pair<std::string, std::string>;

Sides sides_of(const Body& a, const Body& b) {
  return std::minmax(side_of(a), side_of(b));
}

/// Calls f(a, b, declared) with two example bodies for each pair of surfaces with bodies that may meet.
template <int D, class F>
void each_meeting(const Model<D>& model, F&& f) {
  const std::vector<SurfaceBodies> surface = bodies_by_surface(model);
  for (std::size_t i = 0; i < surface.size(); ++i)
    for (std::size_t j = i; j < surface.size(); ++j) {
      const auto [a, b] = i == j ? may_meet(surface[i]) : may_meet(surface[i], surface[j]);
      if (a >= 0 && b >= 0) f(a, b, model.law_of[i * surface.size() + j] != undeclared_law);
    }
}

/// Pairs of surfaces with bodies that may meet, keyed by their names in a statement. `declared` is only filled if some
/// are missing: names are costly to compare for all pairs of many surfaces.
struct MeetingSurfaces {
  std::map<Sides, std::pair<int, int>> missing;  ///< example bodies
  std::set<Sides> declared;                      ///< pairs of materials with a statement for some bodies

  template <int D>
  explicit MeetingSurfaces(const Model<D>& model) {
    each_meeting(model, [&](int a, int b, bool has_law) {
      if (!has_law) missing.try_emplace(sides_of(model.bodies[a], model.bodies[b]), std::pair(a, b));
    });
    if (missing.empty()) return;
    each_meeting(model, [&](int a, int b, bool has_law) {
      if (has_law) declared.insert(sides_of(model.bodies[a], model.bodies[b]));
    });
  }
};

}  // namespace

/// One pass over the bodies, then over pairs of surfaces, whose number depends on the statements. If no pair has a
/// statement, one for all bodies is suggested.
template <int D>
std::vector<std::string> missing_laws(const Model<D>& model) {
  const MeetingSurfaces found(model);
  const bool none = found.declared.empty() && found.missing.size() > 1;
  std::vector<std::string> lines;
  for (const auto& [sides, pair] : found.missing) {
    if (lines.size() == (none ? 1 : most_listed)) {
      lines.push_back(
          fmt::format("and {} more pairs of materials without a contact law", found.missing.size() - lines.size()));
      break;
    }
    const Body &a = model.bodies[pair.first], &b = model.bodies[pair.second];
    lines.push_back(
        line_of(a, b, none ? "*" : sides.first, none ? "*" : sides.second, found.declared.count(sides) > 0));
  }
  return lines;
}

template <int D>
void require_laws(const Model<D>& model) {
  std::string all;
  for (const std::string& line : missing_laws(model)) all += (all.empty() ? "" : "\n  ") + line;
  if (!all.empty()) throw InputError(all);
}

template std::vector<std::string> missing_laws(const Model<2>&);
template std::vector<std::string> missing_laws(const Model<3>&);
template void require_laws(const Model<2>&);
template void require_laws(const Model<3>&);

}  // namespace trilith
