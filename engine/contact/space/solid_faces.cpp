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

/// Whether two opposed faces are near enough for mortar: the distance of a
/// corner of b's below a's plane is that of no other one but for the tilt over
/// the size of both.
bool may_meet(const PlacedSolid& a, int face_a, const PlacedSolid& b, int face_b) {
  const Vec3& corner = b.corners[static_cast<std::size_t>(b.solid->shape.faces[face_b][0])];
  const double reach = 2 * flat_faces_max_tilt * (a.solid->size + b.solid->size);
  return std::abs(depth_below(a, face_a, corner)) <= reach;
}

/// The largest overlap and the largest gap over the shared polygon, its area,
/// and its width: that over its longest extent.
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

/// The same plane and polygon, of which only the corners there are are copied.
void copy_shared(const FaceOverlap3& from, FaceOverlap3& to) {
  to.plane = from.plane, to.shared.count = from.shared.count;
  std::copy_n(from.shared.corner.begin(), from.shared.count, to.shared.corner.begin());
}

/// ... the part of it where c > 0.
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

/// How fast the overlap grows, over the mean plane: at its origin, and its
/// slope.
struct ClosingRate {
  double at_origin;
  Vec2 slope;

  ClosingRate(const MovingSolid& a, const MovingSolid& b, const MeanPlane& plane) {
    const Vec3 spin = b.spin - a.spin, rate = b.velocity_at(plane.origin) - a.velocity_at(plane.origin);
    at_origin = -plane.normal.dot(rate);
    slope = {-plane.normal.dot(cross(spin, plane.x)), -plane.normal.dot(cross(spin, plane.y))};
  }
  /// Integral of a pressure times this, from the pressure's integrals.
  [[nodiscard]] double power(const FaceIntegrals& of) const {
    return at_origin * of.first + slope.dot(of.first_moment);
  }
};

/// The pressure with its damping, where there is overlap and it is above 0.
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

/// How the area in contact lies about its middle.
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

/// How two opposed faces touch: flatly; not themselves, but the one next to either may; otherwise; not at all.
enum class Touch { flat, beside, rough, none };

/// `tried`: what the two faces share.
///
/// Where two meshed sides lie on each other, a face meets the one across and, by the little that nodes have slid, the
/// next one too. That sliver is part of a flat joint though it is narrower than it is deep. So a depth is compared with
/// the width of what two faces share together with the faces in line with them, as in the plane
/// (broad_phase/face_line.hpp). Two that an inner edge of either parts share at most a wedge of their depth squared,
/// which its neighbour has too.
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

/// All pairs of opposed faces are asked; more than one that touches flatly, as of a wedge in a notch, are no flat
/// contact.
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

/// The pair of opposed faces that share the largest area, among those near
/// enough and wide enough for mortar.
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

/// Faces that lie flat. Over the shared polygon the pressure is kn (c + beta
/// dc/dt) where that is above 0 and there is overlap; force, centre, damping
/// and its power are exact integrals of it, see shape/face_overlap_3d.
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

/// kn / 2 times the integral of the overlap squared over the part in contact
/// [J].
double face_energy(const PlainFriction& law, const FaceOverlap3& faces) {
  return law.kn * integrals_in_contact(faces).energy;
}

}  // namespace trilith
