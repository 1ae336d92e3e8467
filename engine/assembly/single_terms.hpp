// Stages of `evaluate` for a single bearing, element, piece or contact.
#pragma once

#include <cstddef>
#include <vector>

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Sizes the arrays of `work` for the responses of all bearings; bearing_force then writes the rows of one.
template <int D>
void start_bearings(const Model<D>& model, Work<D>& work);
template <int D>
void bearing_force(const Model<D>& model, const State<D>& state, Work<D>& work, std::size_t i, double dt);

/// Adds forces and damping forces of a finite element to its nodes in `work`, whose arrays are sized for all nodes.
void element_forces(const Model<2>& model, const State<2>& state, Work<2>& work, int element);
/// Internal forces of a finite element in space; the arrays of `work` are sized for the memories of all elements.
void element_forces(const Model<3>& model, const State<3>& state, Work<3>& work, int element, SpaceElementAnswer& out);

/// Places one piece in space again in `work`, in which all are placed, with all inputs of its contacts.
void place_again(const Model<3>& model, const State<3>& state, Work<3>& work, int piece);
/// Response of one row of contact in space, with its pieces as placed in `work`, which has been evaluated. The trial
/// memory of the row in `work` is written, and no sums change.
void contact_row_forces(const Model<3>& model, const State<3>& state, Work<3>& work, int row, double dt,
                        SolidAnswer& answer);

}  // namespace trilith
