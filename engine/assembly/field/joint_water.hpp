// Water in joints (field/joint_flow.hpp): their apertures, and the pressure on both faces.
#pragma once

#include "field/field.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// True where the model has joints between bodies with water in them.
template <int D>
bool has_joint_water(const Model<D>& model);

/// Apertures at both ends of each cell. In a joint between bodies they are those without load plus the gap of the
/// faces, which is negative where the contact is compressed; never below the hundredth of the one without load. Where
/// the faces do not overlap any more, the aperture is the one without load.
Apertures joint_apertures(const JointFlow& flow, const FieldState& state, const Model<2>& model,
                          const State<2>& positions);
Apertures joint_apertures(const JointFlow& flow, const FieldState& state, const Model<3>& model,
                          const State<3>& positions);

/// Adds the pressure of the water to the forces [N] and moments [N m] of the nodes. The pressure is constant over a
/// cell, so its work is the pressure times the change of the cell's volume.
void press_joints(const Model<2>& model, const State<2>& state, const Work<2>& work, std::vector<Vec2>& force,
                  std::vector<double>& moment);

/// Force on the upper body of a joint [N], and moment about the origin [N m].
struct JointThrust {
  Vec2 force = Vec2::Zero();
  double moment = 0;
};
JointThrust thrust_on_upper(const FlowJoint& joint, const Model<2>& model, const State<2>& state);

}  // namespace trilith
