// An unknown of a state moved a little, to see how forces answer.
#pragma once

#include "step/coupling.hpp"
#include "step/tangent.hpp"
#include "world/model.hpp"
#include "world/state.hpp"

namespace trilith {

/// How far an unknown is moved [m] or [rad]: small against overlaps of faces, large against rounding; over a short step
/// less, so that its velocity is not changed much. A rotation moves what is a radius of gyration away as far.
template <int D>
double disturbance_of(const Model<D>& model, const Freedom& f, const TangentOptions& options);

/// The number of State that an unknown stands for, and its rate.
inline double& place_of(State<2>& state, const Freedom& f) {
  return f.k == 2 ? state.rotation[f.node] : state.position[f.node][f.k];
}
inline double& rate_of(State<2>& state, const Freedom& f) {
  return f.k == 2 ? state.spin[f.node] : state.velocity[f.node][f.k];
}

/// Moves an unknown by `by`, its rate by `rate` times that, for as long as this lives.
class Moved {
 public:
  Moved(State<2>& state, const Freedom& f, double by, double rate)
      : place_(place_of(state, f)), rate_(rate_of(state, f)), was_(place_), ran_(rate_) {
    place_ += by, rate_ += rate * by;
  }
  Moved(const Moved&) = delete;
  Moved& operator=(const Moved&) = delete;
  ~Moved() { place_ = was_, rate_ = ran_; }

 private:
  double &place_, &rate_;
  const double was_, ran_;
};

}  // namespace trilith
