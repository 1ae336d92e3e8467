// Bodies, laws, bearings and seats added to a plane model after it has run.
#include <algorithm>

#include "model/builder/builder.hpp"
#include "model/builder/extend.hpp"
#include "model/pose.hpp"

namespace trilith {

/// All bodies are rebuilt, which gives the existing ones their previous rows. Only the new ones are checked, against
/// the others in their present positions. New laws may change the law between existing bodies.
Model<2> ModelBuilder::extended(const Model<2>& model, const State<2>& state) {
  std::vector<std::string> faults, notes;
  Model<2> grown = assemble_bodies(faults);
  if (!faults.empty()) throw InputError(faults.front());
  carry_conditions(model, grown);
  append_links(model, state, grown);
  const Model<2> standing = as_it_stands(grown, state);
  check_newcomers(standing, state, overlap_allowed, floating_bodies(bodies_, judge_standing), faults, notes);
  if (!faults.empty()) throw InputError(faults.front());
  widen_bounds(standing, bounds, grown);
  notes_.insert(notes_.end(), notes.begin(), notes.end());
  return grown;
}

/// Bearings and seats are attached to bodies in their present positions; a new bearing is unstressed.
void ModelBuilder::append_links(const Model<2>& model, const State<2>& state, Model<2>& grown) const {
  if (bearings_.size() == model.bearings.size() && seats_.size() == model.seats.size()) return;
  Model<2> standing = as_it_stands(grown, state);
  for (std::size_t i = model.bearings.size(); i < bearings_.size(); ++i) {
    append_bearing(bearings_[i], standing);
    Bearing<2>& b = standing.bearings.back();
    const State<2> now = initial_state(standing);
    const double turned = pose_at(standing, now, b.end_a).rotation;
    b.angle -= turned;
    b.rest_angle = pose_at(standing, now, b.end_b).rotation - turned;
  }
  for (std::size_t i = model.bearings.size(); i < bearings_.size(); ++i) check_successor(standing.bearings, i);
  for (std::size_t i = model.seats.size(); i < seats_.size(); ++i) {
    append_seat(seats_[i], standing);
    Seat<2>& seat = standing.seats.back();
    seat.inward = Turn(standing.start_rotation[standing.bodies[seat.support].first_node]).undo(seat.inward);
  }
  grown.bearings = standing.bearings;
  grown.seats = standing.seats;
}

void ModelBuilder::shorten(std::size_t bodies, std::size_t bearings, std::size_t seats) {
  bodies_.resize(std::min(bodies, bodies_.size()));
  bearings_.resize(std::min(bearings, bearings_.size()));
  seats_.resize(std::min(seats, seats_.size()));
}

}  // namespace trilith
