// Deformable bodies for the physics tests.
#pragma once

#include <Eigen/Dense>

#include <string>
#include <vector>

#include "assembly/element/element_stress.hpp"
#include "assembly/evaluate.hpp"
#include "integrate/explicit/stable_step.hpp"
#include "model/pose.hpp"
#include "physics/scene.hpp"

namespace trilith::testing {

inline Material elastic(const std::string& name, double density, double young, double poisson,
                        Plane plane = Plane::stress, ElementForm form = ElementForm::assumed, double damping = 0) {
  return {name, density, Solid{LinearElastic{young, poisson, damping}, plane, form}};
}

/// A body of `material` with four corners, nx by ny elements.
inline BodySpec grid_body(const std::string& name, const Polygon& corners, const std::string& material, int nx,
                          int ny) {
  BodySpec spec;
  spec.name = name, spec.outline = corners, spec.material = material;
  spec.kind = nx * ny == 1 ? BodyKind::quad : BodyKind::mesh;
  spec.divisions = {nx, ny};
  spec.floating = true;
  return spec;
}

/// A model of one body without weight or contact.
inline Model<2> alone(const Material& material, BodySpec spec) {
  ModelBuilder builder;
  builder.gravity = Vec2::Zero();
  builder.add_material(material);
  spec.material = material.name;
  builder.add_body(std::move(spec));
  return builder.build();
}

/// Node of the model at the start position `at`.
inline int node_at(const Model<2>& model, const Vec2& at) {
  int best = 0;
  for (int n = 0; n < model.nodes(); ++n)
    if ((model.start_position[n] - at).norm() < (model.start_position[best] - at).norm()) best = n;
  REQUIRE((model.start_position[best] - at).norm() < 1e-9);
  return best;
}

/// Small displacements under constant nodal forces [N], with fixed supports: K u = f with K from the elements' forces,
/// one column for each unit displacement.
inline std::vector<Vec2> solve_small(const Model<2>& model, const std::vector<Vec2>& load) {
  const double size = 1e-7 * model.body_radius[0];
  State<2> state = initial_state(model);
  Work<2> work;
  std::vector<std::pair<int, int>> free;
  for (int n = 0; n < model.nodes(); ++n)
    for (const int k : {0, 1})
      if (model.support[n][k] == Support::free) free.emplace_back(n, k);
  const auto count = static_cast<Eigen::Index>(free.size());
  Eigen::MatrixXd stiffness(count, count);
  Eigen::VectorXd force(count);
  for (Eigen::Index j = 0; j < count; ++j) {
    const auto [n, k] = free[j];
    std::array<std::vector<Vec2>, 2> at;
    for (const int side : {0, 1}) {
      state.position[n][k] = model.start_position[n][k] + (side == 0 ? size : -size);
      internal_forces(model, state, work);
      at[side] = work.element_force;
    }
    state.position[n][k] = model.start_position[n][k];
    for (Eigen::Index i = 0; i < count; ++i)
      stiffness(i, j) = -(at[0][free[i].first][free[i].second] - at[1][free[i].first][free[i].second]) / (2 * size);
    force[j] = load[n][k];
  }
  const Eigen::VectorXd u = stiffness.ldlt().solve(force);
  std::vector<Vec2> out(static_cast<std::size_t>(model.nodes()), Vec2::Zero());
  for (Eigen::Index i = 0; i < count; ++i) out[free[i].first][free[i].second] = u[i];
  return out;
}

}  // namespace trilith::testing
