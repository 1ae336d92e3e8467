#include "integrate/implicit/step_path.hpp"

#include "broad_phase/solid_pairs.hpp"
#include "geometry/plane/polygon.hpp"
#include "geometry/space/separation_3d.hpp"
#include "geometry/space/sphere_distance.hpp"
#include "model/contact/contact_frame.hpp"

namespace trilith {
namespace {

/// Calls visit(node, rotating node, arm) for each node that carries points of a piece. `arm`: largest distance of these
/// points from the node [m].
template <class Visit>
void for_carriers(const Model<2>& model, int piece, Visit&& visit) {
  for (int c = model.piece_first[piece]; c < model.piece_first[piece + 1]; ++c) {
    const int skin = model.corner_skin[c];
    visit(model.skin_node[skin], model.skin_turn[skin], model.skin_place[skin].norm());
  }
}
template <class Visit>
void for_carriers(const Model<3>& model, int piece, Visit&& visit) {
  const auto p = static_cast<std::size_t>(piece);
  if (!model.is_fitted(piece)) {
    double arm = 0;
    for (const Vec3& x : model.piece_solid[p].shape.corners) arm = std::max(arm, x.norm());
    const int node = model.node_of_piece(piece);
    return visit(node, node, arm);
  }
  const Fit& whole = model.fits[static_cast<std::size_t>(model.piece_fit[p])];
  for (int i = 0; i < whole.nodes; ++i) {
    const int node = whole.node[static_cast<std::size_t>(i)];
    visit(node, node, 0.0);
  }
}

double angle_magnitude(double turn) {
  return std::abs(turn);
}
double angle_magnitude(const Vec3& turn) {
  return turn.norm();
}

}  // namespace

/// The path of a node deviates from the straight line between its ends by s (1 - s) |bend|, at most |bend| / 4. A point
/// that turns about it deviates further, by at most its arm times the angle.
template <int D>
PieceWay<D> StepPath<D>::way_of(int piece) const {
  ValueRange<D> range;
  double more = 0;
  for_carriers(model_, piece, [&](int node, int turning, double arm) {
    const double bent = bend(node).norm(), turned = arm > 0 ? arm * angle_magnitude(turn(turning)) : 0;
    range.add(way(node), 0.25 * bent + turned);
    more = std::max(more, bent);
  });
  return {range.middle(), range.half(), more};
}

void PieceOnPath2::place(const Model<2>& model, const StepPath<2>& path, int index, double s) {
  const int first = model.piece_first[index];
  piece.corners = model.corners_of(index);
  piece.is_face = model.edge_is_face.data() + first;
  for (int c = 0; c < piece.corners; ++c) {
    const int skin = model.corner_skin[first + c], node = model.skin_node[skin];
    const Vec2& arm = model.skin_place[skin];
    piece.at[c] = path.position(node, s);
    if (arm != Vec2::Zero()) piece.at[c] += Turn(path.rotation(model.skin_turn[skin], s)).apply(arm);
    piece.velocity[c] = Vec2::Zero();
  }
}

Vec2 PieceOnPath2::middle() const {
  Vec2 sum = Vec2::Zero();
  for (int c = 0; c < piece.corners; ++c) sum += piece.at[c];
  return sum / piece.corners;
}

/// Places a piece whose nodes do not turn, by the planes of its faces, as in the evaluation of each step.
void PieceOnPath3::place(const Model<3>& model, const StepPath<3>& path, int index, double s) {
  const auto p = static_cast<std::size_t>(index);
  const ConvexSolid& shape = model.piece_solid[p];
  if (!model.is_fitted(index)) {
    const int node = model.node_of_piece(index);
    return trilith::place(shape, Turn3(path.rotation(node, s)), path.position(node, s), solid);
  }
  const auto first = static_cast<std::size_t>(model.piece_fit[p]);
  const Fit& whole = model.fits[first];
  position.resize(static_cast<std::size_t>(model.nodes()));
  for (int i = 0; i < whole.nodes; ++i) {
    const int node = whole.node[static_cast<std::size_t>(i)];
    position[static_cast<std::size_t>(node)] = path.position(node, s);
  }
  faces.clear();
  for (int f = 0; f < shape.shape.faces.count(); ++f)
    faces.push_back(fitted(model, model.fits[first + 1 + static_cast<std::size_t>(f)], position, position));
  solid.solid = &shape;
  solid.corners.resize(shape.shape.corners.size());
  place_between(shape, faces, solid.corners, solid.normals);
}

Vec3 PieceOnPath3::middle() const {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& x : solid.corners) sum += x;
  return sum / static_cast<double>(solid.corners.size());
}

double depth_between(const PieceOnPath2& a, const PieceOnPath2& b) {
  return overlap_of(a.piece, b.piece).whole;
}
double depth_between(const PieceOnPath3& a, const PieceOnPath3& b) {
  const bool round = a.solid.solid->is_sphere() || b.solid.solid->is_sphere();
  return -(round ? sphere_distance(a.solid, b.solid) : separation(a.solid, b.solid).distance);
}

double thickness_of(const Model<2>& model, int piece) {
  if (model.bodies[model.piece_body[piece]].pieces == 1) return model.piece_thickness[piece];
  std::array<Vec2, max_piece_corners> at;
  const int first = model.piece_first[piece], count = model.corners_of(piece);
  for (int c = 0; c < count; ++c) {
    const int skin = model.corner_skin[first + c];
    at[c] = model.start_position[model.skin_node[skin]] +
            Turn(model.start_rotation[model.skin_turn[skin]]).apply(model.skin_place[skin]);
  }
  return std::min(model.piece_thickness[piece], least_width(std::span(at).first(static_cast<std::size_t>(count))));
}
double thickness_of(const Model<3>& model, int piece) {
  return model.piece_thickness[piece];
}

FatBox<2> box_of(const Model<2>& model, const Work<2>& work, int piece) {
  FatBox<2> box;
  box.low.fill(unbounded), box.high.fill(-unbounded);
  for (int c = model.piece_first[piece]; c < model.piece_first[piece + 1]; ++c) {
    const SkinMotion<2>& s = work.skin[model.corner_skin[c]];
    box.low = {std::min(box.low[0], s.x), std::min(box.low[1], s.y)};
    box.high = {std::max(box.high[0], s.x), std::max(box.high[1], s.y)};
  }
  return box;
}
FatBox<3> box_of(const Model<3>& /*model*/, const Work<3>& work, int piece) {
  return box_around(work.solids.placed[piece]);
}

template class StepPath<2>;
template class StepPath<3>;

}  // namespace trilith
