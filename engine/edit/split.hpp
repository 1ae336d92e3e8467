// Rigid bodies that crack: each is replaced by two, at the border of a step.
#pragma once

#include <span>
#include <vector>

#include "edit/crack_search.hpp"
#include "integrate/explicit/central_difference.hpp"
#include "model/builder/builder.hpp"
#include "model/space_builder/solid_model_builder.hpp"

namespace trilith {

/// Extends `model`, which `builder` made, by the two parts of each body that cracks: see ModelBuilder::crack. If the
/// law of a crack softens, the parts are apart by the stress of the section over its stiffness, and their bond carries
/// this stress. Source: Papoulia, Sam and Vavasis, "Time continuity in cohesive finite element modeling", Int. J.
/// Numer. Meth. Engng 58, 2003.
Model<2> with_cracks(ModelBuilder& builder, const Model<2>& model, const std::vector<CrackingBody<2>>& bodies,
                     std::span<const Crack<2>> cracks);
/// In space the faces stay in one plane, and the joint of the parts holds their distance: see crack_contact.
Model<3> with_cracks(SolidModelBuilder& builder, const Model<3>& model, const std::vector<CrackingBody<3>>& bodies,
                     std::span<const Crack<3>> cracks);

/// Replaces the model by `grown`, which has two parts of each cracked body at the ends of its arrays: for each crack in
/// turn the part behind its plane, then the part ahead. The parts continue the rigid motion of their body, so mass,
/// momentum, angular momentum and kinetic energy remain. Contacts with their memories, bearings, seats and loads go to
/// the part that holds them. The body itself is deactivated. The difference of the ledger is booked under
/// EnergyTerm::contact_fracture. `bodies`: the planes before the split. Returns the events: unit.cracked, body.removed
/// and body.added.
template <int D>
std::vector<Event> split(Model<D>& model, State<D>& state, Work<D>& work, const StepOptions& options, Model<D> grown,
                         const std::vector<CrackingBody<D>>& bodies, std::span<const Crack<D>> cracks);

}  // namespace trilith
