// A block that slides freely on mortar that dilates, crushes and damps: the ledger of each leapfrog step.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "contact/joint/face_resultant.hpp"
#include "contact/plane/face_pair.hpp"
#include "law/contact/cohesive.hpp"

using namespace trilith;

namespace {

/// A block of 20 t under its weight, with a face of 1 m on a long one.
struct SlidingBlock {
  static constexpr double mass = 2e4, gravity = 9.81;
  Cohesive::Kernel law;
  double x = 0, y = -mass * gravity / 1e9, vx = 1, vy = -0.3;
  FaceMemory<double> memory{};
  Cohesive::Kernel::Memory<double> own{};
  double lost = 0;

  SlidingBlock(const Cohesive& mortar, double dt, bool bonded) : law(mortar, 1, dt) {
    memory.bonds[0] = memory.bonds[1] = bonded;
  }

  /// Elastic energy of pressure and shear [J].
  [[nodiscard]] double stored(const FaceEnds<double>& a, const FaceEnds<double>& b) const {
    ContactMemory m;
    double shear = 0;
    for (const int h : {0, 1}) {
      m.active[h] = memory.active[h], m.shear_elastic[h] = memory.shear_elastic[h];
      if (m.active[h] > 0) shear += 0.5 * m.shear_elastic[h] * m.shear_elastic[h] / (law.ks * m.active[h]);
    }
    m.slip = memory.slip;
    m.bonds = (memory.bonds[0] ? 1U : 0U) | (memory.bonds[1] ? 2U : 0U);
    return shear + pressing_energy(FaceOverlap<double>(a, b), m, own, law);
  }

  /// One step; all energy at its start [J].
  double step() {
    const FaceEnds<double> a{4, 0, -2, 0, 0, 0, 0, 0}, b{x, y, x + 1, y, vx, vy, vx, vy};
    const auto r = respond_face_pair<Cohesive::Kernel, double>(a, b, 1.0, memory, own, law);
    memory = r.memory, own = r.own;
    lost += r.lost_damping + r.lost_friction + r.lost_fracture;
    const double ux = vx + law.dt * (r.bx0 + r.bx1) / mass, uy = vy + law.dt * ((r.by0 + r.by1) / mass - gravity);
    const double energy = 0.5 * mass * (vx * ux + vy * uy) + mass * gravity * y + stored(a, b) + lost;
    vx = ux, vy = uy, x += law.dt * vx, y += law.dt * vy;
    return energy;
  }
};

}  // namespace

TEST_CASE("the ledger of a joint that slides closes where it dilates, crushes and damps") {
  for (const double dt : {1e-5, 4e-5})
    for (const bool bonded : {false, true})
      for (const double dilation : {0.0, 0.3})
        for (const double beta : {0.0, 1e-4}) {
          Cohesive mortar{1e9, 5e8, 0.6, beta, 1e5, 5e4, 20, 100, dilation, 0.02, 3e5, 0.02};
          SlidingBlock block(mortar, dt, bonded);
          block.step();
          const double first = block.step();
          double off = 0;
          for (int i = 0; i < static_cast<int>(0.05 / dt); ++i) off = std::max(off, std::abs(block.step() - first));
          CAPTURE(dt);
          CAPTURE(bonded);
          CAPTURE(dilation);
          CAPTURE(beta);
          CHECK(block.own.crushed[0] > 5e-3);
          CHECK(off < 1e-10 * block.lost);
        }
}
