// Positions and velocities of skin points from the motion of the nodes.
#include <algorithm>
#include <array>
#include <span>

#include "assembly/displacement_bound.hpp"
#include "assembly/evaluate.hpp"
#include "base/simd/portable_lanes.hpp"
#include "base/team.hpp"
#include "contact/joint/chord.hpp"
#include "element/rigid/rigid.hpp"

namespace trilith {
namespace {

/// Places a skin point.
TRILITH_INLINE void place_point(const Vec2& x, const Vec2& v, SkinMotion<2>& skin, SkinReach& reach) {
  const Lanes now{x.x(), x.y(), v.x(), v.y()};
  reach.add(now, load_lanes(&skin.x));
  store_lanes(&skin.x, now);
}

/// Outward velocity of the chord of a spin over the last step, per arm [1/s]; 0 after an implicit step, whose
/// velocities refer to its end.
TRILITH_INLINE double chord_now(const State<2>& state, double spin) {
  return state.implicit() ? 0 : chord_rate(spin, state.last_dt);
}

/// Places a body whose skin points are its nodes.
TRILITH_INLINE void place_nodes(const State<2>& state, const BodyRow& body, Work<2>& work, SkinReach& reach) {
  for (int i = 0; i < body.skins; ++i)
    place_point(state.position[body.node + i], state.velocity[body.node + i], work.skin[body.skin + i], reach);
}

/// place_rigid for a body that rotates, whose points move along chords: see contact/joint/chord.hpp. `chord`: per arm
/// [1/s].
TRILITH_INLINE void place_turning(const NodeMotion<2>& node, const portable::SineCosine& turn, double chord,
                                  std::span<const Vec2> skin, std::span<SkinMotion<2>> out, SkinReach& reach) {
  const auto [s, c] = turn;
  // As place_rigid; the velocity has a component along the arm, (x, y) of (x, y, y, x).
  const Lanes to_x{c, s, s, c}, to_y{-s, c, c, -s}, spin{1, 1, -node.spin, node.spin}, outward{0, 0, chord, chord};
  const Lanes origin{node.position.x(), node.position.y(), node.velocity.x(), node.velocity.y()};
  for (std::size_t i = 0; i < skin.size(); ++i) {
    const Lanes arm = to_x * skin[i].x() + to_y * skin[i].y();
    const Lanes now = origin + spin * arm + outward * __builtin_shufflevector(arm, arm, 0, 1, 0, 1);
    reach.add(now, load_lanes(&out[i].x));
    store_lanes(&out[i].x, now);
  }
}

/// Places a frame: each skin point rotates with the node of its section.
TRILITH_INLINE void place_sections(const Model<2>& model, const State<2>& state, const BodyRow& body, Work<2>& work,
                                   SkinReach& reach) {
  for (int s = body.skin; s < body.skin + body.skins; ++s) {
    const int n = model.skin_node[s], t = model.skin_turn[s];
    const Vec2 arm = Turn(state.rotation[t]).apply(model.skin_place[s]);
    const Vec2 chord = chord_now(state, state.spin[t]) * arm;
    place_point(state.position[n] + arm, state.velocity[n] + cross(state.spin[t], arm) + chord, work.skin[s], reach);
  }
}

/// Places a rigid body. `turn`: sine and cosine of its node's rotation.
TRILITH_INLINE void place_one_node(const Model<2>& model, const State<2>& state, const BodyRow& body,
                                   const portable::SineCosine& turn, Work<2>& work, SkinReach& reach) {
  const int n = body.node;
  const auto first = static_cast<std::size_t>(body.skin), count = static_cast<std::size_t>(body.skins);
  const NodeMotion<2> motion{state.position[n], state.rotation[n], state.velocity[n], state.spin[n]};
  const std::span skin = std::span(model.skin_place).subspan(first, count);
  const std::span out = std::span(work.skin).subspan(first, count);
  if (const double chord = chord_now(state, motion.spin); chord > 0)
    place_turning(motion, turn, chord, skin, out, reach);
  else
    place_rigid(motion, turn, skin, out, reach);
}

/// `turn`: rotation of the first node of a rigid body.
TRILITH_INLINE void place_body(const Model<2>& model, const State<2>& state, const BodyRow& body,
                               const portable::SineCosine& turn, Work<2>& work, SkinReach& reach) {
  switch (body.layout) {
    case SkinLayout::one_node:
      return place_one_node(model, state, body, turn, work, reach);
    case SkinLayout::node_each:
      return place_nodes(state, body, work, reach);
    case SkinLayout::sections:
      return place_sections(model, state, body, work, reach);
  }
}

/// Bodies per chunk of a thread, about 2 microseconds.
constexpr int body_stretch = 64;

/// Sines and cosines of the rotations of the rigid bodies in a chunk of consecutive bodies.
struct BodyTurns {
  alignas(32) std::array<double, body_stretch> sine, cosine;

  BodyTurns(const State<2>& state, const BodyRow* body, std::size_t count) {
    alignas(32) std::array<double, body_stretch> angle{};
    for (std::size_t i = 0; i < count; ++i)
      if (body[i].layout == SkinLayout::one_node) angle[i] = state.rotation[body[i].node];
    const std::size_t whole = (count + lane_count - 1) / lane_count * lane_count;
    portable::sines_cosines(angle.data(), whole, sine.data(), cosine.data());
  }
};

/// True if a node of the body is free to move.
bool moves(const Model<2>& model, const BodyRow& body) {
  for (int n = body.node; n < body.node + body.nodes; ++n)
    if (model.moves(n)) return true;
  return false;
}

/// Mean velocities of all skin points over the last step, from their positions at its start.
void place_means(const Model<2>& model, const State<2>& state, Work<2>& work) {
  work.skin_mean.resize(model.skin_place.size());
  const double per_step = state.last_dt > 0 ? 1 / state.last_dt : 0;
  int turned = -1;
  Turn turn(0);
  for (std::size_t s = 0; s < work.skin_mean.size(); ++s) {
    const int n = model.skin_node[s], t = model.skin_turn[s];
    if (t != turned) turn = Turn(state.rotation_before[t]), turned = t;
    const Vec2 before = state.position_before[n] + turn.apply(model.skin_place[s]);
    work.skin_mean[s] = (Vec2(work.skin[s].x, work.skin[s].y) - before) * per_step;
  }
}

/// Places up to body_stretch bodies from `first` on and clears the forces on them. `drifted`: see SkinReach.
[[gnu::target_clones("avx2", "default")]] void place_bodies(const Model<2>& model, const State<2>& state,
                                                            const Vec2& drifted, std::size_t first, std::size_t count,
                                                            Work<2>& work, DisplacementBound<2>& to) {
  const BodyRow* const bodies = work.body.data() + first;
  const BodyTurns turns(state, bodies, count);
  const LanePair drift{drifted.x(), drifted.y()};
  for (std::size_t i = 0; i < count; ++i) {
    const BodyRow& body = bodies[i];
    SkinReach of(drift);
    place_body(model, state, body, {turns.sine[i], turns.cosine[i]}, work, of);
    // Usually by the thread that will add to them.
    std::fill_n(work.skin_force.begin() + body.skin, body.skins, Vec2::Zero());
    to.add(of, [&] { return moves(model, body); });
    to.follow(of.step(), work.search.left[first + i]);
  }
}

DisplacementBound<2> place_all(const Model<2>& model, const State<2>& state, Work<2>& work) {
  work.skin.resize(model.skin_place.size());
  work.skin_force.resize(model.skin_place.size());
  BroadPhaseState<2>& search = work.search;
  search.left.resize(work.body.size());
  const Vec2 drift = state.last_dt * search.drift;
  search.together += drift;
  const DisplacementBound<2> reach = place_shared(
      work, static_cast<int>(work.body.size()), body_stretch, [&](int first, int last, DisplacementBound<2>& to) {
        for (int b = first; b < last; b += body_stretch)
          place_bodies(model, state, drift, static_cast<std::size_t>(b),
                       static_cast<std::size_t>(std::min(last - b, body_stretch)), work, to);
      });
  work.skin_mean.clear();
  if (state.implicit()) place_means(model, state, work);
  return reach;
}

}  // namespace

template <>
void update_kinematics(const Model<2>& model, const State<2>& state, Work<2>& work) {
  if (!work.valid) list_bodies(model, work), work.element_stretches.clear(), work.placed.piece.clear();
  keep_displacement_bound(place_all(model, state, work), work);
}

}  // namespace trilith
