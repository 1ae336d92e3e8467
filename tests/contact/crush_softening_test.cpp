// Crushing that softens: energy, peak, residual and unloading in every geometry, and the moment of a joint pressed
// outside its middle against the integral of the law at its points.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "contact/held_joint.hpp"
#include "contact/law_trial.hpp"
#include "contact/mortar_joint.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

constexpr double peak_stress = 2e6, crush_given = 8000, residual_share = 0.2;  // [Pa], [J/m2], [1]
constexpr double bed_kn = MortarJoint::kn, left_stress = residual_share * peak_stress;
constexpr double softened_depth =
    2 * crush_given / (peak_stress - left_stress);  // crushed depth at the residual strength [m]

Cohesive softening_mortar() {
  Cohesive law = MortarJoint::mortar();
  law.compression = peak_stress, law.crushing_depth = 0.03, law.crush_energy = crush_given,
  law.crush_residual = residual_share;
  law.check();
  return law;
}

/// The law at a point: stress at an overlap that has only grown [Pa].
double crushed_stress(double overlap) {
  if (bed_kn * overlap <= peak_stress) return bed_kn * std::max(overlap, 0.0);
  const double slope = (peak_stress - left_stress) / softened_depth;
  return std::max(left_stress, peak_stress - slope * (overlap - peak_stress / bed_kn) / (1 - slope / bed_kn));
}
/// Overlap at the crushed depth z [m].
double crushed_overlap(double z) {
  return z + std::max(left_stress, peak_stress - (peak_stress - left_stress) * z / softened_depth) / bed_kn;
}

/// Energy of crushing to the depth z, per area [J/m2].
double crush_spent(double z) {
  return left_stress * z + crush_given * (z < softened_depth ? (2 - z / softened_depth) * z / softened_depth : 1);
}

MortarJoint softening_joint() {
  MortarJoint joint;
  joint.law = Cohesive::Kernel(softening_mortar(), 1, 1e-4);
  return joint;
}

}  // namespace

TEST_CASE("crushed mortar softens to its residual strength, spends its energy, and unloads with its stiffness") {
  for (const int steps : {300, 3000}) {
    MortarJoint joint = softening_joint();
    double peak = 0;
    for (const double z : {0.25 * softened_depth, 0.75 * softened_depth, softened_depth, 1.3 * softened_depth}) {
      joint.lead(-crushed_overlap(z), 0, steps, [&] { peak = std::max(peak, -joint.normal); });
      CHECK(near(joint.own.crushed[0], z, 1e-9));
      CHECK(near(-joint.normal, crushed_stress(crushed_overlap(z)), 1e-9));
      // The step in which crushing begins is partly elastic.
      CHECK(near(joint.fracture, crush_spent(z), 30.0 / (steps * steps) + 0.3 / steps));
      CHECK(near(joint.work, joint.fracture + joint.stored(), 1e-9));
      const double here = joint.normal;
      joint.lead(joint.gap - 0.5 * here / bed_kn, 0, 10);
      CHECK(near(joint.normal, 0.5 * here, 1e-9));
      joint.lead(-crushed_overlap(z), 0, 10);
    }
    CHECK(peak <= peak_stress * (1 + 1e-12));
    CHECK(near(peak, peak_stress, 20.0 / steps));
  }
}

TEST_CASE("without a crushing energy the strength stays, to the bit") {
  Cohesive plain = MortarJoint::mortar();
  plain.compression = peak_stress, plain.crushing_depth = 0.03;
  const Cohesive::Kernel law(plain, 1, 1e-4);
  for (const double z : {0.0, 1e-5, 3e-3, 0.03}) CHECK(law.crush_limit(z) == law.crushing);
  CHECK(law.crush_slope == 0);
}

TEST_CASE("an energy of crushing that cannot soften is refused with its limit") {
  const auto refused = [](const Cohesive& law, const std::string& with) {
    try {
      law.check();
    } catch (const InputError& e) {
      return std::string(e.what()).find(with) != std::string::npos;
    }
    return false;
  };
  Cohesive law = softening_mortar();
  const double least = (peak_stress - left_stress) * (peak_stress - left_stress) / bed_kn;
  law.crush_energy = 1.001 * least;
  CHECK_NOTHROW(law.check());
  law.crush_energy = 0.999 * least;
  CHECK(refused(law, "must be above (fc - fr)^2/kn = 2560"));
  law = softening_mortar();
  law.crushing_depth = 1.001 * softened_depth;
  CHECK_NOTHROW(law.check());
  law.crushing_depth = 0.999 * softened_depth;
  CHECK(refused(law, "larger crushing_depth"));
  law = softening_mortar();
  law.compression = 0;
  CHECK(refused(law, "without compression"));
  law = MortarJoint::mortar();
  law.crush_residual = 0.3;
  CHECK(refused(law, "without crush_energy"));
}

namespace {

/// A face of 1 m in `count` equal contacts, turned about its middle.
struct DividedFace {
  const Cohesive::Kernel law{softening_mortar(), 1, 1e-4};
  std::vector<FaceMemory<double>> memory;
  std::vector<LawMemory<Cohesive::Kernel>> own;
  double force = 0, moment = 0, fracture = 0;
  double overlap_before = 0, slope_before = 0;

  explicit DividedFace(int count) : memory(count, no_memory(false)), own(count) {}

  /// `overlap`: at the middle [m]; `slope`: its rise along x [1].
  void to(double overlap, double slope) {
    const Vec2 still = Vec2::Zero(), speed(0, (overlap_before - overlap) / law.dt);
    const double spin = (slope_before - slope) / law.dt;
    const auto count = static_cast<double>(memory.size());
    force = moment = 0, overlap_before = overlap, slope_before = slope;
    for (std::size_t i = 0; i < memory.size(); ++i) {
      const double x0 = static_cast<double>(i) / count - 0.5, x1 = x0 + 1 / count;
      const double g0 = -overlap - slope * x0, g1 = -overlap - slope * x1;
      const auto r = respond_face_pair(rigid_face({x1, 0}, {x0, 0}, still, 0),
                                       rigid_face({x0, g0}, {x1, g1}, speed, spin), 1.0, memory[i], own[i], law);
      force += on_b0(r).y() + on_b1(r).y(), moment += on_b0(r).y() * x0 + on_b1(r).y() * x1;
      fracture += r.lost_fracture;
      memory[i] = r.touching ? r.memory : no_memory(false);
      own[i] = r.touching ? r.own : law.parted(r.own);
    }
  }
};

/// Force per metre of width on a face of 1 m and its moment about the middle, from the law at its points.
struct PointSums {
  double force = 0, moment = 0;
  PointSums(double overlap, double slope) {
    constexpr int points = 4000;
    for (int i = 0; i < points; ++i) {
      const double x = (i + 0.5) / points - 0.5, stress = crushed_stress(overlap + slope * x) / points;
      force += stress, moment += stress * x;
    }
  }
};

}  // namespace

TEST_CASE("the energy of crushing does not depend on the division of a face") {
  for (const int count : {1, 3, 8}) {
    DividedFace face(count);
    for (int i = 1; i <= 2000; ++i) face.to(crushed_overlap(1.2 * softened_depth) * i / 2000, 0);
    CHECK(near(face.fracture, crush_spent(1.2 * softened_depth), 1e-4));
    CHECK(near(face.force, left_stress, 1e-9));
  }
}

TEST_CASE("a face turned while it is pressed has the force and moment of the law at its points") {
  // Turned about a pressed middle, to either side: first elastic, then crushed at one end, then softened to the
  // residual strength there. Each contact has two depths, so the error falls with their
  // number: they soften one after another, at first in few jumps.
  for (const double side : {1.0, -1.0}) {
    double before = 1;
    for (const int count : {2, 8, 32}) {
      DividedFace face(count);
      double worst = 0, most = 0, most_by_law = 0;
      for (int i = 1; i <= 2000; ++i) {
        const double share = i / 2000.0, overlap = 1e-3, slope = side * 0.03 * share;
        face.to(overlap, slope);
        const PointSums law(overlap, slope);
        worst = std::max(worst, std::abs(face.moment - law.moment) / (peak_stress / 6));
        most = std::max(most, side * face.moment), most_by_law = std::max(most_by_law, side * law.moment);
      }
      MESSAGE("in ", count, " contacts: moment at most ", most, " N m, by the law ", most_by_law, ", worst difference ",
              worst, " fc/6");
      CHECK(worst < 0.5 * before);
      before = worst;
      if (count >= 8) CHECK(near(most, most_by_law, 0.01));
    }
    CHECK(before < 0.02);
  }
}

namespace {

/// A block of 1 m on a larger one, pressed down step by step as a contact of any shape: polygons, or solids.
struct PressedBlock {
  double force = 0, length = 0, fracture = 0, depth = 0;

  void polygons(const ContactLaw& law, const std::vector<double>& overlaps) {
    const std::vector<std::uint8_t> faces(4, 1);
    const Polygon low{{-1, -1}, {1, -1}, {1, 0}, {-1, 0}};
    ContactMemory memory;
    std::array<double, law_numbers<Cohesive::Kernel>> row{};
    for (const double overlap : overlaps) {
      const Vec2 at(0, -overlap);
      Polygon corners;
      for (const Vec2& p : {Vec2(-0.5, 0), Vec2(0.5, 0), Vec2(0.5, 1), Vec2(-0.5, 1)}) corners.push_back(at + p);
      const PlacedPiece a{low, faces, Vec2(0, -0.5), Vec2::Zero(), 0}, b{corners, faces, at, Vec2::Zero(), 0};
      std::vector<Vec2> on_a(4, Vec2::Zero()), on_b(4, Vec2::Zero());
      std::array<double, law_numbers<Cohesive::Kernel>> next{};
      const OverlapResponse r = respond_overlap(a, b, {memory, row.data()}, {law, 1, 1e-4}, on_a, on_b, next.data());
      memory = r.memory, row = next;
      force = r.force.y(), length = r.length, fracture += r.lost_fracture;
    }
    depth = Cohesive::Kernel::crushed(law_memory<Cohesive::Kernel>(row.data()));
  }
  void solids(const ContactLaw& law, const std::vector<double>& overlaps) {
    SolidMemory memory;
    Separation3 apart{};
    SolidRoom room;
    for (const double overlap : overlaps) {
      const TrialBricks bricks({overlap, 0, 0, 1e-4});
      const LawInUse use{law, 1, 1e-4};
      const MovingSolid a = bricks.lower(), b = bricks.upper(0);
      const SolidPressure pressed = pressure_between(a, b, use, apart, room.shared, true, memory.crushed);
      const SolidResponse r = polyhedron_contact_forces(a, b, memory, use, pressed, room);
      memory = r.memory;
      force = r.force.z(), length = r.area, fracture += r.lost_fracture;
    }
    depth = memory.crushed;
  }
};

std::vector<double> steps_to(double overlap, int count) {
  std::vector<double> all;
  for (int i = 1; i <= count; ++i) all.push_back(overlap * i / count);
  return all;
}

}  // namespace

TEST_CASE("contacts of any shape spend the energy of crushing in the plane and in space") {
  // Strips along the edges, where a side of the block is nearer than the surface, are as wide as the depth.
  for (const double z : {0.3 * softened_depth, 0.9 * softened_depth, 1.2 * softened_depth})
    for (const bool space : {false, true}) {
      CAPTURE(z);
      CAPTURE(space);
      PressedBlock block;
      space ? block.solids(softening_mortar(), steps_to(crushed_overlap(z), 200))
            : block.polygons(softening_mortar(), steps_to(crushed_overlap(z), 400));
      const double strips = (space ? 4 : 2) * crushed_overlap(z);
      CHECK(near(block.depth, z, 2 * strips));
      CHECK(near(block.force, crushed_stress(crushed_overlap(z)) * block.length, 2 * strips));
      CHECK(near(block.fracture, crush_spent(z), 2 * strips));
    }
}

TEST_CASE("a joint in space spends the energy of crushing over its area and unloads with its stiffness") {
  const double x = 0.6, y = 0.4, area = x * y;
  HeldJoint joint(softening_mortar(), x, y);
  double peak = 0;
  for (const double z : {0.5 * softened_depth, softened_depth, 1.2 * softened_depth}) {
    for (int i = 1; i <= 500; ++i) {
      joint.to(Vec3(0, 0,
                    -(z == 0.5 * softened_depth
                          ? crushed_overlap(z) * i / 500
                          : crushed_overlap(z - 0.2 * softened_depth) +
                                (crushed_overlap(z) - crushed_overlap(z - 0.2 * softened_depth)) * i / 500)));
      peak = std::max(peak, joint.last.force.z());
    }
    CHECK(near(joint.joint().most_crushed(), z, 1e-9));
    CHECK(near(joint.last.force.z(), crushed_stress(crushed_overlap(z)) * area, 1e-9));
    CHECK(near(joint.fracture, crush_spent(z) * area, 1e-2));
    CHECK(near_zero(joint.put_in + joint.stored_at_first - joint.stored() - joint.fracture, 1e-6 * joint.put_in));
  }
  CHECK(peak <= peak_stress * area * (1 + 1e-12));
  CHECK(near(peak, peak_stress * area, 0.02));
  const double here = joint.last.force.z();
  joint.to(Vec3(0, 0, -crushed_overlap(1.2 * softened_depth) + 0.5 * left_stress / bed_kn));
  CHECK(near(joint.last.force.z(), 0.5 * here, 1e-9));
}

TEST_CASE("a pair pressed beyond its strength carries the same in every geometry that crushes") {
  const Cohesive law = softening_mortar();
  for (const double overlap : {1.5 * peak_stress / bed_kn, 3 * peak_stress / bed_kn})
    for (const double tilt : {0.0, 1e-4}) {
      CAPTURE(overlap);
      CAPTURE(tilt);
      const Lie lie{overlap, tilt, 0.2, 1e-3};
      const Carried faces = as_plane_faces<Cohesive::Kernel>(law, lie),
                    polygons = as_polygons<Cohesive::Kernel>(law, lie), solids = as_solids(law, lie, true);
      CHECK(faces.normal < 0.98 * peak_stress);
      // Strips along the edges as above.
      CHECK(near(polygons.normal, faces.normal, 4 * overlap));
      CHECK(near(solids.normal, faces.normal, 8 * overlap));
      CHECK(near(faces.normal, crushed_stress(overlap), 1e-9 + tilt));
    }
}
