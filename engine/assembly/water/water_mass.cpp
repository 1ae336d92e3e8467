#include "assembly/water/water_mass.hpp"

#include <Eigen/Cholesky>

#include <algorithm>

#include "assembly/bearing_motion.hpp"
#include "assembly/node_motions.hpp"
#include "element/rigid/rigid_turn.hpp"
#include "model/pose.hpp"

namespace trilith {

/// Arms turn with the nodes; without arms only the positions count.
DirectedMass<2> directed_mass(const Model<2>& model, const State<2>& state, const MassPoint<2>& point) {
  const Attachment<2>& at = point.at;
  const Vec2 along = Turn(pose_at(model, state, at).rotation).apply(point.along);
  DirectedMass<2> row;
  row.mass = point.mass;
  for (int i = 0; i < at.nodes; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double w = at.weight[k];
    row.add(at.node[k], dofs_of(Vec2(w * along), 0));
    if (!at.turns || at.arm[k].isZero(0)) continue;
    const Vec2 arm = Turn(state.rotation[at.turn[k]]).apply(at.arm[k]);
    row.add(at.turn[k], dofs_of(Vec2(Vec2::Zero()), w * cross(arm, along)));
  }
  return row;
}

/// A point of a rigid body or a frame turns with its node; a node of elements has no rotation.
DirectedMass<3> directed_mass(const Model<3>& /*model*/, const State<3>& state, const MassPoint<3>& point) {
  const int n = point.at.node[0];
  const Turn3 turn = turn_of(state.rotation[n]);
  const Vec3 along = turn.apply(point.along), arm = turn.apply(point.at.arm[0]);
  DirectedMass<3> row;
  row.mass = point.mass;
  row.add(n, dofs_of(along, Vec3(cross(arm, along))));
  return row;
}

namespace {

/// M^-1 f of a node along its free directions.
Dofs<2> divided_by_mass(const Model<2>& model, const State<2>& /*state*/, int n, const Dofs<2>& f) {
  const auto i = static_cast<std::size_t>(n);
  Dofs<2> out{};
  for (std::size_t k = 0; k < 2; ++k)
    if (model.support[i][k] == Support::free) out[k] = f[k] / model.mass[i];
  if (model.support[i][2] == Support::free && model.inertia[i] > 0) out[2] = f[2] / model.inertia[i];
  return out;
}
Dofs<3> divided_by_mass(const Model<3>& model, const State<3>& state, int n, const Dofs<3>& f) {
  const auto i = static_cast<std::size_t>(n);
  const auto& support = model.support[i];
  Dofs<3> out{};
  for (std::size_t k = 0; k < 3; ++k)
    if (support[k] == Support::free) out[k] = f[k] / model.mass[i];
  if (!(model.inertia[i].minCoeff() > 0)) return out;
  if (support[3] == Support::free && support[4] == Support::free && support[5] == Support::free) {
    const Turn3 turn(state.rotation[i]);
    const Vec3 rise = turn.apply(Vec3(turn.undo(about_of(f)).cwiseQuotient(model.inertia[i])));
    for (std::size_t k = 0; k < 3; ++k) out[3 + k] = rise[static_cast<Eigen::Index>(k)];
    return out;
  }
  const Dofs<3> mass = mass_of(model, state, n);
  for (std::size_t k = 3; k < 6; ++k)
    if (support[k] == Support::free) out[k] = f[k] / mass[k];
  return out;
}

/// Accelerations of the driven directions of a node.
template <int D>
Dofs<D> driven_rise(const Model<D>& model, const State<D>& state, int n) {
  Dofs<D> out{};
  for (std::size_t k = 0; k < out.size(); ++k) {
    if (model.support[n][k] != Support::driven) continue;
    const Drive& drive = model.drives[model.drive_of[n][k]];
    out[k] = drive.motion->at(state.time - drive.start).acceleration;
  }
  return out;
}

template <std::size_t dofs>
std::array<double, dofs> sum_of(const std::array<double, dofs>& a, const std::array<double, dofs>& b) {
  std::array<double, dofs> out;
  for (std::size_t k = 0; k < dofs; ++k) out[k] = a[k] + b[k];
  return out;
}

/// Entry of C M^-1 C' for two rows.
template <int D>
double coupling_of(const Model<D>& model, const State<D>& state, const DirectedMass<D>& a, const DirectedMass<D>& b) {
  double sum = 0;
  for (int i = 0; i < a.count; ++i)
    for (int j = 0; j < b.count; ++j) {
      const auto k = static_cast<std::size_t>(i), l = static_cast<std::size_t>(j);
      if (a.node[k] == b.node[l]) sum += dot(a.along[k], divided_by_mass(model, state, a.node[k], b.along[l]));
    }
  return sum;
}

}  // namespace

/// Dampings of the nodes belong to the other forces.
template <int D>
void add_water_inertia(const Model<D>& model, const State<D>& state, Work<D>& work, const StepOptions& options) {
  work.added_system.clear();
  if (state.implicit() || !has_water_mass(model)) return;
  std::vector<DirectedMass<D>> rows;
  for_water_masses(model, state, [&](const DirectedMass<D>& row) { rows.push_back(row); });
  const auto size = static_cast<Eigen::Index>(rows.size());
  const NodeMotions<D> nodes(model, state, work, options);
  Eigen::MatrixXd system(size, size);
  Eigen::VectorXd right(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const DirectedMass<D>& row = rows[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j <= i; ++j)
      system(i, j) = system(j, i) = coupling_of(model, state, row, rows[static_cast<std::size_t>(j)]);
    system(i, i) += 1 / row.mass;
    right[i] = -row.times([&](int n) {
      return sum_of(divided_by_mass(model, state, n, nodes.forces(n).force), driven_rise(model, state, n));
    });
  }
  const Eigen::VectorXd y = system.llt().solve(right);
  work.added_system.assign(y.data(), y.data() + y.size());
  const std::vector<Dofs<D>> added = water_inertia(model, state, work);
  for (std::size_t n = 0; n < added.size(); ++n)
    work.force[n] += along_of(added[n]), work.moment[n] += about_of(added[n]);
}

template <int D>
std::vector<Dofs<D>> water_inertia(const Model<D>& model, const State<D>& state, const Work<D>& work) {
  std::vector<Dofs<D>> out;
  if (work.added_system.empty()) return out;
  out.resize(model.mass.size());
  std::size_t i = 0;
  for_water_masses(model, state, [&](const DirectedMass<D>& row) {
    const double y = work.added_system[i++];
    for (int j = 0; j < row.count; ++j) {
      const auto l = static_cast<std::size_t>(j);
      for (std::size_t k = 0; k < row.along[l].size(); ++k)
        out[static_cast<std::size_t>(row.node[l])][k] += y * row.along[l][k];
    }
  });
  return out;
}

template <int D>
double water_energy(const Model<D>& model, const State<D>& state) {
  double sum = 0;
  for_water_masses(model, state, [&](const DirectedMass<D>& row) {
    const double v = row.times([&](int n) { return velocity_of(state, n); });
    sum += 0.5 * row.mass * v * v;
  });
  return sum;
}

template <int D>
double water_kinetic(const Model<D>& model, const State<D>& state, const Work<D>& work, const StepOptions& options) {
  if (!has_water_mass(model)) return 0;
  if (!(state.last_dt > 0)) return water_energy(model, state);
  const NodeMotions<D> nodes(model, state, work, options);
  double sum = 0;
  for_water_masses(model, state, [&](const DirectedMass<D>& row) {
    const double before = row.times([&](int n) { return velocity_of(state, n); });
    sum += 0.5 * row.mass * before * row.times([&](int n) { return nodes.ahead(n); });
  });
  return sum;
}

#define TRILITH_WATER_MASS(D)                                                                      \
  template void add_water_inertia(const Model<D>&, const State<D>&, Work<D>&, const StepOptions&); \
  template std::vector<Dofs<D>> water_inertia(const Model<D>&, const State<D>&, const Work<D>&);   \
  template double water_energy(const Model<D>&, const State<D>&);                                  \
  template double water_kinetic(const Model<D>&, const State<D>&, const Work<D>&, const StepOptions&);
TRILITH_WATER_MASS(2)
TRILITH_WATER_MASS(3)
#undef TRILITH_WATER_MASS

}  // namespace trilith
