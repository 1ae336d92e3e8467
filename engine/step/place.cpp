// Skin points, and in space the corners of solids, where the nodes put them, and how they move.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "base/lane_rows.hpp"
#include "base/portable_lanes.hpp"
#include "base/team.hpp"
#include "body/rigid.hpp"
#include "step/evaluate.hpp"
#include "step/single_terms.hpp"

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

/// place of a rigid body. `turn`: of its node's rotation.
SkinReach place_one_node(const Model<2>& model, const State<2>& state, const BodyRow& body,
                         const portable::SineCosine& turn, Work<2>& work) {
  const int n = body.node;
  const auto first = static_cast<std::size_t>(body.skin), count = static_cast<std::size_t>(body.skins);
  return place_rigid(NodeMotion<2>{state.position[n], state.rotation[n], state.velocity[n], state.spin[n]}, turn,
                     std::span(model.skin_place).subspan(first, count), std::span(work.skin).subspan(first, count));
}

template <int D>
void list_bodies(const Model<D>& model, Work<D>& work) {
  work.body.clear();
  for (const Body& b : model.bodies)
    work.body.push_back({b.first_node, b.nodes, b.first_skin, b.skins, info_of(b.kind).skin, b.first_fit, b.fits});
}

/// Elements that threads take at a time: some ten microseconds.
constexpr int least_elements = 64;

/// Cuts the elements between bodies, which have no nodes in common, so that threads can take the parts. Bodies come one
/// after the other in the list of elements; where they did not, it would not be cut.
void list_element_stretches(const Model<2>& model, Work<2>& work) {
  work.element_stretches.clear();
  const auto& all = model.elements;
  const int count = static_cast<int>(all.size());
  const bool in_order =
      std::is_sorted(all.begin(), all.end(), [](const Element& a, const Element& b) { return a.body < b.body; });
  for (int first = 0, i = 1; i <= count; ++i) {
    if (i < count && (!in_order || i - first < least_elements || all[i].body == all[i - 1].body)) continue;
    work.element_stretches.push_back({first, i - first});
    first = i;
  }
}
/// In space they need no cutting: see step/resist_space.cpp.
void list_element_stretches(const Model<3>& /*model*/, Work<3>& /*work*/) {}

/// `turn`: of the rotation of its first node, where the body is rigid.
SkinReach place_body(const Model<2>& model, const State<2>& state, const BodyRow& body,
                     const portable::SineCosine& turn, Work<2>& work) {
  switch (body.layout) {
    case SkinLayout::one_node:
      return place_one_node(model, state, body, turn, work);
    case SkinLayout::node_each:
      return place_nodes(state, body, work);
    case SkinLayout::sections:
      break;
  }
  return place_sections(model, state, body, work);
}

/// The sines and cosines by which four bodies are turned that stand side by side in the list; beyond its end none are.
portable::FourTurns turns_of(const State<2>& state, const Work<2>& work, int first) {
  std::array<double, lane_count> angle{};
  for (std::size_t i = 0; i < angle.size() && first + i < work.body.size(); ++i)
    if (const BodyRow& body = work.body[first + i]; body.layout == SkinLayout::one_node)
      angle[i] = state.rotation[body.node];
  return portable::sines_cosines(angle);
}

/// True where some node of the body is free to move.
bool moves(const Model<2>& model, const BodyRow& body) {
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

/// The largest squares of all that is placed, of its speeds and of those of bodies that are free to move. One to each
/// thread: none has part of another's in a line of its cache.
struct alignas(64) PlacedReach {
  SkinReach all;
  double moving = 0;  ///< [m2/s2]

  void add(const SkinReach& of, bool moves) {
    all.add(of.speed2, of.path2);
    if (moves) moving = std::max(moving, of.speed2);
  }
  void add(const PlacedReach& other) {
    all.add(other.all.speed2, other.all.path2);
    moving = std::max(moving, other.moving);
  }
};

/// What threads take at a time: in the plane some two microseconds, in space some ten.
constexpr int body_stretch = 64, piece_stretch = 128;

/// Each thread keeps the largest of what it places: the largest of these is the same in any order.
/// place(first, last, reach).
template <int D, class Place>
PlacedReach place_shared(const Work<D>& work, int count, int stretch, Place&& place) {
  std::array<PlacedReach, most_threads> by{};
  share(work.threads, count, stretch, [&](int first, int last, int thread) {
    PlacedReach reach;
    place(first, last, reach);
    by[static_cast<std::size_t>(thread)].add(reach);
  });
  PlacedReach reach;
  for (const PlacedReach& one : by) reach.add(one);
  return reach;
}

PlacedReach place_all(const Model<2>& model, const State<2>& state, Work<2>& work) {
  work.skin.resize(model.skin_place.size());
  work.skin_force.resize(model.skin_place.size());
  const PlacedReach reach =
      place_shared(work, static_cast<int>(work.body.size()), body_stretch, [&](int first, int last, PlacedReach& to) {
        portable::FourTurns turns;
        for (int b = first; b < last; ++b) {
          const auto lane = static_cast<std::size_t>((b - first) % lane_count);
          if (lane == 0) turns = turns_of(state, work, b);
          const BodyRow& body = work.body[static_cast<std::size_t>(b)];
          const SkinReach of = place_body(model, state, body, {turns.sine[lane], turns.cosine[lane]}, work);
          // By the thread that will add to them, mostly.
          std::fill_n(work.skin_force.begin() + body.skin, body.skins, Vec2::Zero());
          to.add(of, of.speed2 > to.moving && moves(model, body));
        }
      });
  work.skin_mean.clear();
  if (state.implicit()) place_means(model, state, work);
  return reach;
}

/// A vector in the first three lanes.
TRILITH_INLINE Lanes in_lanes(const Vec3& v) {
  return Lanes{v.x(), v.y(), v.z(), 0};
}

/// A body as it stands and moves, in all lanes, and the largest squares of speed and path of the corners it placed.
struct MovingCorners {
  Triple<Lanes> x, y, z, at, velocity, spin;
  Lanes speed2{}, path2{};

  TRILITH_INLINE MovingCorners(const NodeMotion<3>& node, const Turn3& turn)
      : x(in_all(turn.x())),
        y(in_all(turn.y())),
        z(in_all(turn.z())),
        at(in_all(node.position)),
        velocity(in_all(node.velocity)),
        spin(in_all(node.spin)) {}
  TRILITH_INLINE static Triple<Lanes> in_all(const Vec3& v) { return four_of(v, v, v, v); }
  [[nodiscard]] TRILITH_INLINE Triple<Lanes> turned(const Triple<Lanes>& r) const {
    return x * r.x + y * r.y + z * r.z;
  }
  TRILITH_INLINE Triple<Lanes> place(const Triple<Lanes>& own, const Triple<Lanes>& before) {
    const Triple<Lanes> arm = turned(own), now = at + arm, rate = velocity + cross(spin, arm);
    speed2 = larger(speed2, rate.square()), path2 = larger(path2, (now - before).square());
    return now;
  }
};

/// Corners and normals of a piece whose body moves and stands so, four at a time: of corners lanes beyond the last
/// repeat it; normals beyond the last four one by one, in a lane for each axis.
[[gnu::target_clones("avx2", "default")]] void place_solid(const ConvexSolid& solid, const NodeMotion<3>& node,
                                                           const Turn3& turn, PlacedSolid& out, SkinReach& reach) {
  MovingCorners body(node, turn);
  const std::vector<Vec3>& own = solid.shape.corners;
  const std::size_t fours = own.size() - own.size() % lane_count;
  for (std::size_t i = 0; i < fours; i += lane_count)
    store_neighbours(body.place(load_neighbours(&own[i]), load_neighbours(&out.corners[i])), &out.corners[i]);
  if (const std::size_t i = fours; i < own.size()) {
    const std::size_t last = own.size() - 1, k1 = std::min(i + 1, last), k2 = std::min(i + 2, last);
    Vec3 *const p0 = &out.corners[i], *const p1 = &out.corners[k1], *const p2 = &out.corners[k2];
    const Triple<Lanes> place = body.place(four_of(own[i], own[k1], own[k2], own[k2]), four_of(*p0, *p1, *p2, *p2));
    *p0 = lane_of(place, 0), *p1 = lane_of(place, 1), *p2 = lane_of(place, 2);
  }
  for (int lane = 0; lane < lane_count; ++lane) reach.add(body.speed2[lane], body.path2[lane]);
  const std::vector<Vec3>& normals = solid.normals;
  const std::size_t whole = normals.size() - normals.size() % lane_count;
  for (std::size_t f = 0; f < whole; f += lane_count)
    store_neighbours(body.turned(load_neighbours(&normals[f])), &out.normals[f]);
  const Lanes along_x = in_lanes(turn.x()), along_y = in_lanes(turn.y()), along_z = in_lanes(turn.z());
  for (std::size_t f = whole; f < normals.size(); ++f) {
    const Vec3& n = normals[f];
    const Lanes now = along_x * n.x() + along_y * n.y() + along_z * n.z();
    out.normals[f] = {now[0], now[1], now[2]};
  }
}

/// The faces beside a piece that bound its body there too.
void place_beside(const Model<3>& model, const State<3>& state, std::size_t piece, PlacedSolid& out) {
  if (model.piece_bounds.empty()) return;
  out.beside.clear();
  for (const int fit : model.piece_bounds[piece]) {
    const Fitted now = fitted(model, model.fits[static_cast<std::size_t>(fit)], state.position, state.velocity);
    out.beside.push_back({now.axes.col(2), now.place});
  }
}

/// A piece of a body whose nodes do not turn: its own fit and those of its faces, then the solid between them. The
/// fastest of its nodes is as fast as any of its corners, or nearly.
SkinReach place_fitted(const Model<3>& model, const State<3>& state, int piece, SolidWork<3>& solids) {
  const auto p = static_cast<std::size_t>(piece), first = static_cast<std::size_t>(model.piece_fit[p]);
  const ConvexSolid& solid = model.piece_solid[p];
  const auto faces = static_cast<std::size_t>(solid.shape.faces.count());
  for (std::size_t i = first; i <= first + faces; ++i)
    solids.fitted[i] = fitted(model, model.fits[i], state.position, state.velocity);
  for (std::size_t f = 0; f < faces; ++f) {
    const Fitted& now = solids.fitted[first + 1 + f];
    const StepBehind* behind = solids.behind.empty() ? nullptr : &solids.behind[state.position.size() + first + 1 + f];
    solids.face_motion[first + 1 + f] = {now.place, now.velocity, now.spin, behind};
  }
  PlacedSolid& out = solids.placed[p];
  const std::vector<Vec3>& own = solid.shape.corners;
  if (out.corners.size() != own.size()) out.corners.assign(own.size(), solids.fitted[first].place);
  solids.before[p] = out.corners;
  out.solid = &solid;
  place_between(solid, std::span(solids.fitted).subspan(first + 1, faces), out.corners, out.normals);
  place_beside(model, state, p, out);
  double speed2 = 0;
  const Fit& whole = model.fits[first];
  for (int i = 0; i < whole.nodes; ++i)
    speed2 = std::max(speed2, state.velocity[whole.node[static_cast<std::size_t>(i)]].squaredNorm());
  SkinReach reach;
  for (std::size_t c = 0; c < out.corners.size(); ++c)
    reach.add(speed2, (out.corners[c] - solids.before[p][c]).squaredNorm());
  solids.speed2[p] = reach.speed2;
  return reach;
}

/// Corners and normals of a piece, which goes with one node: of a frame too, see world/space_frame.hpp.
SkinReach place_piece(const Model<3>& model, const State<3>& state, int piece, SolidWork<3>& solids) {
  const auto p = static_cast<std::size_t>(piece);
  if (model.is_fitted(piece)) return place_fitted(model, state, piece, solids);
  const int n = model.node_of_piece(piece);
  const NodeMotion<3> node{state.position[n], state.rotation[n], state.velocity[n], state.spin[n]};
  const Turn3 turn(node.rotation);
  const ConvexSolid& solid = model.piece_solid[p];
  PlacedSolid& out = solids.placed[p];
  out.solid = &solid;
  if (out.corners.size() != solid.shape.corners.size()) out.corners.assign(solid.shape.corners.size(), node.position);
  out.normals.resize(solid.normals.size());
  SkinReach reach;
  place_solid(solid, node, turn, out, reach);
  solids.speed2[p] = reach.speed2;
  if (!solids.sphere.empty()) solids.sphere[p].centre = out.corners[0];
  return reach;
}

/// True where some node that carries the piece is free to move.
bool piece_moves(const Model<3>& model, int piece) {
  if (!model.is_fitted(piece)) return model.moves(model.node_of_piece(piece));
  const Fit& whole = model.fits[static_cast<std::size_t>(model.piece_fit[static_cast<std::size_t>(piece)])];
  return std::any_of(whole.node.begin(), whole.node.begin() + whole.nodes, [&](int n) { return model.moves(n); });
}

/// How all nodes went along an implicit step, with room for fits; nothing after an explicit one.
void place_behind(const Model<3>& model, const State<3>& state, std::vector<StepBehind>& behind) {
  behind.clear();
  if (!state.implicit()) return;
  behind.resize(state.position.size() + model.fits.size());
  for (std::size_t n = 0; n < state.position.size(); ++n)
    behind[n] = {state.position[n], state.rotation[n], state.position_before[n], state.rotation_before[n]};
}

/// ... and all fits, which have been placed.
void place_fits_behind(const Model<3>& model, const State<3>& state, SolidWork<3>& solids) {
  if (solids.behind.empty()) return;
  for (std::size_t i = 0; i < model.fits.size(); ++i) {
    const BodyMotion now = solids.fitted[i].motion(), before = motion_before(model, state, -1 - static_cast<int>(i));
    solids.behind[state.position.size() + i] = {now.place, now.rotation, before.place, before.rotation};
  }
}

PlacedReach place_all(const Model<3>& model, const State<3>& state, Work<3>& work) {
  const std::size_t pieces = model.piece_solid.size();
  work.solids.placed.resize(pieces), work.solids.speed2.resize(pieces);
  work.solids.fitted.resize(model.fits.size()), work.solids.face_motion.resize(model.fits.size());
  if (!model.fits.empty()) work.solids.before.resize(pieces);
  if (!work.valid) list_spheres(model, work.solids.sphere);
  place_behind(model, state, work.solids.behind);
  const PlacedReach reach =
      place_shared(work, static_cast<int>(pieces), piece_stretch, [&](int first, int last, PlacedReach& to) {
        for (int p = first; p < last; ++p) {
          const SkinReach of = place_piece(model, state, p, work.solids);
          to.add(of, piece_moves(model, p));
        }
      });
  place_fits_behind(model, state, work.solids);
  return reach;
}

}  // namespace

/// Where a piece and its faces were as an implicit step began does not change; where they are now, its fits know.
void place_again(const Model<3>& model, const State<3>& state, Work<3>& work, int piece) {
  SolidWork<3>& solids = work.solids;
  place_piece(model, state, piece, solids);
  if (solids.behind.empty()) return;
  const bool is_fitted = model.is_fitted(piece);
  const int faces = is_fitted ? model.piece_solid[static_cast<std::size_t>(piece)].shape.faces.count() : 0;
  for (int face = -1; face < faces; ++face) {
    const int carrier = model.carrier_of(piece, face), fit = -1 - carrier;
    StepBehind& behind = solids.behind[static_cast<std::size_t>(is_fitted ? model.nodes() + fit : carrier)];
    const BodyMotion now =
        is_fitted ? solids.fitted[static_cast<std::size_t>(fit)].motion() : motion_of(model, state, carrier);
    behind = {now.place, now.rotation, behind.place_before, behind.rotation_before};
  }
}

template <int D>
void place(const Model<D>& model, const State<D>& state, Work<D>& work) {
  if (!work.valid) list_bodies(model, work), list_element_stretches(model, work), work.placed.piece.clear();
  const PlacedReach reach = place_all(model, state, work);
  work.fastest = std::sqrt(reach.all.speed2);
  work.fastest_moving = std::sqrt(reach.moving);
  work.travel += std::sqrt(reach.all.path2);  // of no meaning, and not asked for, before the pairs are found
}

template void place(const Model<2>&, const State<2>&, Work<2>&);
template void place(const Model<3>&, const State<3>&, Work<3>&);

}  // namespace trilith
