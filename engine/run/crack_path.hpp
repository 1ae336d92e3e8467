// Load paths (statics/load_path.hpp) of bodies that crack on them.
//
// The path stops shortly before a section reaches its strength, and the body is divided there. If the law of its planes
// softens, the joint of the parts carries the stress of the section on its elastic branch, so the equilibrium remains.
// The path then follows its peak and its softening as in mortar, past snap-back. The parts of a brittle body have
// no bond: rest is found again at the same displacement of the loaded points, under another load.
#pragma once

#include <functional>
#include <type_traits>
#include <vector>

#include "edit/split.hpp"
#include "statics/load_path.hpp"

namespace trilith {

template <int D>
using CrackBuilder = std::conditional_t<D == 2, ModelBuilder, SolidModelBuilder>;

/// The model of a path, with its loads at factor 1, and the builder that has made it.
template <int D>
struct CrackPath {
  CrackBuilder<D> builder;
  Model<D> model;
  State<D> state;
  std::vector<CrackingBody<D>> bodies;  ///< that may crack; empty: as statics/load_path.hpp
  /// Called at each point at which bodies crack, after `goes_on` of this point, when the model has their parts. May be
  /// empty.
  std::function<void(const std::vector<Crack<D>>&)> on_cracks;
};

/// Follows the path from rest at options.begin, and brings model, state, builder and bodies to the last point. Points
/// and events count through all cracks, with one event unit.cracked for each. The followed displacement belongs to the
/// scaled point loads, which need a name; `followed` of the options is not used. Errors as of follow_loads.
template <int D>
LoadPath follow_loads(CrackPath<D>& path, LoadPathOptions<D> options);

/// The scaled loads at factor 1 as rows of a push along `direction`.
template <int D>
std::vector<PushRow<D>> rows_of_loads(const Model<D>& model, const std::string& loads, const Vec<D>& direction);

}  // namespace trilith
