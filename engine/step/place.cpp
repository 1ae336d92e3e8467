// Skin points where the nodes put them, and how they move.
#include <algorithm>
#include <cmath>
#include <span>

#include "body/rigid.hpp"
#include "step/evaluate.hpp"

namespace trilith {
namespace {

/// place of a body whose skin points are its nodes.
SkinReach place_nodes(const State<2>& state, const BodyRow& body, Work<2>& work) {
  SkinReach reach;
  for (int i = 0; i < body.skins; ++i) {
    const Vec2 &x = state.position[body.node + i], &v = state.velocity[body.node + i];
    SkinMotion<2>& skin = work.skin[body.skin + i];
    const double dx = x.x() - skin.x, dy = x.y() - skin.y;
    skin = {x.x(), x.y(), v.x(), v.y()};
    reach.add(v.squaredNorm(), dx * dx + dy * dy);
  }
  return reach;
}

/// place of a frame: each skin point turns with the node of its section.
SkinReach place_sections(const Model<2>& model, const State<2>& state, const BodyRow& body, Work<2>& work) {
  SkinReach reach;
  for (int s = body.skin; s < body.skin + body.skins; ++s) {
    const int n = model.skin_node[s], t = model.skin_turn[s];
    const Vec2 arm = Turn(state.rotation[t]).apply(model.skin_place[s]);
    const Vec2 x = state.position[n] + arm, v = state.velocity[n] + cross(state.spin[t], arm);
    SkinMotion<2>& skin = work.skin[s];
    const double dx = x.x() - skin.x, dy = x.y() - skin.y;
    skin = {x.x(), x.y(), v.x(), v.y()};
    reach.add(v.squaredNorm(), dx * dx + dy * dy);
  }
  return reach;
}

/// place of a rigid body.
template <int D>
SkinReach place_one_node(const Model<D>& model, const State<D>& state, const BodyRow& body, Work<D>& work) {
  const int n = body.node;
  const auto first = static_cast<std::size_t>(body.skin), count = static_cast<std::size_t>(body.skins);
  return place_rigid(NodeMotion<D>{state.position[n], state.rotation[n], state.velocity[n], state.spin[n]},
                     std::span(model.skin_place).subspan(first, count), std::span(work.skin).subspan(first, count));
}

template <int D>
void list_bodies(const Model<D>& model, Work<D>& work) {
  work.body.clear();
  for (const Body& b : model.bodies)
    work.body.push_back({b.first_node, b.nodes, b.first_skin, b.skins, info_of(b.kind).skin});
}

SkinReach place_body(const Model<2>& model, const State<2>& state, const BodyRow& body, Work<2>& work) {
  switch (body.layout) {
    case SkinLayout::one_node:
      return place_one_node(model, state, body, work);
    case SkinLayout::node_each:
      return place_nodes(state, body, work);
    case SkinLayout::sections:
      break;
  }
  return place_sections(model, state, body, work);
}

/// In space there are rigid bodies alone.
SkinReach place_body(const Model<3>& model, const State<3>& state, const BodyRow& body, Work<3>& work) {
  return place_one_node(model, state, body, work);
}

/// True where some node of the body is free to move.
template <int D>
bool moves(const Model<D>& model, const BodyRow& body) {
  for (int n = body.node; n < body.node + body.nodes; ++n)
    if (model.moves(n)) return true;
  return false;
}

/// Mean velocities of all skin points over the step behind, from where they were when it began.
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

/// Their radii; empty where no piece is one.
void list_spheres(const Model<3>& model, std::vector<Sphere>& sphere) {
  sphere.clear();
  const auto& pieces = model.piece_solid;
  if (std::none_of(pieces.begin(), pieces.end(), [](const ConvexSolid& s) { return s.is_sphere(); })) return;
  for (const ConvexSolid& piece : pieces) sphere.push_back({Vec3::Zero(), piece.radius});
}

void place_solids(const Model<2>& /*model*/, const State<2>& /*state*/, Work<2>& /*work*/) {}
/// Corners, normals and edges of all pieces, and spheres in a row of their own where there are any.
void place_solids(const Model<3>& model, const State<3>& state, Work<3>& work) {
  work.solids.placed.resize(model.piece_solid.size());
  if (!work.valid) list_spheres(model, work.solids.sphere);
  for (std::size_t p = 0; p < model.piece_solid.size(); ++p) {
    const int node = model.bodies[static_cast<std::size_t>(model.piece_body[p])].first_node;
    place(model.piece_solid[p], Turn3(state.rotation[node]), state.position[node], work.solids.placed[p]);
    if (!work.solids.sphere.empty()) work.solids.sphere[p].centre = work.solids.placed[p].corners[0];
  }
}

}  // namespace

template <int D>
void place(const Model<D>& model, const State<D>& state, Work<D>& work) {
  if (!work.valid) list_bodies(model, work);
  work.skin.resize(model.skin_place.size());
  work.skin_force.resize(model.skin_place.size());
  double fastest = 0, fastest_moving = 0, farthest = 0;
  for (const BodyRow& body : work.body) {
    const auto [speed2, path2] = place_body(model, state, body, work);
    fastest = std::max(fastest, speed2);
    farthest = std::max(farthest, path2);
    if (speed2 > fastest_moving && moves(model, body)) fastest_moving = speed2;
  }
  place_solids(model, state, work);
  work.skin_mean.clear();
  if constexpr (D == 2)
    if (state.implicit()) place_means(model, state, work);
  work.fastest = std::sqrt(fastest);
  work.fastest_moving = std::sqrt(fastest_moving);
  work.travel += std::sqrt(farthest);  // of no meaning, and not asked for, before the pairs are found
}

template void place(const Model<2>&, const State<2>&, Work<2>&);
template void place(const Model<3>&, const State<3>&, Work<3>&);

}  // namespace trilith
