#include "events/water_events.hpp"

#include "assembly/load_target.hpp"
#include "events/body_events.hpp"

namespace trilith {
namespace {

/// A joint is flooded if it is open from its heel over more than this share of its length. A shorter opening may close
/// again in the next step.
constexpr double flooded_share = 0.01;

}  // namespace

template <int D>
void water_events(const Model<D>& model, State<D>& state, Work<D>& work) {
  const std::vector<Uplift<D>>& uplifts = loads_of<Uplift<D>>(model);
  if (uplifts.empty()) return;
  state.flooded.resize(uplifts.size(), 0);
  const LoadPlaces<D> places{model, state, &work, &work.closed_joints};
  for (std::size_t i = 0; i < uplifts.size(); ++i) {
    const UpliftNow<D> joint = uplifts[i].now(places);
    const bool was = state.flooded[i] != 0;
    if (was ? joint.tip > 0 : joint.tip <= flooded_share * joint.length) continue;
    state.flooded[i] = was ? 0 : 1;
    Event e = event_now(state, was ? EventType::joint_drained : EventType::joint_flooded, uplifts[i].upper.front().body,
                        uplifts[i].lower.front().body);
    e.value = joint.tip;
    e.set_place(Vec<D>(joint.heel + joint.tip * joint.along));
    e.text = uplifts[i].name;
    work.events.push_back(std::move(e));
  }
}

template void water_events(const Model<2>&, State<2>&, Work<2>&);
template void water_events(const Model<3>&, State<3>&, Work<3>&);

}  // namespace trilith
