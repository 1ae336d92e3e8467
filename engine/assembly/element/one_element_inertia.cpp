#include "assembly/element/rotary_inertia.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

#include "assembly/whole_body.hpp"

namespace trilith {
namespace {

/// The element of a body with a single one, otherwise null. Elements are stored body by body.
template <class E>
const E* only_element(const std::vector<E>& elements, int body) {
  const auto at = std::lower_bound(elements.begin(), elements.end(), body,
                                   [](const E& element, int b) { return element.body < b; });
  if (at == elements.end() || at->body != body) return nullptr;
  const auto next = at + 1;
  return next != elements.end() && next->body == body ? nullptr : &*at;
}

template <int D>
struct Lumped {
  Vec<D> centre = Vec<D>::Zero();
  double mass = 0;
  TurnMatrix<D> inertia = TurnMatrix<D>::Zero();
};

template <int D>
Lumped<D> lumped_inertia(const Model<D>& model, const State<D>& state, const Body& body) {
  Lumped<D> out;
  const int end = body.first_node + body.nodes;
  for (int n = body.first_node; n < end; ++n)
    out.mass += model.mass[n], out.centre += model.mass[n] * state.position[n];
  out.centre /= out.mass;
  for (int n = body.first_node; n < end; ++n) {
    const Vec<D> arm = state.position[n] - out.centre;
    if constexpr (D == 2)
      out.inertia(0, 0) += model.mass[n] * arm.squaredNorm();
    else
      out.inertia += turn_inertia(model.mass[n], arm);
  }
  return out;
}

/// Signs of the natural coordinates of a brick's nodes.
constexpr std::array<std::array<double, 3>, 8> corner{
    {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};

/// Position in a brick as a polynomial of its natural coordinates.
struct BrickShape {
  Vec3 x = Vec3::Zero(), y = x, z = x, yz = x, zx = x, xy = x, xyz = x;

  explicit BrickShape(const std::array<Vec3, 8>& arm) {
    for (std::size_t i = 0; i < 8; ++i) {
      const auto [a, b, c] = corner[i];
      const Vec3 part = 0.125 * arm[i];
      x += a * part, y += b * part, z += c * part;
      yz += b * c * part, zx += c * a * part, xy += a * b * part, xyz += a * b * c * part;
    }
  }
  /// True if the faces are parallelograms within 0.1 %.
  [[nodiscard]] bool is_parallelepiped() const {
    constexpr double share = 1e-6;  // of squares
    const double size = std::min({x.squaredNorm(), y.squaredNorm(), z.squaredNorm()});
    return yz.squaredNorm() + zx.squaredNorm() + xy.squaredNorm() + xyz.squaredNorm() <= share * size;
  }
};

/// Inertia of a brick of mass 1 about its centroid, by 2 x 2 x 2 Gauss points, relative to the mean of its nodes.
Eigen::Matrix3d brick_inertia(const BrickShape& s, const Vec3& from_mean) {
  const double at = 1 / std::sqrt(3.0);
  double volume = 0;
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (const auto& sign : corner) {
    const double a = at * sign[0], b = at * sign[1], c = at * sign[2];
    const Vec3 da = s.x + c * s.zx + b * s.xy + b * c * s.xyz, db = s.y + c * s.yz + a * s.xy + a * c * s.xyz,
               dc = s.z + b * s.yz + a * s.zx + a * b * s.xyz;
    const double share = cross(da, db).dot(dc);
    const Vec3 r =
        a * s.x + b * s.y + c * s.z + b * c * s.yz + c * a * s.zx + a * b * s.xy + a * b * c * s.xyz - from_mean;
    volume += share, second += share * (r * r.transpose());
  }
  second /= volume;
  return second.trace() * Eigen::Matrix3d::Identity() - second;
}

}  // namespace

bool is_one_element(const Model<2>& model, int body) {
  const Body& b = model.bodies[body];
  if (b.kind == BodyKind::quad) return true;
  return b.kind == BodyKind::mesh && b.nodes <= 4 && only_element(model.elements, body) != nullptr;
}
bool is_one_element(const Model<3>& model, int body) {
  const Body& b = model.bodies[body];
  return b.kind == BodyKind::brick || (b.kind == BodyKind::mesh && b.nodes == 4);
}

template <int D>
bool has_one_element_bodies(const Model<D>& model) {
  if (model.elements.empty() && model.space_elements.empty()) return false;
  for (int b = 0; b < static_cast<int>(model.bodies.size()); ++b)
    if (is_one_element(model, b)) return true;
  return false;
}

/// Inertia of a polygon whose nodes follow its outline.
RotaryInertia<2> rotary_inertia(const Model<2>& model, const State<2>& state, int body) {
  const Body& b = model.bodies[body];
  const Lumped<2> lumped = lumped_inertia(model, state, b);
  double twice = 0, second = 0;
  for (int i = 0; i < b.nodes; ++i) {
    const Vec2 p = state.position[b.first_node + i] - lumped.centre,
               q = state.position[b.first_node + (i + 1) % b.nodes] - lumped.centre;
    const double area = cross(p, q);
    twice += area, second += area * (p.squaredNorm() + p.dot(q) + q.squaredNorm());
  }
  RotaryInertia<2> out{lumped.centre, lumped.inertia, {}};
  out.own(0, 0) = lumped.mass * second / (6 * twice);
  return out;
}

RotaryInertia<3> rotary_inertia(const Model<3>& model, const State<3>& state, int body) {
  const Body& b = model.bodies[body];
  const Lumped<3> lumped = lumped_inertia(model, state, b);
  RotaryInertia<3> out{lumped.centre, lumped.inertia, {}};
  if (b.nodes == 4) return {lumped.centre, lumped.inertia, lumped.inertia / 5, 5};
  const SpaceElement* element = only_element(model.space_elements, body);
  std::array<Vec3, 8> arm;
  Vec3 mean = Vec3::Zero();
  for (std::size_t i = 0; i < 8; ++i) arm[i] = state.position[element->node[i]], mean += 0.125 * arm[i];
  for (Vec3& a : arm) a -= mean;
  const BrickShape shape(arm);
  if (shape.is_parallelepiped()) return {lumped.centre, lumped.inertia, lumped.inertia / 3, 3};
  out.own = lumped.mass * brick_inertia(shape, lumped.centre - mean);
  return out;
}

template <int D>
double lumped_over_own(const Model<D>& model, const State<D>& state, int body) {
  if (!is_one_element(model, body)) return 1;
  const RotaryInertia<D> of = rotary_inertia(model, state, body);
  if constexpr (D == 2)
    return of.lumped(0, 0) / of.own(0, 0);
  else if (of.multiple > 0)
    return of.multiple;
  else
    return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix3d>(of.lumped, of.own, Eigen::EigenvaluesOnly)
        .eigenvalues()
        .maxCoeff();
}

template bool has_one_element_bodies(const Model<2>&);
template bool has_one_element_bodies(const Model<3>&);
template double lumped_over_own(const Model<2>&, const State<2>&, int);
template double lumped_over_own(const Model<3>&, const State<3>&, int);

}  // namespace trilith
