// Support reactions of a body: the forces that fix or drive its nodes.
#pragma once

#include <vector>

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Reaction on one node, along its fixed or driven directions only.
template <int D>
struct Reaction {
  int node = -1;
  Vec<D> place = Vec<D>::Zero();          ///< [m]
  Vec<D> force = Vec<D>::Zero();          ///< [N]
  Moment<D> moment = nothing<Spin<D>>();  ///< about the node, in world axes [N m]
};

/// Reactions of all fixed or driven nodes of a body, in their order: m a - F, with the sum F of all other forces,
/// weight included, and the acceleration a of the support. `work` must be evaluated at the present instant. Bearings
/// and contacts are not supports and give no reaction.
template <int D>
std::vector<Reaction<D>> reactions(const Model<D>& model, const State<D>& state, const Work<D>& work, int body);

}  // namespace trilith
