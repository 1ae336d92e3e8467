// Forces at skin points, bearing forces and external forces, summed at the nodes.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "assembly/bearing_motion.hpp"
#include "assembly/contact/face_columns.hpp"
#include "assembly/evaluate.hpp"
#include "base/simd/lanes.hpp"
#include "base/team.hpp"
#include "element/rigid/rigid.hpp"

namespace trilith {
namespace {

/// spread() of a body whose skin points are its nodes: contact forces plus element forces.
TRILITH_INLINE void spread_nodes(const BodyRow& body, Work<2>& work) {
  for (int i = 0; i < body.nodes; ++i) {
    const int n = body.node + i;
    work.force[n] = work.skin_force[body.skin + i] + work.element_force[n] + work.element_damping[n];
    work.moment[n] = 0;
  }
}

/// spread() of a frame: contact forces plus beam forces.
void spread_sections(const Model<2>& model, const State<2>& state, const BodyRow& body, Work<2>& work) {
  for (int n = body.node; n < body.node + body.nodes; ++n) {
    work.force[n] = work.element_force[n] + work.element_damping[n];
    work.moment[n] = work.element_moment[n] + work.element_damping_moment[n];
  }
  for (int s = body.skin; s < body.skin + body.skins; ++s) {
    const Vec2& f = work.skin_force[s];
    if (f.x() == 0 && f.y() == 0) continue;
    const int n = model.skin_node[s];
    work.force[n] += f;
    work.moment[model.skin_turn[s]] += cross(Vec2(Vec2(work.skin[s].x, work.skin[s].y) - state.position[n]), f);
  }
}

/// spread() of a rigid body.
TRILITH_INLINE void spread_one_node(const State<2>& state, const BodyRow& body, Work<2>& work) {
  const auto first = static_cast<std::size_t>(body.skin), count = static_cast<std::size_t>(body.skins);
  const NodeLoad load =
      spread_rigid(state.position[body.node], std::span<const SkinMotion<2>>(work.skin).subspan(first, count),
                   std::span<const Vec2>(work.skin_force).subspan(first, count));
  store_pair(work.force[body.node].data(), load.force);
  work.moment[body.node] = load.moment;
}

/// True for two rigid bodies with the same number of skin points.
TRILITH_INLINE bool are_alike(const BodyRow& a, const BodyRow& b) {
  return a.layout == SkinLayout::one_node && b.layout == SkinLayout::one_node && a.skins == b.skins;
}

/// spread() of two alike rigid bodies side by side: the operations of spread_rigid() for each.
TRILITH_INLINE void spread_two(const State<2>& state, const BodyRow& a, const BodyRow& b, Work<2>& work) {
  const auto both = [](const double* of_a, const double* of_b)
                        TRILITH_INLINE_LAMBDA { return join(load_pair(of_a), load_pair(of_b)); };
  const auto swapped = [](const Lanes& v)
                           TRILITH_INLINE_LAMBDA { return Lanes(__builtin_shufflevector(v, v, 1, 0, 3, 2)); };
  const Lanes origin = both(state.position[a.node].data(), state.position[b.node].data());
  Lanes sum{}, moment{};  // the moments in lanes 0 and 2
  for (int i = 0; i < a.skins; ++i) {
    const Lanes force = both(work.skin_force[a.skin + i].data(), work.skin_force[b.skin + i].data()),
                arm = both(&work.skin[a.skin + i].x, &work.skin[b.skin + i].x) - origin, turning = arm * swapped(force);
    sum += force;
    moment += turning - swapped(turning);
  }
  store_pair(work.force[a.node].data(), LanePair{sum[0], sum[1]});
  store_pair(work.force[b.node].data(), LanePair{sum[2], sum[3]});
  work.moment[a.node] = moment[0], work.moment[b.node] = moment[2];
}

/// spread() of a body in space whose nodes do not turn: element forces, and the forces on its fits.
void spread_fits(const Model<3>& model, const BodyRow& body, Work<3>& work) {
  for (int n = body.node; n < body.node + body.nodes; ++n) {
    work.force[n] = work.element_force[n] + work.element_damping[n];
    work.moment[n] = Vec3::Zero();
  }
  const SolidWork<3>& solids = work.solids;
  for (auto i = static_cast<std::size_t>(body.fit); i < static_cast<std::size_t>(body.fit + body.fits); ++i) {
    const Vec3 &force = solids.fit_force[i], &moment = solids.fit_moment[i];
    if (force.isZero(0) && moment.isZero(0)) continue;
    spread_fitted(model, model.fits[i], solids.fitted[i], force, moment, work.force);
  }
}

/// In space all contact forces are sums at nodes; a frame has the forces of its beams in addition.
void spread_body(const Model<3>& model, const State<3>& /*state*/, const BodyRow& body, Work<3>& work) {
  work.force[body.node] = work.solids.force[body.node], work.moment[body.node] = work.solids.moment[body.node];
  if (body.layout == SkinLayout::one_node) return;
  if (body.layout == SkinLayout::node_each) return spread_fits(model, body, work);
  for (int n = body.node; n < body.node + body.nodes; ++n) {
    work.force[n] = work.solids.force[n] + work.element_force[n] + work.element_damping[n];
    work.moment[n] = work.solids.moment[n] + work.element_moment[n] + work.element_damping_moment[n];
  }
}

TRILITH_INLINE void spread_body(const Model<2>& model, const State<2>& state, const BodyRow& body, Work<2>& work) {
  switch (body.layout) {
    case SkinLayout::one_node:
      return spread_one_node(state, body, work);
    case SkinLayout::node_each:
      return spread_nodes(body, work);
    case SkinLayout::sections:
      return spread_sections(model, state, body, work);
  }
}

/// Adds the forces of a bearing between two rigid bodies, or with an end on a deformable body.
void spread_bearing(const Model<2>& model, const State<2>& state, Work<2>& work, std::size_t i) {
  const Bearing<2>& b = model.bearings[i];
  if (!b.end_a.is_rigid() || !b.end_b.is_rigid())
    return push_ends(model, state, b, work.bearing_force[i], work.bearing_moment[i], work.force, work.moment);
  const int na = b.end_a.node[0], nb = b.end_b.node[0];
  const Vec2 point = state.position[nb] + Turn(state.rotation[nb]).apply(b.end_b.arm[0]);
  const Vec2& f = work.bearing_force[i];
  work.force[nb] += f;
  work.force[na] -= f;
  work.moment[nb] += cross(Vec2(point - state.position[nb]), f) + work.bearing_moment[i];
  work.moment[na] -= cross(Vec2(point - state.position[na]), f) + work.bearing_moment[i];
}

/// In space each end is attached to one contact frame.
void spread_bearing(const Model<3>& model, const State<3>& state, Work<3>& work, std::size_t i) {
  push_ends(model, state, model.bearings[i], work.bearing_force[i], work.bearing_moment[i], work.force, work.moment);
}

/// Largest forces carried and residual, squared. Each thread has its own, in a separate cache line.
struct alignas(64) LargestForces {
  double unbalanced = 0, carried = 0;  ///< [N2]
};

/// Adds the external forces on the nodes from `first` to before `last`, and updates the largest forces carried and
/// residual. Magnitudes are compared squared; the square root keeps their order.
TRILITH_INLINE void add_outside(const Model<2>& model, const Vec2& field, int first, int last, Work<2>& work,
                                LargestForces& largest) {
  const bool loaded = !work.load.empty();
  const Vec2* load = loaded ? work.load.data() : model.load.data();
  const LanePair pull{field.x(), field.y()};
  LanePair most{largest.unbalanced, largest.carried};
  double carried = largest.carried;
  for (int n = first; n < last; ++n) {
    const LanePair reacts = load_pair(work.force[n].data()), steady = model.mass[n] * pull + load_pair(load[n].data());
    LanePair left = reacts + steady;
    store_pair(work.force[n].data(), left);
    if (loaded) work.moment[n] += work.load_moment[n];
    const auto& held = model.support[n];
    if (held[0] != Support::free || held[1] != Support::free) {
      if (!model.moves(n)) continue;
      for (const int k : {0, 1})
        if (held[k] != Support::free) left[k] = 0;
    }
    const LanePair sizes = squared_sizes(left, reacts), steady2 = steady * steady;
    most = sizes > most ? sizes : most;
    carried = std::max(carried, steady2[0] + steady2[1]);
  }
  largest = {most[0], std::max(carried, most[1])};
}

/// The version for space.
void add_outside(const Model<3>& model, const Vec3& field, int first, int last, Work<3>& work, LargestForces& largest) {
  const bool loaded = !work.load.empty();
  const Vec3* load = loaded ? work.load.data() : model.load.data();
  double unbalanced = largest.unbalanced, carried = largest.carried;
  for (int n = first; n < last; ++n) {
    const Vec3 reacts = work.force[n], steady = model.mass[n] * field + load[n];
    Vec3 left = reacts + steady;
    work.force[n] = left;
    if (loaded) work.moment[n] += work.load_moment[n];
    if (!model.moves(n)) continue;
    carried = std::max(carried, std::max(reacts.squaredNorm(), steady.squaredNorm()));
    for (const int k : {0, 1, 2})
      if (model.support[n][k] != Support::free) left[k] = 0;
    unbalanced = std::max(unbalanced, left.squaredNorm());
  }
  largest = {unbalanced, carried};
}

void keep_larger(const LargestForces& of, LargestForces& largest) {
  largest.unbalanced = std::max(largest.unbalanced, of.unbalanced);
  largest.carried = std::max(largest.carried, of.carried);
}

/// Spreads body b, in the plane together with the next one if they are alike and it is before `last`. Returns the next
/// body.
TRILITH_INLINE int spread_some(const Model<2>& model, const State<2>& state, int b, int last, Work<2>& work) {
  const BodyRow* const body = &work.body[static_cast<std::size_t>(b)];
  if (b + 1 < last && are_alike(body[0], body[1])) {
    spread_two(state, body[0], body[1], work);
    return b + 2;
  }
  spread_body(model, state, body[0], work);
  return b + 1;
}
TRILITH_INLINE int spread_some(const Model<3>& model, const State<3>& state, int b, int /*last*/, Work<3>& work) {
  spread_body(model, state, work.body[static_cast<std::size_t>(b)], work);
  return b + 1;
}

/// Sums the forces of the bodies from `first` to before `last`, and adds the external forces if all other forces are
/// complete by then.
template <int D>
TRILITH_INLINE void sum_each(const Model<D>& model, const State<D>& state, const Vec<D>& field, int first, int last,
                             Work<D>& work, LargestForces& largest) {
  const bool at_once = model.bearings.empty();
  LargestForces of = largest;  // local copy: no written force can change it
  for (int b = first; b < last;) {
    const BodyRow* const body = work.body.data();
    const int next = spread_some(model, state, b, last, work);
    const BodyRow& end = body[next - 1];
    if (at_once) add_outside(model, field, body[b].node, end.node + end.nodes, work, of);
    b = next;
  }
  largest = of;
}
[[gnu::target_clones("avx2", "default")]] void sum_bodies(const Model<2>& model, const State<2>& state,
                                                          const Vec2& field, int first, int last, Work<2>& work,
                                                          LargestForces& largest) {
  sum_each(model, state, field, first, last, work, largest);
}
void sum_bodies(const Model<3>& model, const State<3>& state, const Vec3& field, int first, int last, Work<3>& work,
                LargestForces& largest) {
  sum_each(model, state, field, first, last, work, largest);
}

/// Bodies or nodes per chunk of a thread; some microseconds.
constexpr int summed_stretch = 128;

/// Each thread keeps its own largest values; their maximum does not depend on the order. Without bearings the forces on
/// the nodes of a body are complete as soon as it is spread.
template <int D>
LargestForces sum_all(const Model<D>& model, const State<D>& state, Work<D>& work) {
  const Vec<D> field = model.gravity.at(state.time);
  std::array<LargestForces, most_threads> by{};
  share(work.threads, static_cast<int>(work.body.size()), summed_stretch, [&](int first, int last, int thread) {
    LargestForces largest;
    sum_bodies(model, state, field, first, last, work, largest);
    keep_larger(largest, by[static_cast<std::size_t>(thread)]);
  });
  LargestForces largest;
  for (const LargestForces& one : by) keep_larger(one, largest);
  if (model.bearings.empty()) return largest;
  for (std::size_t i = 0; i < model.bearings.size(); ++i) spread_bearing(model, state, work, i);
  add_outside(model, field, 0, model.nodes(), work, largest);
  return largest;
}

}  // namespace

template <int D>
void assemble_forces(const Model<D>& model, const State<D>& state, Work<D>& work) {
  work.force.resize(model.mass.size());
  work.moment.resize(model.mass.size());
  const LargestForces largest = sum_all(model, state, work);
  work.unbalanced = std::sqrt(largest.unbalanced);
  work.carried = std::sqrt(largest.carried);
}

template void assemble_forces(const Model<2>&, const State<2>&, Work<2>&);
template void assemble_forces(const Model<3>&, const State<3>&, Work<3>&);

}  // namespace trilith
