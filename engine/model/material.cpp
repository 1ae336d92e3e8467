#include "model/material.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/nearest.hpp"
#include "model/names.hpp"
#include "model/plausible_ranges.hpp"

namespace trilith {

void check_material(const Material& material, const std::vector<Material>& others, std::vector<std::string>& notes) {
  require_name(material.name, "material");
  require_new(others, material.name, "material", [](const Material& m) { return m.name; });
  const std::string owner = fmt::format("material '{}'", material.name);
  require_positive(material.density, owner + ": density", "kg/m3");
  add_plausibility_note(notes, owner, "density", "kg/m3", material.density);
  if (material.band) {
    check_parameters(*material.band), material.band->check();
    if (!material.solid) throw InputError(owner + ": band_damping needs a stiffness; give E too");
  }
  if (material.solid) std::visit([&](const auto& l) { add_plausibility_notes(notes, owner, l); }, material.solid->law);
}

void require_material(const std::vector<Material>& materials, const std::string& name, const std::string& owner) {
  if (std::any_of(materials.begin(), materials.end(), [&](const Material& m) { return m.name == name; })) return;
  std::vector<std::string> known;
  for (const Material& m : materials) known.push_back(m.name);
  throw InputError(fmt::format("{}: there is no material '{}'{}", owner, name, name_hint(name, known)));
}

}  // namespace trilith
