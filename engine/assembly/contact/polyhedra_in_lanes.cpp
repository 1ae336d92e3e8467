// Rows of polyhedra that are left to the kernels of four.
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "assembly/contact/moving_solid.hpp"
#include "assembly/contact/pair_sleeping.hpp"
#include "assembly/contact/shared_edge_normal.hpp"
#include "assembly/contact/solid_pass.hpp"
#include "base/ask_for.hpp"
#include "contact/plane/edge_pressure.hpp"

namespace trilith {

namespace {

/// Topologies of the overlaps that this thread has evaluated. They save time and change no result, so they belong to
/// the thread instead of to Work.
OverlapMemory& overlaps_of_thread() {
  thread_local OverlapMemory overlaps;
  return overlaps;
}

}  // namespace

/// True if a row may be left to a kernel of four. Meshed bodies, bearings, and all bodies under an implicit scheme are
/// evaluated one by one.
inline bool SolidPass::fits_lanes(const NearPair& pair) const {
  return !model.is_fitted(pair.piece_a) && !model.is_fitted(pair.piece_b) && work.solids.behind.empty() &&
         !pair.replaced && work.solids.law[static_cast<std::size_t>(pair.law)].is_linear;
}

/// Evaluates two pieces with few faces that lie flat on each other, or sums their pressed triangles for the kernel of
/// four if they surely overlap.
FastResponse SolidPass::respond_fast(int row, bool may_be_flat, SolidRoom& room, PressedRows& pressed,
                                     SolidAnswer& answer) const {
  const auto r = static_cast<std::size_t>(row);
  const NearPair& pair = work.pairs[r];
  Vec3 along;
  if (!fits_lanes(pair) || !have_few_faces(work.solids.placed[pair.piece_a], work.solids.placed[pair.piece_b]) ||
      (!work.met.empty() && direction_at_shared_edges(work, row, along)))
    return FastResponse::unfit;
  const MovingSolid a = moving_solid(model, state, work, pair.piece_a),
                    b = moving_solid(model, state, work, pair.piece_b);
  Separation3& apart = work.solids.separation[r];
  if (FaceOverlap3 faces; may_be_flat && flat_faces(a.placed, b.placed, faces)) {
    apart.distance = 0;
    const LawInUse law{model.laws[pair.law], model.thickness, dt};
    respond_pressure(row, a, b, law, face_pressure(a, b, plain_friction(law), faces), room, answer);
    return FastResponse::given;
  }
  const double beta = work.solids.law[static_cast<std::size_t>(pair.law)].beta;
  // A topology is stored only for a pair that touched in the last step. Pairs close to contact would replace records
  // that are used again.
  const bool was_touching = (contacts_before(state, work).memory[r].state & contact_touching) != 0;
  OverlapTopology* const known = was_touching ? &overlaps_of_thread().of(a.placed, b.placed) : nullptr;
  if (!edge_sums(a, b, beta, room.shared.triangles, pressed.next(), known)) return FastResponse::failed;
  pressed.add(row), answer.row = triangles_to_come;
  apart.distance = 0;
  return FastResponse::given;
}

/// True if a row may be two faces that lie flat, and no other pair of faces of the two pieces. The time of a repeated
/// test does not change any result.
bool SolidPass::looks_flat(int row) const {
  const NearPair& pair = work.pairs[row];
  if (!fits_lanes(pair)) return false;
  FacePair& faces = work.solids.faces[static_cast<std::size_t>(row)];
  if (const double way = way_of(work, pair); way >= faces.until) {
    const std::int32_t kind = faces.kind;
    faces = facing_pair(work.solids.placed[pair.piece_a], work.solids.placed[pair.piece_b], way);
    faces.kind = kind;
    faces.node_a = model.node_of_piece(pair.piece_a), faces.node_b = model.node_of_piece(pair.piece_b);
  }
  return faces.a >= 0;
}

/// True if a row is known to lie flat without a test, as most rows of a wall. In a list of pairs without bearings, a
/// row that looked flat keeps the properties that looks_flat() tests until it may have changed. False leaves the
/// question open.
inline bool SolidPass::is_flat_still(std::size_t row, const Contacts<3>& before) const {
  const FacePair& faces = work.solids.faces[row];
  return (before.memory[row].state & contact_touching) != 0 && way_of(work, work.pairs[row]) < faces.until &&
         faces.a >= 0 && before.joint_at(row) == nullptr && model.bearings.empty() && work.solids.behind.empty();
}

namespace {

/// True if the faces lie flat and rounding does not prevent the result of the kernel.
bool is_answered(const FlatResponses& out, std::size_t i) {
  const auto lane = static_cast<int>(i);
  return out.rough[lane] == 0 && out.flat[lane] != 0;
}

}  // namespace

/// Writes the answer of a row with flat faces except for its largest part; `places` receives the destination of that
/// part.
inline void SolidPass::begin_answer(const FlatResponses& out, std::size_t i, int row, SolidAnswer& answer,
                                    FlatPlaces& places) const {
  const auto r = static_cast<std::size_t>(row);
  const FacePair& faces = work.solids.faces[r];
  SolidMemory& memory = work.contacts.memory[r];
  const auto lane = static_cast<int>(i);
  answer.row = row, answer.joint_changed = false;
  answer.was_touching = (contacts_before(state, work).memory[r].state & contact_touching) != 0;
  answer.touching = out.presses[lane] != 0;
  answer.carrier_a = faces.node_a, answer.carrier_b = faces.node_b;
  // For touching rows it is 0 already.
  if (!answer.was_touching || !answer.touching) work.solids.separation[r].distance = 0;
  if (answer.touching) return places.set(i, answer, memory, work.solids.areas[r]);
  answer.lost_damping = out.lost_damping[lane], answer.lost_friction = out.lost_friction[lane];
  answer.lost_fracture = 0;
  memory = {};
}

/// Completes the rows that a kernel of four has answered.
inline void SolidPass::take_four(const FlatResponses& out, std::span<const int> rows, int first,
                                 SolidAnswer* answers) const {
  std::array<double, 20> nowhere;
  FlatPlaces places(nowhere);
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (is_answered(out, i)) begin_answer(out, i, rows[i], answers[rows[i] - first], places);
  store_flat(out, places);
}

/// Evaluates four rows of faces in lanes. Lanes beyond the last row repeat it.
inline void SolidPass::face_contact_forces(std::span<const int> rows, int first, SolidRoom& room, PressedRows& pressed,
                                           SolidAnswer* answers) const {
  FlatContacts in;
  FlatResponses out;
  std::array<int, lane_count> row;
  for (std::size_t i = 0; i < row.size(); ++i) row[i] = rows[std::min(i, rows.size() - 1)];
  load_flat(state, work, row, dt, in);
  respond_flat(in, out);
  take_four(out, rows, first, answers);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto lane = static_cast<int>(i);
    work.solids.faces[static_cast<std::size_t>(rows[i])].kind = static_cast<std::int32_t>(out.kind[lane]);
    if (is_answered(out, i)) continue;
    SolidAnswer& answer = answers[rows[i] - first];
    answer.row = -1;
    respond_other(rows[i], out.rough[lane] != 0, room, pressed, answer);
    if (pressed.full()) pressed_contact_forces(pressed, first, room, answers);
  }
}

/// Evaluates up to four rows of any shape in lanes. A row without area, to rounding, is cut.
void SolidPass::pressed_contact_forces(PressedRows& pressed, int first, SolidRoom& room, SolidAnswer* answers) const {
  const std::size_t count = pressed.rows().size();
  if (count == 0) return;
  PressedContacts in;
  FlatResponses out;
  const std::array<int, lane_count> row = pressed.take(in);
  load_contacts(state, work, row, dt, in);
  respond_pressed(in, out);
  const std::span rows = std::span(row).first(count);
  take_four(out, rows, first, answers);
  for (std::size_t i = 0; i < count; ++i)
    if (!is_answered(out, i)) respond_shapes(rows[i], false, false, room, answers[rows[i] - first]);
}

/// Prefetches the memory of a row with flat faces, which is scattered in large models.
inline void SolidPass::ask_early(int row) const {
  const auto r = static_cast<std::size_t>(row);
  ask_for<Asked::read, sizeof(SolidMemory)>(&contacts_before(state, work).memory[r]);
  ask_for<Asked::write, sizeof(SolidMemory)>(&work.contacts.memory[r]);
  ask_for<Asked::write, sizeof(ContactArea)>(&work.solids.areas[r]);
}

/// Evaluates rows one by one, except rows for the kernels of four. Flat faces are evaluated four of a kind at a time,
/// separately for faces with few and with many corners. The grouping does not change the results.
void SolidPass::respond(int first, int last, SolidRoom& room, SolidAnswer* answers) const {
  RowsByKind flat;
  PressedRows pressed;
  const Contacts<3>& before = contacts_before(state, work);
  for (int row = first; row < last; ++row) {
    const auto r = static_cast<std::size_t>(row);
    if (!is_flat_still(r, before)) {
      SolidAnswer& answer = answers[row - first];
      answer.row = -1;
      respond_alone(row, room, pressed, answer);
      if (pressed.full()) pressed_contact_forces(pressed, first, room, answers);
      if (answer.row != faces_to_come) continue;
    }
    flat.put(row - first, work.solids.faces[r]);
  }
  const std::span<const std::uint8_t> order = flat.ordered();
  const auto row_at = [&](std::size_t i) { return first + order[i]; };
  const auto few_at = [&](std::size_t i) { return work.solids.faces[static_cast<std::size_t>(row_at(i))].few; };
  std::array<int, lane_count> four;
  std::size_t taken = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    four[taken++] = row_at(i);
    if (taken < four.size() && i + 1 < order.size() && few_at(i + 1) == few_at(i)) continue;
    for (std::size_t k = i + 1; k < std::min(i + 1 + four.size(), order.size()); ++k) ask_early(row_at(k));
    face_contact_forces({four.data(), taken}, first, room, pressed, answers);
    taken = 0;
  }
  pressed_contact_forces(pressed, first, room, answers);
}

}  // namespace trilith
