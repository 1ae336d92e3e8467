// Laws of solids in space: agreement with plane strain, in any orientation, and closed forms of loads along three axes.
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "base/rotation_3d.hpp"
#include "law/material/space_point.hpp"
#include "near.hpp"

namespace trilith::testing {
namespace {

J2 steel() {
  J2 law;
  law.young = 200e9, law.poisson = 0.3, law.yield = 250e6, law.hardening = 2e9;
  return law;
}
MohrCoulomb soil() {
  MohrCoulomb law;
  law.young = 50e6, law.poisson = 0.25, law.cohesion = 10e3, law.friction = 0.6, law.dilation = 0.2;
  return law;
}
DruckerPrager clay() {
  DruckerPrager law;
  law.young = 50e6, law.poisson = 0.25, law.cohesion = 10e3, law.friction = 0.6, law.dilation = 0.2;
  return law;
}

/// Calls f(law, a strain at which it yields).
template <class F>
void for_each_law(F&& f) {
  f(steel(), 4e-3), f(soil(), 2e-3), f(clay(), 2e-3);
}

SpaceVector turned(const Eigen::Matrix3d& r, const SpaceVector& v, double shear) {
  Eigen::Matrix3d t;
  t << v[0], v[3] / shear, v[5] / shear, v[3] / shear, v[1], v[4] / shear, v[5] / shear, v[4] / shear, v[2];
  t = (r * t * r.transpose()).eval();
  return (SpaceVector() << t(0, 0), t(1, 1), t(2, 2), shear * t(0, 1), shear * t(1, 2), shear * t(2, 0)).finished();
}

TEST_CASE("a law in space equals the plane law in plane strain, step by step") {
  std::mt19937_64 bits(1);
  std::uniform_real_distribution<double> share(-1, 1);
  for_each_law([&](const auto& law, double size) {
    PlasticMemory in_plane;
    SpaceMemory in_space;
    for (int i = 0; i < 50; ++i) {
      const double x = size * share(bits), y = size * share(bits), xy = size * share(bits);
      const PointResponse p = law.respond(Plane::strain, PlaneVector(x, y, xy), in_plane);
      const SpaceResponse s = respond_in_space(law, (SpaceVector() << x, y, 0, xy, 0, 0).finished(), in_space);
      const double scale = 1e-9 * law.young * size;
      CHECK(near_zero(s.stress[0] - p.stress.xx, scale));
      CHECK(near_zero(s.stress[1] - p.stress.yy, scale));
      CHECK(near_zero(s.stress[2] - p.stress.zz, scale));
      CHECK(near_zero(s.stress[3] - p.stress.xy, scale));
      CHECK(near_zero(s.stress[4], scale));
      CHECK(near_zero(s.stress[5], scale));
      CHECK(near_zero(s.stored - p.stored, scale * size));
      CHECK(near_zero(s.dissipated - p.dissipated, scale * size));
      in_plane = p.memory, in_space = s.memory;
    }
  });
}

TEST_CASE("a law in space gives rotated stress for rotated strain") {
  std::mt19937_64 bits(2);
  std::uniform_real_distribution<double> share(-1, 1);
  for_each_law([&](const auto& law, double size) {
    for (int i = 0; i < 40; ++i) {
      SpaceVector strain;
      for (int k = 0; k < 6; ++k) strain[k] = size * share(bits);
      const Turn3 turn(rotation_by(Vec3(share(bits), 2 * share(bits), share(bits))));
      Eigen::Matrix3d r;
      r << turn.x(), turn.y(), turn.z();
      const SpaceResponse plain = respond_in_space(law, strain, {}),
                          from_side = respond_in_space(law, turned(r, strain, 2), {});
      CHECK((turned(r, plain.stress, 1) - from_side.stress).cwiseAbs().maxCoeff() < 1e-9 * law.young * size);
      CHECK(near(from_side.memory.measure, plain.memory.measure, 1e-9));
    }
  });
}

TEST_CASE("J2 in space: pulled along one axis it hardens along its line, from all sides it stays elastic") {
  const J2 law = steel();
  // At a stress s along x beyond the yield stress: plastic strain e = (s - yield)/hardening, -e/2 across.
  const double s = 300e6, e = (s - law.yield) / law.hardening;
  const double along = s / law.young + e, across = -law.poisson * s / law.young - 0.5 * e;
  const SpaceResponse pulled = respond_in_space(law, (SpaceVector() << along, across, across, 0, 0, 0).finished(), {});
  CHECK(near(pulled.stress[0], s, 1e-9));
  CHECK(near_zero(pulled.stress[1], 1e-6 * s));
  CHECK(near_zero(pulled.stress[2], 1e-6 * s));
  CHECK(near(pulled.memory.measure, e, 1e-9));
  const SpaceResponse squeezed = respond_in_space(law, (SpaceVector() << -.01, -.01, -.01, 0, 0, 0).finished(), {});
  CHECK(squeezed.memory.measure == 0);
  CHECK(near(squeezed.stress[0], -.01 * law.young / (1 - 2 * law.poisson), 1e-12));
}

TEST_CASE("Mohr-Coulomb in space: triaxial compression has its known limit") {
  const MohrCoulomb law = soil();
  const double cell = 50e3, sine = std::sin(law.friction), cosine = std::cos(law.friction);
  const double limit = cell * (1 + sine) / (1 - sine) + 2 * law.cohesion * cosine / (1 - sine);
  // The strain across is found so that the stress across equals the cell pressure.
  SpaceMemory memory;
  SpaceResponse r;
  double across = 0;
  for (int step = 1; step <= 40; ++step) {
    const double along = -step * 5e-4;
    double low = -0.05, high = 0.05;
    for (int i = 0; i < 80; ++i) {
      across = 0.5 * (low + high);
      r = respond_in_space(law, (SpaceVector() << across, along, across, 0, 0, 0).finished(), memory);
      (r.stress[0] < -cell ? low : high) = across;
    }
    memory = r.memory;
  }
  CHECK(near(r.stress[0], -cell, 1e-6));
  CHECK(near(r.stress[2], -cell, 1e-6));
  CHECK(near(-r.stress[1], limit, 1e-6));
}

}  // namespace
}  // namespace trilith::testing
