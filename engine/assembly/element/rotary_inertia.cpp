#include "assembly/element/rotary_inertia.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "assembly/element/quad_rotation.hpp"
#include "assembly/node_motions.hpp"
#include "assembly/whole_body.hpp"
#include "base/team.hpp"

namespace trilith {
namespace {

/// True if all nodes of a body are free along the axes. Branch-free, as it is evaluated for every body in each step.
template <int D>
bool is_unheld(const Model<D>& model, const Body& body) {
  static_assert(Support::free == Support{});
  unsigned held = 0;
  for (int n = body.first_node; n < body.first_node + body.nodes; ++n)
    for (int k = 0; k < D; ++k) held |= static_cast<unsigned>(model.support[n][k]);
  return held == 0;
}

/// T' D v of the nodes of a body.
template <int D, class Velocity>
TurnVector<D> angular_momentum(const Model<D>& model, const State<D>& state, const Body& body, const Vec<D>& centre,
                               Velocity&& velocity) {
  TurnVector<D> sum = TurnVector<D>::Zero();
  for (int n = body.first_node; n < body.first_node + body.nodes; ++n) {
    const auto v = velocity(n);
    for (int k = 0; k < D; ++k) sum += model.mass[n] * v[k] * turn_row(k, Vec<D>(state.position[n] - centre));
  }
  return sum;
}

/// Gyroscopic term of y: with the lumped angular momentum H and s = Jl^-1 H, it is Jl^-1 (J Jl^-1 (s x H) - s x J s).
/// It is zero if J is a multiple of Jl, and so in the plane.
template <int D>
TurnVector<D> gyroscopic_part(const RotaryInertia<D>& of, const TurnVector<D>& momentum) {
  if constexpr (D == 2) {
    return TurnVector<2>::Zero();
  } else {
    if (of.multiple > 0) return Vec3::Zero();
    const Eigen::Matrix3d back = of.lumped.inverse();
    const Vec3 spin = back * momentum;
    return back * (of.own * (back * cross(spin, momentum)) - cross(spin, Vec3(of.own * spin)));
  }
}

/// Computes y, with `free` = Jf and `sum` the moment of forces and of driven masses. Velocities refer to half a step
/// before; the present angular momentum follows from its rate.
template <int D>
TurnVector<D> turning_answer(const Model<D>& model, const State<D>& state, const RotaryInertia<D>& of, const Body& body,
                             const TurnMatrix<D>& free, const TurnVector<D>& sum) {
  const TurnMatrix<D> off = of.taken_off(), left = (TurnMatrix<D>::Identity() - off * free).inverse();
  TurnVector<D> y = left * (off * sum);
  if (D == 2 || of.multiple > 0) return y;
  TurnVector<D> momentum = angular_momentum<D>(model, state, body, of.centre, [&](int n) { return state.velocity[n]; });
  const TurnVector<D> guess = y + left * gyroscopic_part(of, momentum);
  momentum += 0.5 * state.last_dt * (sum + free * guess);
  return y + left * gyroscopic_part(of, momentum);
}

/// Adds y of a free body. force(n): on a node [N].
template <int D, class Force>
void add_to_free(const Model<D>& model, const State<D>& state, const RotaryInertia<D>& of, const Body& body,
                 Force&& force, std::vector<Vec<D>>& added) {
  TurnVector<D> moment = TurnVector<D>::Zero();
  const int end = body.first_node + body.nodes;
  for (int n = body.first_node; n < end; ++n) {
    const Vec<D> f = force(n);
    for (int k = 0; k < D; ++k) moment += f[k] * turn_row(k, Vec<D>(state.position[n] - of.centre));
  }
  if constexpr (D == 2) {
    const double y = (1 / of.own(0, 0) - 1 / of.lumped(0, 0)) * moment[0];
    for (int n = body.first_node; n < end; ++n)
      added[n] += model.mass[n] * cross(y, Vec2(state.position[n] - of.centre));
  } else {
    const Vec3 y = of.multiple > 0 ? Vec3((of.multiple - 1) * (of.lumped.inverse() * moment))
                                   : turning_answer<3>(model, state, of, body, of.lumped, moment);
    for (int n = body.first_node; n < end; ++n)
      added[n] += model.mass[n] * cross(y, Vec3(state.position[n] - of.centre));
  }
}

template <int D>
void add_to_held(const Model<D>& model, const State<D>& state, const RotaryInertia<D>& of, const Body& body,
                 const NodeMotions<D>& motions, std::vector<Vec<D>>& added) {
  TurnMatrix<D> free = TurnMatrix<D>::Zero();
  TurnVector<D> sum = TurnVector<D>::Zero();
  const int end = body.first_node + body.nodes;
  for (int n = body.first_node; n < end; ++n) {
    const NodeForces<D> f = motions.forces(n);
    for (int k = 0; k < D; ++k) {
      const TurnVector<D> row = turn_row(k, Vec<D>(state.position[n] - of.centre));
      if (model.support[n][k] == Support::free)
        free += model.mass[n] * row * row.transpose(), sum += f.force[k] * row;
      else
        sum += model.mass[n] * motions.driven(n, k) * row;
    }
  }
  const TurnVector<D> y = turning_answer(model, state, of, body, free, sum);
  for (int n = body.first_node; n < end; ++n)
    for (int k = 0; k < D; ++k)
      added[n][k] += model.mass[n] * turn_row(k, Vec<D>(state.position[n] - of.centre)).dot(y);
}

}  // namespace

namespace {

/// Arguments of add_rotary_inertia, for one chunk of bodies.
template <int D>
struct RotaryPass {
  const Model<D>& model;
  const State<D>& state;
  const Work<D>& work;
  const StepOptions& options;
  bool all_count;
  std::vector<Vec<D>>& added;

  void add(int b, const NodeMotions<D>& motions) const {
    const Body& body = model.bodies[b];
    if (!model.body_moves(b)) return;
    const RotaryInertia<D> of = rotary_inertia(model, state, b);
    if (!is_unheld(model, body))
      add_to_held(model, state, of, body, motions, added);
    else if (all_count)
      add_to_free(
          model, state, of, body, [&](int n) -> const Vec<D>& { return work.force[n]; }, added);
    else
      add_to_free(
          model, state, of, body, [&](int n) { return along_of(motions.forces(n).force); }, added);
  }
  void add_range(int first, int last, const NodeMotions<D>& motions) const {
    for (int b = first; b < last; ++b)
      if (is_one_element(model, b)) add(b, motions);
  }
};

/// Collects the free quads first, so that SIMD lanes can take four at a time. Their forces include nodal damping and
/// are evaluated once.
void add_range(const RotaryPass<2>& pass, int first, int last, const NodeMotions<2>& motions) {
  FreeQuads quads;
  std::array<int, quads_at_a_time> body;
  std::array<Vec2, 4 * quads_at_a_time> damped;
  for (int b = first; b < last; ++b) {
    const Body& of = pass.model.bodies[b];
    if (of.kind != BodyKind::quad || !is_unheld(pass.model, of)) {
      if (is_one_element(pass.model, b)) pass.add(b, motions);
      continue;
    }
    const auto i = static_cast<std::size_t>(quads.count);
    const Vec2* force = &pass.work.force[static_cast<std::size_t>(of.first_node)];
    if (!pass.all_count) {
      for (int n = 0; n < 4; ++n) damped[4 * i + static_cast<std::size_t>(n)] = motions.free_force(of.first_node + n);
      force = &damped[4 * i];
    }
    body[i] = b;
    quads.add(of.first_node, force);
  }
  add_quad_rotation(pass.model, pass.state, quads, pass.added);
  for (std::size_t i = 0; i < static_cast<std::size_t>(quads.count); ++i)
    if (quads.skewed[i]) pass.add(body[i], motions);
}
void add_range(const RotaryPass<3>& pass, int first, int last, const NodeMotions<3>& motions) {
  pass.add_range(first, last, motions);
}

template <int D>
void add_by_stretches(const RotaryPass<D>& pass) {
  const NodeMotions<D> motions(pass.model, pass.state, pass.work, pass.options);
  const int bodies = static_cast<int>(pass.model.bodies.size());
  share(pass.work.threads, bodies, quads_at_a_time, [&](int first, int last, int /*thread*/) {
    for (; first < last; first += quads_at_a_time)
      add_range(pass, first, std::min(last, first + quads_at_a_time), motions);
  });
}

}  // namespace

template <int D>
void add_rotary_inertia(const Model<D>& model, const State<D>& state, const Work<D>& work, const StepOptions& options,
                        bool all_count, std::vector<Vec<D>>& added) {
  add_by_stretches(RotaryPass<D>{model, state, work, options, all_count, added});
}

template <int D>
double rotary_kinetic(const Model<D>& model, const State<D>& state, const Work<D>& work, const StepOptions& options) {
  if (work.added_inertia.empty()) return 0;
  const NodeMotions<D> motions(model, state, work, options);
  double sum = 0;
  for (int b = 0; b < static_cast<int>(model.bodies.size()); ++b) {
    if (!is_one_element(model, b) || !model.body_moves(b)) continue;
    const Body& body = model.bodies[b];
    const RotaryInertia<D> of = rotary_inertia(model, state, b);
    const TurnVector<D> before =
        angular_momentum<D>(model, state, body, of.centre, [&](int n) { return state.velocity[n]; });
    const TurnVector<D> ahead =
        state.last_dt > 0 ? angular_momentum<D>(model, state, body, of.centre, [&](int n) { return motions.ahead(n); })
                          : before;
    sum -= 0.5 * before.dot(of.taken_off() * ahead);
  }
  return sum;
}

template <int D>
double rotary_energy(const Model<D>& model, const State<D>& state) {
  double sum = 0;
  for (int b = 0; b < static_cast<int>(model.bodies.size()); ++b) {
    if (!is_one_element(model, b) || !model.body_moves(b)) continue;
    const RotaryInertia<D> of = rotary_inertia(model, state, b);
    const TurnVector<D> h =
        angular_momentum<D>(model, state, model.bodies[b], of.centre, [&](int n) { return state.velocity[n]; });
    sum -= 0.5 * h.dot(of.taken_off() * h);
  }
  return sum;
}

template <int D>
void add_rotary_momentum(const Model<D>& model, const State<D>& state, const std::vector<Dofs<D>>& v,
                         std::vector<Dofs<D>>& out) {
  each_rotary_entry(model, state, [&](int i, int k, int j, int l, double m) { out[i][k] += m * v[j][l]; });
}

template <int D>
void add_rotary_diagonal(const Model<D>& model, const State<D>& state, std::vector<Dofs<D>>& out) {
  each_rotary_entry(model, state, [&](int i, int k, int j, int l, double m) {
    if (i == j && k == l) out[i][k] += m;
  });
}

/// -D T B T' D a, and in space the gyroscopic term.
template <int D>
void add_rotary_forces(const Model<D>& model, const State<D>& state, bool rising, std::vector<Dofs<D>>& out) {
  for (int b = 0; b < static_cast<int>(model.bodies.size()); ++b) {
    if (!is_one_element(model, b) || !model.body_moves(b)) continue;
    const Body& body = model.bodies[b];
    const RotaryInertia<D> of = rotary_inertia(model, state, b);
    const auto moment = [&](const std::vector<Vec<D>>& rate) {
      return angular_momentum<D>(model, state, body, of.centre, [&](int n) { return rate[n]; });
    };
    TurnVector<D> y = TurnVector<D>::Zero();
    if (rising) y = of.taken_off() * moment(state.acceleration);
    if (D == 3 && !(of.multiple > 0)) y += gyroscopic_part(of, moment(state.velocity));
    for (int n = body.first_node; n < body.first_node + body.nodes; ++n) {
      const Vec<D> arm = state.position[n] - of.centre;
      for (int k = 0; k < D; ++k) out[n][k] -= model.mass[n] * turn_row(k, arm).dot(y);
    }
  }
}

template void add_rotary_inertia(const Model<2>&, const State<2>&, const Work<2>&, const StepOptions&, bool,
                                 std::vector<Vec2>&);
template void add_rotary_inertia(const Model<3>&, const State<3>&, const Work<3>&, const StepOptions&, bool,
                                 std::vector<Vec3>&);
template double rotary_kinetic(const Model<2>&, const State<2>&, const Work<2>&, const StepOptions&);
template double rotary_kinetic(const Model<3>&, const State<3>&, const Work<3>&, const StepOptions&);
template double rotary_energy(const Model<2>&, const State<2>&);
template double rotary_energy(const Model<3>&, const State<3>&);
template void add_rotary_momentum(const Model<2>&, const State<2>&, const std::vector<Dofs<2>>&, std::vector<Dofs<2>>&);
template void add_rotary_momentum(const Model<3>&, const State<3>&, const std::vector<Dofs<3>>&, std::vector<Dofs<3>>&);
template void add_rotary_diagonal(const Model<2>&, const State<2>&, std::vector<Dofs<2>>&);
template void add_rotary_diagonal(const Model<3>&, const State<3>&, std::vector<Dofs<3>>&);
template void add_rotary_forces(const Model<2>&, const State<2>&, bool, std::vector<Dofs<2>>&);
template void add_rotary_forces(const Model<3>&, const State<3>&, bool, std::vector<Dofs<3>>&);

}  // namespace trilith
