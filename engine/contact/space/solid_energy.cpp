#include "contact/space/solid_energy.hpp"

#include <algorithm>
#include <array>

namespace trilith {
namespace {

/// Integral of effective(depth) over a tetrahedron, from the depths at its corners, for nonlinear laws. Gauss
/// quadrature along each of three collapsed coordinates, whose Jacobian is part of the weight.
template <class K>
double energy_of_tetrahedron(double volume, const std::array<double, 4>& depth, const K& law) {
  constexpr std::array<double, 4> point{0.06943184420297371, 0.33000947820757187, 0.66999052179242813,
                                        0.93056815579702629};
  constexpr std::array<double, 4> weight{0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                                         0.17392742256872693};
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t k = 0; k < 4; ++k) {
        const double u = point[i], v = (1 - u) * point[j], w = (1 - u) * (1 - point[j]) * point[k];
        const double at = (1 - u - v - w) * depth[0] + u * depth[1] + v * depth[2] + w * depth[3];
        sum += weight[i] * weight[j] * weight[k] * (1 - u) * (1 - u) * (1 - point[j]) * law.effective(at);
      }
  return 6 * volume * sum;
}

/// The pressed region of a solid: its volume [m3], and the integral over it of the law's function of the depth [m4].
struct PressedVolume {
  double volume = 0, depth = 0;

  PressedVolume& operator+=(const PressedVolume& more) {
    volume += more.volume, depth += more.depth;
    return *this;
  }
};

double depth_below(const BoundingPlane& plane, const Vec3& x) {
  return plane.normal.dot(plane.point - x);
}

/// Over one cell, in which depths below a plane of the owner are linear and exceed `crushed`.
template <class K>
PressedVolume over_cell(const BoundingPlane& plane, const K& law, const SolidOverlapBuffer& cell, double crushed) {
  if constexpr (K::linear) {
    const auto [volume, centroid] = measured(cell);
    if (!(volume > 0)) return {};
    return {volume, volume * std::max(0.0, depth_below(plane, centroid) - crushed)};
  } else {
    const auto point = [&](int i) -> const Vec3& { return cell.points[static_cast<std::size_t>(i)]; };
    const auto depth = [&](int i) { return std::max(0.0, depth_below(plane, point(i))); };
    const int top = cell.edges[0].from;
    double sum = 0;
    int i = 0;
    for (const auto& face : cell.faces) {
      const int base = cell.edges[static_cast<std::size_t>(i)].from;
      for (; i < face.end; ++i) {
        const auto [from, to] = cell.edges[static_cast<std::size_t>(i)];
        const Vec3 twice = cross(Vec3(point(from) - point(base)), Vec3(point(to) - point(base)));
        sum += energy_of_tetrahedron(twice.dot(point(base) - point(top)) / 6,
                                     {depth(top), depth(base), depth(from), depth(to)}, law);
      }
    }
    return {0, sum};
  }
}

/// Calls f(plane) for all planes that bound the body of a solid, once for coplanar ones.
template <class F>
void for_planes(const PlacedSolid& owner, F&& f) {
  const FaceLoops& faces = owner.solid->shape.faces;
  for (int i = 0; i < faces.count(); ++i)
    if (owner.solid->is_surface(i) && !has_first_like(owner, i))
      f(BoundingPlane{owner.normals[static_cast<std::size_t>(i)], owner.corners[static_cast<std::size_t>(faces[i][0])]},
        i);
  for (std::size_t i = 0; i < owner.beside.size(); ++i) f(owner.beside[i], faces.count() + static_cast<int>(i));
}

/// Copies the solid alone, without the scratch of the buffer.
void copy_solid(const SolidOverlapBuffer& from, SolidOverlapBuffer& to) {
  to.points = from.points, to.edges = from.edges, to.faces = from.faces;
}

/// The half-space in which the depth below `own` is at most the depth below `other`.
HalfSpace nearer_to(const BoundingPlane& own, const BoundingPlane& other) {
  const Vec3 &n = own.normal, &m = other.normal;
  return {m - n, m.dot(other.point) - n.dot(own.point), 0};
}

/// True where no point of the solid in `shared` is in the half-space, as cut() finds it.
bool is_beyond(const SolidOverlapBuffer& shared, const HalfSpace& half) {
  double lowest = 0, highest = 0;
  for (const Vec3& p : shared.points) {
    const double height = half.normal.dot(p) - half.offset;
    lowest = std::min(lowest, height), highest = std::max(highest, height);
  }
  return highest > 0 && lowest >= 0;
}

/// Cuts the cell in which `own`, plane `f` of the owner, is nearest out of the solid in `shared`. False where it is
/// empty, which is most often found before anything is copied: few planes are near a small shared solid.
bool cut_cell(const PlacedSolid& owner, const BoundingPlane& own, int f, const SolidOverlapBuffer& shared,
              SolidOverlapBuffer& cell) {
  bool some = !shared.faces.empty();
  for_planes(owner, [&](const BoundingPlane& other, int g) {
    some = some && (g == f || !is_beyond(shared, nearer_to(own, other)));
  });
  if (!some) return false;
  copy_solid(shared, cell);
  for_planes(owner, [&](const BoundingPlane& other, int g) {
    if (g != f && some) some = cut(nearer_to(own, other), cell) && !cell.edges.empty();
  });
  return some;
}

/// Over the part of the solid in `shared` that is deeper in `owner` than its mortar is crushed, cell by cell.
template <class K>
PressedVolume pressed_in(const PlacedSolid& owner, const K& law, const SolidOverlapBuffer& shared,
                         SolidOverlapBuffer& cell, double crushed) {
  PressedVolume sum;
  for_planes(owner, [&](const BoundingPlane& own, int f) {
    bool some = cut_cell(owner, own, f, shared, cell);
    if (some && crushed > 0)
      some = cut({own.normal, own.normal.dot(own.point) - crushed, 0}, cell) && !cell.edges.empty();
    if (some) sum += over_cell(own, law, cell, crushed);
  });
  return sum;
}

template <class K>
PressedVolume pressed_in_both(const PlacedSolid& a, const PlacedSolid& b, const K& law,
                              const SolidOverlapBuffer& shared, SolidOverlapBuffer& scratch, double crushed) {
  PressedVolume sum = pressed_in(a, law, shared, scratch, crushed);
  return sum += pressed_in(b, law, shared, scratch, crushed);
}

}  // namespace

/// Energy of a pair of solids of any shape [J], the potential of their contact force:
///
///     E = kn / 2 (integral over the shared volume of e(phi_a) + integral of e(phi_b)).
///
/// Here phi is the depth below the nearest face of a solid minus the crushed depth, and kn e the law's pressure (e =
/// phi where it is linear), both where positive.
double solid_energy(const PlacedSolid& a, const PlacedSolid& b, const LawInUse& law, SolidOverlapBuffer& shared,
                    SolidOverlapBuffer& scratch, double crushed) {
  if (!(shared_volume(a, b, shared) > 0)) return 0;
  return with_kernel(law, [&](const auto& kernel) {
    return 0.5 * kernel.kn * pressed_in_both(a, b, kernel, shared, scratch, crushed).depth;
  });
}

/// -dE/dz is kn / 2 times the volumes in which phi is positive.
double solid_crushing_force(const PlacedSolid& a, const PlacedSolid& b, const LawInUse& law,
                            const SolidOverlapBuffer& shared, SolidOverlapBuffer& scratch, double crushed) {
  return with_kernel(law, [&](const auto& kernel) {
    return 0.5 * kernel.kn * pressed_in_both(a, b, kernel, shared, scratch, crushed).volume;
  });
}

}  // namespace trilith
