// Common readers of m:body, m:add and the bridge builders: options of a body except its shape.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "bindings/core/handles.hpp"
#include "build/plane/part.hpp"

namespace trilith::script {

/// All options of a body except name and outline.
struct BodyOptions {
  BodySpec spec;
  std::vector<std::string> fixed;                          ///< names or groups of the parts that are fixed
  std::vector<std::pair<std::string, BodySpec>> by_group;  ///< replacing options for parts of that name or group
};

/// Reads material, groups, density, unit_weight, mass, weight, inertia, thickness, support, velocity, spin, load,
/// floating, body, hold and, for several parts, fixed and by_group, a table of these keys for each name or group.
/// Problems are noted in `keys`.
BodyOptions read_body_options(Keys& keys, bool several, const BodyForm& preset);

/// Reads `body`: "rigid", "quad" or { mesh = {nx, ny} }; `preset` if not given.
BodyForm read_body_form(Keys& keys, const BodyForm& preset);

/// Reads "fixed", "free" or { x =, y =, rotation = } under `key`; `support` remains unchanged if not given.
void read_support(Keys& keys, std::string_view key, std::array<Support, 3>& support);

/// Notes a problem if a density is so large that it must be a unit weight.
void check_density(Keys& keys, double density);
/// Notes a problem if a unit weight [N/m3] is not above 0, or beyond that density.
void check_unit_weight(Keys& keys, double weight);

/// Throws InputError if `fixed` or `by_group` names an unknown part or group. Options and parts of either dimension.
template <class Options, class AnyPart>
void check_named(const Options& options, const std::vector<AnyPart>& parts, const std::string& owner) {
  std::vector<std::string> groups, names;
  const auto is_in = [](const std::vector<std::string>& list, const std::string& name) {
    return std::find(list.begin(), list.end(), name) != list.end();
  };
  for (const AnyPart& part : parts) {
    names.push_back(part.name);
    for (const std::string& group : part.groups)
      if (!is_in(groups, group)) groups.push_back(group);
  }
  const auto check = [&](const std::string& name, const char* key) {
    if (!is_in(groups, name) && !is_in(names, name))
      throw InputError(fmt::format("{}: {} names '{}', but there is no such group or part{}", owner, key, name,
                                   name_hint(name, groups)));
  };
  for (const std::string& name : options.fixed) check(name, "fixed");
  for (const auto& [name, spec] : options.by_group) check(name, "by_group");
}

/// Adds a part as a body, with the groups of the part and of the options. If several entries of by_group apply, the
/// entry of the part's name counts, otherwise the entry of its first group.
void add_part(PlaneModel& model, const Part& part, const BodyOptions& options);

}  // namespace trilith::script
