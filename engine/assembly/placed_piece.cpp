// Pieces in their present position, for contacts of general shape.
#include <cstddef>
#include <span>

#include "assembly/contact/contact_rows.hpp"
#include "base/simd/lanes.hpp"
#include "base/team.hpp"
#include "contact/plane/edge_lanes.hpp"

namespace trilith {
namespace {

/// Velocity and spin of the rigid motion that fits the corners of a deforming piece best. Least squares over its
/// corners: the mean velocity, and spin = sum of r x v / sum of r^2 about their mean position.
void fit_rigid(PlacedPiece& piece) {
  const auto count = piece.corner.size();
  piece.origin = piece.velocity = Vec2::Zero();
  const auto share = [&](const Vec2& v) {  // a factor of 1/4 is exact and needs no division
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

namespace {

/// Buffers for corners and velocities of a piece in `all`.
PieceRoom piece_room(const Model<2>& model, int piece, PlacedPieces& all) {
  const int first = model.piece_first[piece];
  const bool means = !all.mean.empty();
  return {&all.place[first], &all.velocity[first], means ? &all.mean[first] : nullptr,
          means ? &all.over_step[piece] : nullptr};
}

/// Sizes the buffers for all pieces and connects their constant data.
void lay_pieces(const Model<2>& model, const Work<2>& work, PlacedPieces& placed) {
  const auto pieces = static_cast<std::size_t>(model.pieces()), corners = model.corner_skin.size();
  const bool means = !work.skin_mean.empty();
  placed.piece.resize(pieces);
  placed.over_step.resize(means ? pieces : 0);
  placed.place.resize(corners);
  placed.velocity.resize(corners);
  placed.mean.resize(means ? corners : 0);
  placed.row.resize(PlacedPieces::first_row(model.pieces(), static_cast<int>(corners)));
  placed.source.resize(pieces);
  for (int p = 0; p < model.pieces(); ++p) {
    PlacedPiece& piece = placed.piece[p];
    lay_piece(model, work, p, piece_room(model, p, placed), piece);
    const int first = model.piece_first[p];
    piece.sides = {&placed.row[PlacedPieces::first_row(p, first)], surface_bits(piece.is_face)};
    placed.source[p] = {first, model.corner_skin[first], work.body[model.piece_body[p]].node};
  }
}

/// True if the views of the pieces refer to this Work and this model; in a copy of Work they refer to the original.
bool are_laid(const Model<2>& model, const Work<2>& work, const PlacedPieces& placed) {
  const auto pieces = static_cast<std::size_t>(model.pieces());
  if (placed.piece.size() != pieces || placed.over_step.size() != (work.skin_mean.empty() ? 0 : pieces)) return false;
  return pieces == 0 || (placed.piece[0].corner.data() == placed.place.data() &&
                         placed.piece[0].is_face.data() == model.edge_is_face.data());
}

/// move_piece() for a rigid piece after an explicit step, which needs no velocities of its corners.
void move_rigid_piece(const Model<2>& model, const State<2>& state, const Work<2>& work, const PieceSource& source,
                      Vec2* place, PlacedPiece& placed) {
  const int* const skin = model.corner_skin.data() + source.corner;
  const SkinMotion<2>* const of = work.skin.data();
  const std::size_t count = placed.corner.size();
  for (std::size_t c = 0; c < count; ++c) store_pair(place[c].data(), load_pair(&of[skin[c]].x));
  const int node = source.node;
  placed.origin = state.position[node], placed.velocity = state.velocity[node], placed.spin = state.spin[node];
}

/// Places a piece with its edges in `all`.
void place_sides(const Model<2>& model, const State<2>& state, const Work<2>& work, int piece, PlacedPieces& all) {
  PlacedPiece& placed = all.piece[piece];
  const PieceSource& source = all.source[piece];
  if (placed.corner_velocity.empty() && placed.over_step == nullptr)
    move_rigid_piece(model, state, work, source, &all.place[source.corner], placed);
  else
    move_piece(model, state, work, piece, piece_room(model, piece, all), placed);
  place_edges(placed.corner, &all.row[PlacedPieces::first_row(piece, source.corner)]);
}

}  // namespace

void place_none(const Model<2>& model, Work<2>& work) {
  PlacedPieces& placed = work.placed;
  const auto pieces = static_cast<std::size_t>(model.pieces());
  placed.is_placed.assign(pieces, 0);
  if (!are_laid(model, work, placed)) lay_pieces(model, work, placed);
}

void place_once(const Model<2>& model, const State<2>& state, Work<2>& work, int piece) {
  make_once(work.threads, work.placed.is_placed[static_cast<std::size_t>(piece)],
            [&] { place_sides(model, state, work, piece, work.placed); });
}

}  // namespace trilith
