// Heat of friction: the energy that sliding contacts dissipate enters the cells of both bodies.
#pragma once

#include <vector>

#include "field/field.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Energy that enters a cell of the field of heat.
struct HeatDeposit {
  int cell = -1;
  double energy = 0;  ///< [J]
};

/// The field of heat of a model whose friction heats bodies; otherwise nullptr.
template <int D>
const Field* friction_heated(const Model<D>& model);

/// Before a commit: the deposits of the friction of the last step. None for a model whose friction heats no body.
template <int D>
std::vector<HeatDeposit> friction_of_step(const Model<D>& model, const State<D>& state, const Work<D>& work);

/// Divides the energy that friction dissipated in the last step over the contacts at this instant, which `work`
/// contains: by shear force times relative speed where it slides; without motion by shear force. Half of each part
/// enters either body, at its node nearest to the contact; a body without cells leaves its half to the other one, and
/// parts between two such bodies are lost.
template <int D>
std::vector<HeatDeposit> friction_deposits(const Field& heat, const Model<D>& model, const State<D>& state,
                                           const Work<D>& work, double energy);

/// Raises the temperatures by the deposits, and counts them as supplied by friction. `fields`: of State, all rows.
template <int D>
void add_deposits(const Model<D>& model, const std::vector<HeatDeposit>& deposits, std::vector<FieldState>& fields);

}  // namespace trilith
