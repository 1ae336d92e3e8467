// Loads on bodies: made between steps, for the model to hold. Pushes are in model/pushes.hpp.
//
// Places and faces are those of the bodies where they stand at the start; a load moves with its body.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "load/forces.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// A force to be.
struct PointLoadSpec {
  std::string name;
  std::optional<Vec2> at;     ///< [m]; without it the centroid, spread like the mass over a deformable body
  Vec2 force = Vec2::Zero();  ///< [N]
  double moment = 0;          ///< [N m]; of a deformable body with `at` alone
  bool follows = false;       ///< turns with the body
  LoadCurve curve;
};

/// A force on a rigid body in space to be.
struct SolidLoadSpec {
  std::string name;
  std::optional<Vec3> at;      ///< where the body stands at the start [m]; without it the centroid
  Vec3 force = Vec3::Zero();   ///< [N]
  Vec3 moment = Vec3::Zero();  ///< [N m]
  bool follows = false;        ///< both turn with the body
  LoadCurve curve;
};

/// A pressure to be.
struct PressureSpec {
  std::string name;
  double value = 0;               ///< [Pa], onto the face where above 0
  bool follows = true;            ///< acts against the face as it is; false: with the force it has at the start
  std::optional<Vec2> direction;  ///< along which it acts instead, where it does not follow
  LoadCurve curve;
};

/// A pressure on a body in space to be.
struct SolidPressureSpec {
  std::string name;
  double value = 0;               ///< [Pa], onto the face where above 0
  bool follows = true;            ///< turns with the face; false: with the force it has at the start
  std::optional<Vec3> direction;  ///< along which it acts instead, where it does not follow
  LoadCurve curve;
};

/// A face of a piece of a body in space.
struct SolidFace {
  int piece = -1, face = -1;
};

/// A part of a face of a body's outline, by shares of the way from one skin point to the next, counter-clockwise.
struct FacePart {
  int skin_a = -1, skin_b = -1;
  double from = 0, to = 1;
};

/// Places of a body that have names: "centroid"; "top", "bottom", "left", "right": the middle of the faces that look
/// there; "top left" and so on: the corner farthest out.
inline constexpr std::string_view place_names =
    "centroid, top, bottom, left, right, top left, top right, bottom left, bottom right";
std::optional<Vec2> named_place(const Model<2>& model, int body, std::string_view name);

/// All faces of the body's outline.
std::vector<FacePart> outline_faces(const Model<2>& model, int body);
/// Those that look along `side`, within 45 degrees.
std::vector<FacePart> faces_towards(const Model<2>& model, int body, const Vec2& side);
/// The outline from the point nearest to `from` on, counter-clockwise, to the point nearest to `to`. Throws InputError
/// where one of them is farther from the outline than a hundredth of the body's size, or both are the same.
std::vector<FacePart> faces_between(const Model<2>& model, int body, const Vec2& from, const Vec2& to,
                                    const std::string& owner);

/// The load as the model holds it, work-consistent: in the element that `at` lies in. Throws InputError for numbers
/// that are not finite, a load curve that makes no sense, a point that is not in a deformable body or is farther from a
/// rigid one than that is large.
std::vector<PointLoad<2>> make_point_load(const Model<2>& model, int body, const PointLoadSpec& spec);
/// Throws InputError for numbers that are not finite, and a load curve that makes no sense.
PointLoad<3> make_solid_load(const Model<3>& model, int body, const SolidLoadSpec& spec);
/// The same on any body in space, as the model holds it. A force at a point of a body of elements goes to the nodes of
/// the element that holds it, by the shape functions, and without a point to all nodes by mass, as weight does; a
/// moment there, or a force that follows, to the nearest face of its skin. Throws InputError too for a point outside of
/// a body of elements, and for a moment or a force that follows without a point on a body that deforms.
std::vector<PointLoad<3>> make_solid_loads(const Model<3>& model, int body, const SolidLoadSpec& spec);
/// All plane faces of a body's surface in space; a sphere has none.
std::vector<SolidFace> surface_faces(const Model<3>& model, int body);
/// Those that look along `side` at the start, within 45 degrees.
std::vector<SolidFace> faces_towards(const Model<3>& model, int body, const Vec3& side);
/// As make_pressure, on faces of the size they have at the start.
std::vector<PointLoad<3>> make_solid_pressure(const Model<3>& model, int body, const std::vector<SolidFace>& faces,
                                              const SolidPressureSpec& spec);
std::vector<FaceLoad<2>> make_pressure(const Model<2>& model, int body, const std::vector<FacePart>& faces,
                                       const PressureSpec& spec);

/// Drops the loads of supports released before `now` [s] that have faded; they have no name.
template <int D>
void drop_faded(Model<D>& model, double now);
/// From `now` [s] on the loads called `name` go to `share` of their full size within `duration` [s], smoothly, from
/// the share they have. Gives how many.
template <int D>
int change_loads(Model<D>& model, const std::string& name, double now, double share, double duration);
/// Scales the point and face loads called `name`, or all where it is empty. Gives how many.
template <int D>
int scale_loads(Model<D>& model, const std::string& name, double factor);
/// Takes the loads called `name` away at once. Gives how many.
template <int D>
int drop_loads(Model<D>& model, const std::string& name);
/// Names of all loads and pushes, each once.
template <int D>
std::vector<std::string> load_names(const Model<D>& model);

}  // namespace trilith
