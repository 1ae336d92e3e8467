// Bodies and bearings that are removed, reactivated or added during a simulation.
#include <algorithm>
#include <utility>

#include "assembly/tangent/tangent.hpp"
#include "edit/deactivate.hpp"
#include "edit/split.hpp"
#include "run/simulation.hpp"
#include "run/watch.hpp"

namespace trilith {

/// Applies `change(options of the next step)`, which returns events to report. All derived data are reset.
template <int D>
template <class Change>
void Simulation<D>::change_parts(Change&& change) {
  unscale_masses();
  refresh();
  const std::vector<Event> events = change(StepOptions{swept_.dt, rest_});
  leaving_.insert(leaving_.end(), events.begin(), events.end());
  all_left_ = hold_left(model_, state_);
  edited();
}

template <int D>
void Simulation<D>::remove(const Parts& parts) {
  change_parts([&](const StepOptions& options) { return trilith::remove(model_, state_, work_, options, parts); });
}

template <int D>
void Simulation<D>::reactivate(const Parts& parts) {
  change_parts([&](const StepOptions& options) { return trilith::reactivate(model_, state_, work_, options, parts); });
  drop_step();
}

template <int D>
void Simulation<D>::grow(Model<D> grown) {
  constexpr double mortar_reach = 1e-3;  // share of the smaller body's size: new mortar fills gaps that settlement has
                                         // left
  causes_.grow(grown.bodies.size());
  change_parts([&](const StepOptions& options) {
    return trilith::grow(model_, state_, work_, options, std::move(grown), mortar_reach);
  });
  drop_step();
}

/// Bodies that a process does not bring to equilibrium have stresses of temperatures that they have not followed.
template <int D>
CrackSearch<D> Simulation<D>::search_cracks() {
  if (stage_ && stage_->options.process && !stage_->options.process->mechanics) return {{}, cracking_.watch, 0};
  refresh();
  return trilith::search_cracks(model_, state_, work_, cracking_, crack_scratch_);
}

template <int D>
void Simulation<D>::split(Model<D> grown, std::span<const Crack<D>> cracks) {
  causes_.grow(grown.bodies.size());
  change_parts([&](const StepOptions& options) {
    return trilith::split(model_, state_, work_, options, std::move(grown), cracking_.bodies, cracks);
  });
  drop_step();
}

template <int D>
void Simulation<D>::modify(const std::function<void(Model<D>&)>& change, std::span<const int> begun) {
  change_parts([&](const StepOptions& options) {
    trilith::modify(model_, state_, work_, options, change, begun);
    return std::vector<Event>{};
  });
  drop_step();
}

namespace {

/// True if the ledger has begun: something has moved, or was found at rest.
template <int D>
bool has_begun(const State<D>& state) {
  return state.step > 0 ||
         std::any_of(state.given.value.begin(), state.given.value.end(), [](double given) { return given != 0; });
}

}  // namespace

/// Most motions are assigned to fixed supports. Such a change does not affect the free degrees of freedom and needs no
/// update.
template <int D>
void Simulation<D>::change_supports(const std::function<void(Model<D>&)>& change) {
  unscale_masses();
  Model<D> changed = model_;
  change(changed);
  hold_left(changed, state_);
  const SupportChange what = support_change(model_, changed);
  if (!has_begun(state_) || !(what.frees || what.stops)) {
    model_ = std::move(changed);
    edited();
    return;
  }
  change_parts([&](const StepOptions& options) {
    return trilith::change_supports(model_, state_, work_, options, std::move(changed));
  });
  if (what.frees) drop_step();
}

template void Simulation<2>::change_supports(const std::function<void(Model<2>&)>&);
template void Simulation<3>::change_supports(const std::function<void(Model<3>&)>&);
template void Simulation<2>::modify(const std::function<void(Model<2>&)>&, std::span<const int>);
template void Simulation<3>::modify(const std::function<void(Model<3>&)>&, std::span<const int>);
template void Simulation<2>::remove(const Parts&);
template void Simulation<2>::reactivate(const Parts&);
template void Simulation<2>::grow(Model<2>);
template CrackSearch<2> Simulation<2>::search_cracks();
template CrackSearch<3> Simulation<3>::search_cracks();
template void Simulation<2>::split(Model<2>, std::span<const Crack<2>>);
template void Simulation<3>::split(Model<3>, std::span<const Crack<3>>);
template void Simulation<3>::remove(const Parts&);
template void Simulation<3>::reactivate(const Parts&);
template void Simulation<3>::grow(Model<3>);

}  // namespace trilith
