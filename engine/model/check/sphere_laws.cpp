#include "model/check/sphere_laws.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace trilith {
namespace {

bool has_sphere(const Model<3>& model, const Body& body) {
  const auto first = model.piece_solid.begin() + body.first_piece;
  return std::any_of(first, first + body.pieces, [](const ConvexSolid& piece) { return piece.is_sphere(); });
}

/// Keys of a law with nonzero values that sphere contact ignores: all except pressure and friction.
std::vector<std::string> idle_keys(const ContactLaw& law) {
  std::vector<std::string> keys;
  if (!may_bond(law)) return keys;
  std::visit(
      [&](const auto& l) {
        for (const auto& p : l.parameters()) {
          const std::string_view key = p.name;
          if (key == "kn" || key == "ks" || key == "mu" || key == "beta") continue;
          if (l.*(p.member) != 0 && l.*(p.member) != p.preset) keys.emplace_back(key);
        }
      },
      law);
  return keys;
}

/// At most three names, and the number of further ones.
std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 3;
  std::vector<std::string> quoted;
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i) quoted.push_back(fmt::format("'{}'", names[i]));
  const std::string shown = fmt::format("{}", fmt::join(quoted, ", "));
  return names.size() <= most ? shown : fmt::format("{} and {} more", shown, names.size() - most);
}

/// Names of the bodies from `first` on that contain spheres, for each law of their surfaces.
std::vector<std::vector<std::string>> spheres_by_law(const Model<3>& model, int first) {
  std::vector<std::vector<std::string>> out(model.laws.size());
  for (std::size_t b = static_cast<std::size_t>(first); b < model.bodies.size(); ++b) {
    const Body& body = model.bodies[b];
    if (!has_sphere(model, body)) continue;
    for (int s = 0; s < model.surfaces; ++s) {
      const int law = model.law_of[body.surface * model.surfaces + s];
      if (law < 0) continue;
      std::vector<std::string>& names = out[static_cast<std::size_t>(law)];
      if (names.empty() || names.back() != body.name) names.push_back(body.name);
    }
  }
  return out;
}

}  // namespace

void note_sphere_laws(const Model<3>& model, int first, std::vector<std::string>& notes) {
  const std::vector<std::vector<std::string>> spheres = spheres_by_law(model, first);
  for (std::size_t law = 0; law < model.laws.size(); ++law) {
    const std::vector<std::string>& bodies = spheres[law];
    if (bodies.empty()) continue;
    const std::vector<std::string> keys = idle_keys(model.laws[law]);
    if (keys.empty()) continue;
    notes.push_back(
        fmt::format("contact law '{}': contacts of spheres use only kn, ks, mu and beta, so {} {} not act on {}; use "
                    "trilith.frictional for them, or polyhedra if the bond must hold",
                    model.law_names[law], fmt::join(keys, ", "), keys.size() == 1 ? "does" : "do", listed(bodies)));
  }
}

}  // namespace trilith
