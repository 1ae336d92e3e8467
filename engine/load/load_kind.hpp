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
#pragma once

#include <concepts>
#include <string>
#include <string_view>

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

}  // namespace trilith
