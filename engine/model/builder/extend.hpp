// Common part of builders that extend a model after it has run: rows are permanent, and new ones are appended to the
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

/// Calls part() and records an InputError as a fault.
template <class Part>
void attempt(std::vector<std::string>& faults, Part&& part) {
  try {
    part();
  } catch (const InputError& e) {
    faults.emplace_back(e.what());
  }
}

/// [body] 1 if it may start unsupported: all bodies if this is not judged yet.
template <class Specs>
std::vector<std::uint8_t> floating_bodies(const Specs& bodies, bool judged = true) {
  std::vector<std::uint8_t> floating;
  for (const auto& b : bodies) floating.push_back(b.floating || !judged ? 1 : 0);
  return floating;
}

/// `grown` is newly built. Copies the changes of `model` after its construction: supports, motions, loads, gravity,
/// dampings, law parameters, bearings.
template <int D>
void carry_conditions(const Model<D>& model, Model<D>& grown);

/// `grown` with its first nodes at their positions in `state`, as if they had started there.
template <int D>
Model<D> as_it_stands(const Model<D>& grown, const State<D>& state);

/// Faults of the bodies of `standing` that are not in `state`: overlaps deeper than `allowed`, or than a ten-thousandth
/// of the smaller body's size because existing bodies have settled; and unsupported bodies.
template <int D>
void check_newcomers(const Model<D>& standing, const State<D>& state, double allowed,
                     const std::vector<std::uint8_t>& floating, std::vector<std::string>& faults,
                     std::vector<std::string>& notes);

/// Unsupported bodies among all bodies present in `state`, a line for each.
template <int D>
std::vector<std::string> standing_faults(const Model<D>& model, const State<D>& state,
                                         const std::vector<std::uint8_t>& floating);

/// Throws InputError if one of `bodies`, which are removed in `state`, would overlap a present body deeper than
/// check_newcomers allows. Bodies that return together keep their relative positions.
template <int D>
void check_put_back(const Model<D>& model, const State<D>& state, double allowed, const std::vector<int>& bodies);

/// Extends the bounds of `grown`, where `chosen` leaves them open, to include the bounds of the present bodies.
template <int D>
void widen_bounds(const Model<D>& standing, const Bounds<D>& chosen, Model<D>& grown);

}  // namespace trilith
