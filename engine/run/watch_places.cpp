// Positions of bodies at the start of a stage that ends at rest, and the bodies that have left their places at its end.
#include <algorithm>

#include "run/seal.hpp"
#include "run/watch.hpp"

namespace trilith {

void Watch::reset() {
  auto places = std::move(places_);
  *this = {};
  places_ = std::move(places);
}

template <int D>
void Watch::keep_places(const State<D>& state) {
  std::erase_if(places_, [&](const auto& stage) { return stage.first >= state.time; });
  places_.emplace_back(state.time, placement_of(state));
}

template <int D>
Travel Watch::farthest(const Instant<D>& now) const {
  const auto stage = std::find_if(places_.begin(), places_.end(), [&](const auto& s) { return s.first == now.begun; });
  const auto* const from = stage == places_.end() ? nullptr : std::get_if<Placement<D>>(&stage->second);
  if (from == nullptr) return {};
  const Travel all = farthest_travel(now.model, now.state, *from);
  // Bodies that were without support fall to their places. To find out which these are takes longer.
  return all.share > SealLimit::travel ? displaced_body(now.model, now.state, *from, 0) : all;
}

template <int D>
const Travel& Watch::look_at_places(const Instant<D>& now) {
  displaced_ = {};
  const double within = now.stage.within;
  const auto stage = std::find_if(places_.begin(), places_.end(), [&](const auto& s) { return s.first == now.begun; });
  if (!(within > 0) || stage == places_.end()) return displaced_;
  if (const auto* const from = std::get_if<Placement<D>>(&stage->second))
    displaced_ = displaced_body(now.model, now.state, *from, within);
  return displaced_;
}

template void Watch::keep_places(const State<2>&);
template void Watch::keep_places(const State<3>&);
template Travel Watch::farthest(const Instant<2>&) const;
template Travel Watch::farthest(const Instant<3>&) const;
template const Travel& Watch::look_at_places(const Instant<2>&);
template const Travel& Watch::look_at_places(const Instant<3>&);

}  // namespace trilith
