// Water against bodies, created between steps and stored in the model (load/water/water.hpp, load/water/uplift.hpp,
// load/water/drag.hpp).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "load/list.hpp"
#include "model/loads.hpp"
#include "model/model.hpp"

namespace trilith {

/// Specification of water. Faces are chosen at the start.
struct WaterSpec {
  std::string name;
  LoadCurve level;        ///< [m], with at least one point
  double density = 1000;  ///< [kg/m3]
  bool sealed = true;     ///< closed joints are dry; false: water reaches the whole of each face
};

/// Specification of water in the joint between two bodies whose faces lie on each other at the start.
template <int D>
struct UpliftSpec {
  std::string name;
  int upper = -1, lower = -1;        ///< bodies
  std::string upstream, downstream;  ///< names of waters; downstream "" without tail water
  std::optional<Vec<D>> heel;   ///< a point on the side where the water enters [m]; default: from the faces upstream
  bool full = false;            ///< the head upstream acts everywhere
  double drain_at = 0;          ///< distance of the drain from the heel [m]; 0: none
  double drain_efficiency = 0;  ///< from 0 to 1 [1]
};

/// Specification of the drag of a flow on a body.
template <int D>
struct DragSpec {
  std::string name;
  std::optional<Vec<D>> at;      ///< point of action at the start [m]; default: the centroid, of a rigid body
  Vec<D> flow = Vec<D>::Zero();  ///< [m/s]
  double coefficient = 0;        ///< above 0 [1]
  double area = 0;               ///< above 0 [m2]
  double density = 1000;         ///< above 0 [kg/m3]
  LoadCurve curve;
};

/// Faces of a body whose outward normal points to `side` at the start, at any angle below 90 degrees.
std::vector<FacePart> faces_on_side(const Model<2>& model, int body, const Vec2& side);
std::vector<SolidFace> faces_on_side(const Model<3>& model, int body, const Vec3& side);

/// As faces that water may reach. In space without the parts that other pieces of a rigid body cover.
std::vector<WetFace<2>> wet_faces(const Model<2>& model, int body, const std::vector<FacePart>& faces);
std::vector<WetFace<3>> wet_faces(const Model<3>& model, int body, const std::vector<SolidFace>& faces);

/// Throws InputError for a model without gravity along its vertical axis, a density that is not above 0, an invalid
/// level, or no faces.
template <int D>
Water<D> make_water(const Model<D>& model, const WaterSpec& spec, std::vector<WetFace<D>> faces);
/// Throws InputError for bodies whose faces do not lie on each other, waters that do not exist, a side that does not
/// follow from the faces upstream, and a drain outside of the joint.
template <int D>
Uplift<D> make_uplift(const Model<D>& model, const UpliftSpec<D>& spec);
/// The faces of two bodies that lie on each other at the start.
template <int D>
struct JointFaces {
  std::vector<WetFace<D>> upper, lower;
  std::vector<Vec<D>> points;      ///< ends of their shared parts [m]
  Vec<D> normal = Vec<D>::Zero();  ///< sum of the normals
};
/// Throws InputError, beginning with `owner`, if no faces lie on each other.
template <int D>
JointFaces<D> joint_faces(const Model<D>& model, int upper, int lower, const std::string& owner);
/// Throws InputError for numbers out of range, and for a deformable body without a point of action.
template <int D>
Drag<D> make_drag(const Model<D>& model, int body, const DragSpec<D>& spec);

/// From `now` [s] on, changes the level of the water `name`, and of the uplift that follows it, smoothly within
/// `duration` [s] to `level` [m]. Returns the number of waters.
template <int D>
int change_level(Model<D>& model, const std::string& name, double now, double level, double duration);

/// The water of that name, or nullptr.
template <int D>
const Water<D>* find_water(const Model<D>& model, const std::string& name);

}  // namespace trilith
