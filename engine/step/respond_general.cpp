// Contacts of general shape: corners, deep overlap, pieces that tumble.
#include <algorithm>
#include <array>
#include <cassert>
#include <span>

#include "base/team.hpp"
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

/// `room` keeps what the piece's spans point to. Where an implicit step was taken it comes with its mean velocities
/// over the step, by which slip and losses go.
PlacedPiece placed_piece(const Model<2>& model, const State<2>& state, const Work<2>& work, int piece,
                         const PieceRoom& room) {
  const auto first = static_cast<std::size_t>(model.piece_first[piece]),
             count = static_cast<std::size_t>(model.corners_of(piece));
  for (std::size_t c = 0; c < count; ++c) {
    const SkinMotion<2>& s = work.skin[model.corner_skin[first + c]];
    room.place[c] = {s.x, s.y};
  }
  const Body& body = model.bodies[model.piece_body[piece]];
  const int node = body.first_node;
  PlacedPiece placed{std::span(room.place, count), std::span(model.edge_is_face).subspan(first, count),
                     state.position[node], state.velocity[node], state.spin[node]};
  if (!work.skin_mean.empty()) {
    for (std::size_t c = 0; c < count; ++c) room.mean[c] = work.skin_mean[model.corner_skin[first + c]];
    *room.over_step = placed;
    room.over_step->corner_velocity = std::span(room.mean, count);
    fit_rigid(*room.over_step);
    placed.over_step = room.over_step;
  }
  if (body.is_rigid()) return placed;
  for (std::size_t c = 0; c < count; ++c) {
    const SkinMotion<2>& s = work.skin[model.corner_skin[first + c]];
    room.velocity[c] = {s.u, s.v};
  }
  placed.corner_velocity = std::span(room.velocity, count);
  fit_rigid(placed);
  return placed;
}

namespace {

/// Room for all pieces, none of which is placed.
void place_none(const Model<2>& model, bool means, PlacedPieces& placed) {
  const auto pieces = static_cast<std::size_t>(model.pieces()), corners = model.corner_skin.size();
  placed.is_placed.assign(pieces, 0);
  placed.piece.resize(pieces);
  placed.over_step.resize(means ? pieces : 0);
  placed.place.resize(corners);
  placed.velocity.resize(corners);
  placed.mean.resize(means ? corners : 0);
  const std::size_t fours = PlacedPieces::first_four(model.pieces(), static_cast<int>(corners));
  placed.four.resize(fours);
  placed.row.resize(fours * lane_count);
}

/// A piece with its edges, placed by the first of its contacts that asks.
const PlacedPiece& place_once(const Model<2>& model, const State<2>& state, Work<2>& work, int piece) {
  PlacedPieces& all = work.placed;
  const auto p = static_cast<std::size_t>(piece);
  PlacedPiece& placed = all.piece[p];
  if (all.is_placed[p] != 0) return placed;
  all.is_placed[p] = 1;
  const int first = model.piece_first[piece];
  const bool means = !all.mean.empty();
  placed = placed_piece(model, state, work, piece,
                        {&all.place[first], &all.velocity[first], means ? &all.mean[first] : nullptr,
                         means ? &all.over_step[p] : nullptr});
  const std::size_t four = PlacedPieces::first_four(piece, first);
  placed.sides = {&all.four[four], &all.row[four * lane_count], surface_bits(placed.is_face)};
  place_edges(placed.corner, &all.four[four], &all.row[four * lane_count]);
  return placed;
}

void add_to_skin(const Model<2>& model, int piece, const Vec2* force, Work<2>& work) {
  const int *skin = &model.corner_skin[model.piece_first[piece]], count = model.corners_of(piece);
  Vec2* const on = work.skin_force.data();  // read once: the compiler cannot know that sums do not change it
  for (int c = 0; c < count; ++c) on[skin[c]] += force[c];
}

/// What two faces held that their contact does not as one of general shape.
/// Dilation that faces held open, halves crushed unlike: neither has a place in the overlap of areas.
ShapeLoss change_of_shape(const Work<2>& work, const NearPair& pair, const Remembered& before, const LawInUse& use) {
  return with_kernel(use, [&]<class K>(const K& law) {
    return law.leave_faces(face_overlap(work, pair), before.contact, law_memory<K>(before.law));
  });
}

/// What stays where the pieces of a row do not touch.
void part_row(const ContactHistory& before, ContactHistory& after, int row) {
  after.memory[row] = before.memory[row].parted();
  with_kernel_type(before.law_row[row].place, [&]<class K>() {
    keep_law_memory<K>(K::parted(law_memory<K>(before.law_numbers(row))), after.law_numbers(row));
  });
}

/// One evaluation's rows. Each is found from what State and its own row hold, and writes its own row alone.
struct GeneralPass {
  const Model<2>& model;
  const State<2>& state;
  const ContactHistory& before;
  Work<2>& work;
  double dt;

  /// False where there is nothing to be found out: the two were apart, and still are. What did not touch and remembers
  /// nothing has an empty row before and after already.
  [[nodiscard]] bool wakes(int row) const {
    const ContactMemory& memory = before.memory[row];
    if ((memory.state & contact_touching) != 0) return true;
    assert(!memory.empty() || work.contacts.memory[row].empty());
    if (!memory.empty()) part_row(before, work.contacts, row);
    // A pair found apart sleeps until the fastest point has gone far enough to have brought it together.
    return work.travel >= work.asleep_until[row];
  }
  /// The distance at which the edge that kept two pieces apart last still does; else 0 [m].
  [[nodiscard]] double still_apart(const PlacedPiece& a, const PlacedPiece& b, int row) const {
    const int by = work.pairs[row].apart_by, e = by % max_piece_corners;
    const PlacedPiece &owner = by < max_piece_corners ? a : b, &other = by < max_piece_corners ? b : a;
    if (by < 0 || e >= static_cast<int>(owner.corner.size())) return 0;
    return distance_outside(owner.sides.row[e], other.corner);
  }
  void sleep(int row, double distance) const {
    // Each of the two may come nearer by the path of the fastest point.
    work.asleep_until[row] = work.travel + 0.5 * (1 - 1e-9) * distance;
  }
  /// Whether one corner under one face has an answer of its own under the law of a pair, which remembers `memory`.
  [[nodiscard]] bool knows_corners(const NearPair& pair, const ContactMemory& memory) const {
    return is_plain_friction(model.laws[pair.law]) && !pair.replaced &&
           (memory.empty() || (memory.state & contact_general) != 0);
  }
  [[nodiscard]] Coulomb friction_of(int law) const {
    return with_kernel(law_in_use(model, law, dt), [](const Coulomb& kernel) { return kernel; });
  }
  void respond_rows(std::span<const int> rows, OverlapAnswer* answers) const;
  void respond(int row, OverlapAnswer& answer) const;
  void finish(int row, OverlapAnswer& answer) const;
  void take_up(int row, const OverlapAnswer& answer) const;
};

/// Rows of one law in which a corner was below a face last, to be answered together.
struct CornerRows {
  std::array<CornerCase, lane_count> pair;
  std::array<int, lane_count> row;
  std::array<OverlapAnswer*, lane_count> answer;
  std::size_t count = 0;
  int law = -1;

  void add(int r, int l, const CornerCase& of, OverlapAnswer& to) {
    pair[count] = of, row[count] = r, answer[count] = &to;
    law = l;
    ++count;
  }
};

/// One corner of a pair under one face of it, as it was last; there may be no such corner or face.
bool there_is(const CornerOnFace& at, const PlacedPiece& a, const PlacedPiece& b) {
  const PlacedPiece &wedge = at.wedge_is_b ? b : a, &owner = at.wedge_is_b ? a : b;
  return at.corner < wedge.corner.size() && at.face < owner.corner.size();
}

/// Makes an answer ready to be written.
void clear(OverlapAnswer& answer, const PlacedPiece& a, const PlacedPiece& b) {
  answer.changed = answer.touching = false;
  answer.let_go = {};
  std::fill_n(answer.on_a.begin(), a.corner.size(), Vec2::Zero());
  std::fill_n(answer.on_b.begin(), b.corner.size(), Vec2::Zero());
}

/// The corner that a row had last is tried first, with those of the next rows, four at once; what it does not hold for
/// is looked at by itself. `answers`: one for each row.
void GeneralPass::respond_rows(std::span<const int> rows, OverlapAnswer* answers) const {
  CornerRows waiting;
  const auto answer_waiting = [&] {
    if (waiting.count == 0) return;
    const std::uint32_t done = respond_corners(std::span(waiting.pair).first(waiting.count), friction_of(waiting.law));
    for (std::size_t k = 0; k < waiting.count; ++k)
      (done >> k & 1U) != 0 ? finish(waiting.row[k], *waiting.answer[k]) : respond(waiting.row[k], *waiting.answer[k]);
    waiting.count = 0;
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const int row = rows[i];
    const NearPair& pair = work.pairs[row];
    const ContactMemory& memory = before.memory[row];
    if (!pair.corner_at.is_there() || !knows_corners(pair, memory)) {
      respond(row, answers[i]);
      continue;
    }
    const PlacedPiece &a = place_once(model, state, work, pair.piece_a),
                      &b = place_once(model, state, work, pair.piece_b);
    if (!there_is(pair.corner_at, a, b) || !has_plain_corners(a) || !has_plain_corners(b)) {
      respond(row, answers[i]);
      continue;
    }
    if (waiting.count > 0 && waiting.law != pair.law) answer_waiting();
    clear(answers[i], a, b);
    waiting.add(row, pair.law,
                {&a, &b, pair.corner_at, &memory, &answers[i].response, answers[i].on_a, answers[i].on_b}, answers[i]);
    if (waiting.count == waiting.pair.size()) answer_waiting();
  }
  answer_waiting();
}

/// A row that wakes. Its pieces are placed by now, or are by this.
void GeneralPass::respond(int row, OverlapAnswer& answer) const {
  answer.changed = answer.touching = false;
  answer.let_go = {};
  const ContactMemory& memory = before.memory[row];
  const bool was = (memory.state & contact_touching) != 0;
  NearPair& pair = work.pairs[row];
  OverlapResponse& r = answer.response;
  // A bearing carries what its two faces would: flat contact is held off, a corner that strikes is not.
  if (NearPair flat = pair; pair.replaced && choose_face_pair(model, work, false, flat)) {
    if (was) part_row(before, work.contacts, row);
    r = {};
    answer.changed = was;
    return;
  }
  const PlacedPiece &a = place_once(model, state, work, pair.piece_a),
                    &b = place_once(model, state, work, pair.piece_b);
  if (memory.empty())
    if (const double distance = still_apart(a, b, row); distance > 0) return r = {}, sleep(row, distance);
  clear(answer, a, b);
  // What one corner comes to is found in one way, remembered or not, or bits would depend on it.
  if (knows_corners(pair, memory) && has_plain_corners(a) && has_plain_corners(b)) {
    pair.corner_at = corner_within(a, b);
    const CornerCase one{&a, &b, pair.corner_at, &memory, &r, answer.on_a, answer.on_b};
    if (pair.corner_at.is_there() && respond_corners({&one, 1}, friction_of(pair.law)) != 0) return finish(row, answer);
  }
  const LawInUse law = law_in_use(model, pair.law, dt);
  const Remembered remembered{memory, before.law_numbers(row)};
  r = respond_overlap(a, b, remembered, law, answer.on_a, answer.on_b, work.contacts.law_numbers(row));
  if (was && (memory.state & contact_general) == 0) answer.let_go = change_of_shape(work, pair, remembered, law);
  finish(row, answer);
}

/// What a response means for its row: whether anything changed, what is remembered, how long it may sleep.
void GeneralPass::finish(int row, OverlapAnswer& answer) const {
  const ContactMemory& memory = before.memory[row];
  const OverlapResponse& r = answer.response;
  const bool was = (memory.state & contact_touching) != 0;
  answer.changed =
      was != r.touching || memory.bonds != 0 || (memory.state & contact_kept) != (r.memory.state & contact_kept);
  if (was || r.touching) work.contacts.memory[row] = r.memory;
  answer.touching = r.touching;
  if (r.touching) return;
  work.pairs[row].apart_by = static_cast<std::int16_t>(r.apart_by);
  sleep(row, r.separation);
}

/// Adds what a row came to to forces, ledger and lists.
void GeneralPass::take_up(int row, const OverlapAnswer& answer) const {
  const OverlapResponse& r = answer.response;
  if (answer.changed) work.changed_rows.push_back(row);
  work.given[EnergyTerm::contact_friction] += answer.let_go.friction;
  work.given[EnergyTerm::contact_fracture] += answer.let_go.fracture;
  work.given[EnergyTerm::contact_damping] += r.lost_damping;
  work.given[EnergyTerm::contact_friction] += r.lost_friction;
  work.given[EnergyTerm::contact_fracture] += r.lost_fracture;
  if (!answer.touching) return;
  add_to_skin(model, work.pairs[row].piece_a, answer.on_a.data(), work);
  add_to_skin(model, work.pairs[row].piece_b, answer.on_b.data(), work);
  work.general_touching.push_back({row, r.length, r.depth, r.centre, r.force});
}

/// Rows and pieces that threads take at a time: some ten microseconds.
constexpr int general_stretch = 32, awake_stretch = 128, waking_stretch = 1024;

/// Rows of general shape, and those that were to be faces and are not now, in the order of rows; of these `awake_rows`
/// are worked on.
void list_rows(const GeneralPass& pass, Work<2>& work) {
  std::sort(work.general_now.begin(), work.general_now.end());
  work.general_rows.reserve(work.pairs.size());
  work.general_rows.resize(work.general.size() + work.general_now.size());
  std::merge(work.general.begin(), work.general.end(), work.general_now.begin(), work.general_now.end(),
             work.general_rows.begin());
  work.awake_rows.reserve(work.pairs.size());
  work.awake_rows.clear();
  const std::size_t count = work.general_rows.size();
  if (work.threads <= 1 || count <= waking_stretch) {
    for (const int row : work.general_rows)
      if (pass.wakes(row)) work.awake_rows.push_back(row);
    return;
  }
  work.is_awake.resize(count);
  share(work.threads, static_cast<int>(count), waking_stretch, [&](int first, int last, int /*thread*/) {
    for (int i = first; i < last; ++i) work.is_awake[i] = pass.wakes(work.general_rows[i]) ? 1 : 0;
  });
  for (std::size_t i = 0; i < count; ++i)
    if (work.is_awake[i] != 0) work.awake_rows.push_back(work.general_rows[i]);
}

/// All pieces of the rows to come: where several threads respond, none may place what another reads.
void place_awake(const GeneralPass& pass, Work<2>& work) {
  work.awake_pieces.clear();
  for (const int row : work.awake_rows)
    for (const int piece : {work.pairs[row].piece_a, work.pairs[row].piece_b}) {
      std::uint8_t& listed = work.placed.is_placed[static_cast<std::size_t>(piece)];
      if (listed == 0) work.awake_pieces.push_back(piece);
      listed = 1;
    }
  for (const int piece : work.awake_pieces) work.placed.is_placed[static_cast<std::size_t>(piece)] = 0;
  share(work.threads, static_cast<int>(work.awake_pieces.size()), awake_stretch,
        [&](int first, int last, int /*thread*/) {
          for (int i = first; i < last; ++i) place_once(pass.model, pass.state, work, work.awake_pieces[i]);
        });
}

}  // namespace

/// Several threads answer the rows; the answers are taken up in the order of rows, so that sums and lists have the bits
/// of one row after the other.
void respond_general(const Model<2>& model, const State<2>& state, Work<2>& work, double dt) {
  work.general_touching.clear();
  if (work.general.empty() && work.general_now.empty()) return work.general_rows.clear();
  const GeneralPass pass{model, state, contacts_before(state, work), work, dt};
  list_rows(pass, work);
  place_none(model, !work.skin_mean.empty(), work.placed);
  if (work.threads > 1) place_awake(pass, work);
  work.answer.resize(static_cast<std::size_t>(stretches_under_way(work.threads)) * general_stretch);
  const auto answer_of = [&](int slot, int i) -> OverlapAnswer& {
    return work.answer[static_cast<std::size_t>(slot * general_stretch + i)];
  };
  share_in_order(
      work.threads, static_cast<int>(work.awake_rows.size()), general_stretch,
      [&](int first, int last, int /*thread*/, int slot) {
        const auto count = static_cast<std::size_t>(last - first);
        pass.respond_rows(std::span(work.awake_rows).subspan(static_cast<std::size_t>(first), count),
                          &answer_of(slot, 0));
      },
      [&](int first, int last, int slot) {
        for (int i = first; i < last; ++i) pass.take_up(work.awake_rows[i], answer_of(slot, i - first));
      });
}

}  // namespace trilith
