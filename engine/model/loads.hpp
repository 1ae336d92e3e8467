// Loads on bodies, created between steps and stored in the model. Displacement controls are in model/pushes.hpp.
//
// Positions and faces refer to the bodies at the start; a load moves with its body.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "load/list.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Specification of a force.
struct PointLoadSpec {
  std::string name;
  std::optional<Vec2> at;     ///< [m]; default: the centroid, distributed like the mass over a deformable body
  Vec2 force = Vec2::Zero();  ///< [N]
  double moment = 0;          ///< [N m]; for a deformable body only with `at`
  bool follows = false;       ///< rotates with the body
  LoadCurve curve;
};

/// Specification of a force on a body in space.
struct SolidLoadSpec {
  std::string name;
  std::optional<Vec3> at;      ///< position at the start [m]; default: the centroid
  Vec3 force = Vec3::Zero();   ///< [N]
  Vec3 moment = Vec3::Zero();  ///< [N m]
  bool follows = false;        ///< force and moment rotate with the body
  LoadCurve curve;
};

/// Specification of a pressure.
struct PressureSpec {
  std::string name;
  double value = 0;               ///< [Pa], positive onto the face
  bool follows = true;            ///< true: normal to the present face; false: with the force at the start
  std::optional<Vec2> direction;  ///< direction of action if it does not follow
  LoadCurve curve;
};

/// Specification of a pressure on a body in space.
struct SolidPressureSpec {
  std::string name;
  double value = 0;               ///< [Pa], positive onto the face
  bool follows = true;            ///< true: rotates with the face; false: with the force at the start
  std::optional<Vec3> direction;  ///< direction of action if it does not follow
  LoadCurve curve;
};

/// A face of a piece of a body in space.
struct SolidFace {
  int piece = -1, face = -1;
};

/// A part of a face of a body's outline, by relative positions from one skin point to the next, counter-clockwise.
struct FacePart {
  int skin_a = -1, skin_b = -1;
  double from = 0, to = 1;
};

/// Named points of a body: "centroid"; "top", "bottom", "left", "right": the centre of the faces towards that side;
/// "top left" and so on: the outermost corner.
inline constexpr std::string_view place_names =
    "centroid, top, bottom, left, right, top left, top right, bottom left, bottom right";
std::optional<Vec2> named_place(const Model<2>& model, int body, std::string_view name);

/// All faces of the body's outline.
std::vector<FacePart> outline_faces(const Model<2>& model, int body);
/// Faces towards `side`, within 45 degrees.
std::vector<FacePart> faces_towards(const Model<2>& model, int body, const Vec2& side);
/// The outline from the point nearest to `from`, counter-clockwise, to the point nearest to `to`. Throws InputError
/// where a point is farther from the outline than a hundredth of the body's size, or both are equal.
std::vector<FacePart> faces_between(const Model<2>& model, int body, const Vec2& from, const Vec2& to,
                                    const std::string& owner);

/// The load in the model's form, work-consistent: in the element that contains `at`. Throws InputError for numbers that
/// are not finite, an invalid load curve, a point outside of a deformable body, or farther from a rigid one than its
/// size.
std::vector<PointLoad<2>> make_point_load(const Model<2>& model, int body, const PointLoadSpec& spec);
/// Throws InputError for numbers that are not finite, and an invalid load curve.
PointLoad<3> make_solid_load(const Model<3>& model, int body, const SolidLoadSpec& spec);
/// For any body in space. A force at a point of a body of elements is distributed to the nodes of the element that
/// contains it, by the shape functions. Without a point it is distributed to all nodes by mass, like weight. A moment
/// at a point, or a force that follows, acts on the nearest face of its skin. Also throws InputError for a point
/// outside of a body of elements, and for a moment or a force that follows without a point on a deformable body.
std::vector<PointLoad<3>> make_solid_loads(const Model<3>& model, int body, const SolidLoadSpec& spec);
/// All plane faces of a body's surface in space; a sphere has none.
std::vector<SolidFace> surface_faces(const Model<3>& model, int body);
/// Faces towards `side` at the start, within 45 degrees.
std::vector<SolidFace> faces_towards(const Model<3>& model, int body, const Vec3& side);
/// Like make_pressure, for faces with their size at the start.
std::vector<PointLoad<3>> make_solid_pressure(const Model<3>& model, int body, const std::vector<SolidFace>& faces,
                                              const SolidPressureSpec& spec);
std::vector<FaceLoad<2>> make_pressure(const Model<2>& model, int body, const std::vector<FacePart>& faces,
                                       const PressureSpec& spec);

/// Out-of-plane width of a body [m].
double depth_of(const Model<2>& model, int body);

/// Removes the faded loads of supports released before `now` [s], which have no name.
template <int D>
void drop_faded(Model<D>& model, double now);
/// From `now` [s] on, changes the loads named `name` smoothly within `duration` [s] from their present share to `share`
/// of their full size. Returns their number. Water has a level and no share: see model/water/water.hpp.
template <int D>
int change_loads(Model<D>& model, const std::string& name, double now, double share, double duration);
/// Scales the loads named `name`, or all if it is empty. Returns their number.
template <int D>
int scale_loads(Model<D>& model, const std::string& name, double factor);
/// Removes the loads named `name` at once. Returns their number.
template <int D>
int drop_loads(Model<D>& model, const std::string& name);
/// Names of all loads and displacement controls, each once.
template <int D>
std::vector<std::string> load_names(const Model<D>& model);

}  // namespace trilith
