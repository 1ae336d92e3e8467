// A material law with equations in space. The laws of plane strain and plane stress are derived from it.
//
// A law of tensor form has  SpaceResponse respond(const SpaceVector& strain, const SpaceMemory& before) const.
// Plane strain has e_zz = 0. Plane stress has the strain e_zz at which the stress s_zz vanishes; it is found by the
// secant method within a bracket.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>

#include "law/material/point.hpp"

namespace trilith {

template <class L>
concept TensorLaw = requires(const L& law, const SpaceVector& strain, const SpaceMemory& before) {
  { law.respond(strain, before) } -> std::same_as<SpaceResponse>;
};

/// True for a plane law that declares `acts_across`: it treats the out-of-plane strain like the in-plane ones. See
/// law/material/space_point.hpp.
template <class L>
concept AcrossLaw = requires {
  requires L::acts_across;
};

/// Whether a law has equations in space.
template <class L>
inline constexpr bool acts_in_space = [] {
  if constexpr (L::is_elastic)
    return true;
  else
    return TensorLaw<L> || AcrossLaw<L>;
}();

/// A strain in the plane with the strain `across` [1].
inline SpaceVector space_strain(const PlaneVector& in_plane, double across) {
  SpaceVector out;
  out << in_plane[0], in_plane[1], across, in_plane[2], 0, 0;
  return out;
}

inline PointResponse plane_part(const SpaceResponse& r) {
  const SpaceMemory& m = r.memory;
  return {{r.stress[0], r.stress[1], r.stress[2], r.stress[3]},
          {m.xx, m.yy, m.zz, m.xy, m.measure},
          r.stored,
          r.dissipated};
}

/// With zero out-of-plane stress. The bounds are widened until this stress changes its sign between them. After
/// repeated steps on one side the value at the other end is halved, so that both ends converge (Illinois method).
template <class Law>
SpaceResponse respond_without_stress_across(const Law& law, const PlaneVector& strain, const SpaceMemory& before) {
  const auto at = [&](double across) { return law.respond(space_strain(strain, across), before); };
  const double share = law.poisson / (1 - law.poisson),
               guess = before.zz - share * (strain[0] + strain[1] - before.xx - before.yy);
  const double enough = 1e-12 * law.young * std::max(strain.cwiseAbs().maxCoeff(), 1e-12);
  SpaceResponse out = at(guess);
  if (std::abs(out.stress[2]) <= enough) return out;
  double reach = std::max(strain.cwiseAbs().maxCoeff(), 1e-12), near = guess, of_near = out.stress[2], far = guess,
         of_far = of_near;
  for (int i = 0; i < 60 && of_far * of_near > 0; ++i, reach *= 2) {
    near = far, of_near = of_far;
    far = guess + (of_near > 0 ? -reach : reach), out = at(far), of_far = out.stress[2];
  }
  for (int i = 0; i < 200 && std::abs(out.stress[2]) > enough; ++i) {
    const double next = near - of_near * (far - near) / (of_far - of_near);
    out = at(next);
    const bool beyond = out.stress[2] * of_far < 0;
    if (beyond)
      near = far, of_near = of_far;
    else
      of_near *= 0.5;
    far = next, of_far = out.stress[2];
  }
  return out;
}

/// Response of a law in the plane at a strain; `before` is the previous memory.
template <class Law>
PointResponse respond_in_plane(const Law& law, Plane plane, const PlaneVector& strain, const PlasticMemory& before) {
  if constexpr (TensorLaw<Law>) {
    const SpaceMemory m{before.xx, before.yy, before.zz, before.xy, 0, 0, before.measure};
    if (plane == Plane::strain) return plane_part(law.respond(space_strain(strain, 0), m));
    PointResponse out = plane_part(respond_without_stress_across(law, strain, m));
    out.stress.zz = 0;
    return out;
  } else {
    return law.respond(plane, strain, before);
  }
}

}  // namespace trilith
