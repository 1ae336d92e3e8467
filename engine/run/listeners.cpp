#include "run/listeners.hpp"

#include <utility>

namespace trilith {
namespace {

template <class... Told>
std::function<void(Told...)> after(std::function<void(Told...)> first, std::function<void(Told...)> second) {
  if (!first) return second;
  if (!second) return first;
  return [one = std::move(first), two = std::move(second)](Told... told) {
    one(told...);
    two(told...);
  };
}

}  // namespace

template <int D>
RunListener<D> both(RunListener<D> first, RunListener<D> second) {
  RunListener<D> out;
  out.on_frame = after(std::move(first.on_frame), std::move(second.on_frame));
  out.on_history = after(std::move(first.on_history), std::move(second.on_history));
  out.on_energy = after(std::move(first.on_energy), std::move(second.on_energy));
  out.on_step = after(std::move(first.on_step), std::move(second.on_step));
  out.on_event = after(std::move(first.on_event), std::move(second.on_event));
  if (first.change_model && second.change_model)
    out.change_model = [one = std::move(first.change_model), two = std::move(second.change_model)](Model<D>& model) {
      const bool changed = one(model);
      return two(model) || changed;
    };
  else
    out.change_model = first.change_model ? std::move(first.change_model) : std::move(second.change_model);
  out.crack_bodies = first.crack_bodies ? std::move(first.crack_bodies) : std::move(second.crack_bodies);
  return out;
}

template RunListener<2> both(RunListener<2>, RunListener<2>);
template RunListener<3> both(RunListener<3>, RunListener<3>);

}  // namespace trilith
