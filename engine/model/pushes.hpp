// Displacement control: bodies that are pushed along, made between steps for the model to hold, in the plane and in
// space; statics/displacement_control.hpp finds the forces.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "load/forces.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// How forces of a push are shared among bodies.
enum class PushPattern { uniform, mass, triangle };  ///< triangle: mass times height above the lowest of all bodies

/// Rows of a push of `bodies`, at their centroids or, of a single body, at a point where it stands at the start [m].
/// In space a point of a body of elements is that of the element that holds it, one of a frame that of the node nearest
/// to it. Throws InputError where no body is
/// given, and where one cannot move along `direction` (unit vector).
template <int D>
std::vector<PushRow<D>> push_rows(const Model<D>& model, const std::vector<int>& bodies,
                                  const std::optional<std::type_identity_t<Vec<D>>>& at, PushPattern pattern,
                                  const std::type_identity_t<Vec<D>>& direction);

/// Adds it, from the present place on. Throws InputError where one of its nodes is pushed already or its name is taken.
template <int D>
void add_push(Model<D>& model, const State<D>& state, const std::string& name, std::vector<PushRow<D>> rows,
              const std::type_identity_t<Vec<D>>& direction, const std::shared_ptr<const GroundMotion>& motion);

/// Where a push stands: the weighed mean of its points' places along its direction [m].
template <int D>
double push_place(const State<D>& state, const Push<D>& push);

/// Ends a push: its forces stay as loads that fade smoothly within `fade` [s], so that nothing is set off. False where
/// there is none of that name.
template <int D>
bool release_push(Model<D>& model, const State<D>& state, const Work<D>& work, const std::string& name, double fade);

}  // namespace trilith
