#include "contact/space/sampled_faces.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "base/simd/registers.hpp"
#include "contact/space/sampled_triangles.hpp"

namespace trilith {
namespace {

/// A triangle is cut into four while the overlap at its corners differs by more than this ratio, and at most so often.
/// Halved triangles along the edge of contact have other ratios, so rounding does not decide on cuts.
/// Six points then integrate a power between 1 and 3 over a polygon to 1 part in 10^5, also where it is partly open.
constexpr double even_enough = 0.45;
constexpr int most_cuts = 3;

using CutTriangle = std::array<Lanes, 3>;  // corners: arm and overlap

void add_cut(const Lanes& face, const CutTriangle& t, int cuts, TriangleLanes& triangles) {
  const auto [least, most] = std::minmax({t[0][3], t[1][3], t[2][3]});
  if (cuts == 0 || least >= even_enough * most) return triangles.add(face, t[0], t[1], t[2]);
  const std::array<Lanes, 3> middle{0.5 * (t[1] + t[2]), 0.5 * (t[2] + t[0]), 0.5 * (t[0] + t[1])};
  for (std::size_t i = 0; i < 3; ++i)
    add_cut(face, {t[i], middle[(i + 2) % 3], middle[(i + 1) % 3]}, cuts - 1, triangles);
  add_cut(face, middle, cuts - 1, triangles);
}

/// The part of the polygon where the overlap is positive, as triangles about the origin of the mean plane. Their normal
/// points out of a, and they push b along it.
std::span<const FourTriangles> closed_triangles(const FaceOverlap3& faces, TriangleLanes& triangles) {
  const MeanPlane& plane = faces.plane;
  const SharedPolygon& polygon = faces.shared;
  const Vec3& n = plane.normal;
  const Lanes face{n.x(), n.y(), n.z(), 1};
  Lanes first{}, last{};
  int corners = 0;
  const auto add = [&](const Vec2& p, double overlap) {
    const Vec3 arm = p.x() * plane.x + p.y() * plane.y;
    const Lanes corner{arm.x(), arm.y(), arm.z(), overlap};
    if (corners == 0) first = corner;
    if (corners > 1) add_cut(face, {first, last, corner}, most_cuts, triangles);
    last = corner, ++corners;
  };
  for (int i = 0; i < polygon.count; ++i) {
    const Vec2 &p = polygon.corner[static_cast<std::size_t>(i)],
               &q = polygon.corner[static_cast<std::size_t>(i + 1 < polygon.count ? i + 1 : 0)];
    const double cp = plane.overlap_at(p), cq = plane.overlap_at(q);
    if (cp >= 0) add(p, cp);
    if ((cp > 0 && cq < 0) || (cp < 0 && cq > 0)) add(p + cp / (cp - cq) * (q - p), 0);
  }
  return triangles.all();
}

template <class K>
TRILITH_INLINE PressedSums sums_of_all(std::span<const FourTriangles> triangles, const K& law, const Vec3& normal,
                                       const ClosingMotion& motion) {
  const DampedMotion damped(normal, motion);
  TriangleSums sums;
  for (const FourTriangles& in : triangles) sum_sampled(in, law, damped, sums);
  return over_lanes(sums, damped.normal, nullptr);
}

// One copy for wide registers and one for any machine: the same operations, so the same bits.

template <class K>
PressedSums sums_narrow(std::span<const FourTriangles> triangles, const K& law, const Vec3& normal,
                        const ClosingMotion& motion) {
  return sums_of_all(triangles, law, normal, motion);
}
#ifdef __x86_64__
template <class K>
[[gnu::target("avx2")]] PressedSums sums_wide(std::span<const FourTriangles> triangles, const K& law,
                                              const Vec3& normal, const ClosingMotion& motion) {
  return sums_of_all(triangles, law, normal, motion);
}
#endif

template <class K>
PressedSums sums_of_faces(std::span<const FourTriangles> triangles, const K& law, const Vec3& normal,
                          const ClosingMotion& motion) {
#ifdef __x86_64__
  static const bool wide = registers_here() != Registers::narrow;
  if (wide) return sums_wide(triangles, law, normal, motion);
#endif
  return sums_narrow(triangles, law, normal, motion);
}

/// Work over kn to reach an overlap [m2]: the integral of e from 0 to c, written as c times the integral of
/// 2 t e(c t^2) from 0 to 1, by four points of Gauss quadrature. In t powers are smoother; half integers are exact.
template <class K>
TRILITH_INLINE Lanes work_to_reach(const K& law, const Lanes& overlap) {
  constexpr std::array<std::array<double, 2>, 4> points{{{0.06943184420297371, 0.17392742256872693},
                                                         {0.33000947820757187, 0.32607257743127307},
                                                         {0.66999052179242813, 0.32607257743127307},
                                                         {0.93056815579702629, 0.17392742256872693}}};
  Lanes sum{};
  for (const auto& [t, weight] : points) sum += 2 * t * weight * effective_of(law, Lanes(t * t * overlap));
  return sum * overlap;
}

template <class K>
double work_over(std::span<const FourTriangles> triangles, const K& law) {
  Lanes sum{};
  for (const FourTriangles& in : triangles) {
    const Lanes area = area_of(in);
    for (const auto& [own, other, weight] : sample_rule)
      for (const std::size_t i : {0U, 1U, 2U})
        sum += weight * area *
               work_to_reach(law, Lanes(own * in.depth[i] + other * (in.depth[(i + 1) % 3] + in.depth[(i + 2) % 3])));
  }
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

}  // namespace

bool has_sampled_faces(const ContactLaw& law) {
  return !may_crush(law) && std::visit([](const auto& l) { return !std::decay_t<decltype(l)>::Kernel::linear; }, law);
}

/// pressure_of_sums takes sums over the faces of both solids, each with half of the stiffness. Here one polygon
/// represents both, so its area counts twice and its pressure has the whole stiffness.
SolidPressure sampled_face_pressure(const MovingSolid& a, const MovingSolid& b, const LawInUse& law,
                                    const FaceOverlap3& faces, std::vector<FourTriangles>& room) {
  const MeanPlane& plane = faces.plane;
  const ClosingMotion motion{b.velocity_at(plane.origin) - a.velocity_at(plane.origin), b.spin - a.spin};
  TriangleLanes lanes(room);
  const std::span<const FourTriangles> triangles = closed_triangles(faces, lanes);
  SolidPressure out = with_kernel(law, [&](const auto& kernel) {
    PressedSums sums = sums_of_faces(triangles, kernel, plane.normal, motion);
    sums.area *= 2, sums.area_arm *= 2;
    for (double& second : sums.area_second) second *= 2;
    return pressure_of_sums(plane.origin, kernel.kn, sums);
  });
  out.face_a = faces.face_a, out.face_b = faces.face_b;
  return out;
}

double sampled_face_energy(const LawInUse& law, const FaceOverlap3& faces, std::vector<FourTriangles>& room) {
  TriangleLanes lanes(room);
  const std::span<const FourTriangles> triangles = closed_triangles(faces, lanes);
  return with_kernel(law, [&](const auto& kernel) { return kernel.kn * work_over(triangles, kernel); });
}

}  // namespace trilith
