// Contacts of general shape: corners, deep overlap, pieces that tumble.
#include <algorithm>
#include <array>

#include "detect/pairs.hpp"
#include "step/contact_rows.hpp"
#include "step/evaluate.hpp"
#include "step/stored_energy.hpp"

namespace trilith {

namespace {

/// An element moves in a general contact as the rigid piece that fits its corners best.
PlacedPiece deformed_piece(const Model<2>& model, const Work<2>& work, int piece, std::span<const Vec2> corners) {
  const int first = model.piece_first[piece], count = model.corners_of(piece);
  Vec2 place = Vec2::Zero(), velocity = Vec2::Zero();
  for (int c = 0; c < count; ++c) {
    const SkinMotion& s = work.skin[model.corner_skin[first + c]];
    place += corners[c] / count;
    velocity += Vec2(s.u, s.v) / count;
  }
  double turn = 0, size = 0;
  for (int c = 0; c < count; ++c) {
    const SkinMotion& s = work.skin[model.corner_skin[first + c]];
    const Vec2 arm = corners[c] - place;
    turn += cross(arm, Vec2(s.u, s.v));
    size += arm.squaredNorm();
  }
  return {corners, std::span(model.edge_is_face).subspan(static_cast<std::size_t>(first), corners.size()), place,
          velocity, size > 0 ? turn / size : 0};
}

}  // namespace

PlacedPiece placed_piece(const Model<2>& model, const State<2>& state, const Work<2>& work, int piece,
                         std::span<Vec2> corners) {
  const int first = model.piece_first[piece], count = model.corners_of(piece);
  for (int c = 0; c < count; ++c) {
    const SkinMotion& s = work.skin[model.corner_skin[first + c]];
    corners[c] = {s.x, s.y};
  }
  const Body& body = model.bodies[model.piece_body[piece]];
  const int node = body.first_node;
  if (body.deforms()) return deformed_piece(model, work, piece, corners.first(static_cast<std::size_t>(count)));
  return {corners.first(static_cast<std::size_t>(count)),
          std::span(model.edge_is_face).subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(count)),
          state.position[node], state.velocity[node], state.spin[node]};
}

namespace {

using Corners = std::array<Vec2, max_piece_corners>;

void add_to_skin(const Model<2>& model, int piece, const Corners& force, Work<2>& work) {
  const int first = model.piece_first[piece];
  for (int c = 0; c < model.corners_of(piece); ++c) work.skin_force[model.corner_skin[first + c]] += force[c];
}

void respond_row(const Model<2>& model, const State<2>& state, Work<2>& work, int row, double dt) {
  const ContactMemory& before = state.memory[row];
  ContactMemory& after = work.memory[row];
  const bool was = (before.state & contact_touching) != 0;
  after = {};
  if (!was && work.travel < work.asleep_until[row]) return;
  const NearPair& pair = work.pairs[row];
  if (NearPair flat = pair; pair.held_off && choose_face_pair(model, work, false, flat)) {
    if (was) work.turned.push_back(row);
    return;
  }
  Corners corners_a, corners_b, on_a, on_b;
  const PlacedPiece a = placed_piece(model, state, work, pair.piece_a, corners_a);
  const PlacedPiece b = placed_piece(model, state, work, pair.piece_b, corners_b);
  std::fill_n(on_a.begin(), a.corner.size(), Vec2::Zero());
  std::fill_n(on_b.begin(), b.corner.size(), Vec2::Zero());
  const FaceLaw law = face_law(model, pair.law, dt);
  const OverlapResponse r = respond_overlap(a, b, before, law, on_a, on_b);
  if (law.dilation > 0 && was && (before.state & contact_general) == 0)
    work.given[EnergyTerm::contact_friction] += dilation_energy(work, pair, before, law);
  if (was != r.touching || before.bonds != 0) work.turned.push_back(row);
  work.given[EnergyTerm::contact_damping] += r.lost_damping;
  work.given[EnergyTerm::contact_friction] += r.lost_friction;
  if (!r.touching) {
    // Each of the two may come nearer by the path of the fastest point.
    work.asleep_until[row] = work.travel + 0.5 * (1 - 1e-9) * r.separation;
    return;
  }
  after = r.memory;
  if (law.dilation > 0) after.state |= contact_worn;
  add_to_skin(model, pair.piece_a, on_a, work);
  add_to_skin(model, pair.piece_b, on_b, work);
  work.general_touching.push_back({row, r.length, r.centre, r.force});
}

}  // namespace

void respond_general(const Model<2>& model, const State<2>& state, Work<2>& work, double dt) {
  work.general_touching.clear();
  work.general_now.insert(work.general_now.end(), work.general.begin(), work.general.end());
  std::sort(work.general_now.begin(), work.general_now.end());
  for (const int row : work.general_now) respond_row(model, state, work, row, dt);
}

}  // namespace trilith
