// Perturbation of one unknown of a state for finite differences of the forces.
#pragma once

#include <cstddef>

#include "assembly/implicit_turn.hpp"
#include "assembly/tangent/dof_graph.hpp"
#include "assembly/tangent/tangent.hpp"
#include "element/rigid/rigid.hpp"
#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// Size of the perturbation [m] or [rad]: small compared with overlaps of faces, large compared with rounding. It is
/// smaller for a short step, so that the velocity changes little. A rotation moves a point at the radius of gyration by
/// the same distance. `most`: upper limit, for example for faces in slight contact.
template <int D>
double perturbation_of(const Model<D>& model, const Freedom& f, const TangentOptions& options, double most = unbounded);

/// Pairs farther apart than this do not touch while an unknown is moved: rotation moves no corner by more than some
/// perturbations [m].
inline double reach_of_moves(const TangentOptions& options) {
  return 10 * (options.move > 0 ? options.move : 1e-8);
}

/// Upper limit of the perturbation as a share of the depth of a contact; a larger one would open the contact on one
/// side of the difference. It is at least `least_move` [m] because of rounding.
inline constexpr double share_of_depth = 0.01, least_move = 1e-13;

/// Moves an unknown by `by`, and its rate by `rate` times that, during its lifetime.
template <int D>
class Moved {
 public:
  Moved(State<D>& state, const Freedom& f, double by, double rate)
      : state_(state),
        node_(static_cast<std::size_t>(f.node)),
        was_{state.position[node_], state.rotation[node_], state.velocity[node_], state.spin[node_]} {
    if (is_turn<D>(f)) {
      const int axis = f.k - Space<D>::translations;
      turn_about(axis, by, state.rotation[node_]);
      number_at(axis, state.spin[node_]) += rate * by;
    } else {
      state.position[node_][f.k] += by, state.velocity[node_][f.k] += rate * by;
    }
  }
  Moved(const Moved&) = delete;
  Moved& operator=(const Moved&) = delete;
  ~Moved() {
    state_.position[node_] = was_.position, state_.rotation[node_] = was_.rotation;
    state_.velocity[node_] = was_.velocity, state_.spin[node_] = was_.spin;
  }

 private:
  State<D>& state_;
  const std::size_t node_;
  const NodeMotion<D> was_;
};

}  // namespace trilith
