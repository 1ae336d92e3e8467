// Loads on bodies, displacement control and quiet release: made between steps, for the model to hold.
//
// Places and faces are those of the bodies where they stand at the start; a load moves with its body.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "load/forces.hpp"
#include "world/model.hpp"
#include "world/state.hpp"
#include "world/work.hpp"

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
/// that are not finite, a load curve that makes no sense, a point that is not in a deformable body.
std::vector<PointLoad<2>> make_point_load(const Model<2>& model, int body, const PointLoadSpec& spec);
/// Throws InputError for numbers that are not finite, and a load curve that makes no sense.
PointLoad<3> make_solid_load(const Model<3>& model, int body, const SolidLoadSpec& spec);
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

/// How forces of a push are shared among bodies.
enum class PushPattern { uniform, mass, triangle };  ///< triangle: mass times height above the lowest of all bodies

/// Rows of a push of `bodies`, at their centroids or, of a single body, at a point. Throws InputError where a body
/// cannot move along `direction` (unit vector).
std::vector<PushRow<2>> push_rows(const Model<2>& model, const std::vector<int>& bodies, const std::optional<Vec2>& at,
                                  PushPattern pattern, const Vec2& direction);
/// Adds it, from the present place on. Throws InputError where one of its nodes is pushed already or its name is taken.
void add_push(Model<2>& model, const State<2>& state, const std::string& name, std::vector<PushRow<2>> rows,
              const Vec2& direction, std::shared_ptr<const GroundMotion> motion);

/// Where a push stands: the weighed mean of its points' places along its direction [m].
double push_place(const State<2>& state, const Push<2>& push);

/// Ends a push: its forces stay as loads that fade smoothly within `fade` [s], so that nothing is set off. False where
/// there is none of that name.
bool release_push(Model<2>& model, const State<2>& state, const Work<2>& work, const std::string& name, double fade);

}  // namespace trilith
