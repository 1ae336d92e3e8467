#include "detect/pairs.hpp"

#include <algorithm>
#include <cmath>

#include "base/portable.hpp"
#include "contact/face_overlap.hpp"
#include "detect/grid.hpp"
#include "shape/polygon.hpp"

namespace trilith {
namespace {

/// One edge of a piece: its two skin points in counter-clockwise order.
struct Edge {
  int s0, s1;
  double corner;
};

Edge edge_of(const Model<2>& model, int piece, int e) {
  const int first = model.piece_first[piece], count = model.corners_of(piece);
  return {model.corner_skin[first + e], model.corner_skin[first + (e + 1) % count], model.edge_corner[first + e]};
}

/// As Work is placed: ends of a face and their velocities, counter-clockwise around its own body.
FaceEnds<double> ends(const Work<2>& work, int s0, int s1) {
  const SkinMotion<2>&p = work.skin[s0], &q = work.skin[s1];
  return {p.x, p.y, q.x, q.y, p.u, p.v, q.u, q.v};
}

void set_faces(NearPair& pair, const Edge& a, const Edge& b) {
  pair.a0 = a.s0, pair.a1 = a.s1, pair.b0 = b.s0, pair.b1 = b.s1;
  pair.corner = std::max(a.corner, b.corner);
}

/// Calls visit(edge a, edge b) for every two surface edges of the pieces whose directions oppose within `angle`.
/// With e_a, e_b along the faces, both counter-clockwise: e_a . e_b < 0 and |e_a x e_b| <= tan(angle) |e_a . e_b|, so
/// no root and no angle is found. `angle` is that tangent.
template <class Visit>
void for_facing_edges(const Model<2>& model, const Work<2>& work, int piece_a, int piece_b, double angle,
                      Visit&& visit) {
  const int na = model.corners_of(piece_a), nb = model.corners_of(piece_b);
  for (int i = 0; i < na; ++i) {
    if (!model.edge_is_face[model.piece_first[piece_a] + i]) continue;
    const Edge a = edge_of(model, piece_a, i);
    const double ax = work.skin[a.s1].x - work.skin[a.s0].x, ay = work.skin[a.s1].y - work.skin[a.s0].y;
    for (int j = 0; j < nb; ++j) {
      if (!model.edge_is_face[model.piece_first[piece_b] + j]) continue;
      const Edge b = edge_of(model, piece_b, j);
      const double bx = work.skin[b.s1].x - work.skin[b.s0].x, by = work.skin[b.s1].y - work.skin[b.s0].y;
      const double cosine = ax * bx + ay * by, sine = ax * by - ay * bx;
      if (cosine < 0 && std::abs(sine) <= -cosine * angle) visit(a, b);
    }
  }
}

/// Could the faces come to touch flatly before the next search? Until then no two points come nearer than the margin.
bool may_touch(const FaceOverlap<double>& o, double margin) {
  const double depth = -std::min(o.gap_lo, o.gap_hi), shared = o.shared + margin;
  return shared > 0 && depth > -margin && depth <= face_pair_max_depth * shared + margin;
}

/// The faces of a deformable body turn with their nodes.
/// A face whose ends move by d each turns by up to 2 d over its length: half of the shortest is its arm.
double half_shortest_face(const Model<2>& model, const Work<2>& work, int piece) {
  double least = unbounded;
  for (int e = 0; e < model.corners_of(piece); ++e) {
    const Edge edge = edge_of(model, piece, e);
    const SkinMotion<2>&p = work.skin[edge.s0], &q = work.skin[edge.s1];
    if (model.edge_is_face[model.piece_first[piece] + e])
      least = std::min(least, portable::hypot(q.x - p.x, q.y - p.y));
  }
  return 0.5 * least;
}

/// Counts the pairs of faces that may come to touch flatly, up to two, and keeps the first. 0: a contact of general
/// shape until the next search; 1: of these two faces; 2: chosen anew at each step.
void find_facing(const Model<2>& model, const Work<2>& work, NearPair& pair) {
  const auto turn = [&](int piece) {
    const int body = model.piece_body[piece];
    const double arm = model.bodies[body].is_rigid() ? model.body_radius[body] : half_shortest_face(model, work, piece);
    return work.margin / std::max(arm, work.margin);
  };
  // A body moves by half the margin at most before the next search, and so turns by margin / 2 arm at most.
  const double angle =
      portable::tan(std::min(1.0, face_pair_max_tilt + 0.5 * (turn(pair.piece_a) + turn(pair.piece_b))));
  pair.facing = 0;
  for_facing_edges(model, work, pair.piece_a, pair.piece_b, angle, [&](const Edge& a, const Edge& b) {
    const FaceOverlap<double> overlap(ends(work, a.s0, a.s1), ends(work, b.s0, b.s1));
    if (!may_touch(overlap, work.margin)) return;
    if (pair.facing == 0) set_faces(pair, a, b);
    pair.facing = std::min(pair.facing + 1, 2);
  });
}

std::vector<Box> piece_boxes(const Model<2>& model, const Work<2>& work, double widen) {
  std::vector<Box> boxes(static_cast<std::size_t>(model.pieces()));
  for (int p = 0; p < model.pieces(); ++p) {
    Box box{1e300, 1e300, -1e300, -1e300};
    for (int c = model.piece_first[p]; c < model.piece_first[p + 1]; ++c) {
      const SkinMotion<2>& s = work.skin[model.corner_skin[c]];
      box.x0 = std::min(box.x0, s.x), box.x1 = std::max(box.x1, s.x);
      box.y0 = std::min(box.y0, s.y), box.y1 = std::max(box.y1, s.y);
    }
    boxes[p] = {box.x0 - widen, box.y0 - widen, box.x1 + widen, box.y1 + widen};
  }
  return boxes;
}

/// Of a frame: its box says nothing of it.
double thinnest_piece(const Model<2>& model, const Body& b) {
  return *std::min_element(model.piece_thickness.begin() + b.first_piece,
                           model.piece_thickness.begin() + b.first_piece + b.pieces);
}

/// A twentieth of the median thickness (smaller side of the box in its own axes) of the bodies that move.
/// A wider margin finds more pairs that do not touch, a narrower one searches more often.
double search_margin(const Model<2>& model) {
  std::vector<double> thickness;
  for (int body = 0; body < static_cast<int>(model.bodies.size()); ++body) {
    if (!model.body_moves(body)) continue;
    const Body& b = model.bodies[body];
    if (b.skin_is_sections()) {
      thickness.push_back(thinnest_piece(model, b));
      continue;
    }
    // Places of the skin of a rigid body are in its own axes, those of a deformable one are its nodes.
    const auto first = static_cast<std::size_t>(b.is_rigid() ? b.first_skin : b.first_node);
    const Box2 box = bounding_box(std::span(b.is_rigid() ? model.skin_place : model.start_position)
                                      .subspan(first, static_cast<std::size_t>(b.skins)));
    thickness.push_back((box.high - box.low).minCoeff());
  }
  if (thickness.empty()) return 1;
  const auto middle = thickness.begin() + static_cast<std::ptrdiff_t>(thickness.size() / 2);
  std::nth_element(thickness.begin(), middle, thickness.end());
  return 0.05 * *middle;
}

/// Pairs of faces by law, for kernels that do several rows at once; all others one by one. Rows stay in their order.
void sort_into_batches(const Model<2>& model, Work<2>& work) {
  work.batches.assign(model.laws.size(), {});
  work.general.clear();
  for (std::size_t l = 0; l < model.laws.size(); ++l) work.batches[l].law = static_cast<int>(l);
  for (int row = 0; row < static_cast<int>(work.pairs.size()); ++row) {
    const NearPair& pair = work.pairs[row];
    if (pair.facing == 0 || pair.replaced)
      work.general.push_back(row);
    else
      (pair.facing == 1 ? work.batches[pair.law].row : work.batches[pair.law].choice).push_back(row);
  }
}

}  // namespace

int contact_law(const Model<2>& model, int body_a, int body_b) {
  return model.law_of[model.bodies[body_a].surface * model.surfaces + model.bodies[body_b].surface];
}

void apply_bearings(const Model<2>& model, std::span<const BearingMemory> bearings, NearPair& pair) {
  for (std::size_t i = 0; i < model.bearings.size(); ++i) {
    const Bearing<2>& b = model.bearings[i];
    if (!b.sits_between(pair.piece_a, pair.piece_b)) continue;
    if (is_live(bearings[i].status))
      pair.replaced = pair.replaced || b.replaces_contact;
    else if (b.contact_after >= 0)
      pair.law = b.contact_after;
  }
}

namespace {

/// The middle of what all nodes have moved by since the pairs were found, between the least and the most of it.
/// As of a building on its ground: what all of it goes by brings no two bodies nearer.
Vec2 moved_together(const State<2>& state, const Work<2>& work) {
  Vec2 least = Vec2::Constant(unbounded), most = Vec2::Constant(-unbounded);
  for (std::size_t n = 0; n < state.position.size(); ++n) {
    const Vec2 moved = state.position[n] - work.found_position[n];
    least = least.cwiseMin(moved), most = most.cwiseMax(moved);
  }
  return 0.5 * (least + most);
}

/// The farthest that a section of a frame has carried a point of the skin by turning, an upper bound.
double sections_turned(const Model<2>& model, const State<2>& state, const Work<2>& work, const BodyRow& body) {
  double most = 0;
  for (int s = body.skin; s < body.skin + body.skins; ++s) {
    const int t = model.skin_turn[s];
    most = std::max(most, model.skin_place[s].norm() * std::abs(state.rotation[t] - work.found_rotation[t]));
  }
  return most;
}

/// The farthest that a point of a body has moved beside what all have moved by together, an upper bound.
double body_moved(const Model<2>& model, const State<2>& state, const Work<2>& work, std::size_t b,
                  const Vec2& together) {
  const BodyRow& body = work.body[b];
  double most = 0;
  for (int n = body.node; n < body.node + body.nodes; ++n)
    most = std::max(most, (state.position[n] - work.found_position[n] - together).norm());
  if (body.layout == SkinLayout::node_each) return most;
  if (body.layout == SkinLayout::sections) return most + sections_turned(model, state, work, body);
  return most + model.body_radius[b] * std::abs(state.rotation[body.node] - work.found_rotation[body.node]);
}

}  // namespace

/// First the cheap bound, the path of the fastest point since the search; only where that has come to `look_again`
/// is each body looked at, and the next look put off by what is left of half the margin.
bool pairs_outdated(const Model<2>& model, const State<2>& state, Work<2>& work) {
  if (!work.valid) return true;
  if (work.travel < work.look_again) return false;
  const Vec2 together = moved_together(state, work);
  double moved = 0;
  for (std::size_t b = 0; b < work.body.size(); ++b)
    moved = std::max(moved, body_moved(model, state, work, b, together));
  // A node moves no faster than the fastest skin point, turning takes the farthest point from it at twice that at most,
  // and each component of what all move by together is no faster either.
  const double most = 0.5 * work.margin;
  // 5 is above 1 + 2 + sqrt(2), the three paths of above; the share of 1e-6 is for rounding.
  work.look_again = work.travel + (most * (1 - 1e-6) - moved) / 5;
  return moved > most;
}

void find_pairs(const Model<2>& model, const State<2>& state, Work<2>& work) {
  work.margin = search_margin(model);
  work.travel = work.look_again = work.clear_path = 0;
  work.found_position = state.position;
  work.found_rotation = state.rotation;
  work.pairs.clear();
  // Each box is widened by half the margin, as each of two bodies may move by that.
  for (const auto& [p, q] : meeting_boxes(piece_boxes(model, work, 0.5 * work.margin))) {
    const int body_p = model.piece_body[p], body_q = model.piece_body[q];
    if (body_p == body_q || state.left[body_p] != 0 || state.left[body_q] != 0) continue;
    if (!model.body_moves(body_p) && !model.body_moves(body_q)) continue;
    NearPair pair{p, q, contact_law(model, body_p, body_q), 0, 0, 0, 0, 0, 1.0, false};
    if (pair.law < 0) continue;
    apply_bearings(model, state.bearing, pair);
    find_facing(model, work, pair);
    work.pairs.push_back(pair);
  }
  work.asleep_until.assign(work.pairs.size(), -1.0);
  sort_into_batches(model, work);
  work.valid = true;
}

/// Bonded faces stay a pair however far they open or tilt, so the one at the smallest mean gap is taken, and touch and
/// flatness are not asked.
bool choose_face_pair(const Model<2>& model, const Work<2>& work, bool bonded, NearPair& pair) {
  int found = 0;
  double nearest = unbounded;
  const double angle = portable::tan(face_pair_max_tilt);
  for_facing_edges(model, work, pair.piece_a, pair.piece_b, angle, [&](const Edge& a, const Edge& b) {
    const FaceOverlap<double> overlap(ends(work, a.s0, a.s1), ends(work, b.s0, b.s1));
    if (!overlap.sane) return;
    const double gap = 0.5 * std::abs(overlap.gap_lo + overlap.gap_hi);
    const bool touches = std::min(overlap.gap_lo, overlap.gap_hi) < 0;
    if (bonded ? gap >= nearest : !touches || !overlap.is_flat(std::max(a.corner, b.corner))) return;
    nearest = gap;
    if (found++ == 0 || bonded) set_faces(pair, a, b);
  });
  // Two flat pairs that touch at once, as of a wedge in a notch, are one contact of general shape.
  return bonded ? found > 0 : found == 1;
}

}  // namespace trilith
