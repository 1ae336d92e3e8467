// Fields of a body that splits: the cells of its parts, and of the water in its crack.
#pragma once

#include <vector>

#include "edit/split_contacts.hpp"
#include "load/load_kind.hpp"
#include "model/crack_planes.hpp"
#include "model/state.hpp"

namespace trilith {

/// Gives the parts of a body the temperatures of its nodes, so that its heat remains: see divide_heat. `source`: for
/// each node of the part behind, then of the part ahead, the node of the body that it continues.
template <int D>
void split_heat(Model<D>& model, State<D>& state, const SplitBody& split, const std::vector<int>& source);

/// The crack of a body at joints with seepage. Such a joint is divided at the border of its cells that is nearest to
/// the crack, where a node is added. The crack becomes a joint between both parts. It begins without water, is as wide
/// as the joint, and has its aperture or FlowJoint::crack_aperture. An end at no joint is open to the air. Water does
/// not flow into the crack where a water at rest fills it. `faces`: see crack_faces. `law`: of the crack.
void split_seepage(Model<2>& model, State<2>& state, const SplitBody& split, const std::vector<SplitFace>& faces,
                   const ContactLaw& law);

}  // namespace trilith
