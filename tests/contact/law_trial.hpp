// One pair of blocks in five geometries, for tests of the contact laws. A block of 1 m by 1 m lies on a larger one,
// pressed into it, tilted or not, and slides along x. One geometry is a ball on the block.
#pragma once

#include <array>
#include <cmath>
#include <string>

#include "contact/face_scene.hpp"
#include "contact/joint/face_resultant.hpp"
#include "contact/laid_bricks.hpp"
#include "contact/plane/face_pair.hpp"
#include "contact/plane/overlap_energy.hpp"
#include "contact/space/solid_energy.hpp"
#include "contact/space/sphere_contact.hpp"

namespace trilith::testing {

/// Position and motion of the upper block.
struct Lie {
  double overlap = 0;  ///< at its middle [m]
  double tilt = 0;     ///< rise of its lower side along x [1]
  double speed = 0;    ///< along x [m/s]
  double dt = 0;       ///< [s]
};

/// Force of the lower block on the upper one, and the contact's stored and dissipated energy.
struct Carried {
  double normal = 0, shear = 0;  ///< [N]
  double stored = 0;             ///< of the pressure [J]
  double taken =
      0;  ///< by shear and damping, dissipated or stored: in the plane the halves of faces slide independently [J]
};

/// Elastic shear energy of both halves [J].
template <class Memory>
double shear_held(const Memory& m, double ks) {
  double sum = 0;
  for (const int h : {0, 1}) sum += 0.5 * m.shear_elastic[h] * m.shear_elastic[h] * inverse_or_zero(ks * m.active[h]);
  return sum;
}

/// As faces: one of each block.
template <class K>
Carried as_plane_faces(const ContactLaw& law, const Lie& lie) {
  const Vec2 along = Vec2(1, lie.tilt).normalized(), middle(0.5, -lie.overlap), velocity(lie.speed, 0);
  const Faces f{rigid_face({1.2, 0}, {-0.2, 0}, Vec2::Zero(), 0),
                rigid_face(middle - 0.5 * along, middle + 0.5 * along, velocity, 0)};
  return with_kernel({law, 1, lie.dt}, [&]<class Kernel>(const Kernel& kernel) {
    const auto r = respond_fresh(f, no_memory(), kernel);
    const Vec2 on_b = on_b0(r) + on_b1(r);
    const FaceOverlap<double> overlap(f.a, f.b);
    return Carried{on_b.y(), on_b.x(), pressing_energy(overlap, ContactMemory{}, LawMemory<Kernel>{}, kernel),
                   r.lost_friction + r.lost_damping + shear_held(r.memory, kernel.ks)};
  });
}

/// As polygons of general shape.
template <class K>
Carried as_polygons(const ContactLaw& law, const Lie& lie) {
  const Vec2 along = Vec2(1, lie.tilt).normalized(), up(-along.y(), along.x()), middle(0.5, -lie.overlap);
  const std::array<Vec2, 4> low{Vec2(-0.2, -1), Vec2(1.2, -1), Vec2(1.2, 0), Vec2(-0.2, 0)},
      high{middle - 0.5 * along, middle + 0.5 * along, middle + 0.5 * along + up, middle - 0.5 * along + up};
  const std::array<std::uint8_t, 4> all{1, 1, 1, 1};
  const PlacedPiece a{low, all, Vec2::Zero(), Vec2::Zero(), 0}, b{high, all, middle, Vec2(lie.speed, 0), 0};
  const LawInUse use{law, 1, lie.dt};
  std::array<Vec2, 4> on_a, on_b;
  on_a.fill(Vec2::Zero()), on_b.fill(Vec2::Zero());
  const std::array<double, 32> none{};
  std::array<double, 32> after;
  const OverlapResponse r = respond_overlap(a, b, {ContactMemory{}, none.data()}, use, on_a, on_b, after.data());
  Vec2 sum = Vec2::Zero();
  for (const Vec2& force : on_b) sum += force;
  return {sum.y(), sum.x(), overlap_energy(a, b, use, 0),
          r.lost_friction + r.lost_damping + shear_held(r.memory, plain_friction(use).ks)};
}

/// Two bricks of 1 m; the lower one is larger.
struct TrialBricks {
  ConvexSolid below = brick(1.4, 1.4, 1), above = brick(1, 1, 1);
  PlacedSolid a, b;

  explicit TrialBricks(const Lie& lie) {
    const UnitQuaternion lean = rotation_by(Vec3(0, -std::atan(lie.tilt), 0));
    a = set_down(below, {}, Vec3(0.5, 0, -0.5));
    b = set_down(above, lean, Vec3(0.5, 0, -lie.overlap) + 0.5 * Turn3(lean).apply(Vec3::UnitZ()));
  }
  [[nodiscard]] MovingSolid lower() const { return {a, Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}; }
  [[nodiscard]] MovingSolid upper(double speed) const {
    return {b, Vec3(0.5, 0, 0.5), Vec3(speed, 0, 0), Vec3::Zero()};
  }
};

/// In space, as faces in flat contact or as polyhedra of general shape.
inline Carried as_solids(const ContactLaw& law, const Lie& lie, bool flat) {
  const TrialBricks bricks(lie);
  const LawInUse use{law, 1, lie.dt};
  const MovingSolid a = bricks.lower(), b = bricks.upper(lie.speed);
  SolidRoom room;
  Separation3 apart{};
  apart.distance = 0;
  SolidPressure pressed;
  double stored = 0;
  if (flat) {
    pressed = pressure_between(a, b, use, apart, room.shared);
    stored = solid_contact_energy(a.placed, b.placed, SolidMemory{}, use, room.shared, room.part);
  } else {
    solid_overlap(a.placed, b.placed, room.shared);
    pressed = solid_pressure(a, b, use, room.shared);
    stored = solid_energy(a.placed, b.placed, use, room.shared, room.part);
  }
  const SolidResponse r = polyhedron_contact_forces(a, b, SolidMemory{}, use, pressed, room);
  return {r.force.z(), r.force.x(), stored,
          r.lost_friction + r.lost_damping + sliding_energy(plain_friction(use).ks, r.memory.shear)};
}

/// A ball of radius 0.5 m.
struct TrialBall {
  ConvexSolid below = brick(1.4, 1.4, 1), ball = convex_sphere({Vec3::Zero(), 0.5});
  PlacedSolid a, b;
  Sphere sphere, none;

  explicit TrialBall(double overlap) {
    a = set_down(below, {}, Vec3(0, 0, -0.5));
    b = set_down(ball, {}, Vec3(0, 0, 0.5 - overlap));
    sphere = {b.corners[0], ball.radius}, none = {a.corners[0], 0};
  }
};

inline Carried as_ball(const ContactLaw& law, const Lie& lie) {
  const TrialBall balls(lie.overlap);
  const LawInUse use{law, 1, lie.dt};
  double apart = 0;
  const Vec3 zero = Vec3::Zero();
  const SolidResponse r = respond_spheres({balls.none, balls.a, zero, zero, zero},
                                          {balls.sphere, balls.b, balls.sphere.centre, Vec3(lie.speed, 0, 0), zero},
                                          SolidMemory{}, use, apart);
  return {r.force.z(), r.force.x(), sphere_energy(balls.a, balls.b, use), r.lost_friction + r.lost_damping};
}

/// Pressure at a point, integrated over rings of the ball's contact disc, and its work. The law is given by the force
/// of two parallel faces of 1 m2 at a penetration, pressed(overlap) [N], and its energy stored(overlap) [J].
template <class Pressed, class Stored>
Carried rings_of_ball(double overlap, Pressed&& pressed, Stored&& stored) {
  constexpr int rings = 400;
  const double radius = 0.5, rim2 = overlap * (2 * radius - overlap);
  Carried sum;
  for (int i = 0; i < rings; ++i) {
    const double rho2 = rim2 * (i + 0.5) / rings, ring = M_PI * rim2 / rings;
    // Depth of a point of the plane below the ball's surface, and height of the ball's surface below it.
    const double height = radius - overlap, depth = radius - std::sqrt(height * height + rho2);
    sum.normal += ring * pressed(depth), sum.stored += ring * stored(depth);
  }
  return sum;
}

}  // namespace trilith::testing
