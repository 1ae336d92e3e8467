#include "assembly/element/consistent_mass.hpp"

#include <cmath>

#include "assembly/element/beam_motion.hpp"
#include "assembly/element/rotary_inertia.hpp"
#include "assembly/water/water_mass.hpp"

namespace trilith {
namespace {

/// Matrix from nodal motion to the motion of the beam's ends, each at `arm` from its node.
BeamMatrix carried_by(const std::array<Vec2, 2>& arm) {
  BeamMatrix g = BeamMatrix::Identity();
  for (const int end : {0, 1}) g(3 * end, 3 * end + 2) = -arm[end].y(), g(3 * end + 1, 3 * end + 2) = arm[end].x();
  return g;
}

/// Position of the beam: its chord and arms.
struct Lie {
  std::array<Vec2, 2> arm;
  Vec2 along;
  double length;

  Lie(const State<2>& state, const Beam& beam) {
    const Vec2 from = end_of(state, beam, 0, arm[0]).place, to = end_of(state, beam, 1, arm[1]).place;
    length = (to - from).norm();
    along = (to - from) / length;
  }
};

/// Translations and rotations of the two nodes as a vector of six.
BeamVector of_nodes(const Beam& beam, const std::vector<Vec2>& along, const std::vector<double>& about) {
  BeamVector out;
  for (const int end : {0, 1}) {
    const int n = beam.node[end];
    out.segment<2>(3 * end) = along[n], out[3 * end + 2] = about[n];
  }
  return out;
}

/// Lumped masses and inertias of the beam at its nodes, which are subtracted from the added mass.
BeamVector lumped_of(const BeamInertia& inertia) {
  BeamVector out;
  out << inertia.lumped, inertia.lumped, inertia.turning[0], inertia.lumped, inertia.lumped, inertia.turning[1];
  return out;
}

/// Translations and rotations of the two nodes in space as a vector of twelve.
BeamVector3 of_nodes(const Beam3& beam, const std::vector<Vec3>& along, const std::vector<Vec3>& about) {
  BeamVector3 out;
  for (const int end : {0, 1}) {
    const auto n = static_cast<std::size_t>(beam.node[static_cast<std::size_t>(end)]);
    out.segment<3>(6 * end) = along[n], out.segment<3>(6 * end + 3) = about[n];
  }
  return out;
}

/// Position of a beam in space: its chord, and the offsets of its ends from the nodes.
struct Lie3 {
  Vec3 along;
  double length;
  bool on_arms;
  std::array<Vec3, 2> arm;
  BeamMatrix3 carried;  ///< motion of the ends from the motion of the nodes: an end moves with v + w x arm

  Lie3(const State<3>& state, const Beam3& beam) : on_arms(has_arm(beam, 0) || has_arm(beam, 1)) {
    const Vec3 chord = end_of(state, beam, 1).place - end_of(state, beam, 0).place;
    length = chord.norm(), along = chord / length;
    if (!on_arms) return;
    carried.setIdentity();
    for (const int end : {0, 1}) {
      arm[static_cast<std::size_t>(end)] = arm_of(state, beam, static_cast<std::size_t>(end));
      for (int k = 0; k < 3; ++k)
        carried.block<3, 1>(6 * end, 6 * end + 3 + k) = cross(Vec3::Unit(k), arm[static_cast<std::size_t>(end)]);
    }
  }
  /// Rotary inertia of a node due to the lumped half of the beam's mass at its arm.
  [[nodiscard]] Eigen::Matrix3d lumped_turning(double mass, int end) const {
    return inertia_at(0.5 * mass, arm[static_cast<std::size_t>(end)]);
  }
};

/// Inertia forces of a beam on arms. An arm that rotates with its node adds w x (w x arm). The term of the lumped mass
/// in the node's tensor, I a + w x I w, is subtracted.
BeamVector3 forces_on_arms(const BeamInertia3& inertia, const Lie3& lie, const BeamVector3& v, const BeamVector3& a) {
  BeamMotion3 motion{lie.along, lie.length, lie.carried * v, lie.carried * a};
  for (const int end : {0, 1}) {
    const Vec3 spin = v.segment<3>(6 * end + 3);
    motion.rise.segment<3>(6 * end) += cross(spin, cross(spin, lie.arm[static_cast<std::size_t>(end)]));
  }
  BeamVector3 force = lie.carried.transpose() * inertia_forces(inertia, motion);
  for (const int end : {0, 1}) {
    const Eigen::Matrix3d turning = lie.lumped_turning(inertia.mass, end);
    const Vec3 spin = v.segment<3>(6 * end + 3), rise = a.segment<3>(6 * end + 3);
    force.segment<3>(6 * end + 3) -= turning * rise + cross(spin, Vec3(turning * spin));
  }
  return force;
}

/// Momentum of a node's own mass for the motion v; in space rotations are multiplied by its present tensor.
Dofs<2> own_momentum(const Model<2>& model, const State<2>& state, int n, const Dofs<2>& v) {
  const Dofs<2> mass = mass_of(model, state, n);
  return {mass[0] * v[0], mass[1] * v[1], mass[2] * v[2]};
}
Dofs<3> own_momentum(const Model<3>& model, const State<3>& state, int n, const Dofs<3>& v) {
  const auto i = static_cast<std::size_t>(n);
  const double m = model.mass[i];
  return dofs_of(Vec3(m * v[0], m * v[1], m * v[2]),
                 momentum_of(model.inertia[i], state.rotation[i], Vec3(v[3], v[4], v[5])));
}

/// Adds the mass matrix of the water (assembly/water/water_mass.hpp) times one vector of numbers by node.
template <int D, class Of>
void add_water_momentum(const Model<D>& model, const State<D>& state, Of&& of, std::vector<Dofs<D>>& out) {
  for_water_masses(model, state, [&](const DirectedMass<D>& row) {
    const double force = row.mass * row.times(of);
    for (int i = 0; i < row.count; ++i) {
      const auto j = static_cast<std::size_t>(i);
      for (std::size_t k = 0; k < row.along[j].size(); ++k)
        out[static_cast<std::size_t>(row.node[j])][k] += force * row.along[j][k];
    }
  });
}

/// Acceleration of a node in implicit steps.
template <int D>
Dofs<D> rise_of(const State<D>& state, int n) {
  return dofs_of(state.acceleration[n], state.spin_rate[n]);
}

template <int D>
double dot_free(const Model<D>& model, const std::vector<Dofs<D>>& a, const std::vector<Dofs<D>>& b) {
  double sum = 0;
  for (std::size_t n = 0; n < a.size(); ++n)
    for (int k = 0; k < Space<D>::dofs; ++k)
      if (model.support[n][k] == Support::free) sum += a[n][k] * b[n][k];
  return sum;
}

/// Mass matrix M of all beams in their present position, for matrix-vector products.
template <int D>
class MassMatrix {
 public:
  static constexpr int dofs = Space<D>::dofs;
  using Added = std::conditional_t<D == 2, BeamMatrix, BeamMatrix3>;

  MassMatrix(const Model<D>& model, const State<D>& state) : model_(model), state_(state) {
    for (const auto& beam : beams_of(model))
      if (beam.inertia >= 0) added_.push_back({beam.node, added_mass(model, state, beam)});
  }
  [[nodiscard]] std::vector<Dofs<D>> times(const std::vector<Dofs<D>>& v) const {
    std::vector<Dofs<D>> out(v.size());
    for (std::size_t n = 0; n < v.size(); ++n) out[n] = own_momentum(model_, state_, static_cast<int>(n), v[n]);
    for (const auto& [node, m] : added_)
      for (int row = 0; row < 2 * dofs; ++row)
        for (int column = 0; column < 2 * dofs; ++column)
          out[node[row / dofs]][row % dofs] += m(row, column) * v[node[column / dofs]][column % dofs];
    add_rotary_momentum(model_, state_, v, out);
    add_water_momentum(
        model_, state_, [&](int n) { return v[static_cast<std::size_t>(n)]; }, out);
    return out;
  }
  /// Diagonal of M.
  [[nodiscard]] std::vector<Dofs<D>> diagonal() const {
    std::vector<Dofs<D>> out(model_.mass.size());
    for (int n = 0; n < model_.nodes(); ++n)
      for (int k = 0; k < dofs; ++k) {
        Dofs<D> one{};
        one[k] = 1;
        out[n][k] = own_momentum(model_, state_, n, one)[k];
      }
    for (const auto& [node, m] : added_)
      for (int i = 0; i < 2 * dofs; ++i) out[node[i / dofs]][i % dofs] += m(i, i);
    add_rotary_diagonal(model_, state_, out);
    each_water_entry(model_, state_, [&](int i, int k, int j, int l, double m) {
      if (i == j && k == l) out[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] += m;
    });
    return out;
  }

 private:
  const Model<D>& model_;
  const State<D>& state_;
  std::vector<std::pair<std::array<int, 2>, Added>> added_;
};

}  // namespace

/// G' R' M R G - diag(lumped): M in the axes of the chord, rotated to the world, transferred to the nodes by their
/// arms.
BeamMatrix added_mass(const Model<2>& model, const State<2>& state, const Beam& beam) {
  const BeamInertia& inertia = model.beam_inertias[beam.inertia];
  const Lie lie(state, beam);
  const BeamMatrix g = carried_by(lie.arm);
  BeamMatrix out = g.transpose() * turned(inertia.consistent, lie.along) * g;
  out.diagonal() -= lumped_of(inertia);
  return out;
}

/// Forces of the added mass on the nodes, from its acceleration and from its change as the chord rotates: the Lagrange
/// equation of its kinetic energy, d/dt (dT/dv) - dT/dx. An arm that rotates with its node adds -w^2 arm.
void added_inertia(const Model<2>& model, const State<2>& state, bool rising, std::vector<Dofs<2>>& out) {
  out.clear();
  if (!has_added_mass(model)) return;
  out.resize(static_cast<std::size_t>(model.nodes()));
  add_rotary_forces(model, state, rising, out);
  if (rising)
    add_water_momentum(
        model, state, [&](int n) { return rise_of(state, n); }, out);
  for (const Beam& beam : model.beams) {
    if (beam.inertia < 0) continue;
    const BeamInertia& inertia = model.beam_inertias[beam.inertia];
    const Lie lie(state, beam);
    const BeamMatrix g = carried_by(lie.arm);
    const BeamVector v = of_nodes(beam, state.velocity, state.spin);
    const BeamVector a = rising ? of_nodes(beam, state.acceleration, state.spin_rate) : BeamVector(BeamVector::Zero());
    BeamMotion motion{lie.along, lie.length, g * v, g * a};
    for (const int end : {0, 1}) motion.rise.segment<2>(3 * end) -= v[3 * end + 2] * v[3 * end + 2] * lie.arm[end];
    const BeamVector force =
        g.transpose() * inertia_forces(inertia.consistent, motion) - lumped_of(inertia).cwiseProduct(a);
    for (int i = 0; i < 6; ++i) out[beam.node[i / 3]][i % 3] += force[i];
  }
}

/// M transferred to the nodes by arms, minus the lumped half of the beam's mass at either node. The rotary inertia of
/// its sections is already part of the nodes.
BeamMatrix3 added_mass(const Model<3>& model, const State<3>& state, const Beam3& beam) {
  const BeamInertia3& inertia = model.beam_inertias_3d[static_cast<std::size_t>(beam.inertia)];
  const Lie3 lie(state, beam);
  BeamMatrix3 out = mass_in_space(inertia, lie.along);
  if (lie.on_arms) out = (lie.carried.transpose() * out * lie.carried).eval();
  for (const int i : {0, 1, 2, 6, 7, 8}) out(i, i) -= 0.5 * inertia.mass;
  for (const int end : {0, 1})
    if (lie.on_arms) out.block<3, 3>(6 * end + 3, 6 * end + 3) -= lie.lumped_turning(inertia.mass, end);
  return out;
}

void added_inertia(const Model<3>& model, const State<3>& state, bool rising, std::vector<Dofs<3>>& out) {
  out.clear();
  if (!has_added_mass(model)) return;
  out.resize(static_cast<std::size_t>(model.nodes()));
  add_rotary_forces(model, state, rising, out);
  if (rising)
    add_water_momentum(
        model, state, [&](int n) { return rise_of(state, n); }, out);
  for (const Beam3& beam : model.beams_3d) {
    if (beam.inertia < 0) continue;
    const BeamInertia3& inertia = model.beam_inertias_3d[static_cast<std::size_t>(beam.inertia)];
    const Lie3 lie(state, beam);
    const BeamVector3 v = of_nodes(beam, state.velocity, state.spin);
    const BeamVector3 a =
        rising ? of_nodes(beam, state.acceleration, state.spin_rate) : BeamVector3(BeamVector3::Zero());
    BeamVector3 force =
        lie.on_arms ? forces_on_arms(inertia, lie, v, a) : inertia_forces(inertia, {lie.along, lie.length, v, a});
    for (const int i : {0, 1, 2, 6, 7, 8}) force[i] -= 0.5 * inertia.mass * a[i];
    for (int i = 0; i < 12; ++i) out[static_cast<std::size_t>(beam.node[i / 6])][i % 6] += force[i];
  }
}

template <int D>
bool has_added_mass(const Model<D>& model) {
  return model.has_consistent_mass() || has_one_element_bodies(model) || has_water_mass(model);
}
template bool has_added_mass(const Model<2>&);
template bool has_added_mass(const Model<3>&);

template <int D>
void added_damping(const Model<D>& model, const State<D>& state, std::vector<Dofs<D>>& out) {
  constexpr int dofs = Space<D>::dofs;
  out.clear();
  if (!has_added_mass(model) || !(model.mass_damping > 0)) return;
  out.resize(static_cast<std::size_t>(model.nodes()));
  each_rotary_entry(model, state, [&](int i, int k, int j, int l, double m) {
    if (model.support[i][k] == Support::free) out[i][k] -= model.mass_damping * m * state.velocity[j][l];
  });
  for (const auto& beam : beams_of(model)) {
    if (beam.inertia < 0) continue;
    const auto momentum = (added_mass(model, state, beam) * of_nodes(beam, state.velocity, state.spin)).eval();
    for (int i = 0; i < 2 * dofs; ++i)
      if (const int n = beam.node[i / dofs]; model.support[n][i % dofs] == Support::free)
        out[n][i % dofs] -= model.mass_damping * momentum[i];
  }
}

template void added_damping(const Model<2>&, const State<2>&, std::vector<Dofs<2>>&);
template void added_damping(const Model<3>&, const State<3>&, std::vector<Dofs<3>>&);

template <int D>
std::vector<NodeForces<D>> implicit_forces(const Model<D>& model, const State<D>& state, const Work<D>& work) {
  const Outside outside(model, state, work);
  std::vector<NodeForces<D>> out;
  out.reserve(static_cast<std::size_t>(model.nodes()));
  for (int n = 0; n < model.nodes(); ++n)
    out.push_back(node_forces(model, state, work, n, velocity_of(state, n), outside, {}));
  std::vector<Dofs<D>> added;
  added_damping(model, state, added);
  for (std::size_t n = 0; n < added.size(); ++n)
    for (int k = 0; k < Space<D>::dofs; ++k) out[n].force[k] += added[n][k], out[n].mass[k] += added[n][k];
  return out;
}

template std::vector<NodeForces<2>> implicit_forces(const Model<2>&, const State<2>&, const Work<2>&);
template std::vector<NodeForces<3>> implicit_forces(const Model<3>&, const State<3>&, const Work<3>&);

/// v' (M - lumped) v / 2, in addition to the sum of m v^2 / 2 over the nodes.
template <int D>
double added_kinetic(const Model<D>& model, const State<D>& state) {
  double sum = rotary_energy(model, state) + water_energy(model, state);
  for (const auto& beam : beams_of(model)) {
    if (beam.inertia < 0) continue;
    const auto v = of_nodes(beam, state.velocity, state.spin);
    sum += 0.5 * v.dot(added_mass(model, state, beam) * v);
  }
  return sum;
}

template double added_kinetic(const Model<2>&, const State<2>&);
template double added_kinetic(const Model<3>&, const State<3>&);

template <int D>
double work_on_support(const Model<D>& model, int node, const std::type_identity_t<Dofs<D>>& force,
                       const std::type_identity_t<Dofs<D>>& path) {
  double sum = 0;
  for (int k = 0; k < Space<D>::dofs; ++k)
    if (model.support[node][k] != Support::free) sum += force[k] * path[k];
  return sum;
}

template double work_on_support(const Model<2>&, int, const Dofs<2>&, const Dofs<2>&);
template double work_on_support(const Model<3>&, int, const Dofs<3>&, const Dofs<3>&);

/// Scaled by its diagonal, M is so well conditioned that about 20 products reach full precision.
template <int D>
std::vector<Dofs<D>> accelerations(const Model<D>& model, const State<D>& state, const std::vector<Dofs<D>>& force) {
  const MassMatrix<D> mass(model, state);
  const std::vector<Dofs<D>> diagonal = mass.diagonal();
  std::vector<Dofs<D>> a(force.size()), left = force, scaled(force.size()), way;
  const auto each_free = [&](auto&& f) {
    for (std::size_t n = 0; n < force.size(); ++n)
      for (int k = 0; k < Space<D>::dofs; ++k)
        if (model.support[n][k] == Support::free) f(n, k);
  };
  each_free([&](std::size_t n, int k) { scaled[n][k] = left[n][k] / diagonal[n][k]; });
  way = scaled;
  double merit = dot_free(model, left, scaled);
  const double enough = 1e-28 * merit;
  for (int turn = 0; turn < 500 && merit > enough; ++turn) {
    const std::vector<Dofs<D>> moved = mass.times(way);
    const double step = merit / dot_free(model, way, moved);
    each_free([&](std::size_t n, int k) {
      a[n][k] += step * way[n][k], left[n][k] -= step * moved[n][k];
      scaled[n][k] = left[n][k] / diagonal[n][k];
    });
    const double next = dot_free(model, left, scaled), share = next / merit;
    each_free([&](std::size_t n, int k) { way[n][k] = scaled[n][k] + share * way[n][k]; });
    merit = next;
  }
  return a;
}

template std::vector<Dofs<2>> accelerations(const Model<2>&, const State<2>&, const std::vector<Dofs<2>>&);
template std::vector<Dofs<3>> accelerations(const Model<3>&, const State<3>&, const std::vector<Dofs<3>>&);

}  // namespace trilith
