// Natural frequencies and mode shapes of an assembly in its present state: K phi = w^2 M phi.
//
// K is the tangent of all forces at the present state (assembly/tangent/tangent.hpp). It contains elements and beams
// with the geometric stiffness of loads and weight, bearings on their present branch, and closed contacts, which stick.
// Faces apart have no stiffness. If friction slides at present, K is not symmetric, and its symmetric part is used. M
// is lumped, except for frames with consistent mass. Large models use shift and invert (Lanczos, by Spectra); small
// models compute all modes.
#pragma once

#include <array>
#include <vector>

#include "base/space.hpp"
#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

template <int D>
struct NaturalMode {
  double square = 0;                 ///< w^2; negative for an unstable assembly [rad2/s2]
  std::vector<Vec<D>> displacement;  ///< [node] phi' M phi = 1 [1/sqrt(kg)]
  std::vector<Spin<D>> rotation;     ///< [node] in space about world axes
  std::array<double, D> mass{};      ///< effective mass along each axis [kg]
  std::array<double, D> factor{};    ///< participation: phi' M r, r = 1 along that axis [sqrt(kg)]

  /// [Hz]; 0 for an unstable or a rigid mode.
  [[nodiscard]] double frequency() const;
};
using Mode = NaturalMode<2>;

/// The state at rest in its present position, prepared so that a displacement causes slip and friction; to be evaluated
/// over State::last_dt.
template <int D>
State<D> at_rest(const State<D>& from);

/// The lowest `count` modes, or as many as there are degrees of freedom, by increasing w^2. Throws InputError if no
/// degree of freedom is free, and for a count below 1.
template <int D>
std::vector<NaturalMode<D>> modes(const Model<D>& model, const State<D>& state, int count);

/// Mass that is free to move along each axis [kg].
template <int D>
std::array<double, D> free_mass(const Model<D>& model, const State<D>& state);

}  // namespace trilith
