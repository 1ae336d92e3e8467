#include "integrate/implicit/alpha_method.hpp"

#include <fmt/format.h>

#include "integrate/implicit/implicit_step.hpp"
#include "model/pose.hpp"

namespace trilith {
namespace {

/// Reason of a step that did not converge: the place of the largest residual, and advice.
template <int D>
std::string stuck_reason(const Model<D>& model, const State<D>& state, const ImplicitStep& step) {
  const auto body_of = [&](int piece) { return model.bodies[model.piece_body[piece]].name; };
  if (step.through_a >= 0)
    return fmt::format(
        "every step from t = {:.6g} s on, down to {:.2g} s, moves '{}' and '{}' through each other. Use a smaller dt, "
        "check their speeds and the stiffness of their contact law, or continue with integrator = \"explicit\"",
        state.time, step.dt, body_of(step.through_a), body_of(step.through_b));
  const std::string where = step.worst < 0 ? "nowhere" : model.bodies[body_of_node(model, step.worst)].name;
  return fmt::format(
      "no step from t = {:.6g} s on converges, down to {:.2g} s: the residual is {:.2g} of the largest force, most of "
      "it on {}. Check contacts and yielding there, use a smaller dt or more damping, or continue with integrator = "
      "\"explicit\"",
      state.time, step.dt, step.left, where);
}

}  // namespace

template <int D>
StepResult AlphaMethod::step(const StepInput<D>& in) const {
  ImplicitOptions how;
  how.scheme = scheme(), how.dt = in.dt;
  how.tolerance = in.control.tolerance, how.accuracy = in.control.accuracy;
  how.shortest = in.control.shortest, how.give_up = in.control.give_up;
  how.is_stopped = in.control.is_stopped;
  const ImplicitStep step = advance_implicitly(in.model, in.state, in.work, in.energy, in.tangent, how, in.times);
  const bool is_stuck = !step.converged && !step.stopped;
  return {step.converged, step.dt, is_stuck ? stuck_reason(in.model, in.state, step) : ""};
}

template StepResult AlphaMethod::step(const StepInput<2>&) const;
template StepResult AlphaMethod::step(const StepInput<3>&) const;

}  // namespace trilith
