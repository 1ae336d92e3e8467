// Bodies that leave the step, as they have left the bounds or are removed, and those that come back. What is out stands
// still where it is; no row of the model goes, so that all others keep their places.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "integrate/explicit/central_difference.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Takes `bodies` out of the step at an evaluated instant, as they have left the bounds; that is evaluated anew. They
/// touch nothing from then on, their bearings fail, and what they held (motion, elastic energy of what they touched)
/// goes to the ledger's EnergyTerm::left_bounds. Gives what is to be told: body.left, and bearing.failed of those that
/// were live.
template <int D>
std::vector<Event> deactivate(Model<D>& model, State<D>& state, Work<D>& work, const StepOptions& options,
                              std::span<const int> bodies);

/// Which bodies and bearings a change of the model is about.
struct Parts {
  std::span<const int> bodies, bearings;
  /// Of reactivate: displacements of the bearings count from where they were placed first, not from where they are now.
  bool from_start = false;
};

/// The same of bodies and bearings that are removed: bearings of the bodies are removed too. The energy goes to
/// EnergyTerm::removed. Gives body.removed and bearing.removed.
template <int D>
std::vector<Event> remove(Model<D>& model, State<D>& state, Work<D>& work, const StepOptions& options,
                          const Parts& parts);

/// Puts back what was removed: bodies at rest where they stood, with the supports they had; bearings, whose bodies must
/// be there, begin anew where they are, free of force; with Parts::from_start springs act from where the bearing was
/// placed first. The energy that this puts in goes to EnergyTerm::added. Gives body.added and bearing.added.
template <int D>
std::vector<Event> reactivate(Model<D>& model, State<D>& state, Work<D>& work, const StepOptions& options,
                              const Parts& parts);

/// Changes numbers of laws. Bearings of `begun`, whose laws are others now, forget what theirs remembered. What that
/// puts in goes to EnergyTerm::added; it may be negative.
template <int D>
void modify(Model<D>& model, State<D>& state, Work<D>& work, const StepOptions& options,
            const std::function<void(Model<D>&)>& change, std::span<const int> begun);

/// What a change of supports and motions does to degrees of freedom.
struct SupportChange {
  bool frees = false;  ///< some were held or driven, and are free
  bool stops = false;  ///< some were free, and are held or driven
};
template <int D>
SupportChange support_change(const Model<D>& model, const Model<D>& changed);

/// Takes over `changed`, the model with other supports, motions and loads, where support_change is not nothing. What is
/// freed begins at this instant, at rest or at the speed of its motion, whose energy goes to EnergyTerm::support, and
/// what its contacts press to EnergyTerm::added. What is stopped takes the energy of its motion and its contacts along,
/// to EnergyTerm::removed. Gives what the step behind has led to, where that had to be ended here.
template <int D>
std::vector<Event> change_supports(Model<D>& model, State<D>& state, Work<D>& work, const StepOptions& options,
                                   Model<D> changed);

/// Takes over `grown`, the model with further bodies, bearings and seats at the ends of its arrays. Mortar is put
/// between new bodies and what they meet within `reach` (see set_bonds). What that puts in goes to EnergyTerm::added.
/// Gives body.added and bearing.added.
template <int D>
std::vector<Event> grow(Model<D>& model, State<D>& state, Work<D>& work, const StepOptions& options, Model<D> grown,
                        double reach);

/// Holds all that is out by the state, whatever the model says of its supports, which are set aside. True where
/// something is out and nothing is free to move any more.
template <int D>
bool hold_left(Model<D>& model, const State<D>& state);

}  // namespace trilith
