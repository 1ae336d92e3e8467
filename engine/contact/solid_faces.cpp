#include "contact/solid_faces.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

#include "base/lane_bits.hpp"
#include "base/lane_vectors.hpp"
#include "shape/edge_overlap.hpp"
#include "shape/facing_faces.hpp"

namespace trilith {
namespace {

bool fits_faces(const PlacedSolid& solid, int face) {
  return solid.solid->is_surface(face) && solid.solid->shape.faces[face].size() <= max_face_corners;
}

/// How far the plane of a face of the larger solid is from a corner of the
/// smaller one's [m], and that corner from one of the face [m].
struct PlaneDistance {
  double depth, corner;

  PlaneDistance(const PlacedSolid& a, int face_a, const PlacedSolid& b, int face_b) {
    const bool b_is_larger = a.solid->size < b.solid->size;
    const PlacedSolid &large = b_is_larger ? b : a, &small = b_is_larger ? a : b;
    const int face = b_is_larger ? face_b : face_a, other = b_is_larger ? face_a : face_b;
    const Vec3& x = small.corners[static_cast<std::size_t>(small.solid->shape.faces[other][0])];
    const Vec3& on_face = large.corners[static_cast<std::size_t>(large.solid->shape.faces[face][0])];
    depth = std::abs(depth_below(large, face, x)), corner = (on_face - x).norm();
  }
};

double opposed(const PlacedSolid& a, int f, const PlacedSolid& b, int g) {
  return a.normals[static_cast<std::size_t>(f)].dot(b.normals[static_cast<std::size_t>(g)]);
}

/// Two faces, and by how much the product of their normals is beyond that of
/// faces that may lie flat.
struct PairOfFaces {
  int f = 0, g = 0;
  double beyond = unbounded;
};

/// Of those that are beyond it the one that is so by the least.
PairOfFaces least_to_turn(const PlacedSolid& a, const PlacedSolid& b) {
  PairOfFaces least;
  for (int f = 0; f < a.solid->shape.faces.count(); ++f)
    for (int g = 0; g < b.solid->shape.faces.count(); ++g) {
      const double beyond = opposed(a, f, b, g) - opposed_enough;
      const bool is_less = (beyond > 0) & (beyond < least.beyond);
      least = {is_less ? f : least.f, is_less ? g : least.g, is_less ? beyond : least.beyond};
    }
  return least;
}

/// How far the products of all normals of two solids of few faces are beyond
/// that of faces that may lie flat, eight for each face of a.
struct BeyondOpposed {
  static constexpr std::size_t most = few_faces;
  std::array<std::array<Lanes, 2>, most> of;
  std::size_t faces;  // of a
  double least;       // of those above 0

  TRILITH_INLINE BeyondOpposed(const PlacedSolid& a, const PlacedSolid& b) : faces(a.normals.size()) {
    std::array<Triple<Lanes>, 2> n;
    for (std::size_t g = 0; g < most; ++g) {
      const Vec3& v = b.normals[std::min(g, b.normals.size() - 1)];
      const auto lane = static_cast<int>(g % lane_count);
      n[g / lane_count].x[lane] = v.x(), n[g / lane_count].y[lane] = v.y(), n[g / lane_count].z[lane] = v.z();
    }
    Lanes smallest = Lanes{} + unbounded;
    for (std::size_t f = 0; f < faces; ++f)
      for (std::size_t half = 0; half < 2; ++half) {
        const Vec3& m = a.normals[f];
        const Triple<Lanes>& v = n[half];
        const Lanes beyond = (m.x() * v.x + (m.y() * v.y + m.z() * v.z)) - opposed_enough;
        of[f][half] = beyond;
        smallest = select(beyond > 0.0, smaller<Lanes>(smallest, beyond), smallest);
      }
    least = smaller(smaller(smallest[0], smallest[1]), smaller(smallest[2], smallest[3]));
  }
  /// f(face of a, face of b, beyond) of all that are not above 0, and of those
  /// below what `enough` comes to meanwhile.
  template <class F>
  TRILITH_INLINE void for_below(std::size_t faces_of_b, const double& enough, F&& f) const {
    for (std::size_t i = 0; i < faces; ++i) {
      const Lanes &first = of[i][0], &rest = of[i][1];
      unsigned bits = lane_bits((first <= 0.0) | (first < enough), (rest <= 0.0) | (rest < enough));
      for (bits &= (1U << faces_of_b) - 1; bits != 0; bits &= bits - 1) {
        const int g = std::countr_zero(bits);
        const double beyond = g < lane_count ? first[g] : rest[g - lane_count];
        if (beyond <= 0 || beyond < enough) f(static_cast<int>(i), g, beyond);
      }
    }
  }
  /// The two faces that have the least far to turn.
  [[nodiscard]] TRILITH_INLINE PairOfFaces nearest() const {
    for (std::size_t f = 0; f < faces; ++f)
      if (const unsigned bits = lane_bits(of[f][0] == least, of[f][1] == least); bits != 0)
        return {static_cast<int>(f), std::countr_zero(bits), least};
    return {};
  }
};

/// Whether two faces may lie flat on each other: see near_faces.
bool may_touch_flatly(const PlacedSolid& a, int f, const PlacedSolid& b, int g) {
  return opposed(a, f, b, g) <= opposed_enough && fits_faces(a, f) && fits_faces(b, g) &&
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

/// Which corners of its solid a face has, the last again and again beyond its own; false where they are many.
bool list_few(const ConvexSolid& solid, int face, std::array<std::uint8_t, few_corners>& corner) {
  const std::span<const int> loop = solid.shape.faces[face];
  if (loop.size() > corner.size()) return false;
  for (std::size_t k = 0; k < corner.size(); ++k) {
    const int c = loop[std::min(k, loop.size() - 1)];
    if (c > std::numeric_limits<std::uint8_t>::max()) return false;
    corner[k] = static_cast<std::uint8_t>(c);
  }
  return true;
}

/// What goes with the two faces found.
void describe(const PlacedSolid& a, const PlacedSolid& b, FacePair& found) {
  found.near = near_faces(a, b), found.b_is_larger = a.solid->size < b.solid->size;
  found.few = list_few(*a.solid, found.a, found.corner_a) && list_few(*b.solid, found.b, found.corner_b);
}

}  // namespace

/// Whether the pressure of a law is kn times the overlap, so that integrals over polygons are exact.
bool is_linear(const ContactLaw& law) {
  return !may_crush(law) && std::visit([](const auto& l) { return std::decay_t<decltype(l)>::Kernel::linear; }, law);
}

namespace {

FacePair none_yet() {
  FacePair found;
  found.a = found.b = FacePair::none, found.until = unbounded;
  return found;
}

/// What is known of the pair of faces of two solids that may lie flat, as one pair after the other is looked at.
///
/// Corners that have gone by at most t have turned a body of inner radius r (ConvexSolid) by so little that a unit
/// vector in it has moved by t / r or less. So the product of two normals changes by t / r of both together, and the
/// depth of a corner x below a plane through c by 2 t + |c - x| t / r. A pair that is none stays none until either
/// could have made it one.
struct FacePairSearch {
  const PlacedSolid &a, &b;
  double near = near_faces(a, b), turns = 1 / a.solid->inner_radius + 1 / b.solid->inner_radius;
  FacePair found = none_yet();
  double enough = unbounded;  // of turning: another pair may be one before
  bool several = false;

  void may_become_one(double beyond, const PlaneDistance& distance) {
    const double by_turn = beyond / turns, by_way = (distance.depth - near) / (2 + distance.corner * turns);
    found.until = std::min(found.until, std::max(by_turn, by_way)), enough = found.until * turns;
  }
  /// The pair that has the least far to turn comes first: of most others it
  /// then is known that they come later.
  void begin_with(const PairOfFaces& nearest) {
    if (nearest.beyond < unbounded && fits_faces(a, nearest.f) && fits_faces(b, nearest.g))
      may_become_one(nearest.beyond, PlaneDistance(a, nearest.f, b, nearest.g));
  }
  void look_at(int f, int g, double beyond) {
    if (several || (beyond > 0 && beyond >= enough) || !fits_faces(a, f) || !fits_faces(b, g)) return;
    const PlaneDistance distance(a, f, b, g);
    if (beyond > 0 || distance.depth > near) return may_become_one(beyond, distance);
    several = found.a >= 0;
    found.a = f, found.b = g;
  }
  [[nodiscard]] FacePair result(double travel) const {
    if (several) return {};
    FacePair out = found;
    out.until = travel + (1 - 1e-6) * found.until;
    if (out.a >= 0) describe(a, b, out);
    return out;
  }
};

[[gnu::target_clones("avx2", "default")]] void search_few(FacePairSearch& search) {
  const BeyondOpposed beyond(search.a, search.b);
  search.begin_with(beyond.nearest());
  beyond.for_below(search.b.normals.size(), search.enough, [&](int f, int g, double by) { search.look_at(f, g, by); });
}

}  // namespace

FacePair facing_pair(const PlacedSolid& a, const PlacedSolid& b, double travel) {
  FacePairSearch search{a, b};
  if (has_few_faces(*a.solid) && has_few_faces(*b.solid)) {
    search_few(search);
    return search.result(travel);
  }
  search.begin_with(least_to_turn(a, b));
  for (int f = 0; f < a.solid->shape.faces.count(); ++f)
    for (int g = 0; g < b.solid->shape.faces.count(); ++g) search.look_at(f, g, opposed(a, f, b, g) - opposed_enough);
  return search.result(travel);
}

/// All pairs of opposed faces are asked; more than one that touches flatly, as of a wedge in a notch, are no flat
/// contact.
bool flat_faces(const PlacedSolid& a, const PlacedSolid& b, FaceOverlap3& out) {
  int found = 0;
  FaceRoom room_a, room_b;
  FaceOverlap3 another;
  for (int f = 0; f < a.solid->shape.faces.count(); ++f)
    for (int g = 0; g < b.solid->shape.faces.count(); ++g) {
      if (!may_touch_flatly(a, f, b, g)) continue;
      FaceOverlap3& tried = found == 0 ? out : another;
      if (!face_overlap(face_of(a, f, room_a), face_of(b, g, room_b), tried)) continue;
      const FlatMeasures measures(tried);
      if (!measures.touch()) continue;
      tried.face_a = f, tried.face_b = g;
      if (!measures.are_flat() || ++found > 1) return false;
    }
  return found == 1;
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
SolidPressure face_pressure(const MovingSolid& a, const MovingSolid& b, const Coulomb& law, const FaceOverlap3& faces) {
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
double face_energy(const Coulomb& law, const FaceOverlap3& faces) {
  return law.kn * integrals_in_contact(faces).energy;
}

}  // namespace trilith
