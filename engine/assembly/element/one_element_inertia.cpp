#include <Eigen/Eigenvalues>
#include <algorithm>

#include "assembly/element/integration_shares.hpp"
#include "assembly/element/rotary_inertia.hpp"
#include "assembly/whole_body.hpp"

namespace trilith {
namespace {

TurnMatrix<2> inertia_of(double mass, const Vec2& arm) {
  return TurnMatrix<2>(turn_inertia(mass, arm));
}
TurnMatrix<3> inertia_of(double mass, const Vec3& arm) {
  return turn_inertia(mass, arm);
}

/// Without the inertia of the body itself.
template <int D>
RotaryInertia<D> lumped_inertia(const Model<D>& model, const State<D>& state, const Body& body) {
  RotaryInertia<D> out;
  double mass = 0;
  out.nodes.count = body.nodes;
  for (int i = 0; i < body.nodes; ++i) {
    const auto n = static_cast<std::size_t>(body.first_node + i);
    out.nodes.mass[i] = model.mass[n];
    mass += model.mass[n], out.centre += model.mass[n] * state.position[n];
  }
  out.centre /= mass;
  for (int i = 0; i < body.nodes; ++i) {
    out.nodes.arm[i] = state.position[static_cast<std::size_t>(body.first_node + i)] - out.centre;
    out.lumped += inertia_of(out.nodes.mass[i], out.nodes.arm[i]);
  }
  return out;
}

template <int D>
RotaryInertia<D> proportional(RotaryInertia<D> of, double multiple) {
  of.multiple = multiple, of.own = of.lumped / multiple;
  return of;
}

/// Arms of the element's nodes, in its own order.
template <int D, class E>
NodeVectors<D> element_arms(RotaryInertia<D>& of, const Body& body, const E& element) {
  NodeVectors<D> out;
  for (int i = 0; i < corners_in<D>; ++i) {
    of.place[i] = element.node[i] - body.first_node;
    out[i] = of.nodes.arm[of.place[i]];
  }
  return out;
}

constexpr double proportional_share = 1e-6;  // of squares

/// True if a quad is a parallelogram within 0.1 % of its size.
bool is_proportional(const NodeVectors<2>& arm, const RotaryInertia<2>& of) {
  double mass = 0;
  for (const double m : of.nodes.mass) mass += m;
  return (arm[0] + arm[2]).squaredNorm() * mass <= proportional_share * of.lumped(0, 0);
}
/// True if the faces of a brick are parallelograms within 0.1 %. The position is a polynomial of the natural
/// coordinates.
bool is_proportional(const NodeVectors<3>& arm, const RotaryInertia<3>& /*of*/) {
  Vec3 x = Vec3::Zero(), y = x, z = x, yz = x, zx = x, xy = x, xyz = x;
  for (std::size_t i = 0; i < 8; ++i) {
    const auto [a, b, c] = corner_signs<3>[i];
    const Vec3 part = 0.125 * arm[i];
    x += a * part, y += b * part, z += c * part;
    yz += b * c * part, zx += c * a * part, xy += a * b * part, xyz += a * b * c * part;
  }
  return yz.squaredNorm() + zx.squaredNorm() + xy.squaredNorm() + xyz.squaredNorm() <=
         proportional_share * std::min({x.squaredNorm(), y.squaredNorm(), z.squaredNorm()});
}

/// The mass of a quad or brick at its integration points: shares of the volume at the start, so that mass stays where
/// it is in the material.
template <int D, class E>
void set_points(const Model<D>& model, const E& element, const NodeVectors<D>& arm, RotaryInertia<D>& of) {
  double volume = 0, mass = 0;
  of.points.count = corners_in<D>;
  for (int g = 0; g < corners_in<D>; ++g) {
    Eigen::Matrix<double, D, D> jacobian = Eigen::Matrix<double, D, D>::Zero();
    of.points.arm[g].setZero();
    for (int i = 0; i < corners_in<D>; ++i) {
      for (int k = 0; k < D; ++k)
        jacobian.col(k) += slope_share<D>(i, g, k) * model.start_position[static_cast<std::size_t>(element.node[i])];
      of.points.arm[g] += node_share<D>(i, g) * arm[i];
    }
    of.points.mass[g] = jacobian.determinant(), volume += of.points.mass[g], mass += of.nodes.mass[g];
  }
  for (int g = 0; g < corners_in<D>; ++g) {
    of.points.mass[g] *= mass / volume;
    of.own += inertia_of(of.points.mass[g], of.points.arm[g]);
  }
}

template <int D, class E>
RotaryInertia<D> inertia_of_element(const Model<D>& model, const State<D>& state, const Body& body, const E& element) {
  RotaryInertia<D> out = lumped_inertia(model, state, body);
  const NodeVectors<D> arm = element_arms(out, body, element);
  if (is_proportional(arm, out)) return proportional(out, 3);
  set_points(model, element, arm, out);
  return out;
}

}  // namespace

template <int D>
bool has_one_element_bodies(const Model<D>& model) {
  if (model.elements.empty() && model.space_elements.empty()) return false;
  for (int b = 0; b < static_cast<int>(model.bodies.size()); ++b)
    if (is_one_element(model, b)) return true;
  return false;
}

RotaryInertia<2> rotary_inertia(const Model<2>& model, const State<2>& state, int body) {
  const Body& b = model.bodies[body];
  if (b.nodes == 3) return proportional(lumped_inertia(model, state, b), 4);
  return inertia_of_element(model, state, b, first_element(model.elements, body));
}

RotaryInertia<3> rotary_inertia(const Model<3>& model, const State<3>& state, int body) {
  const Body& b = model.bodies[body];
  if (b.nodes == 4) return proportional(lumped_inertia(model, state, b), 5);
  return inertia_of_element(model, state, b, first_element(model.space_elements, body));
}

template <int D>
double lumped_over_own(const Model<D>& model, const State<D>& state, int body) {
  if (!is_one_element(model, body)) return 1;
  const RotaryInertia<D> of = rotary_inertia(model, state, body);
  if (of.multiple > 0) return of.multiple;
  if constexpr (D == 2)
    return of.lumped(0, 0) / of.own(0, 0);
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
