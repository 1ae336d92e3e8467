#include "contact/space/solid_faces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "contact/plane/opposed_faces.hpp"
#include "geometry/plane/widened_face.hpp"
#include "geometry/space/facing_faces.hpp"

namespace trilith {
namespace {

/// Whether two faces may lie flat on each other: see near_faces.
bool may_touch_flatly(const PlacedSolid& a, int f, const PlacedSolid& b, int g) {
  return opposed(a, f, b, g) <= opposed_enough && fits_faces(b, g) &&
         PlaneDistance(a, f, b, g).depth <= near_faces(a, b);
}

/// Whether two opposed faces are near enough for mortar. The distance of one corner of b's face from a's plane is
/// tested; other corners differ from it by at most the tilt times the size of both.
bool may_meet(const PlacedSolid& a, int face_a, const PlacedSolid& b, int face_b) {
  const Vec3& corner = b.corners[static_cast<std::size_t>(b.solid->shape.faces[face_b][0])];
  const double reach = 2 * flat_faces_max_tilt * (a.solid->size + b.solid->size);
  return std::abs(depth_below(a, face_a, corner)) <= reach;
}

/// The largest overlap and the largest gap over the shared polygon, its area, and its width: area over longest extent.
struct FlatMeasures {
  double deepest = 0, widest = 0, area = 0, width = 0;

  explicit FlatMeasures(const FaceOverlap3& faces) {
    const SharedPolygon& polygon = faces.shared;
    Vec2 low = polygon.corner[0], high = low;
    double twice = 0;
    for (int i = 0; i < polygon.count; ++i) {
      const Vec2 &p = polygon.corner[static_cast<std::size_t>(i)],
                 &q = polygon.corner[static_cast<std::size_t>(i + 1 < polygon.count ? i + 1 : 0)];
      const double overlap = faces.plane.overlap_at(p);
      deepest = std::max(deepest, overlap), widest = std::max(widest, -overlap);
      low = low.cwiseMin(p), high = high.cwiseMax(p);
      twice += cross(p, q);
    }
    const double extent = (high - low).norm();
    area = 0.5 * twice;
    width = extent > 0 ? 0.5 * twice / extent : 0;
  }
  [[nodiscard]] bool touch() const { return deepest > 0; }
  [[nodiscard]] bool are_flat() const { return deepest <= flat_faces_max_depth * width; }
};

/// Copies plane and polygon; of the corners only those in use.
void copy_shared(const FaceOverlap3& from, FaceOverlap3& to) {
  to.plane = from.plane, to.shared.count = from.shared.count;
  std::copy_n(from.shared.corner.begin(), from.shared.count, to.shared.corner.begin());
}

/// Copies the part of the polygon where c > 0.
void copy_closed(const FaceOverlap3& from, FaceOverlap3& to) {
  const SharedPolygon& all = from.shared;
  SharedPolygon& kept = to.shared;
  to.plane = from.plane, kept.count = 0;
  const auto add = [&](const Vec2& p) {
    if (kept.count < 2 * max_face_corners) kept.corner[static_cast<std::size_t>(kept.count++)] = p;
  };
  for (int i = 0; i < all.count; ++i) {
    const Vec2 &p = all.corner[static_cast<std::size_t>(i)],
               &q = all.corner[static_cast<std::size_t>(i + 1 < all.count ? i + 1 : 0)];
    const double cp = from.plane.overlap_at(p), cq = from.plane.overlap_at(q);
    if (cp >= 0) add(p);
    if ((cp > 0 && cq < 0) || (cp < 0 && cq > 0)) add(p + cp / (cp - cq) * (q - p));
  }
}

/// Rate of the overlap over the mean plane: at its origin, and its slope.
struct ClosingRate {
  double at_origin;
  Vec2 slope;

  ClosingRate(const MovingSolid& a, const MovingSolid& b, const MeanPlane& plane) {
    const Vec3 spin = b.spin - a.spin, rate = b.velocity_at(plane.origin) - a.velocity_at(plane.origin);
    at_origin = -plane.normal.dot(rate);
    slope = {-plane.normal.dot(cross(spin, plane.x)), -plane.normal.dot(cross(spin, plane.y))};
  }
  /// Integral of a pressure times this rate, from the pressure's integrals.
  [[nodiscard]] double power(const FaceIntegrals& of) const {
    return at_origin * of.first + slope.dot(of.first_moment);
  }
};

/// The pressure with its damping, where there is overlap and it is positive.
FaceMoments damped_moments(const FaceOverlap3& faces, const ClosingRate& rate, double beta, bool open) {
  FaceOverlap3 damped;
  if (open)
    copy_closed(faces, damped);
  else
    copy_shared(faces, damped);
  damped.plane.overlap += beta * rate.at_origin;
  damped.plane.slope += beta * rate.slope;
  return damped.shared.count > 2 ? moments_in_contact(damped) : FaceMoments{};
}

/// Second moments of the area in contact about its centroid.
void set_spread(const FaceIntegrals& of, const MeanPlane& plane, SolidPressure& out) {
  const Vec2 middle = of.area_moment / of.area;
  const double xx = of.xx / of.area - middle.x() * middle.x(), yy = of.yy / of.area - middle.y() * middle.y(),
               xy = of.xy / of.area - middle.x() * middle.y();
  out.radius = std::sqrt(std::max(0.0, xx + yy));
  out.arm = spread_arms(xx, xy, yy, plane.x, plane.y);
}

/// Mean distance of the pressure from its centre.
double friction_arm(const FaceMoments& of, const Vec2& centre) {
  if (!(of.first > 0)) return 0;
  const double xx = of.first_xx / of.first - centre.x() * centre.x(),
               yy = of.first_yy / of.first - centre.y() * centre.y(),
               xy = of.first_xy / of.first - centre.x() * centre.y();
  return mean_distance(xx + yy, xx * yy - xy * xy);
}

}  // namespace

/// Whether the pressure of a law is kn times the overlap, so that integrals over polygons are exact.
bool is_linear(const ContactLaw& law) {
  return !may_crush(law) && std::visit([](const auto& l) { return std::decay_t<decltype(l)>::Kernel::linear; }, law);
}

namespace {

/// Contact of two opposed faces: flat; not these, but neighbouring faces may be flat; other contact; none.
enum class Touch { flat, beside, rough, none };

/// `tried`: the polygon shared by the two faces.
///
/// If two meshed sides lie on each other, a face meets the opposite face and also, because nodes slide slightly, the
/// next one. That sliver is part of a flat joint although it is narrower than it is deep. So the depth is compared with
/// the width shared by two faces together with their coplanar neighbours, as in the plane (broad_phase/face_line.hpp).
/// Two faces separated by an inner edge share at most a wedge of their depth squared, which the neighbour also has.
Touch touch_of(const PlacedSolid& a, int f, const PlacedSolid& b, int g, FaceOverlap3& tried) {
  if (lies_beyond(b, g, a, f) || lies_beyond(a, f, b, g)) return Touch::beside;
  FaceRoom room_a, room_b;
  if (!face_overlap(face_of(a, f, room_a), face_of(b, g, room_b), tried)) return Touch::none;
  const FlatMeasures own(tried);
  if (!own.touch()) return Touch::none;
  if (own.are_flat()) return Touch::flat;
  FaceOverlap3 in_line;
  const bool goes_on = !a.solid->goes_on.empty() || !b.solid->goes_on.empty();
  if (!goes_on || !face_overlap(widened_face(a, f, room_a), widened_face(b, g, room_b), in_line)) return Touch::rough;
  FlatMeasures whole(in_line);
  whole.deepest = own.deepest;
  return whole.are_flat() ? Touch::flat : Touch::rough;
}

}  // namespace

/// All pairs of opposed faces are tested. If more than one touches flatly, as for a wedge in a notch, the contact is
/// not flat.
bool flat_faces(const PlacedSolid& a, const PlacedSolid& b, FaceOverlap3& out) {
  int found = 0;
  bool beside = false;
  FaceOverlap3 another;
  for (int f = 0; f < a.solid->shape.faces.count(); ++f) {
    if (!fits_faces(a, f)) continue;
    for (int g = 0; g < b.solid->shape.faces.count(); ++g) {
      if (!may_touch_flatly(a, f, b, g)) continue;
      FaceOverlap3& tried = found == 0 ? out : another;
      const Touch touch = touch_of(a, f, b, g, tried);
      if (touch == Touch::beside) beside = true;
      if (touch == Touch::rough) return false;
      if (touch != Touch::flat) continue;
      tried.face_a = f, tried.face_b = g;
      if (++found > 1) return false;
    }
  }
  if (found == 0) out.shared.count = 0;
  return found == 1 || beside;
}

/// The pair of opposed faces with the largest shared area, among those near enough and wide enough for mortar.
bool meeting_faces(const PlacedSolid& a, const PlacedSolid& b, double reach, double width, FaceOverlap3& out) {
  double most = 0;
  FaceRoom room_a, room_b;
  FaceOverlap3 tried;
  for (int f = 0; f < a.solid->shape.faces.count(); ++f)
    for (int g = 0; g < b.solid->shape.faces.count(); ++g) {
      if (opposed(a, f, b, g) > opposed_enough) continue;
      if (!fits_faces(a, f) || !fits_faces(b, g) || !may_meet(a, f, b, g)) continue;
      if (!face_overlap(face_of(a, f, room_a), face_of(b, g, room_b), tried)) continue;
      const FlatMeasures measures(tried);
      const bool near = std::max(measures.deepest, measures.widest) <= reach && measures.width >= width;
      if (!near || !(measures.area > most)) continue;
      most = measures.area, out = tried;
      out.face_a = f, out.face_b = g;
    }
  return most > 0;
}

/// Flat faces. Over the shared polygon the pressure is kn (c + beta dc/dt), where it is positive and the faces overlap.
/// Force, centre, damping and its power are exact integrals, see geometry/space/face_overlap_3d.hpp.
SolidPressure face_pressure(const MovingSolid& a, const MovingSolid& b, const PlainFriction& law,
                            const FaceOverlap3& faces) {
  const bool is_damped = law.beta > 0;
  const FaceMoments undamped = is_damped ? FaceMoments{integrals_in_contact(faces)} : moments_in_contact(faces);
  const FaceIntegrals& springs = undamped;
  SolidPressure out;
  if (!(springs.area > 0)) return out;
  const MeanPlane& plane = faces.plane;
  const ClosingRate rate(a, b, plane);
  bool open = false;
  for (int i = 0; i < faces.shared.count; ++i) {
    const double c = plane.overlap_at(faces.shared.corner[static_cast<std::size_t>(i)]);
    open = open || c < 0;
    out.depth = std::max(out.depth, c);
  }
  const FaceMoments total = is_damped ? damped_moments(faces, rate, law.beta, open) : undamped;
  out.pressure = law.kn * total.first;
  out.force = out.pressure * plane.normal;
  const Vec2 at = total.first > 0 ? Vec2(total.first_moment / total.first) : Vec2(springs.area_moment / springs.area);
  out.centre = plane.at(at), out.middle = plane.at(Vec2(springs.area_moment / springs.area));
  const double damping = law.kn * (total.first - springs.first);
  const Vec2 arm = law.kn * (total.first_moment - springs.first_moment) - damping * at;
  out.damping = damping * plane.normal;
  out.damping_moment = cross(Vec3(arm.x() * plane.x + arm.y() * plane.y), plane.normal);
  out.damped = law.kn * (rate.power(total) - rate.power(springs));
  out.area = springs.area;
  out.face_a = faces.face_a, out.face_b = faces.face_b;
  set_spread(springs, plane, out);
  out.friction_arm = friction_arm(total, at);
  return out;
}

/// kn / 2 times the integral of the squared overlap over the part in contact [J].
double face_energy(const PlainFriction& law, const FaceOverlap3& faces) {
  return law.kn * integrals_in_contact(faces).energy;
}

}  // namespace trilith
