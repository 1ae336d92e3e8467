// Contact laws between bodies, as specified for a model: named laws, and statements about pairs of materials, groups or
// bodies.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "model/material.hpp"
#include "model/model.hpp"

namespace trilith {

class ContactRules {
 public:
  /// Throws InputError for a name in use and for parameters out of range; adds unusual values to `notes`.
  void add_law(const std::string& name, const ContactLaw& law, std::vector<std::string>& notes);
  /// Sets the law between two materials, groups or bodies ("*": any), which may be added later. The last statement that
  /// matches a pair of bodies is used. `law` "none": they never touch. Throws InputError if the law does not exist.
  void set_contact(const std::string& a, const std::string& b, const std::string& law);
  /// Every statement about `body` also holds for the group `heirs`, with the same precedence.
  void inherit(const std::string& body, const std::string& heirs);
  /// Index of the law of that name in Model::laws, or -1.
  [[nodiscard]] int law_row(const std::string& name) const;
  [[nodiscard]] std::vector<std::string> law_names() const;
  [[nodiscard]] const std::vector<std::pair<std::string, ContactLaw>>& laws() const { return laws_; }

  /// Adds a line for each statement about an unknown name; `bodies` have a name and groups.
  template <class Bodies>
  void check(const Bodies& bodies, const std::vector<Material>& materials, std::vector<std::string>& faults) const {
    std::vector<std::string> known{"*"}, names;
    for (const Material& m : materials) known.push_back(m.name);
    for (const auto& b : bodies) {
      known.insert(known.end(), b.groups.begin(), b.groups.end());
      names.push_back(b.name);
    }
    check_sides(std::move(known), names, faults);
  }
  /// Writes laws, surfaces and their table to a model whose bodies have names, materials and groups. Throws InputError
  /// for a law with equations that do not act between all its bodies.
  template <int D>
  void fill(Model<D>& model) const;

 private:
  struct Statement {
    std::string a, b, law;
  };
  void check_sides(std::vector<std::string> known, const std::vector<std::string>& bodies,
                   std::vector<std::string>& faults) const;

  template <int D>
  std::vector<const Body*> assign_surfaces(Model<D>& model) const;
  /// Throws InputError if some equations of a law do not act in a geometry in which two of its bodies may meet.
  template <int D>
  void require_whole_laws(const Model<D>& model, const std::vector<const Body*>& example) const;

  std::vector<std::pair<std::string, ContactLaw>> laws_;
  std::map<std::string, int> law_rows_;  ///< indices into laws_ by name
  std::vector<Statement> statements_;
};

}  // namespace trilith
