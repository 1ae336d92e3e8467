// Displacement control of bodies, created between steps and stored in the model, in the plane and in space.
// statics/displacement_control.hpp computes the forces.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "load/push.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Distribution of the control's forces to bodies.
enum class PushPattern { uniform, mass, triangle };  ///< triangle: mass times height above the lowest of all bodies

/// Rows of a displacement control of `bodies`, at their centroids or, for a single body, at a point at the start [m].
/// In space a point of a body of elements is attached to the element that contains it, a point of a frame to the
/// nearest node. Throws InputError if no body is given, and if one cannot move along `direction` (unit vector).
template <int D>
std::vector<PushRow<D>> push_rows(const Model<D>& model, const std::vector<int>& bodies,
                                  const std::optional<std::type_identity_t<Vec<D>>>& at, PushPattern pattern,
                                  const std::type_identity_t<Vec<D>>& direction);

/// Adds the control, starting at the present position. Throws InputError if one of its nodes is already controlled or
/// its name is used.
template <int D>
void add_push(Model<D>& model, const State<D>& state, const std::string& name, std::vector<PushRow<D>> rows,
              const std::type_identity_t<Vec<D>>& direction, const std::shared_ptr<const GroundMotion>& motion);

/// Position of a control: the weighted mean of its points' coordinates along its direction [m].
template <int D>
double push_place(const State<D>& state, const Push<D>& push);

/// Ends a control: its forces remain as loads that fade smoothly within `fade` [s], so that the release excites no
/// motion. Returns false if there is none with this name.
template <int D>
bool release_push(Model<D>& model, const State<D>& state, const Work<D>& work, const std::string& name, double fade);

}  // namespace trilith
