// Data of a model that move from a body that has split to its parts: motion, bearings, seats and loads.
#pragma once

#include <utility>
#include <vector>

#include "edit/split_contacts.hpp"
#include "load/list.hpp"
#include "model/crack_planes.hpp"
#include "model/state.hpp"

namespace trilith {

/// Sets the motion of both parts to the rigid motion of their body, and deactivates the body at the present time.
template <int D>
void place_parts(const Model<D>& model, State<D>& state, const SplitBody& split);

/// Attaches bearings, seats, loads and displacement controls of the body to the part that holds their point. A load on
/// a face that spans the plane is divided by its kind, see load/load_kind.hpp.
template <int D>
void hand_over_links(Model<D>& model, const SplitBody& split, const CrackSection<D>& section);

/// Replaces each load of a model, except inertia, by the loads that give(load, list) appends.
template <int D, class Give>
void replace_loads(Model<D>& model, Give&& give) {
  model.loads.for_each_kind([&]<class L>(std::vector<L>& loads) {
    if constexpr (acts_in<L, D> && !is_inertia<L>) {
      std::vector<L> given;
      for (const L& load : loads) give(load, given);
      loads = std::move(given);
    }
  });
}

}  // namespace trilith
