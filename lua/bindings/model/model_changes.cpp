// Bodies, bearings and histories that are added, removed and reactivated after a model has run.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "base/error.hpp"
#include "base/quantity_text.hpp"
#include "bindings/core/guard.hpp"
#include "bindings/model/simulated_model.hpp"
#include "load/motion.hpp"
#include "model/builder/extend.hpp"
#include "model/check/missing_laws.hpp"
#include "model/pose.hpp"

namespace trilith::script {
namespace {

template <int D>
bool is_bearing_removed(const State<D>& state, int bearing) {
  return state.bearing[static_cast<std::size_t>(bearing)].status == BearingStatus::removed;
}

/// An error at the step border belongs to `place` in the script instead of the line that runs the stage; "" if it was
/// requested now.
[[noreturn]] void refuse_later(const std::string& place, const std::string& what) {
  if (place.empty()) throw InputError(what);
  throw ScriptError(place + what);
}

/// Note on a bearing whose force after reactivation exceeds the weight of its bodies; "" otherwise.
template <int D>
std::string jolt_text(Simulation<D>& sim, std::size_t bearing) {
  sim.refresh();
  const Model<D>& model = sim.model();
  const Bearing<D>& b = model.bearings[bearing];
  if (!is_live(sim.state().bearing[bearing].status)) return "";
  double weight = 0;
  for (const int body : {b.body_a, b.body_b})
    if (model.body_moves(body)) weight += standard_gravity * body_mass(model, body);
  const double force = sim.work().bearing_force[bearing].norm();
  if (!(force > weight)) return "";
  return fmt::format(
      "put_back: bearing '{}' acts with {} at once, more than the weight of its bodies, {}, because its displacement "
      "counts from its first place; without from = \"start\" it begins without force",
      b.name, quantity_text(force, "N"), quantity_text(weight, "N"));
}

}  // namespace

template <int D>
bool SimulatedModel<D>::is_out(int body) const {
  const auto row = static_cast<std::size_t>(body);
  return simulation_ && row < simulation_->state().left.size() && simulation_->state().left[row] != 0;
}

template <int D>
bool SimulatedModel<D>::is_bearing_out(int bearing) const {
  const auto row = static_cast<std::size_t>(bearing);
  if (!simulation_ || row >= simulation_->model().bearings.size()) return false;
  const Bearing<D>& b = simulation_->model().bearings[row];
  return is_bearing_removed(simulation_->state(), bearing) || is_out(b.body_a) || is_out(b.body_b);
}

template <int D>
bool SimulatedModel<D>::is_seat_out(int seat) const {
  const auto row = static_cast<std::size_t>(seat);
  if (!simulation_ || row >= simulation_->model().seats.size()) return false;
  const Seat<D>& s = simulation_->model().seats[row];
  return is_out(s.body) || is_out(s.support);
}

template <int D>
bool SimulatedModel<D>::is_storey_out(int number) {
  const auto& storeys = findings().storeys;
  const auto it = std::ranges::find(storeys, number, &Storey::number);
  return it != storeys.end() && std::ranges::all_of(it->top, [this](int body) { return is_out(body); });
}

template <int D>
void SimulatedModel<D>::catch_up() {
  if (simulation_ && !adds_later && caught_up_ != additions_ && (!running_ || paused_)) extend();
}

template <int D>
void SimulatedModel<D>::modify(std::function<void(Model<D>&)> what, std::vector<int> begun) {
  change([this, what = std::move(what), begun = std::move(begun)](Model<D>&) { simulation_->modify(what, begun); });
}

template <int D>
void SimulatedModel<D>::change_supports(std::function<void(Model<D>&)> what) {
  change([this, what = std::move(what)](Model<D>&) { simulation_->change_supports(what); });
}

/// Invalid additions are removed, so that the model remains unchanged.
template <int D>
void SimulatedModel<D>::extend() {
  caught_up_ = additions_;
  findings_.reset();
  try {
    Model<D> grown = extended_model(simulation_->model(), simulation_->state());
    if (running_) require_laws(grown);  // otherwise the next stage does, before which a law may still be added
    simulation_->grow(std::move(grown));
    simulation_->set_cracking(cracking_bodies(simulation_->model()));
  } catch (const InputError&) {
    forget_added();
    throw;
  }
  extend_recording();
}

/// Bodies that a change at the same border has removed do not crack.
template <int D>
void SimulatedModel<D>::split(const std::vector<Crack<D>>& cracks) {
  std::vector<Crack<D>> present;
  for (const Crack<D>& crack : cracks)
    if (!is_out(crack.body)) present.push_back(crack);
  if (present.empty()) return;
  findings_.reset();
  simulation_->split(cracked_model(simulation_->model(), present), present);
  simulation_->set_cracking(cracking_bodies(simulation_->model()));
  extend_recording();
}

/// Removes bodies, bearings and seats that the simulation does not contain.
template <int D>
void SimulatedModel<D>::forget_added() {
  findings_.reset();
  const Model<D>& model = simulation_->model();
  forget_beyond(model);
  bearings.resize(std::min(bearings.size(), model.bearings.size()));
  seats.resize(std::min(seats.size(), model.seats.size()));
  caught_up_ = additions_;
}

template <int D>
std::vector<double> SimulatedModel<D>::heights() const {
  const Model<D>& model = simulation_->model();
  std::vector<double> heights(model.bodies.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t b = 0; b < heights.size(); ++b)
    if (model.body_moves(static_cast<int>(b)))
      heights[b] = simulation_->state().position[static_cast<std::size_t>(model.bodies[b].first_node)][D - 1];
  return heights;
}

template <int D>
std::vector<RecordedHistory<D>> SimulatedModel<D>::recorded_histories() const {
  std::vector<RecordedHistory<D>> all;
  for (const History& h : histories) all.push_back({h.name, h.unit, h.sentence, {}});
  return all;
}

template <int D>
void SimulatedModel<D>::extend_recording() {
  if (!recording_) return;
  try {
    recording_->extend(simulation_->model(), simulation_->state(), recorded_histories());
  } catch (...) {
    recording_.reset();  // previous records are in the file named in the message
    throw;
  }
}

template <int D>
void SimulatedModel<D>::follow_more() {
  ++effects;
  extend_recording();
}

template <int D>
std::optional<double> SimulatedModel<D>::removed_at(int body) const {
  const auto row = static_cast<std::size_t>(body);
  if (!simulation_ || !simulation_->state().is_removed(row)) return std::nullopt;
  return simulation_->state().removed_at[row];
}

template <int D>
std::string SimulatedModel<D>::why_absent(int body) const {
  if (body >= body_count()) return "was never added, because the run went back to an earlier time";
  if (!simulation_) return "";
  if (body >= static_cast<int>(simulation_->model().bodies.size())) return "is added at the next step border";
  const std::optional<double> removed = removed_at(body);
  if (!removed) return "";
  const int part = first_part(body);
  if (part >= 0)
    return fmt::format("cracked at {:.6g} s into '{}' and '{}'", *removed, body_name(part), body_name(part + 1));
  return fmt::format("was removed at {:.6g} s", *removed);
}

/// Rejects bodies under a push, whose forces make them follow its displacement.
template <int D>
void SimulatedModel<D>::require_unpushed(const std::vector<int>& which) const {
  const Model<D>& model = simulation_->model();
  for (const int b : which) {
    const Body& body = model.bodies[static_cast<std::size_t>(b)];
    for (const Push<D>& push : model.pushes)
      for (const auto& row : push.rows)
        if (row.node >= body.first_node && row.node < body.first_node + body.nodes)
          throw InputError(
              fmt::format("remove: body '{}' is pushed by '{}'; release that first", body.name, push.name));
  }
}

template <int D>
void SimulatedModel<D>::remove(const std::vector<int>& which, const std::vector<int>& links, const std::string& place) {
  simulation();
  const bool waits = running_ && !paused_;
  change([this, which, links, place = waits ? place : ""](Model<D>& model) {
    for (const int b : which)
      if (const std::string why = why_absent(b); !why.empty())
        refuse_later(place, fmt::format("remove: body '{}' {}", body_name(b), why));
    require_unpushed(which);
    for (const int i : links)
      if (is_bearing_removed(simulation_->state(), i))
        refuse_later(place, fmt::format("remove: bearing '{}' was removed already",
                                        model.bearings[static_cast<std::size_t>(i)].name));
    simulation_->remove({which, links});
  });
}

template <int D>
void SimulatedModel<D>::reactivate(const std::vector<int>& which, const std::vector<int>& links, bool from_start,
                                   const std::string& place) {
  simulation();
  const bool waits = running_ && !paused_;
  change([this, which, links, from_start, place = waits ? place : ""](Model<D>& model) {
    for (const int b : which)
      if (first_part(b) >= 0)
        refuse_later(place, fmt::format("put_back: body '{}' {}; a body that has cracked does not return", body_name(b),
                                        why_absent(b)));
    for (const int b : which)
      if (!removed_at(b))
        refuse_later(place, fmt::format("put_back: body '{}' is present; only removed bodies can be put back",
                                        model.bodies[static_cast<std::size_t>(b)].name));
    for (const int i : links)
      if (!is_bearing_removed(simulation_->state(), i))
        refuse_later(place, fmt::format("put_back: bearing '{}' is present; only removed bearings can be put back",
                                        model.bearings[static_cast<std::size_t>(i)].name));
    if (!which.empty()) check_put_back(model, simulation_->state(), overlap_allowed(), which);
    simulation_->reactivate({which, links, from_start});
    for (const int i : links)
      if (const std::string jolt = jolt_text(*simulation_, static_cast<std::size_t>(i)); !jolt.empty())
        add_note(jolt), note(jolt);
  });
}

template void SimulatedModel<2>::modify(std::function<void(Model<2>&)>, std::vector<int>);
template void SimulatedModel<2>::change_supports(std::function<void(Model<2>&)>);
template void SimulatedModel<3>::change_supports(std::function<void(Model<3>&)>);
template bool SimulatedModel<2>::is_out(int) const;
template bool SimulatedModel<2>::is_bearing_out(int) const;
template bool SimulatedModel<2>::is_seat_out(int) const;
template bool SimulatedModel<2>::is_storey_out(int);
template bool SimulatedModel<3>::is_out(int) const;
template bool SimulatedModel<3>::is_bearing_out(int) const;
template bool SimulatedModel<3>::is_seat_out(int) const;
template bool SimulatedModel<3>::is_storey_out(int);
template void SimulatedModel<2>::catch_up();
template std::vector<double> SimulatedModel<2>::heights() const;
template void SimulatedModel<2>::extend();
template void SimulatedModel<2>::forget_added();
template void SimulatedModel<2>::split(const std::vector<Crack<2>>&);
template void SimulatedModel<3>::split(const std::vector<Crack<3>>&);
template std::vector<RecordedHistory<2>> SimulatedModel<2>::recorded_histories() const;
template void SimulatedModel<2>::extend_recording();
template void SimulatedModel<2>::follow_more();
template std::optional<double> SimulatedModel<2>::removed_at(int) const;
template std::string SimulatedModel<2>::why_absent(int) const;
template void SimulatedModel<2>::require_unpushed(const std::vector<int>&) const;
template void SimulatedModel<2>::remove(const std::vector<int>&, const std::vector<int>&, const std::string&);
template void SimulatedModel<2>::reactivate(const std::vector<int>&, const std::vector<int>&, bool, const std::string&);
template void SimulatedModel<3>::modify(std::function<void(Model<3>&)>, std::vector<int>);
template void SimulatedModel<3>::catch_up();
template std::vector<double> SimulatedModel<3>::heights() const;
template void SimulatedModel<3>::extend();
template void SimulatedModel<3>::forget_added();
template std::vector<RecordedHistory<3>> SimulatedModel<3>::recorded_histories() const;
template void SimulatedModel<3>::extend_recording();
template void SimulatedModel<3>::follow_more();
template std::optional<double> SimulatedModel<3>::removed_at(int) const;
template std::string SimulatedModel<3>::why_absent(int) const;
template void SimulatedModel<3>::require_unpushed(const std::vector<int>&) const;
template void SimulatedModel<3>::remove(const std::vector<int>&, const std::vector<int>&, const std::string&);
template void SimulatedModel<3>::reactivate(const std::vector<int>&, const std::vector<int>&, bool, const std::string&);

}  // namespace trilith::script
