// Natural frequencies and shapes of an assembly as it stands: K phi = w^2 M phi.
//
// K is the tangent of all forces at the present state (assembly/tangent/tangent.hpp): of elements and beams with what
// loads and weight make of their geometry, of bearings on their present branch, of contacts that are closed and stick.
// Where faces stand apart there is no stiffness; where friction slides just now, K is not symmetric, and its symmetric
// part is taken. M is lumped but for frames with consistent mass. Shift and invert (Lanczos), by Spectra; all at once
// where there are few.
#pragma once

#include <array>
#include <vector>

#include "base/space.hpp"
#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

template <int D>
struct NaturalMode {
  double square = 0;                 ///< w^2; below 0 where the assembly is unstable [rad2/s2]
  std::vector<Vec<D>> displacement;  ///< [node] phi' M phi = 1 [1/sqrt(kg)]
  std::vector<Spin<D>> rotation;     ///< [node] in space about the axes of the world
  std::array<double, D> mass{};      ///< effective mass along each axis [kg]
  std::array<double, D> factor{};    ///< participation: phi' M r, r = 1 along that axis [sqrt(kg)]

  /// [Hz]; of an unstable or a rigid mode 0.
  [[nodiscard]] double frequency() const;
};
using Mode = NaturalMode<2>;

/// The state at rest where it stands, as one that a change of place has slip and friction from; to be evaluated over
/// State::last_dt.
template <int D>
State<D> at_rest(const State<D>& from);

/// The lowest `count` modes, or as many as there are degrees of freedom, by rising w^2. Throws InputError where nothing
/// is free to move, and where there are fewer than 1 to find.
template <int D>
std::vector<NaturalMode<D>> modes(const Model<D>& model, const State<D>& state, int count);

/// Mass that is free to move along each axis [kg].
template <int D>
std::array<double, D> free_mass(const Model<D>& model, const State<D>& state);

}  // namespace trilith
