// Strain and stress at one integration point of a solid in space.
//
// A law of tensor form (law/material/tensor_form.hpp) is used directly. A law written for plane strain must declare
// `acts_across`: it treats the out-of-plane strain like the in-plane strains, and is isotropic. It is evaluated along
// the principal axes of the trial's elastic strain, where shear vanishes. The strains e1, e2 are in its plane and its
// plastic out-of-plane strain is -e3, so that its elastic out-of-plane strain is e3. The plastic strain is rotated back
// along the same axes. A law for the plane alone is rejected when a body in space is added.
#pragma once

#include <Eigen/Core>

#include <stdexcept>
#include <type_traits>

#include "base/principal_axes.hpp"
#include "law/material/list.hpp"

namespace trilith {

/// Memory of a point in D dimensions.
template <int D>
using PointMemory = std::conditional_t<D == 2, PlasticMemory, SpaceMemory>;

/// Elastic matrix of an isotropic solid in space [Pa].
SpaceMatrix elastic_in_space(const Solid& solid);

/// Stress of `strain` minus the plastic strain in `memory`, without further flow [Pa].
SpaceVector stress_in_space(const Solid& solid, const SpaceVector& strain, const SpaceMemory& memory);

/// From a strain with engineering shears.
Eigen::Matrix3d tensor_of_strain(const SpaceVector& strain);

/// Response at a strain of a law that acts across its plane; `before` is the previous memory.
template <class Law>
SpaceResponse respond_along_axes(const Law& law, const SpaceVector& strain, const SpaceMemory& before) {
  const Eigen::Matrix3d elastic = tensor_of_strain(strain - before.strain());
  const PrincipalAxes p = principal_axes(elastic, 1e-17 * elastic.cwiseAbs().maxCoeff());
  const PlasticMemory across{0, 0, -p.value[2], 0, before.measure};
  const PointResponse r = law.respond(Plane::strain, PlaneVector(p.value[0], p.value[1], 0), across);
  const Eigen::Vector3d flown(r.memory.xx, r.memory.yy, r.memory.zz + p.value[2]),
      stress(r.stress.xx, r.stress.yy, r.stress.zz);
  const Eigen::Matrix3d s = p.axes * stress.asDiagonal() * p.axes.transpose(),
                        e = p.axes * flown.asDiagonal() * p.axes.transpose();
  SpaceResponse out;
  out.stress << s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(1, 2), s(2, 0);
  out.memory = {before.xx + e(0, 0),     before.yy + e(1, 1),     before.zz + e(2, 2), before.xy + 2 * e(0, 1),
                before.yz + 2 * e(1, 2), before.zx + 2 * e(2, 0), r.memory.measure};
  out.stored = r.stored, out.dissipated = r.dissipated;
  return out;
}

/// Response at a strain of a law that acts in space; `before` is the previous memory.
template <class Law>
SpaceResponse respond_in_space(const Law& law, const SpaceVector& strain, const SpaceMemory& before) {
  if constexpr (TensorLaw<Law>)
    return law.respond(strain, before);
  else if constexpr (acts_in_space<Law>)
    return respond_along_axes(law, strain, before);
  else
    throw std::logic_error("a material law for the plane only is used in space");
}

}  // namespace trilith
