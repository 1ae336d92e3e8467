// An element in space in its co-rotating axes: deformation and rate of its nodes, see element/corotation_3d.hpp.
#pragma once

#include <array>
#include <span>

#include "element/corotation_3d.hpp"
#include "model/element/space_element_rows.hpp"

namespace trilith {

/// `number`: its rows of Model::element_number.
template <int N>
struct SpaceElementNow {
  FittedTurn turn;
  std::array<double, 3 * N> d, v;  ///< x0, y0, z0, x1, ... [m], [m/s]

  SpaceElementNow(const double* number, const int* node, std::span<const Vec3> position,
                  std::span<const Vec3> velocity) {
    const double *const shape = number, *const gradient = number + 3 * N;
    Vec3 mean = Vec3::Zero(), drift = Vec3::Zero();
    Eigen::Matrix3d f = Eigen::Matrix3d::Zero();
    for (int i = 0; i < N; ++i) mean += at(position, node[i]), drift += at(velocity, node[i]);
    mean /= N, drift /= N;
    for (int i = 0; i < N; ++i)
      for (int k = 0; k < 3; ++k) f.col(k) += gradient[3 * i + k] * (at(position, node[i]) - mean);
    turn = fitted_turn(f);
    Vec3 spin = Vec3::Zero();
    for (int i = 0; i < N; ++i) {
      const Vec3 place = turn.axes.transpose() * (at(position, node[i]) - mean),
                 rate = turn.axes.transpose() * (at(velocity, node[i]) - drift);
      spin += cross(row(gradient, i), rate);
      for (int k = 0; k < 3; ++k) d[3 * i + k] = place[k] - shape[3 * i + k], v[3 * i + k] = rate[k];
    }
    spin = (turn.couple * spin).eval();
    for (int i = 0; i < N; ++i) {
      const Vec3 swept = cross(spin, now_at(shape, i));
      for (int k = 0; k < 3; ++k) v[3 * i + k] -= swept[k];
    }
  }

  /// Forces on the nodes in world axes, which do the work of h in the rate of d.
  void to_nodes(const double* number, const double* h, Vec3* out) const {
    const double *const shape = number, *const gradient = number + 3 * N;
    Vec3 moment = Vec3::Zero();
    for (int i = 0; i < N; ++i) moment += cross(now_at(shape, i), row(h, i));
    const Vec3 couple = turn.couple * moment;
    for (int i = 0; i < N; ++i) out[i] = turn.axes * (row(h, i) - cross(couple, row(gradient, i)));
  }

 private:
  static const Vec3& at(std::span<const Vec3> of, int node) { return of[static_cast<std::size_t>(node)]; }
  static Vec3 row(const double* of, int i) { return {of[3 * i], of[3 * i + 1], of[3 * i + 2]}; }
  [[nodiscard]] Vec3 now_at(const double* shape, int i) const { return row(shape, i) + row(d.data(), i); }
};

}  // namespace trilith
