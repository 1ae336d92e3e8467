// What the supports of a body do to it: the forces that hold or drive its nodes.
#pragma once

#include <vector>

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// On one node, along the directions in which it is held or driven alone.
template <int D>
struct Reaction {
  int node = -1;
  Vec<D> place = Vec<D>::Zero();          ///< [m]
  Vec<D> force = Vec<D>::Zero();          ///< [N]
  Moment<D> moment = nothing<Spin<D>>();  ///< about the node, about the axes of the world [N m]
};

/// Of each node of a body that is held or driven along or about some axis, in their order: what makes up for all other
/// forces on it, its weight with them, and takes it along, m a - F. `work` must hold the evaluation of the present
/// instant. Where a bearing or a contact holds a body there is no support and no reaction.
template <int D>
std::vector<Reaction<D>> reactions(const Model<D>& model, const State<D>& state, const Work<D>& work, int body);

}  // namespace trilith
