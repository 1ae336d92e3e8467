// What builders share that extend a model which has run: rows are for ever, and new ones come at the ends of the
// arrays.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "model/check/check.hpp"
#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// Calls part(); what it finds wrong is a fault.
template <class Part>
void attempt(std::vector<std::string>& faults, Part&& part) {
  try {
    part();
  } catch (const InputError& e) {
    faults.emplace_back(e.what());
  }
}

/// [body] 1 where it may start with nothing that holds it up: all of them where that is not judged yet.
template <class Specs>
std::vector<std::uint8_t> floating_bodies(const Specs& bodies, bool judged = true) {
  std::vector<std::uint8_t> floating;
  for (const auto& b : bodies) floating.push_back(b.floating || !judged ? 1 : 0);
  return floating;
}

/// `grown` is as the builder makes it; whatever was changed in `model` since it was built is carried over: supports,
/// motions, loads, gravity, dampings, numbers of laws, bearings.
template <int D>
void carry_conditions(const Model<D>& model, Model<D>& grown);

/// `grown` with its first nodes where `state` has them, as if they had started there.
template <int D>
Model<D> as_it_stands(const Model<D>& grown, const State<D>& state);

/// Faults of the bodies of `standing` that `state` does not know: what overlaps deeper than `allowed`, or than a
/// ten-thousandth of the smaller one's size, as what has run has settled; what stands on nothing.
template <int D>
void check_newcomers(const Model<D>& standing, const State<D>& state, double allowed,
                     const std::vector<std::uint8_t>& floating, std::vector<std::string>& faults,
                     std::vector<std::string>& notes);

/// What stands on nothing now, of all bodies that are there by `state`, a line each.
template <int D>
std::vector<std::string> standing_faults(const Model<D>& model, const State<D>& state,
                                         const std::vector<std::uint8_t>& floating);

/// Throws InputError where one of `bodies`, which are out by `state`, would stand in what is there now, deeper than
/// check_newcomers allows. What comes back together stands as it did.
template <int D>
void check_put_back(const Model<D>& model, const State<D>& state, double allowed, const std::vector<int>& bodies);

/// Widens the bounds of `grown`, where `chosen` leaves them open, so that they are those of what is there now too.
template <int D>
void widen_bounds(const Model<D>& standing, const Bounds<D>& chosen, Model<D>& grown);

}  // namespace trilith
