// Strain and stress at one integration point of a solid, in the plane and in space.
#pragma once

#include <Eigen/Core>

#include <cstdint>

namespace trilith {

/// Out-of-plane condition: zero stress (a thin wall) or zero strain (a slice of a long body).
enum class Plane : std::uint8_t { stress, strain };

/// xx, yy [1] and the engineering shear xy = 2 e_xy [1], or xx, yy, xy of stress [Pa].
using PlaneVector = Eigen::Vector3d;

/// Stress [Pa]; zz is 0 in plane stress.
struct Stress {
  double xx = 0, yy = 0, zz = 0, xy = 0;
  [[nodiscard]] PlaneVector in_plane() const { return {xx, yy, xy}; }
};

/// Memory of an inelastic point: plastic strain (xy engineering) and the law's measure of it (never decreases).
struct PlasticMemory {
  double xx = 0, yy = 0, zz = 0, xy = 0;
  double measure = 0;
};

/// Response of a law to a strain.
struct PointResponse {
  Stress stress;
  PlasticMemory memory;
  double stored = 0;      ///< elastic energy [J/m3]
  double dissipated = 0;  ///< plastic work of this step, never negative [J/m3]
};

/// xx, yy, zz, xy, yz, zx of stress [Pa], or of strain with engineering shears [1].
using SpaceVector = Eigen::Matrix<double, 6, 1>;
using SpaceMatrix = Eigen::Matrix<double, 6, 6>;

/// Memory of an inelastic point in space: plastic strain (engineering shears) and the law's measure of it.
struct SpaceMemory {
  double xx = 0, yy = 0, zz = 0, xy = 0, yz = 0, zx = 0;
  double measure = 0;
  [[nodiscard]] SpaceVector strain() const { return (SpaceVector() << xx, yy, zz, xy, yz, zx).finished(); }
};

/// Response of a law in space, like PointResponse.
struct SpaceResponse {
  SpaceVector stress;
  SpaceMemory memory;
  double stored = 0, dissipated = 0;  ///< [J/m3]
};

/// Elastic matrix of an isotropic solid in space [Pa].
SpaceMatrix elastic_in_space(double young, double poisson);

/// Elastic matrix of an isotropic solid: stress (xx, yy, xy) per strain (xx, yy, xy engineering) [Pa].
inline Eigen::Matrix3d elastic_matrix(double young, double poisson, Plane plane) {
  const double e = plane == Plane::stress ? young : young / (1 - poisson * poisson);
  const double v = plane == Plane::stress ? poisson : poisson / (1 - poisson);
  Eigen::Matrix3d c;
  c << 1, v, 0, v, 1, 0, 0, 0, 0.5 * (1 - v);
  return e / (1 - v * v) * c;
}

/// Stress of the elastic strain (xx, yy, xy) in the plane; in plane strain the elastic strain zz is minus `plastic_zz`.
inline Stress elastic_stress(double young, double poisson, Plane plane, const PlaneVector& elastic, double plastic_zz) {
  if (plane == Plane::stress) {
    const PlaneVector s = elastic_matrix(young, poisson, plane) * elastic;
    return {s[0], s[1], 0, s[2]};
  }
  const double shear = young / (2 * (1 + poisson)), lambda = 2 * shear * poisson / (1 - 2 * poisson);
  const double volume = lambda * (elastic[0] + elastic[1] - plastic_zz);
  return {volume + 2 * shear * elastic[0], volume + 2 * shear * elastic[1], volume - 2 * shear * plastic_zz,
          shear * elastic[2]};
}

}  // namespace trilith
