// Which contact law holds between which bodies, as it is said of a model: laws by name, and statements about pairs of
// materials, groups or bodies.
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
  /// Throws InputError for a name taken and for numbers out of range; adds to `notes` what is unusual.
  void add_law(const std::string& name, const ContactLaw& law, std::vector<std::string>& notes);
  /// Which law holds between two materials, groups or bodies ("*": any), which may be added later. The last statement
  /// that fits a pair of bodies wins. `law` "none": they never touch. Throws InputError where there is no such law.
  void set_contact(const std::string& a, const std::string& b, const std::string& law);
  [[nodiscard]] std::vector<std::string> law_names() const;
  [[nodiscard]] const std::vector<std::pair<std::string, ContactLaw>>& laws() const { return laws_; }

  /// A line for each statement about a name that nothing has; `bodies` have a name and groups.
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
  /// Writes laws, surfaces and their table into a model whose bodies have names, materials and groups. Throws
  /// InputError for a law of which not all equations act between bodies that it holds for.
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
  /// Throws InputError where a geometry in which two bodies may meet leaves out equations of their law.
  template <int D>
  void require_whole_laws(const Model<D>& model, const std::vector<const Body*>& example) const;

  std::vector<std::pair<std::string, ContactLaw>> laws_;
  std::map<std::string, int> law_rows_;  ///< rows of laws_ by name
  std::vector<Statement> statements_;
};

}  // namespace trilith
