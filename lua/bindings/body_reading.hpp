// What m:body, m:add and the bridge conveniences share: reading what a body is, but for its shape.
#pragma once

#include "handles.hpp"

namespace trilith::script {

/// Everything a constructor says of a body besides name and outline.
struct BodyOptions {
  BodySpec spec;
  std::vector<std::string> fixed;  ///< names or groups of the parts that are fixed
};

/// Reads material, groups, density, unit_weight, mass, weight, inertia, thickness, support, velocity, spin, load,
/// floating and, for several parts, fixed. Problems are noted in `keys`.
BodyOptions read_body_options(Keys& keys, bool several);

/// Notes a problem where a density is so large that it must be a unit weight.
void check_density(Keys& keys, double density);

/// Adds a part as a body; its groups are the part's and those of the options.
void add_part(ScriptModel& model, const Polygon& outline, const std::string& name,
              const std::vector<std::string>& groups, const BodyOptions& options);

}  // namespace trilith::script
