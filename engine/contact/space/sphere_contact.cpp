#include "contact/space/sphere_contact.hpp"

#include "contact/joint/chord.hpp"
#include "contact/space/sphere_facets.hpp"

namespace trilith {
namespace {

/// Mean distance from the centre of a disc, weighted by a pressure that falls to 0 at its rim, as for a sphere.
constexpr double arm_of_turning = 8.0 / 15;

/// The contact area and its pressure.
struct SphereArea {
  Vec3 normal, middle;             ///< from a to b; where friction acts [m]
  double area, depth;              ///< [m2], [m]
  double elastic, force, closing;  ///< [N], [N] with damping, [m/s]
};

/// The force over kn with damping; pressed(relief) is the force of max(e - relief, 0).
template <class Pressed>
double damped_force(double elastic, double area, double closing, double beta, Pressed&& pressed) {
  if (closing >= 0 || beta == 0) return elastic + beta * closing * area;
  return pressed(-beta * closing);
}

/// False where they are apart.
template <class K>
bool meet_spheres(const SphereSide& a, const SphereSide& b, const K& law, SphereArea& out, double& apart) {
  const Vec3 way = b.sphere.centre - a.sphere.centre;
  const double sum = a.sphere.radius + b.sphere.radius, square = way.squaredNorm();
  const double distance = std::sqrt(square);
  apart = distance - sum;
  if (!(apart < 0)) return false;
  apart = 0;
  const SphereLens lens{std::max(a.sphere.radius, b.sphere.radius), std::min(a.sphere.radius, b.sphere.radius),
                        distance, distance > 0 ? 1 / distance : 0};
  out.normal = distance > 0 ? Vec3(lens.inverse * way) : Vec3(Vec3::UnitZ());
  const bool swallowed = lens.is_swallowed();
  const double plane = swallowed ? (a.sphere.radius < b.sphere.radius ? 0 : distance)
                                 : lens.plane_from(a.sphere.radius, b.sphere.radius);
  out.middle = a.sphere.centre + plane * out.normal;
  out.area = lens.area(), out.depth = lens.overlap();
  out.closing = out.normal.dot(a.velocity_at(out.middle) - b.velocity_at(out.middle));
  const double elastic = lens_force(lens, law, 0);
  out.elastic = law.kn * elastic;
  out.force = law.kn * damped_force(elastic, out.area, out.closing, law.beta,
                                    [&](double relief) { return lens_force(lens, law, relief); });
  return true;
}

/// Contact of a sphere and a polyhedron. The contact point is below the sphere's centre by the mean height of the
/// pressed area: on a face its foot, at an edge or a corner the point on it.
template <class K>
bool meet_facets(const SphereSide& a, const SphereSide& b, const K& law, SphereArea& out, double& apart) {
  const bool a_is_sphere = a.sphere.radius > 0;
  const Sphere& sphere = a_is_sphere ? a.sphere : b.sphere;
  const PlacedSolid& solid = a_is_sphere ? b.placed : a.placed;
  const SphereFacets facets = pressed_facets(solid, sphere, law, 0);
  apart = std::max(0.0, facets.apart);
  const double elastic = facets.pressed.norm();
  if (!(elastic > 0)) return false;
  const Vec3 outward = facets.pressed / elastic;
  const double height = facets.lever / elastic;
  out.normal = a_is_sphere ? Vec3(-outward) : outward;
  out.middle = sphere.centre - height * outward;
  out.area = facets.area.dot(outward), out.depth = sphere.radius - height;
  if (!(out.area > 0)) return false;
  out.closing = out.normal.dot(a.velocity_at(out.middle) - b.velocity_at(out.middle));
  out.elastic = law.kn * elastic;
  out.force = law.kn * damped_force(elastic, out.area, out.closing, law.beta, [&](double relief) {
                return std::max(0.0, outward.dot(pressed_facets(solid, sphere, law, relief).pressed));
              });
  return true;
}

/// Rotates the previous shear with the plane of contact, by the shortest rotation, and about its normal.
class CarriedShear {
 public:
  /// From one normal to another; `turn` about the new one [rad], small: by Cayley's map, which conserves lengths.
  CarriedShear(const Vec3& from, const Vec3& to, double turn) : to_(to), axis_(cross(from, to)) {
    const double cosine = from.dot(to);
    turned_over_ = cosine <= -0.5;  // the shortest rotation is ill-conditioned
    share_ = 1 / (1 + cosine), half_ = 0.5 * turn, scale_ = 2 * half_ / (1 + half_ * half_);
  }
  [[nodiscard]] Vec3 operator()(const Vec3& v) const {
    if (turned_over_) return v - 2 * v.dot(to_) * to_;
    const Vec3 once = cross(axis_, v);
    const Vec3 here = v + once + share_ * cross(axis_, once);
    return here + scale_ * (cross(to_, here) - half_ * (here - to_.dot(here) * to_));
  }

 private:
  const Vec3& to_;
  Vec3 axis_;
  double share_, half_, scale_;
  bool turned_over_;
};

/// A Kelvin-Voigt spring in series with a slider, as in contact/joint/shear_3d.hpp, but with a radial return: slip and
/// rotation follow the direction of the force. Area that separates takes its share with it.
template <class K>
void add_sphere_friction(const SphereSide& a, const SphereSide& b, const SolidMemory& before, const K& law,
                         const SphereArea& at, SolidResponse& out) {
  const Vec3& n = at.normal;
  const double radius = out.radius;
  Vec3 rate = chord_velocity_at(b, b.origin, at.middle, law.dt) - chord_velocity_at(a, a.origin, at.middle, law.dt);
  rate += (radius * n.dot(Vec3(b.spin - a.spin)) - n.dot(rate)) * n;
  const double limit = friction_limit_of(law, at.force, at.area, [&] { return rate.norm(); });
  Vec3 path = law.dt * rate;
  if (a.behind != nullptr) {
    const Vec3 slip = mean_slip(a, b, at.middle, law.dt);
    path = law.dt * (slip + (radius * n.dot(Vec3(mean_spin(b, law.dt) - mean_spin(a, law.dt))) - n.dot(slip)) * n);
  }
  Vec3 old = Vec3::Zero(), old_total = Vec3::Zero();
  if (before.shear.area > 0) {
    const CarriedShear carried(before.normal, n,
                               0.5 * law.dt * n.dot(Vec3(mean_spin(a, law.dt) + mean_spin(b, law.dt))));
    old = carried(before.shear.elastic), old_total = carried(before.shear.total);
  }
  const double stiffness = law.ks * at.area, compliance = stiffness > 0 ? 1 / stiffness : 0,
               compliance_before = law.ks * before.shear.area > 0 ? 1 / (law.ks * before.shear.area) : 0;
  const Vec3 kept = old * std::min(1.0, stiffness * compliance_before);
  const double relaxed = 0.5 * (old.squaredNorm() * compliance_before - kept.squaredNorm() * compliance);
  Vec3 elastic = kept + stiffness * path, total = elastic + law.beta * stiffness * rate, stretch = path;
  if (const double square = total.squaredNorm(); square > limit * limit) {
    total *= limit / std::sqrt(square);
    elastic = kept + (total - kept) * (law.dt > 0 ? law.dt / (law.dt + law.beta) : 0.0);
    stretch = (elastic - kept) * compliance;
    out.memory.slip += (path - stretch).norm();
  }
  const Vec3 slip = path - stretch, mean_total = 0.5 * (total + old_total), mean_elastic = 0.5 * (elastic + old);
  out.memory.shear = {elastic, total, at.area};
  out.memory.normal = n;
  out.lost_friction += mean_total.dot(slip) + relaxed + 0.5 * (old - kept).dot(stretch);
  out.lost_damping += (mean_total - mean_elastic).dot(stretch);
  const double along = n.dot(total);
  out.force -= total - along * n;
  out.moment -= radius * along * n;
}

/// Power of the previous damping force in the motion of b relative to a [W].
double power_of_damping(const SphereSide& a, const SphereSide& b, const SolidMemory& m, double dt) {
  return m.damping.dot(Vec3(mean_velocity_at(b, a.origin, dt) - mean_velocity_at(a, a.origin, dt))) +
         m.damping_moment.dot(Vec3(mean_spin(b, dt) - mean_spin(a, dt)));
}

/// As two solids separate, their elastic shear is released, and the last damping force does work for half a step more.
template <class K>
SolidResponse respond_by(const SphereSide& a, const SphereSide& b, const SolidMemory& before, const K& law,
                         double& apart) {
  SolidResponse out;
  SphereArea at;
  const bool both = a.sphere.radius > 0 && b.sphere.radius > 0;
  const bool meets = both ? meet_spheres(a, b, law, at, apart) : meet_facets(a, b, law, at, apart);
  if (before.state != 0) out.lost_damping = -0.5 * law.dt * power_of_damping(a, b, before, law.dt);
  if (!meets) {
    out.lost_friction = sliding_energy(law.ks, before.shear);
    return out;
  }
  out.touching = true;
  out.force = out.normal_force = at.force * at.normal;
  out.centre = out.middle = at.middle, out.normal = at.normal;
  out.area = at.area, out.depth = at.depth;
  out.radius = arm_of_turning * std::sqrt(at.area / std::numbers::pi);
  out.memory.state = contact_touching | contact_general;
  out.memory.slip = before.slip;
  const double damping = at.force - at.elastic;
  out.memory.damping = damping * at.normal;
  out.memory.damping_moment = cross(Vec3(at.middle - a.origin), out.memory.damping);
  const double power = a.behind == nullptr ? damping * at.closing : -power_of_damping(a, b, out.memory, law.dt);
  out.lost_damping += 0.5 * law.dt * power;
  add_sphere_friction(a, b, before, law, at, out);
  return out;
}

Sphere sphere_of(const PlacedSolid& placed) {
  return {placed.corners[0], placed.solid->radius};
}

}  // namespace

SolidResponse respond_spheres(const SphereSide& a, const SphereSide& b, const SolidMemory& before, const LawInUse& law,
                              double& apart) {
  return with_kernel(law, [&](const auto& kernel) { return respond_by(a, b, before, kernel, apart); });
}

double sphere_energy(const PlacedSolid& a, const PlacedSolid& b, const LawInUse& law) {
  return with_kernel(law, [&](const auto& kernel) {
    if (!a.solid->is_sphere()) return kernel.kn * facets_energy(a, sphere_of(b), kernel);
    if (!b.solid->is_sphere()) return kernel.kn * facets_energy(b, sphere_of(a), kernel);
    const Sphere p = sphere_of(a), q = sphere_of(b);
    const SphereLens lens{std::max(p.radius, q.radius), std::min(p.radius, q.radius), (q.centre - p.centre).norm()};
    return lens.overlap() > 0 ? kernel.kn * lens_energy(lens, kernel) : 0.0;
  });
}

}  // namespace trilith
