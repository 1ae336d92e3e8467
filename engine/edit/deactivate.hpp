// Bodies that are deactivated because they leave the bounds or are removed, and bodies that are reactivated. A
// deactivated body is at rest in its position. No row of the model is deleted, so all others keep their indices.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "integrate/explicit/central_difference.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Deactivates `bodies` that have left the bounds, at an evaluated instant, and evaluates again. They touch nothing
/// from then on and their bearings fail. Their energy (motion, and elastic energy of their contacts) is booked under
/// EnergyTerm::left_bounds. Returns the events: body.left, and bearing.failed for live bearings.
template <int D>
std::vector<Event> deactivate(Model<D>& model, State<D>& state, Work<D>& work, const StepOptions& options,
                              std::span<const int> bodies);

/// Bodies and bearings that a change of the model applies to.
struct Parts {
  std::span<const int> bodies, bearings;
  /// For reactivate: displacements of the bearings count from their first position instead of the present one.
  bool from_start = false;
};

/// Removes bodies and bearings, including the bearings of these bodies. The energy is booked under EnergyTerm::removed.
/// Returns the events body.removed and bearing.removed.
template <int D>
std::vector<Event> remove(Model<D>& model, State<D>& state, Work<D>& work, const StepOptions& options,
                          const Parts& parts);

/// Reactivates removed parts: bodies at rest in their position, with their previous supports; bearings, whose bodies
/// must be active, without force in the present position. With Parts::from_start springs act from the first position of
/// the bearing. The added energy is booked under EnergyTerm::added. Returns the events body.added and bearing.added.
template <int D>
std::vector<Event> reactivate(Model<D>& model, State<D>& state, Work<D>& work, const StepOptions& options,
                              const Parts& parts);

/// Changes parameters of laws. Bearings in `begun`, whose laws are replaced, reset their memory. The added energy,
/// which may be negative, is booked under EnergyTerm::added.
template <int D>
void modify(Model<D>& model, State<D>& state, Work<D>& work, const StepOptions& options,
            const std::function<void(Model<D>&)>& change, std::span<const int> begun);

/// Effect of a change of supports and motions on degrees of freedom.
struct SupportChange {
  bool frees = false;  ///< fixed or driven ones become free
  bool stops = false;  ///< free ones become fixed or driven
};
template <int D>
SupportChange support_change(const Model<D>& model, const Model<D>& changed);

/// Replaces the model by `changed`, with other supports, motions and loads, if support_change is not empty. Freed
/// degrees of freedom start at this instant, at rest or with the speed of their motion. This kinetic energy is booked
/// under EnergyTerm::support, and the energy of their contacts under EnergyTerm::added. Stopped ones remove their
/// kinetic and contact energy, under EnergyTerm::removed. Returns the events of the last step if it had to be ended
/// here.
template <int D>
std::vector<Event> change_supports(Model<D>& model, State<D>& state, Work<D>& work, const StepOptions& options,
                                   Model<D> changed);

/// Replaces the model by `grown`, with further bodies, bearings and seats at the ends of its arrays. Mortar bonds new
/// bodies to all faces they meet within `reach` (see set_bonds). The added energy is booked under EnergyTerm::added.
/// Returns the events body.added and bearing.added.
template <int D>
std::vector<Event> grow(Model<D>& model, State<D>& state, Work<D>& work, const StepOptions& options, Model<D> grown,
                        double reach);

/// Fixes all deactivated bodies of the state; the supports in the model are stored. True if a body is deactivated and
/// no body is free to move any more.
template <int D>
bool hold_left(Model<D>& model, const State<D>& state);

}  // namespace trilith
