#include "world/contact_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/nearest.hpp"
#include "world/names.hpp"
#include "world/usual.hpp"

namespace trilith {

std::vector<std::string> ContactRules::law_names() const {
  std::vector<std::string> names;
  for (const auto& l : laws_) names.push_back(l.first);
  return names;
}

/// Its parameters are checked one by one, then together, and what is possible and yet unlikely is noted.
void ContactRules::add_law(const std::string& name, const ContactLaw& law, std::vector<std::string>& notes) {
  require_name(name, "contact law");
  require_new(laws_, name, "contact law", [](const auto& l) { return l.first; });
  std::visit(
      [&](const auto& l) {
        check_parameters(l);
        if constexpr (requires { l.check(); }) l.check();
        add_doubts(notes, fmt::format("contact law '{}'", name), l);
        if constexpr (requires { l.note(); })
          if (const std::string note = l.note(); !note.empty())
            notes.push_back(fmt::format("contact law '{}': {}", name, note));
      },
      law);
  laws_.emplace_back(name, law);
}

void ContactRules::set_contact(const std::string& a, const std::string& b, const std::string& law) {
  std::vector<std::string> known = law_names();
  known.emplace_back("none");
  if (std::find(known.begin(), known.end(), law) == known.end())
    throw InputError(fmt::format("contact of '{}' and '{}': there is no law '{}'{}", a, b, law, name_hint(law, known)));
  statements_.push_back({a, b, law});
}

/// Statements become a table: bodies that no statement tells apart share a surface, and of each pair of surfaces the
/// last statement that fits both gives the law.
template <int D>
void ContactRules::fill(Model<D>& model) const {
  for (const auto& [name, law] : laws_) {
    model.laws.push_back(law);
    model.law_names.push_back(name);
  }
  // Bodies of one material and one set of groups share a surface, unless a statement names one of them.
  std::map<std::pair<std::string, std::vector<std::string>>, int> surface;
  std::vector<const Body*> example;
  for (Body& body : model.bodies) {
    std::vector<std::string> key = body.groups;
    for (const Statement& c : statements_)
      if (c.a == body.name || c.b == body.name) key.push_back(body.name);
    const auto [it, fresh] = surface.try_emplace({body.material, key}, static_cast<int>(surface.size()));
    body.surface = it->second;
    if (fresh) example.push_back(&body);
  }
  const auto fits = [](const Body& body, const std::string& name) {
    return name == "*" || body.material == name || body.name == name ||
           std::find(body.groups.begin(), body.groups.end(), name) != body.groups.end();
  };
  model.surfaces = static_cast<int>(surface.size());
  model.law_of.assign(surface.size() * surface.size(), -1);
  for (const Statement& c : statements_) {
    const auto law = std::find(model.law_names.begin(), model.law_names.end(), c.law);
    const int index = c.law == "none" ? -1 : static_cast<int>(law - model.law_names.begin());
    for (std::size_t i = 0; i < example.size(); ++i)
      for (std::size_t j = 0; j < example.size(); ++j)
        if ((fits(*example[i], c.a) && fits(*example[j], c.b)) || (fits(*example[i], c.b) && fits(*example[j], c.a)))
          model.law_of[i * surface.size() + j] = index;
  }
}

/// A statement about a name that nothing has would never hold. Hundreds of bodies are no help in a message, so the hint
/// names them only where one is near.
void ContactRules::check_sides(std::vector<std::string> known, const std::vector<std::string>& bodies,
                               std::vector<std::string>& faults) const {
  std::vector<std::string> told;
  for (const std::string& name : known)
    if (std::find(told.begin(), told.end(), name) == told.end()) told.push_back(name);
  known = told;
  known.insert(known.end(), bodies.begin(), bodies.end());
  for (const Statement& c : statements_)
    for (const std::string& side : {c.a, c.b}) {
      if (std::find(known.begin(), known.end(), side) != known.end()) continue;
      const bool near = !nearest_name(side, known).empty();
      faults.push_back(fmt::format("contact of '{}' and '{}': there is no material, group or body '{}'{}", c.a, c.b,
                                   side, name_hint(side, near ? known : told)));
    }
}

template void ContactRules::fill(Model<2>&) const;
template void ContactRules::fill(Model<3>&) const;

}  // namespace trilith
