// Water in joints (field/joint_flow.hpp): their apertures, and the pressure on
// both faces.
#pragma once

#include "field/field.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// True where the model has joints between bodies with water in them.
template <int D>
bool has_joint_water(const Model<D>& model);

/// Apertures at both ends of each cell. In a joint between bodies they are
/// those without load plus the gap of the faces, which is negative where the
/// contact is compressed; never below the hundredth of the one without load.
/// Where the faces do not overlap any more, the aperture is the one without
/// load.
Apertures joint_apertures(const JointFlow& flow, const FieldState& state, const Model<2>& model,
                          const State<2>& positions);
Apertures joint_apertures(const JointFlow& flow, const FieldState& state, const Model<3>& model,
                          const State<3>& positions);

/// Adds the pressure of the water to the forces [N] and moments [N m] of the
/// nodes. The pressure is constant over a cell, so its work is the pressure
/// times the change of the cell's volume.
void press_joints(const Model<2>& model, const State<2>& state, const Work<2>& work, std::vector<Vec2>& force,
                  std::vector<double>& moment);
void press_joints(const Model<3>& model, const State<3>& state, const Work<3>& work, std::vector<Vec3>& force,
                  std::vector<Vec3>& moment);

/// Stiffness of the water that is enclosed between two faces, K/a, as a spring
/// between their bodies.
struct WaterSpring {
  int body_a = -1, body_b = -1;
  std::array<std::array<int, 2>, 2> skin{};  ///< of the face of either body
  Vec2 at = Vec2::Zero(), normal = Vec2::Zero();
  double length = 0;     ///< along the faces [m]
  double stiffness = 0;  ///< largest of any cell, with its width [N/m per m of length]
};

/// The water in the joints of a model in which it flows in stages of motion;
/// otherwise none. A joint counts with the smaller of its present aperture and
/// its aperture without load, as it may close before the next estimate.
std::vector<WaterSpring> water_springs(const Model<2>& model, const State<2>& state);
/// True if the water of the joints flows in a stage of motion;
/// `steps_are_explicit`: its steps.
template <int D>
bool flows_in_motion(const Model<D>& model, bool steps_are_explicit);

/// Force on the upper body of a joint [N], and moment about the origin [N m].
struct JointThrust {
  Vec2 force = Vec2::Zero();
  double moment = 0;
};
struct SpaceThrust {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
};
/// A plane; behind it is the side away from its normal.
struct PlaneBehind {
  Vec2 point = Vec2::Zero(), normal = Vec2::UnitX();
};
/// Force on a body by the water in all its joints, or on the part of it behind a plane, and moment about a point.
JointThrust thrust_on_body(const Model<2>& model, const State<2>& state, int body, const Vec2& about,
                           const PlaneBehind* plane = nullptr);
SpaceThrust thrust_on_upper(const FlowJoint& joint, const Model<3>& model, const State<3>& state);
/// Present ends of a joint in space [m].
std::array<Vec3, 2> ends_in_space(const FlowJoint& joint, const Model<3>& model, const State<3>& state);
JointThrust thrust_on_upper(const FlowJoint& joint, const Model<2>& model, const State<2>& state);

}  // namespace trilith
