// Contacts of general shape: corners, deep overlap, pieces that tumble.
#include <algorithm>
#include <array>

#include "detect/pairs.hpp"
#include "step/contact_rows.hpp"
#include "step/evaluate.hpp"

namespace trilith {

namespace {

/// The velocity and spin of the rigid piece that fits the corners of a piece that deforms best.
/// Least squares over its corners: the mean velocity, and spin = sum of r x v / sum of r^2 about their mean place.
void fit_rigid(PlacedPiece& piece) {
  const auto count = piece.corner.size();
  piece.origin = piece.velocity = Vec2::Zero();
  for (std::size_t c = 0; c < count; ++c) {
    piece.origin += piece.corner[c] / static_cast<double>(count);
    piece.velocity += piece.corner_velocity[c] / static_cast<double>(count);
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

/// `corners` keeps what the piece's spans point to. Where an implicit step was taken it comes with its mean velocities
/// over the step, by which slip and losses go.
PlacedPiece placed_piece(const Model<2>& model, const State<2>& state, const Work<2>& work, int piece,
                         PieceCorners& corners) {
  const auto first = static_cast<std::size_t>(model.piece_first[piece]),
             count = static_cast<std::size_t>(model.corners_of(piece));
  for (std::size_t c = 0; c < count; ++c) {
    const SkinMotion<2>& s = work.skin[model.corner_skin[first + c]];
    corners.place[c] = {s.x, s.y};
  }
  const Body& body = model.bodies[model.piece_body[piece]];
  const int node = body.first_node;
  PlacedPiece placed{std::span(corners.place).first(count), std::span(model.edge_is_face).subspan(first, count),
                     state.position[node], state.velocity[node], state.spin[node]};
  if (!work.skin_mean.empty()) {
    for (std::size_t c = 0; c < count; ++c) corners.mean[c] = work.skin_mean[model.corner_skin[first + c]];
    corners.over_step = placed;
    corners.over_step.corner_velocity = std::span(corners.mean).first(count);
    fit_rigid(corners.over_step);
    placed.over_step = &corners.over_step;
  }
  if (body.is_rigid()) return placed;
  for (std::size_t c = 0; c < count; ++c) {
    const SkinMotion<2>& s = work.skin[model.corner_skin[first + c]];
    corners.velocity[c] = {s.u, s.v};
  }
  placed.corner_velocity = std::span(corners.velocity).first(count);
  fit_rigid(placed);
  return placed;
}

namespace {

using Corners = std::array<Vec2, max_piece_corners>;

void add_to_skin(const Model<2>& model, int piece, const Corners& force, Work<2>& work) {
  const int first = model.piece_first[piece];
  for (int c = 0; c < model.corners_of(piece); ++c) work.skin_force[model.corner_skin[first + c]] += force[c];
}

/// What two faces held that their contact does not as one of general shape.
/// Dilation that faces held open, halves crushed unlike: neither has a place in the overlap of areas.
void book_change_of_shape(Work<2>& work, const NearPair& pair, const Remembered& before, const LawInUse& use) {
  const ShapeLoss lost = with_kernel(use, [&]<class K>(const K& law) {
    return law.leave_faces(face_overlap(work, pair), before.contact, law_memory<K>(before.law));
  });
  work.given[EnergyTerm::contact_friction] += lost.friction;
  work.given[EnergyTerm::contact_fracture] += lost.fracture;
}

/// What stays where the pieces of a row do not touch.
void part_row(const ContactHistory& before, ContactHistory& after, int row) {
  after.memory[row] = before.memory[row].parted();
  with_kernel_type(before.law_row[row].place, [&]<class K>() {
    keep_law_memory<K>(K::parted(law_memory<K>(before.law_numbers(row))), after.law_numbers(row));
  });
}

void respond_row(const Model<2>& model, const State<2>& state, Work<2>& work, int row, double dt) {
  const ContactHistory& contacts = contacts_before(state, work);
  const ContactMemory& before = contacts.memory[row];
  ContactMemory& after = work.contacts.memory[row];
  const bool was = (before.state & contact_touching) != 0;
  // First as if it did not touch; written over below where it does.
  part_row(contacts, work.contacts, row);
  // A pair found apart sleeps until the fastest point has gone far enough to have brought it together.
  if (!was && work.travel < work.asleep_until[row]) return;
  const NearPair& pair = work.pairs[row];
  // A bearing carries what its two faces would: flat contact is held off, a corner that strikes is not.
  if (NearPair flat = pair; pair.replaced && choose_face_pair(model, work, false, flat)) {
    if (was) work.changed_rows.push_back(row);
    return;
  }
  PieceCorners corners_a, corners_b;
  Corners on_a, on_b;
  const PlacedPiece a = placed_piece(model, state, work, pair.piece_a, corners_a);
  const PlacedPiece b = placed_piece(model, state, work, pair.piece_b, corners_b);
  std::fill_n(on_a.begin(), a.corner.size(), Vec2::Zero());
  std::fill_n(on_b.begin(), b.corner.size(), Vec2::Zero());
  const LawInUse law = law_in_use(model, pair.law, dt);
  const Remembered remembered{before, contacts.law_numbers(row)};
  const OverlapResponse r = respond_overlap(a, b, remembered, law, on_a, on_b, work.contacts.law_numbers(row));
  if (was && (before.state & contact_general) == 0) book_change_of_shape(work, pair, remembered, law);
  if (was != r.touching || before.bonds != 0 || (before.state & contact_kept) != (r.memory.state & contact_kept))
    work.changed_rows.push_back(row);
  work.given[EnergyTerm::contact_damping] += r.lost_damping;
  work.given[EnergyTerm::contact_friction] += r.lost_friction;
  work.given[EnergyTerm::contact_fracture] += r.lost_fracture;
  if (!r.touching) {
    // Each of the two may come nearer by the path of the fastest point.
    work.asleep_until[row] = work.travel + 0.5 * (1 - 1e-9) * r.separation;
    return;
  }
  after = r.memory;
  add_to_skin(model, pair.piece_a, on_a, work);
  add_to_skin(model, pair.piece_b, on_b, work);
  work.general_touching.push_back({row, r.length, r.depth, r.centre, r.force});
}

}  // namespace

/// Rows of general shape, and those that were to be faces and are not now, in the order of rows.
void respond_general(const Model<2>& model, const State<2>& state, Work<2>& work, double dt) {
  work.general_touching.clear();
  work.general_now.insert(work.general_now.end(), work.general.begin(), work.general.end());
  std::sort(work.general_now.begin(), work.general_now.end());
  for (const int row : work.general_now) respond_row(model, state, work, row, dt);
}

}  // namespace trilith
