#include "assembly/element/quad_rotation.hpp"

#include "base/simd/lane_rows.hpp"

namespace trilith {
namespace {

/// x and y of the four nodes of four quads.
struct QuadNodes {
  std::array<Lanes, 4> x, y;

  TRILITH_INLINE explicit QuadNodes(const std::array<const double*, lane_count>& row) {
    const FourRowsOf<const double> rows(row);
    rows.load(0, x[0], y[0], x[1], y[1]);
    rows.load(4, x[2], y[2], x[3], y[3]);
  }
};

/// Computes the additional nodal forces of four quads. Returns a mask of the quads that are not parallelograms.
TRILITH_INLINE LaneMask rotation_forces(const QuadNodes& place, const QuadNodes& velocity, const QuadNodes& force,
                                        double last_dt, const std::array<Lanes, 4>& m, std::array<Lanes, 4>& fx,
                                        std::array<Lanes, 4>& fy) {
  const Lanes total = m[0] + m[1] + m[2] + m[3];
  const Lanes cx = (m[0] * place.x[0] + m[1] * place.x[1] + m[2] * place.x[2] + m[3] * place.x[3]) / total,
              cy = (m[0] * place.y[0] + m[1] * place.y[1] + m[2] * place.y[2] + m[3] * place.y[3]) / total;
  const Lanes skew_x = place.x[0] + place.x[2] - 2 * cx, skew_y = place.y[0] + place.y[2] - 2 * cy;
  Lanes lumped{}, moment{}, momentum{};
  std::array<Lanes, 4> x, y;
  for (std::size_t i = 0; i < 4; ++i) {
    x[i] = place.x[i] - cx, y[i] = place.y[i] - cy;
    lumped += m[i] * (x[i] * x[i] + y[i] * y[i]);
    moment += x[i] * force.y[i] - y[i] * force.x[i];
    momentum += m[i] * (x[i] * velocity.y[i] - y[i] * velocity.x[i]);
  }
  const Lanes turn = 2 * moment / lumped, spin = (momentum + 1.5 * last_dt * moment) / lumped,
              inwards = (2.0 / 3.0) * spin * spin;
  for (std::size_t i = 0; i < 4; ++i) {
    fx[i] = m[i] * (-turn * y[i] - inwards * x[i]), fy[i] = m[i] * (turn * x[i] - inwards * y[i]);
  }
  constexpr double share = 1e-6;  // of squares
  return (skew_x * skew_x + skew_y * skew_y) * total > share * lumped;
}

/// Adds the forces of two nodes.
TRILITH_INLINE void add_row(double* to, const Lanes& row) {
  store_lanes(to, load_lanes(to) + row);
}

}  // namespace

[[gnu::target_clones("arch=x86-64-v4", "avx2", "default")]] void add_quad_rotation(const Model<2>& model,
                                                                                   const State<2>& state,
                                                                                   FreeQuads& quads,
                                                                                   std::vector<Vec2>& added) {
  const auto count = static_cast<std::size_t>(quads.count);
  for (std::size_t i = count; i < (count + 3) / 4 * 4; ++i)
    quads.first_node[i] = quads.first_node[0], quads.force[i] = quads.force[0];
  for (std::size_t first = 0; first < count; first += 4) {
    std::array<const double*, lane_count> place, velocity, force, mass;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto node = static_cast<std::size_t>(quads.first_node[first + i]);
      place[i] = state.position[node].data(), mass[i] = &model.mass[node];
      velocity[i] = state.velocity[node].data();
      force[i] = quads.force[first + i]->data();
    }
    std::array<Lanes, 4> m, fx, fy;
    FourRowsOf<const double>(mass).load(0, m[0], m[1], m[2], m[3]);
    const LaneMask skewed =
        rotation_forces(QuadNodes(place), QuadNodes(velocity), QuadNodes(force), state.last_dt, m, fx, fy);
    const FourByFour low(fx[0], fy[0], fx[1], fy[1]), high(fx[2], fy[2], fx[3], fy[3]);
    for (std::size_t i = 0; i < 4 && first + i < count; ++i) {
      quads.skewed[first + i] = skewed[static_cast<int>(i)] != 0;
      if (quads.skewed[first + i]) continue;
      double* const to = added[static_cast<std::size_t>(quads.first_node[first + i])].data();
      add_row(to, low.v[i]), add_row(to + 4, high.v[i]);
    }
  }
}

}  // namespace trilith
