#include "readings/reactions.hpp"

#include <algorithm>

namespace trilith {
namespace {

/// Acceleration by a drive of one direction of a node at present [m/s2], [rad/s2]; 0 without a drive.
template <int D>
double driven_acceleration(const Model<D>& model, const State<D>& state, int node, int dof) {
  const int row = model.drive_of[node][static_cast<std::size_t>(dof)];
  if (row < 0) return 0;
  const Drive& drive = model.drives[static_cast<std::size_t>(row)];
  return drive.motion->at(state.time - drive.start).acceleration;
}

double& part_of(double& moment, int /*axis*/) {
  return moment;
}
double& part_of(Vec3& moment, int axis) {
  return moment[axis];
}

/// Rotary inertia about a world axis, for small rotations of the principal axes.
double turning_inertia(const Model<2>& model, const State<2>& /*state*/, int node, int /*axis*/) {
  return model.inertia[node];
}
double turning_inertia(const Model<3>& model, const State<3>& state, int node, int axis) {
  const Vec3 own = turn_of(state.rotation[node]).undo(Vec3(Vec3::Unit(axis)));
  return own.cwiseAbs2().dot(model.inertia[node]);
}

template <int D>
Reaction<D> reaction_of(const Model<D>& model, const State<D>& state, const Work<D>& work, int node, int directions) {
  Reaction<D> out;
  out.node = node, out.place = state.position[node];
  const auto& support = model.support[node];
  for (int k = 0; k < D; ++k) {
    if (support[static_cast<std::size_t>(k)] == Support::free) continue;
    const double inertia = work.added_inertia.empty() ? 0 : work.added_inertia[node][k];
    out.force[k] = model.mass[node] * driven_acceleration(model, state, node, k) - work.force[node][k] - inertia;
  }
  for (int k = D; k < directions; ++k) {
    if (support[static_cast<std::size_t>(k)] == Support::free) continue;
    Moment<D> acting = work.moment[node];
    part_of(out.moment, k - D) =
        turning_inertia(model, state, node, k - D) * driven_acceleration(model, state, node, k) -
        part_of(acting, k - D);
  }
  return out;
}

}  // namespace

template <int D>
std::vector<Reaction<D>> reactions(const Model<D>& model, const State<D>& state, const Work<D>& work, int body) {
  std::vector<Reaction<D>> out;
  const Body& b = model.bodies[static_cast<std::size_t>(body)];
  // Nodes of elements do not turn.
  const int directions = b.is_rigid() || b.nodes_turn() ? Space<D>::dofs : D;
  for (int n = b.first_node; n < b.first_node + b.nodes; ++n) {
    const auto& support = model.support[n];
    if (std::any_of(support.begin(), support.begin() + directions, [](Support s) { return s != Support::free; }))
      out.push_back(reaction_of(model, state, work, n, directions));
  }
  return out;
}

template std::vector<Reaction<2>> reactions(const Model<2>&, const State<2>&, const Work<2>&, int);
template std::vector<Reaction<3>> reactions(const Model<3>&, const State<3>&, const Work<3>&, int);

}  // namespace trilith
