// Strain and stress at one point of a solid in space, by the laws that are written for the plane.
//
// All laws here are isotropic: what they do is done along the principal axes of the elastic strain of the trial, in
// which there is no shear. There a law of plane strain is asked for the strains e1, e2 in its plane, with -e3 as what
// has flown across: its elastic strain across is then e3. What flows comes back along the same axes. So a law is
// written once, and is in space what it is in plane strain, to rounding.
#pragma once

#include <Eigen/Core>

#include <type_traits>

#include "base/principal_axes.hpp"
#include "material/list.hpp"

namespace trilith {

/// xx, yy, zz, xy, yz, zx of stress [Pa], or of strain with engineering shears [1].
using SpaceVector = Eigen::Matrix<double, 6, 1>;
using SpaceMatrix = Eigen::Matrix<double, 6, 6>;

/// What an inelastic point in space remembers: its plastic strain (shears engineering) and the law's measure of it.
struct SpaceMemory {
  double xx = 0, yy = 0, zz = 0, xy = 0, yz = 0, zx = 0;
  double measure = 0;
  [[nodiscard]] SpaceVector strain() const { return (SpaceVector() << xx, yy, zz, xy, yz, zx).finished(); }
};

/// Of a point in D dimensions.
template <int D>
using PointMemory = std::conditional_t<D == 2, PlasticMemory, SpaceMemory>;

/// Answer of a law in space, as PointResponse.
struct SpaceResponse {
  SpaceVector stress;
  SpaceMemory memory;
  double stored = 0, dissipated = 0;  ///< [J/m3]
};

/// Elastic matrix of an isotropic solid in space [Pa].
SpaceMatrix elastic_in_space(double young, double poisson);
SpaceMatrix elastic_in_space(const Solid& solid);

/// Stress of `strain` less the plastic strain of `memory`, without further flow [Pa].
SpaceVector stress_in_space(const Solid& solid, const SpaceVector& strain, const SpaceMemory& memory);

/// Of a strain with engineering shears.
Eigen::Matrix3d tensor_of_strain(const SpaceVector& strain);

/// What `law` answers at a strain with the memory of before.
template <class Law>
SpaceResponse respond_in_space(const Law& law, const SpaceVector& strain, const SpaceMemory& before) {
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

}  // namespace trilith
