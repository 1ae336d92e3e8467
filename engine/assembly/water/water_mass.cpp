#include "assembly/water/water_mass.hpp"

#include <Eigen/SparseCholesky>

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

/// Calls add(k, l, value) for the entries of the mass matrix of a node. A direction without an entry does not move
/// freely.
template <class Add>
void each_mass_entry(const Model<2>& model, const State<2>& /*state*/, int n, Add&& add) {
  const auto i = static_cast<std::size_t>(n);
  for (std::size_t k = 0; k < 2; ++k)
    if (model.support[i][k] == Support::free) add(k, k, model.mass[i]);
  if (model.support[i][2] == Support::free && model.inertia[i] > 0) add(2, 2, model.inertia[i]);
}
template <class Add>
void each_mass_entry(const Model<3>& model, const State<3>& state, int n, Add&& add) {
  const auto i = static_cast<std::size_t>(n);
  const auto& support = model.support[i];
  for (std::size_t k = 0; k < 3; ++k)
    if (support[k] == Support::free) add(k, k, model.mass[i]);
  if (!(model.inertia[i].minCoeff() > 0)) return;
  if (support[3] == Support::free && support[4] == Support::free && support[5] == Support::free) {
    for (std::size_t l = 0; l < 3; ++l) {
      const Vec3 column = momentum_of(model.inertia[i], state.rotation[i], Vec3::Unit(static_cast<Eigen::Index>(l)));
      for (std::size_t k = 0; k < 3; ++k) add(3 + k, 3 + l, column[static_cast<Eigen::Index>(k)]);
    }
    return;
  }
  const Dofs<3> mass = mass_of(model, state, n);
  for (std::size_t k = 3; k < 6; ++k)
    if (support[k] == Support::free) add(k, k, mass[k]);
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

/// (M + W) a = F for the free directions of the nodes at which water acts, with W from all points.
template <int D>
class MovingWater {
 public:
  MovingWater(const Model<D>& model, const State<D>& state)
      : model_(model), state_(state), first_(model.mass.size(), -1) {
    for_water_masses(model, state, [&](const DirectedMass<D>& row) { add_row(row); });
  }
  /// Forces of the points along their directions. `force` gives all other forces on a node.
  template <class Force>
  [[nodiscard]] std::vector<double> forces(Force&& force) {
    Eigen::VectorXd right = Eigen::VectorXd::Zero(size_);
    for (const int n : nodes_) place(n, force(n), right);
    const Eigen::VectorXd rise = solved(right);
    std::vector<double> out;
    for (const DirectedMass<D>& row : rows_)
      out.push_back(-row.mass * (row.times([&](int n) { return free_part(n, rise); }) + driven(row)));
    return out;
  }

 private:
  static constexpr int dofs = static_cast<int>(std::tuple_size_v<Dofs<D>>);

  void add_row(const DirectedMass<D>& row) {
    rows_.push_back(row);
    for (int i = 0; i < row.count; ++i) {
      const int n = row.node[static_cast<std::size_t>(i)];
      if (first_[static_cast<std::size_t>(n)] >= 0) continue;
      first_[static_cast<std::size_t>(n)] = size_, size_ += dofs;
      nodes_.push_back(n);
    }
  }
  [[nodiscard]] int position(int n, std::size_t k) const {
    return first_[static_cast<std::size_t>(n)] + static_cast<int>(k);
  }
  [[nodiscard]] bool moves(int n, std::size_t k) const { return moves_[static_cast<std::size_t>(position(n, k))]; }
  [[nodiscard]] double driven(const DirectedMass<D>& row) const {
    return row.times([&](int n) { return driven_rise(model_, state_, n); });
  }
  [[nodiscard]] Dofs<D> free_part(int n, const Eigen::VectorXd& of) const {
    Dofs<D> out;
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = of[position(n, k)];
    return out;
  }
  void place(int n, const Dofs<D>& f, Eigen::VectorXd& right) const {
    for (std::size_t k = 0; k < f.size(); ++k) right[position(n, k)] = f[k];
  }
  void add_masses() {
    moves_.assign(static_cast<std::size_t>(size_), false);
    for (const int n : nodes_)
      each_mass_entry(model_, state_, n, [&](std::size_t k, std::size_t l, double value) {
        entries_.emplace_back(position(n, k), position(n, l), value);
        moves_[static_cast<std::size_t>(position(n, k))] = true;
      });
    for (int i = 0; i < size_; ++i)  // held and driven directions keep an acceleration of zero in this system
      if (!moves_[static_cast<std::size_t>(i)]) entries_.emplace_back(i, i, 1);
  }
  /// Adds m c c' and, on the right, the inertia of the driven directions.
  void add_water(const DirectedMass<D>& row, Eigen::VectorXd& right) {
    const double given = driven(row);
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i)
      for (std::size_t k = 0; k < row.along[i].size(); ++k) {
        const double c = row.mass * row.along[i][k];
        if (c == 0 || !moves(row.node[i], k)) continue;
        right[position(row.node[i], k)] -= c * given;
        for (std::size_t j = 0; j < static_cast<std::size_t>(row.count); ++j)
          for (std::size_t l = 0; l < row.along[j].size(); ++l)
            if (row.along[j][l] != 0 && moves(row.node[j], l))
              entries_.emplace_back(position(row.node[i], k), position(row.node[j], l), c * row.along[j][l]);
      }
  }
  Eigen::VectorXd solved(Eigen::VectorXd& right) {
    add_masses();
    for (int i = 0; i < size_; ++i)
      if (!moves_[static_cast<std::size_t>(i)]) right[i] = 0;
    for (const DirectedMass<D>& row : rows_) add_water(row, right);
    Eigen::SparseMatrix<double> system(size_, size_);
    system.setFromTriplets(entries_.begin(), entries_.end());
    return Eigen::SimplicialLLT<Eigen::SparseMatrix<double>>(system).solve(right);
  }

  const Model<D>& model_;
  const State<D>& state_;
  std::vector<DirectedMass<D>> rows_;
  std::vector<int> nodes_, first_;  // touched nodes; [node] position of their unknowns, -1 without
  std::vector<bool> moves_;         // [unknown]
  std::vector<Eigen::Triplet<double>> entries_;
  int size_ = 0;
};

}  // namespace

/// Dampings of the nodes belong to the other forces.
template <int D>
void add_water_inertia(const Model<D>& model, const State<D>& state, Work<D>& work, const StepOptions& options) {
  work.added_system.clear();
  if (state.implicit() || !has_water_mass(model)) return;
  const NodeMotions<D> nodes(model, state, work, options);
  work.added_system = MovingWater<D>(model, state).forces([&](int n) { return nodes.forces(n).force; });
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
