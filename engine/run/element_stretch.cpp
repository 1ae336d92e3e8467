#include "run/element_stretch.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/portable.hpp"
#include "base/principal_axes.hpp"
#include "element/solid/element_gradients.hpp"
#include "model/element/element_rows.hpp"

namespace trilith {
namespace {

/// A corner of an element: its two edges at the start and now.
struct Corner {
  Vec2 first, second, first_now, second_now;
};

Corner corner_of(const Model<2>& model, const State<2>& state, const Element& e, int i) {
  const double* const shape = &model.element_number[e.first_number];
  const int next = (i + 1) % e.nodes, before = (i + e.nodes - 1) % e.nodes;
  const auto start = [&](int k) { return Vec2(shape[2 * k], shape[2 * k + 1]); };
  const auto now = [&](int k) { return state.position[e.node[k]]; };
  return {start(next) - start(i), start(before) - start(i), now(next) - now(i), now(before) - now(i)};
}

/// Principal stretches at a corner; the smaller one has the sign of the corner's area.
struct Stretches {
  double least, most;
};

/// F = first_now g' + second_now h', with g and h such that F maps the initial edges to the present ones. Its singular
/// values are p + q and |p - q|; p - q < 0 if the corner is inverted.
Stretches stretches_at(const Corner& c) {
  const double area = cross(c.first, c.second);
  const Vec2 g(c.second.y() / area, -c.second.x() / area), h(-c.first.y() / area, c.first.x() / area);
  const double xx = c.first_now.x() * g.x() + c.second_now.x() * h.x(),
               xy = c.first_now.x() * g.y() + c.second_now.x() * h.y(),
               yx = c.first_now.y() * g.x() + c.second_now.y() * h.x(),
               yy = c.first_now.y() * g.y() + c.second_now.y() * h.y();
  const double p = 0.5 * portable::hypot(xx + yy, yx - xy), q = 0.5 * portable::hypot(xx - yy, xy + yx);
  return {p - q, p + q};
}

/// Least travel of all nodes before the stretches at a corner change by 1. An edge changes by at most twice the travel,
/// and the stretches by at most the change of the deformation gradient.
double path_per_stretch(const Corner& c) {
  const double size = std::sqrt(c.first.squaredNorm() + c.second.squaredNorm());
  return std::abs(cross(c.first, c.second)) / (2 * std::sqrt(2.0) * size);
}

/// Stretch of an element. `room` is reduced to the travel of all points before the element may reach its limit.
ElementStretch stretch_of(const Model<2>& model, const State<2>& state, int element, double& room) {
  const Element& e = model.elements[element];
  const double limit = model.solids[e.solid].strain_limit;
  ElementStretch worst{element, 0, unbounded};
  for (int i = 0; i < e.nodes; ++i) {
    const Corner c = corner_of(model, state, e, i);
    const Stretches s = stretches_at(c);
    // Reserve to both limits: stretches from 1 - limit to 1 + limit.
    const double squeezed = s.least - std::max(0.0, 1 - limit), stretched = 1 + limit - s.most;
    const double spare = std::min(squeezed, stretched);
    room = std::min(room, spare * path_per_stretch(c));
    if (spare < worst.spare) worst = {element, squeezed < stretched ? s.least - 1 : s.most - 1, spare};
  }
  return worst;
}

/// Stretch of an element in space, at its corners and Gauss points: principal stretches of the deformation gradient F,
/// the least of which is negative if the element is inverted. A node that moves by p changes F by at most p times its
/// gradient.
ElementStretch stretch_of(const Model<3>& model, const State<3>& state, int element, double& room) {
  const SpaceElement& e = model.space_elements[static_cast<std::size_t>(element)];
  const double limit = model.solids[static_cast<std::size_t>(e.solid)].strain_limit;
  const auto nodes = static_cast<std::size_t>(info_of(e.shape).nodes);
  const double* const shape = &model.element_number[static_cast<std::size_t>(e.first_number)];
  std::vector<Vec3> start, now;
  for (std::size_t i = 0; i < nodes; ++i) {
    start.emplace_back(shape[3 * i], shape[3 * i + 1], shape[3 * i + 2]);
    now.push_back(state.position[static_cast<std::size_t>(e.node[i])]);
  }
  ElementStretch worst{element, 0, unbounded};
  for (const auto& gradient : watched_gradients(e.shape, start)) {
    Eigen::Matrix3d f = Eigen::Matrix3d::Zero();
    double slope = 0;
    for (std::size_t i = 0; i < nodes; ++i) f += now[i] * gradient[i].transpose(), slope += gradient[i].norm();
    const Eigen::Matrix3d c = f.transpose() * f;
    const Eigen::Vector3d squares = principal_axes(c, 1e-15 * c.cwiseAbs().maxCoeff()).value;
    const double least = std::copysign(std::sqrt(std::max(0.0, squares.minCoeff())), f.determinant()),
                 most = std::sqrt(squares.maxCoeff());
    const double squeezed = least - std::max(0.0, 1 - limit), stretched = 1 + limit - most;
    const double spare = std::min(squeezed, stretched);
    room = std::min(room, spare / slope);
    if (spare < worst.spare) worst = {element, squeezed < stretched ? least - 1 : most - 1, spare};
  }
  return worst;
}

}  // namespace

template <int D>
ElementStretch worst_element(const Model<D>& model, const State<D>& state, double& room) {
  const auto& elements = elements_of(model);
  ElementStretch worst{-1, 0, unbounded};
  for (int e = 0; e < static_cast<int>(elements.size()); ++e) {
    if (state.left[elements[e].body] != 0) continue;
    const ElementStretch s = stretch_of(model, state, e, room);
    if (s.spare < worst.spare) worst = s;
  }
  return worst;
}

template ElementStretch worst_element(const Model<2>&, const State<2>&, double&);
template ElementStretch worst_element(const Model<3>&, const State<3>&, double&);

}  // namespace trilith
