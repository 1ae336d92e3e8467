#include "model/contact/contact_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/nearest.hpp"
#include "law/contact/form_check.hpp"
#include "model/check/missing_laws.hpp"
#include "model/names.hpp"
#include "model/plausible_ranges.hpp"

namespace trilith {
std::vector<std::string> ContactRules::law_names() const {
  std::vector<std::string> names;
  for (const auto& l : laws_) names.push_back(l.first);
  return names;
}

/// Its parameters are checked one by one, then together; allowed but implausible values are noted.
void ContactRules::add_law(const std::string& name, const ContactLaw& law, std::vector<std::string>& notes) {
  require_name(name, "contact law");
  if (law_rows_.contains(name))
    throw InputError(fmt::format("contact law '{}' exists already; give each its own name", name));
  std::visit(
      [&](const auto& l) {
        check_parameters(l);
        if constexpr (requires { l.check(); }) l.check();
        add_plausibility_notes(notes, fmt::format("contact law '{}'", name), l);
        if constexpr (requires { l.note(); })
          if (const std::string note = l.note(); !note.empty())
            notes.push_back(fmt::format("contact law '{}': {}", name, note));
      },
      law);
  law_rows_.emplace(name, static_cast<int>(laws_.size()));
  laws_.emplace_back(name, law);
}

void ContactRules::set_contact(const std::string& a, const std::string& b, const std::string& law) {
  if (law != "none" && !law_rows_.contains(law)) {
    std::vector<std::string> known = law_names();
    known.emplace_back("none");
    throw InputError(fmt::format("contact of '{}' and '{}': there is no law '{}'{}", a, b, law, name_hint(law, known)));
  }
  statements_.push_back({a, b, law});
}

int ContactRules::law_row(const std::string& name) const {
  const auto found = law_rows_.find(name);
  return found == law_rows_.end() ? -1 : found->second;
}

void ContactRules::inherit(const std::string& body, const std::string& heirs) {
  std::vector<Statement> all;
  for (const Statement& c : statements_) {
    all.push_back(c);
    if (c.a == body || c.b == body) all.push_back({c.a == body ? heirs : c.a, c.b == body ? heirs : c.b, c.law});
  }
  statements_ = std::move(all);
}

namespace {

/// Surfaces by all names that a statement may use for them.
class SurfaceNames {
 public:
  void add(const Body& body, int surface) {
    all_.push_back(surface);
    std::vector<std::string> names = body.groups;
    names.push_back(body.material);
    names.push_back(body.name);
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    for (const std::string& name : names) surfaces_[name].push_back(surface);
  }
  [[nodiscard]] const std::vector<int>& of(const std::string& name) const {
    static const std::vector<int> none;
    if (name == "*") return all_;
    const auto found = surfaces_.find(name);
    return found == surfaces_.end() ? none : found->second;
  }

 private:
  std::map<std::string, std::vector<int>> surfaces_;
  std::vector<int> all_;
};

}  // namespace

/// Bodies that no statement distinguishes share a surface: bodies with one material and one set of groups, unless a
/// statement names one of them.
template <int D>
std::vector<const Body*> ContactRules::assign_surfaces(Model<D>& model) const {
  std::set<std::string> named;
  for (const Statement& c : statements_) named.insert({c.a, c.b});
  std::map<std::pair<std::string, std::vector<std::string>>, int> surface;
  std::vector<const Body*> example;
  for (Body& body : model.bodies) {
    std::vector<std::string> key = body.groups;
    if (named.contains(body.name)) key.push_back(body.name);
    const auto [it, fresh] = surface.try_emplace({body.material, key}, static_cast<int>(surface.size()));
    body.surface = it->second;
    if (fresh) example.push_back(&body);
  }
  return example;
}

namespace {

/// The geometries in which two bodies may meet.
std::vector<ContactForm> meeting_forms(const Model<2>& /*model*/, const Body& /*a*/, const Body& /*b*/) {
  return {ContactForm::plane_faces, ContactForm::polygons};
}
std::vector<ContactForm> meeting_forms(const Model<3>& model, const Body& a, const Body& b) {
  bool sphere = false;
  for (const Body* body : {&a, &b})
    for (int p = body->first_piece; p < body->first_piece + body->pieces; ++p)
      sphere = sphere || model.piece_solid[static_cast<std::size_t>(p)].is_sphere();
  std::vector<ContactForm> forms{ContactForm::flat_faces, ContactForm::polyhedra};
  if (sphere) forms.push_back(ContactForm::spheres);
  return forms;
}

}  // namespace

/// One line for each law, for the first two bodies for which it does not hold as specified. The surface of a single
/// body never meets itself.
template <int D>
void ContactRules::require_whole_laws(const Model<D>& model, const std::vector<const Body*>& example) const {
  std::vector<const Body*> second(example.size(), nullptr);
  for (const Body& body : model.bodies)
    if (const auto s = static_cast<std::size_t>(body.surface); &body != example[s] && second[s] == nullptr)
      second[s] = &body;
  // Laws that act everywhere need no further check.
  std::set<int> told;
  for (std::size_t law = 0; law < laws_.size(); ++law)
    if (form_refusal(laws_[law].second, contact_forms).empty()) told.insert(static_cast<int>(law));
  if (told.size() == laws_.size()) return;
  std::string faults;
  for (std::size_t i = 0; i < example.size(); ++i)
    for (std::size_t j = i; j < example.size(); ++j) {
      const int law = model.law_of[i * example.size() + j];
      const Body* const other = i == j ? second[i] : example[j];
      if (law < 0 || other == nullptr || told.contains(law)) continue;
      const auto& [name, numbers] = laws_[static_cast<std::size_t>(law)];
      const std::string refusal = form_refusal(numbers, meeting_forms(model, *example[i], *other));
      if (refusal.empty()) continue;
      told.insert(law);
      faults += fmt::format("{}contact law '{}' ({}) between '{}' and '{}': {}", faults.empty() ? "" : "\n", name,
                            std::visit([](const auto& l) { return l.name; }, numbers), example[i]->name, other->name,
                            refusal);
    }
  if (!faults.empty()) throw InputError(faults);
}

/// For each pair of surfaces the last statement that matches both gives the law.
template <int D>
void ContactRules::fill(Model<D>& model) const {
  for (const auto& [name, law] : laws_) {
    model.laws.push_back(law);
    model.law_names.push_back(name);
  }
  const std::vector<const Body*> example = assign_surfaces(model);
  SurfaceNames names;
  for (std::size_t i = 0; i < example.size(); ++i) names.add(*example[i], static_cast<int>(i));
  model.surfaces = static_cast<int>(example.size());
  model.law_of.assign(example.size() * example.size(), undeclared_law);
  for (const Statement& c : statements_) {
    const int index = c.law == "none" ? -1 : law_rows_.at(c.law);
    for (const int i : names.of(c.a))
      for (const int j : names.of(c.b)) {
        model.law_of[static_cast<std::size_t>(i * model.surfaces + j)] = index;
        model.law_of[static_cast<std::size_t>(j * model.surfaces + i)] = index;
      }
  }
  require_whole_laws(model, example);
}

namespace {

/// Begins the name of the group of all parts of a body that has cracked (pieces_group).
constexpr std::string_view pieces_of = "pieces of ";

}  // namespace

/// A statement about an unknown name would never apply. The hint lists bodies only if a name is similar, because
/// hundreds of them do not help in a message.
void ContactRules::check_sides(std::vector<std::string> known, const std::vector<std::string>& bodies,
                               std::vector<std::string>& faults) const {
  std::set<std::string> any;
  std::vector<std::string> told;
  for (const std::string& name : known)
    if (any.insert(name).second) told.push_back(name);
  known = told;
  known.insert(known.end(), bodies.begin(), bodies.end());
  any.insert(bodies.begin(), bodies.end());
  for (const Statement& c : statements_)
    for (const std::string& side : {c.a, c.b}) {
      // Groups of parts of cracked bodies disappear where a run goes back in time.
      if (any.contains(side) || side.starts_with(pieces_of)) continue;
      const bool near = !nearest_name(side, known).empty();
      faults.push_back(fmt::format("contact of '{}' and '{}': there is no material, group or body '{}'{}", c.a, c.b,
                                   side, name_hint(side, near ? known : told)));
    }
}

template void ContactRules::fill(Model<2>&) const;
template void ContactRules::fill(Model<3>&) const;

}  // namespace trilith
