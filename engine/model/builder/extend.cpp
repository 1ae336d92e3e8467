#include "model/builder/extend.hpp"

#include <algorithm>
#include <cmath>

#include "model/bounds.hpp"
#include "model/check/small_gaps.hpp"

namespace trilith {
namespace {

/// Settlement of bodies that have run, relative to the smaller body's size.
constexpr double settled = 1e-4;

/// Copies the rows of `from` to the beginning of `to`.
template <class T>
void carry(const std::vector<T>& from, std::vector<T>& to) {
  std::copy(from.begin(), from.end(), to.begin());
}

}  // namespace

/// Changes after the model was built are copied to the extended one, whose first rows are the same bodies.
template <int D>
void carry_conditions(const Model<D>& model, Model<D>& grown) {
  grown.gravity = model.gravity;
  grown.mass_damping = model.mass_damping;
  grown.bounds = model.bounds;
  grown.impact_speed = model.impact_speed, grown.apart_time = model.apart_time;
  grown.still_speed = model.still_speed, grown.still_time = model.still_time;
  carry(model.support, grown.support);
  carry(model.load, grown.load);
  carry(model.drive_of, grown.drive_of);
  grown.set_aside = model.set_aside;
  grown.drives = model.drives;
  grown.loads = model.loads;
  grown.fields = model.fields;
  grown.pushes = model.pushes;
  carry(model.laws, grown.laws);
  grown.bearings = model.bearings;
  grown.seats = model.seats;
}

template <int D>
Model<D> as_it_stands(const Model<D>& grown, const State<D>& state) {
  Model<D> standing = grown;
  carry(state.position, standing.start_position);
  carry(state.rotation, standing.start_rotation);
  return standing;
}

/// New bodies are checked against the present positions of the others, not their initial ones.
template <int D>
void check_newcomers(const Model<D>& standing, const State<D>& state, double allowed,
                     const std::vector<std::uint8_t>& floating, std::vector<std::string>& faults,
                     std::vector<std::string>& notes) {
  const Newcomers among{static_cast<int>(state.left.size()), &state.left};
  check_overlaps(standing, std::max(allowed, settled), faults, notes, among);
  check_held_up_and_gaps(standing, floating, faults, notes, among);
}

template <int D>
std::vector<std::string> standing_faults(const Model<D>& model, const State<D>& state,
                                         const std::vector<std::uint8_t>& floating) {
  std::vector<std::string> faults;
  check_held_up(as_it_stands(model, state), floating, faults, {0, &state.left});
  return faults;
}

template <int D>
void check_put_back(const Model<D>& model, const State<D>& state, double allowed, const std::vector<int>& bodies) {
  std::vector<std::uint8_t> out = state.left, back(model.bodies.size(), 0);
  for (const int b : bodies) out[static_cast<std::size_t>(b)] = 0, back[static_cast<std::size_t>(b)] = 1;
  std::vector<std::string> faults, notes;
  check_overlaps(as_it_stands(model, state), std::max(allowed, settled), faults, notes, {0, &out, &back});
  if (!faults.empty()) throw InputError("put_back: " + faults.front());
}

template <int D>
void widen_bounds(const Model<D>& standing, const Bounds<D>& chosen, Model<D>& grown) {
  const Bounds<D> around = default_bounds(standing);
  for (int k = 0; k < D; ++k) {
    if (!std::isfinite(chosen.low[k])) grown.bounds.low[k] = std::min(grown.bounds.low[k], around.low[k]);
    if (!std::isfinite(chosen.high[k])) grown.bounds.high[k] = std::max(grown.bounds.high[k], around.high[k]);
  }
}

template void carry_conditions(const Model<2>&, Model<2>&);
template void carry_conditions(const Model<3>&, Model<3>&);
template Model<2> as_it_stands(const Model<2>&, const State<2>&);
template Model<3> as_it_stands(const Model<3>&, const State<3>&);
template std::vector<std::string> standing_faults(const Model<2>&, const State<2>&, const std::vector<std::uint8_t>&);
template std::vector<std::string> standing_faults(const Model<3>&, const State<3>&, const std::vector<std::uint8_t>&);
template void check_newcomers(const Model<2>&, const State<2>&, double, const std::vector<std::uint8_t>&,
                              std::vector<std::string>&, std::vector<std::string>&);
template void check_newcomers(const Model<3>&, const State<3>&, double, const std::vector<std::uint8_t>&,
                              std::vector<std::string>&, std::vector<std::string>&);
template void check_put_back(const Model<2>&, const State<2>&, double, const std::vector<int>&);
template void check_put_back(const Model<3>&, const State<3>&, double, const std::vector<int>&);
template void widen_bounds(const Model<2>&, const Bounds<2>&, Model<2>&);
template void widen_bounds(const Model<3>&, const Bounds<3>&, Model<3>&);

}  // namespace trilith
