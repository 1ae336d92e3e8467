#include "assembly/element/rotary_inertia.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>

#include "assembly/element/quad_rotation.hpp"
#include "assembly/element/spin_terms.hpp"
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

/// Adds the forces of a free body whose J is a multiple of Jl. force(i): on its node i [N].
template <int D, class Force>
void add_proportional(const State<D>& state, const RotaryInertia<D>& of, int first_node, Force&& force,
                      std::vector<Vec<D>>& added) {
  TurnVector<D> moment = TurnVector<D>::Zero();
  for (int i = 0; i < of.nodes.count; ++i) {
    const Vec<D> f = force(i);
    for (int k = 0; k < D; ++k) moment += f[k] * turn_row(k, of.nodes.arm[i]);
  }
  // Velocities refer to half a step before. The rate of the angular momentum of the lumped masses is J^-1 Jl (moment).
  const SpinTerms<D> terms(of, angular_momentum(of, [&](int i) { return state.velocity[first_node + i]; }) +
                                   0.5 * state.last_dt * of.multiple * moment);
  const TurnVector<D> y = (of.multiple - 1) * (of.lumped.inverse() * moment) + terms.rate;
  for (int i = 0; i < of.nodes.count; ++i) {
    Vec<D>& to = added[first_node + i];
    to += terms.force[i];
    for (int k = 0; k < D; ++k) to[k] += of.nodes.mass[i] * turn_row(k, of.nodes.arm[i]).dot(y);
  }
}

/// Forces on the free axes of the nodes of a body, and accelerations of the others.
template <int D>
struct NodeActions {
  NodeVectors<D> force, rise;
  std::array<std::array<bool, D>, corners_in<D>> is_free;
};

/// Adds the forces of any body. Velocities refer to half a step before, so the terms of the spin are found twice: with
/// these velocities and with velocities at the instant.
template <int D>
void add_any(const State<D>& state, const RotaryInertia<D>& of, int first_node, NodeActions<D>& on,
             std::vector<Vec<D>>& added) {
  const TurnMatrix<D> off = of.taken_off();
  TurnMatrix<D> free = TurnMatrix<D>::Zero();
  NodeVectors<D> velocity, extra;
  for (int i = 0; i < of.nodes.count; ++i) {
    velocity[i] = state.velocity[first_node + i];
    for (int k = 0; k < D; ++k) {
      const TurnVector<D> row = turn_row(k, of.nodes.arm[i]);
      if (on.is_free[i][k]) free += of.nodes.mass[i] * row * row.transpose();
    }
  }
  const TurnMatrix<D> left = (TurnMatrix<D>::Identity() - off * free).inverse();
  for (const int pass : {0, 1}) {
    const SpinTerms<D> terms(of, velocity);
    TurnVector<D> sum = TurnVector<D>::Zero();
    for (int i = 0; i < of.nodes.count; ++i)
      for (int k = 0; k < D; ++k)
        sum += (on.is_free[i][k] ? on.force[i][k] + terms.force[i][k] : of.nodes.mass[i] * on.rise[i][k]) *
               turn_row(k, of.nodes.arm[i]);
    const TurnVector<D> y = left * (off * sum + terms.rate);
    for (int i = 0; i < of.nodes.count; ++i)
      for (int k = 0; k < D; ++k) {
        extra[i][k] = terms.force[i][k] + of.nodes.mass[i] * turn_row(k, of.nodes.arm[i]).dot(y);
        if (on.is_free[i][k]) on.rise[i][k] = (on.force[i][k] + extra[i][k]) / of.nodes.mass[i];
        if (pass == 0) velocity[i][k] += 0.5 * state.last_dt * on.rise[i][k];
      }
  }
  for (int i = 0; i < of.nodes.count; ++i) added[first_node + i] += extra[i];
}

template <int D>
NodeActions<D> node_actions(const Model<D>& model, const Body& body, const NodeMotions<D>& motions) {
  NodeActions<D> out;
  for (int i = 0; i < body.nodes; ++i) {
    const int n = body.first_node + i;
    out.force[i] = along_of(motions.forces(n).force);
    for (int k = 0; k < D; ++k) {
      out.is_free[i][k] = model.support[n][k] == Support::free;
      out.rise[i][k] = motions.driven(n, k);
    }
  }
  return out;
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
    const int first = body.first_node;
    if (!(of.multiple > 0) || !is_unheld(model, body)) {
      NodeActions<D> actions = node_actions(model, body, motions);
      add_any(state, of, first, actions, added);
    } else if (all_count) {
      add_proportional(
          state, of, first, [&](int i) -> const Vec<D>& { return work.force[first + i]; }, added);
    } else {
      add_proportional(
          state, of, first, [&](int i) { return along_of(motions.forces(first + i).force); }, added);
    }
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
    const TurnVector<D> before = angular_momentum(of, [&](int i) { return state.velocity[body.first_node + i]; });
    const TurnVector<D> ahead =
        state.last_dt > 0 ? angular_momentum(of, [&](int i) { return motions.ahead(body.first_node + i); }) : before;
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
    const int first = model.bodies[b].first_node;
    const TurnVector<D> h = angular_momentum(of, [&](int i) { return state.velocity[first + i]; });
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

/// - D T (B T' D a + k) - f_s.
template <int D>
void add_rotary_forces(const Model<D>& model, const State<D>& state, bool rising, std::vector<Dofs<D>>& out) {
  for (int b = 0; b < static_cast<int>(model.bodies.size()); ++b) {
    if (!is_one_element(model, b) || !model.body_moves(b)) continue;
    const int first = model.bodies[b].first_node;
    const RotaryInertia<D> of = rotary_inertia(model, state, b);
    NodeVectors<D> velocity;
    for (int i = 0; i < of.nodes.count; ++i) velocity[i] = state.velocity[first + i];
    const SpinTerms<D> terms(of, velocity);
    TurnVector<D> y = terms.rate;
    if (rising) y += of.taken_off() * angular_momentum(of, [&](int i) { return state.acceleration[first + i]; });
    for (int i = 0; i < of.nodes.count; ++i)
      for (int k = 0; k < D; ++k)
        out[first + i][k] -= of.nodes.mass[i] * turn_row(k, of.nodes.arm[i]).dot(y) + terms.force[i][k];
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
