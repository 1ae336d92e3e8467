// Displacements of bodies from the start of a search for rest, and bodies that have left their places.
//
// An equilibrium is valid for the drawn structure only near that configuration. A toppled block, a fallen voussoir and
// a plank that slid down come to rest too, in another place.
#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// Default limit of the displacement of a body as a share of its size.
constexpr double usual_travel = 0.25;

/// Positions of all nodes at one instant.
template <int D>
struct Placement {
  std::vector<Vec<D>> position;       ///< [node] [m]
  std::vector<Rotation<D>> rotation;  ///< [node]
};
template <int D>
Placement<D> placement_of(const State<D>& state) {
  return {state.position, state.rotation};
}

/// Displacement of a body. Its size is twice the distance of its farthest point from its centre.
struct Travel {
  int body = -1;      ///< -1: none
  double moved = 0;   ///< the centre of a rigid body, the farthest node of a deformable one [m]
  double turned = 0;  ///< of a rigid body, except a sphere [rad]
  double share = 0;   ///< (moved + chord of the turn at its farthest point) / size [1]
  double fallen = 0;  ///< along gravity, as a share of the body's own height [1]
};

/// The body with the largest displacement as a share of its size. Some bodies are not considered: bodies that are fixed
/// or driven in every direction, removed or added later, and deformable bodies with some support, which bend as
/// designed.
template <int D>
Travel farthest_travel(const Model<D>& model, const State<D>& state, const Placement<D>& from);

/// The body that has left its place: it moved by more than `within` of its size or fell by more than its own height.
/// Bodies without support at `from` are still on their way and are not considered. Travel::body is -1 if there is none.
template <int D>
Travel displaced_body(const Model<D>& model, const State<D>& state, const Placement<D>& from, double within);

/// "moved by 0.21 m and rotated by 1 rad, 0.3 of its size"
std::string travel_text(const Travel& travel);

}  // namespace trilith
