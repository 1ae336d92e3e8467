// Pieces where they stand, for contacts of general shape.
#include <span>

#include "step/contact_rows.hpp"

namespace trilith {
namespace {

/// The velocity and spin of the rigid piece that fits the corners of a piece that deforms best.
/// Least squares over its corners: the mean velocity, and spin = sum of r x v / sum of r^2 about their mean place.
void fit_rigid(PlacedPiece& piece) {
  const auto count = piece.corner.size();
  piece.origin = piece.velocity = Vec2::Zero();
  const auto share = [&](const Vec2& v) {  // a quarter is exact, and no division
    return count == 4 ? Vec2(0.25 * v) : Vec2(v / static_cast<double>(count));
  };
  for (std::size_t c = 0; c < count; ++c) {
    piece.origin += share(piece.corner[c]);
    piece.velocity += share(piece.corner_velocity[c]);
  }
  double turn = 0, size = 0;
  for (std::size_t c = 0; c < count; ++c) {
    const Vec2 arm = piece.corner[c] - piece.origin;
    turn += cross(arm, piece.corner_velocity[c]);
    size += arm.squaredNorm();
  }
  piece.spin = size > 0 ? turn / size : 0;
}

}  // namespace

void place_piece(const Model<2>& model, const State<2>& state, const Work<2>& work, int piece, const PieceRoom& room,
                 PlacedPiece& placed) {
  const auto first = static_cast<std::size_t>(model.piece_first[piece]),
             count = static_cast<std::size_t>(model.corners_of(piece));
  const int* const skin = &model.corner_skin[first];
  for (std::size_t c = 0; c < count; ++c) {
    const SkinMotion<2>& s = work.skin[skin[c]];
    room.place[c] = {s.x, s.y};
  }
  const BodyRow& body = work.body[model.piece_body[piece]];
  const int node = body.node;
  placed.corner = {room.place, count}, placed.is_face = {&model.edge_is_face[first], count};
  placed.origin = state.position[node], placed.velocity = state.velocity[node], placed.spin = state.spin[node];
  placed.corner_velocity = {}, placed.over_step = nullptr, placed.sides = {};
  if (!work.skin_mean.empty()) {
    for (std::size_t c = 0; c < count; ++c) room.mean[c] = work.skin_mean[skin[c]];
    *room.over_step = placed;
    room.over_step->corner_velocity = std::span(room.mean, count);
    fit_rigid(*room.over_step);
    placed.over_step = room.over_step;
  }
  if (body.layout == SkinLayout::one_node) return;
  for (std::size_t c = 0; c < count; ++c) {
    const SkinMotion<2>& s = work.skin[skin[c]];
    room.velocity[c] = {s.u, s.v};
  }
  placed.corner_velocity = std::span(room.velocity, count);
  fit_rigid(placed);
}

PlacedPiece placed_piece(const Model<2>& model, const State<2>& state, const Work<2>& work, int piece,
                         const PieceRoom& room) {
  PlacedPiece placed;
  place_piece(model, state, work, piece, room, placed);
  return placed;
}

}  // namespace trilith
