// How far bodies have gone from where a search for rest began, and which of them have left their places.
//
// An equilibrium is that of the structure as it is drawn only where it lies near that configuration. A block that
// topples, a voussoir that falls and a plank that slides down come to rest too, somewhere else.
#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// A body may go by this share of its size, where nothing else is asked for.
constexpr double usual_travel = 0.25;

/// Where all nodes are at one instant.
template <int D>
struct Placement {
  std::vector<Vec<D>> position;       ///< [node] [m]
  std::vector<Rotation<D>> rotation;  ///< [node]
};
template <int D>
Placement<D> placement_of(const State<D>& state) {
  return {state.position, state.rotation};
}

/// How far a body has gone. Its size is twice the distance of its farthest point from its centre.
struct Travel {
  int body = -1;      ///< -1: none
  double moved = 0;   ///< the centre of a rigid body, the farthest node of a deformable one [m]
  double turned = 0;  ///< of a rigid body that is no sphere [rad]
  double share = 0;   ///< (moved + chord of the turn at its farthest point) / size [1]
  double fallen = 0;  ///< along gravity, as a share of the body's own height [1]
};

/// The body that has gone farthest by share of its size. Asked of all but those that are held or driven in every
/// direction, were removed, came later, or deform and are held somewhere: these bend as far as they are made to.
template <int D>
Travel farthest_travel(const Model<D>& model, const State<D>& state, const Placement<D>& from);

/// The same of bodies that have left their places: that went by more than `within` of their size or fell by more than
/// their own height. Bodies that nothing held up at `from` are on their way to a place and are not asked.
/// Travel::body is -1 where all stay.
template <int D>
Travel displaced_body(const Model<D>& model, const State<D>& state, const Placement<D>& from, double within);

/// "moved by 0.21 m and turned by 1 rad, 0.3 of its size"
std::string travel_text(const Travel& travel);

}  // namespace trilith
