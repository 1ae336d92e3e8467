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

void lay_piece(const Model<2>& model, const Work<2>& work, int piece, const PieceRoom& room, PlacedPiece& placed) {
  const auto first = static_cast<std::size_t>(model.piece_first[piece]),
             count = static_cast<std::size_t>(model.corners_of(piece));
  placed.corner = {room.place, count}, placed.is_face = {&model.edge_is_face[first], count};
  const bool deforms = work.body[model.piece_body[piece]].layout != SkinLayout::one_node;
  placed.corner_velocity = deforms ? std::span<const Vec2>(room.velocity, count) : std::span<const Vec2>{};
  placed.over_step = work.skin_mean.empty() ? nullptr : room.over_step;
  placed.sides = {};
}

void move_piece(const Model<2>& model, const State<2>& state, const Work<2>& work, int piece, const PieceRoom& room,
                PlacedPiece& placed) {
  const std::size_t count = placed.corner.size();
  const int *skin = &model.corner_skin[model.piece_first[piece]], node = work.body[model.piece_body[piece]].node;
  const SkinMotion<2>* const of = work.skin.data();
  for (std::size_t c = 0; c < count; ++c) store_pair(room.place[c].data(), load_pair(&of[skin[c]].x));
  placed.origin = state.position[node], placed.velocity = state.velocity[node], placed.spin = state.spin[node];
  if (placed.over_step != nullptr) {
    for (std::size_t c = 0; c < count; ++c) room.mean[c] = work.skin_mean[skin[c]];
    *room.over_step = placed;
    room.over_step->over_step = nullptr;
    room.over_step->corner_velocity = std::span(room.mean, count);
    fit_rigid(*room.over_step);
  }
  if (placed.corner_velocity.empty()) return;
  for (std::size_t c = 0; c < count; ++c) store_pair(room.velocity[c].data(), load_pair(&of[skin[c]].u));
  fit_rigid(placed);
}

PlacedPiece placed_piece(const Model<2>& model, const State<2>& state, const Work<2>& work, int piece,
                         const PieceRoom& room) {
  PlacedPiece placed;
  lay_piece(model, work, piece, room, placed);
  move_piece(model, state, work, piece, room, placed);
  return placed;
}

}  // namespace trilith
