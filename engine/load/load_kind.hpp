// The members of a kind of load. A kind is one file with these members and one row of load/list.hpp.
//
// - Static `kind` and `sentence`: its name in messages, and its description.
// - Static `in_space`: false for a kind that acts in the plane alone.
// - Static `is_water`, optional: true for a kind whose work the ledger shows as work of water.
// - Members `name` and `curve` of a load. The curve is a factor; the curve of `Water` and `Uplift` is a level.
// - Static `members()`: pointers to all data of a load. They determine the fingerprint of a model.
// - Function `scale(factor)` multiplies the full value of the load.
// - Function `parts()`: number of independent parts. The tangent differentiates each part by itself.
// - Function `body_of(part)`: the body that a part acts on.
// - Function `visit(part, see)` calls see(attachment) or see(skin point) for the places that the force of a part
// depends
//   on.
// - Function `apply(on, part)` adds the present force of a part to the target `on`.
//
// `apply` is a template over the target: the nodes in an evaluation, or the readers of results. So there is no virtual
// call, and a kind needs no header of the model.
//
// - Target `time()`: the instant [s].
// - Target `turn_of(attachment)`: rotation of an attached point since the start, used by its .apply(vector).
// - Target `velocity_of(attachment)`: its velocity [m/s].
// - Target `place_of(attachment)`: its position [m].
// - Target `gravity()`: present gravity downwards [m/s2].
// - Target `closed()`: the closed parts of faces (load/water/closed_joints.hpp); for kinds with `is_water`.
// - Target `push(attachment, force, moment)` adds a force [N] and a moment [N m] at an attached point.
// - Target `skin(i)` and `push_skin(i, force)`, in the plane: position of a skin point [m], and a force there [N].
//
// A target with the static member `keeps_parts` reads the part of a load on one side of a plane. A kind that is
// distributed over faces then asks it for the kept part of each face, and adds the resultant of this part:
//
// - Target `kept(a, b)`, in the plane: the kept part of the face between two skin points, see KeptPart.
// - Target `keep(corners)`, in space: the kept part of a plane convex polygon, as a list of corners [m].
// - Target `corners_of(body, face)`, in space: the present corners of a face of a rigid body of one piece [m].
// - Target `push_part(attachment, force, moment)`, in space: adds the resultant of a kept part. `push_skin` adds it in
//   the plane. `push` adds a force at one point, which is kept or not.
//
// A body that cracks hands its loads over to its two parts, see hand_over. A kind with a member `at` and `body` needs
// nothing for it. Others have a function `split(parts, out)`, which appends the loads of the parts to `out`:
//
// - `parts.is_on(body)`: true for the body that has split.
// - `parts.give(attachment, body)`: attaches a point of it to the part that holds the point, and sets `body`.
// - `parts.is_behind(body)`: true for its part behind the plane.
// - `parts.axes_of(part)`, in space: turns vectors from the axes of the body into the axes of a part.
// - `parts.for_face(face, see)`: calls see(face) for the parts of a face, see SplitFace and load/water/water.hpp.
// - `parts.corners_of(face)`, in space: corners of a face of the body, in the axes of its node. `parts.face_with(part,
//   face, corners)`: the face of a part that holds a part of it.
// - `parts.for_polygon(corners, see)`, in space: calls see(part, node, corners) for the parts of a plane convex polygon
//   in the axes of the body's node, each in the axes of the part's node.
// - `parts.is_at_crack(face)`: true for a face that the crack meets at its edge, without dividing it.
// - `parts.for_new_faces(see)`: calls see(face) for all faces of the crack.
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/attachment.hpp"
#include "base/space.hpp"
#include "load/load_curve.hpp"

namespace trilith {

/// Data of a load that is hashed, and its names.
template <class L>
concept LoadData = requires(const L& load) {
  { L::kind } -> std::convertible_to<std::string_view>;
  { L::sentence } -> std::convertible_to<std::string_view>;
  { L::in_space } -> std::convertible_to<bool>;
  { load.name } -> std::convertible_to<std::string>;
  { load.curve } -> std::convertible_to<LoadCurve>;
  L::members();
};

/// Accepts every place in `visit`.
template <int D>
struct AnyPlace {
  void operator()(const Attachment<D>&) const {}
  void operator()(int /*skin*/) const {}
};

/// A kind whose loads act on `Target` in D dimensions.
template <class L, int D, class Target>
concept LoadKind = LoadData<L> && requires(L& changed, const L& load, Target& on, const AnyPlace<D>& see) {
  changed.scale(2.0);
  { load.parts() } -> std::convertible_to<int>;
  { load.body_of(0) } -> std::convertible_to<int>;
  load.visit(0, see);
  load.apply(on, 0);
};

/// True for kinds whose work the ledger shows as work of water.
template <class L>
inline constexpr bool is_water = false;
template <class L>
requires requires {
  L::is_water;
}
inline constexpr bool is_water<L> = L::is_water;
/// True for kinds whose load curve is a level of water, and no factor.
template <class L>
inline constexpr bool has_level = requires(const L& load) {
  load.tail;
}
|| requires(const L& load) {
  load.sealed;
};
/// True for kinds whose force follows from the acceleration of the step.
template <class L>
inline constexpr bool is_inertia = requires {
  L::is_inertia;
};

/// True where loads of the kind act in D dimensions.
template <class L, int D>
inline constexpr bool acts_in = D == 2 || L::in_space;

/// Relative positions on a face in the plane, from its first point [1].
struct KeptPart {
  double from = 0, to = 1;
};
/// True for targets that keep a part of each face.
template <class Target>
inline constexpr bool keeps_parts = requires {
  Target::keeps_parts;
};
/// The part of a face in the plane that a target keeps: all of it, for most targets.
template <class Target>
KeptPart kept_part(const Target& on, int skin_a, int skin_b) {
  if constexpr (keeps_parts<Target>)
    return on.kept(skin_a, skin_b);
  else
    return {};
}

/// A part of a face in the plane of a body that has split: the new face between two skin points, and the relative
/// positions on the old face at which it begins and ends.
struct SplitFace {
  int body = -1, skin_a = -1, skin_b = -1;
  double from = 0, to = 1;
};

/// Appends to `out` the loads that replace `load` after a body has split; see above.
template <class L, class Parts>
void hand_over(const L& load, const Parts& parts, std::vector<L>& out) {
  if constexpr (requires { load.split(parts, out); }) {
    load.split(parts, out);
  } else {
    L given = load;
    if (parts.is_on(given.body)) parts.give(given.at, given.body);
    out.push_back(std::move(given));
  }
}

}  // namespace trilith
