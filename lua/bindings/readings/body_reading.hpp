// What m:body, m:add and the bridge conveniences share: reading what a body is, but for its shape.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "bindings/core/handles.hpp"
#include "build/plane/part.hpp"

namespace trilith::script {

/// Everything a constructor says of a body besides name and outline.
struct BodyOptions {
  BodySpec spec;
  std::vector<std::string> fixed;                          ///< names or groups of the parts that are fixed
  std::vector<std::pair<std::string, BodySpec>> by_group;  ///< what holds instead for parts of that name or group
};

/// Reads material, groups, density, unit_weight, mass, weight, inertia, thickness, support, velocity, spin, load,
/// floating, body, hold and, for several parts, fixed and by_group, a table of these keys for each name or group.
/// Problems are noted in `keys`.
BodyOptions read_body_options(Keys& keys, bool several, const BodyForm& preset);

/// Reads `body`: "rigid", "quad" or { mesh = {nx, ny} }; `preset` where it is not there.
BodyForm read_body_form(Keys& keys, const BodyForm& preset);

/// Reads "fixed", "free" or { x =, y =, rotation = } under `key`; leaves `support` as it is where that is not there.
void read_support(Keys& keys, std::string_view key, std::array<Support, 3>& support);

/// Notes a problem where a density is so large that it must be a unit weight.
void check_density(Keys& keys, double density);
/// Notes a problem where a unit weight [N/m3] is not above 0, or beyond that density.
void check_unit_weight(Keys& keys, double weight);

/// Throws InputError where `fixed` or `by_group` names a part or group that is not among `parts`.
/// Options and parts of either dimension.
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

/// Adds a part as a body; its groups are the part's and those of the options. Of several entries of by_group that fit,
/// the one of the part's name counts, else the one of its first group.
void add_part(PlaneModel& model, const Part& part, const BodyOptions& options);

}  // namespace trilith::script
