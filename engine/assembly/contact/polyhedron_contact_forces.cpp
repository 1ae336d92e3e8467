// Contacts in space: faces with or without bond, any other shape, or apart by the last separating axis.
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "assembly/contact/flat_contact_simd.hpp"
#include "assembly/contact/general_contact_partition.hpp"
#include "assembly/contact/moving_solid.hpp"
#include "assembly/contact/pair_sleeping.hpp"
#include "assembly/contact/rows_by_kind.hpp"
#include "assembly/contact/shared_edge_normal.hpp"
#include "assembly/contact/solid_joints.hpp"
#include "assembly/evaluate.hpp"
#include "assembly/single_terms.hpp"
#include "base/ask_for.hpp"
#include "base/team.hpp"
#include "broad_phase/bearing_rules.hpp"
#include "contact/joint/joint.hpp"
#include "contact/space/flat_contact.hpp"
#include "contact/space/sphere_contact.hpp"

namespace trilith {
namespace {

/// Rows per chunk of a thread, about 20 microseconds if they touch. A chunk of this size usually contains four rows of
/// a kind (FlatResponses::kind) and four more.
constexpr int solid_row_stretch = 64;
static_assert(solid_row_stretch <= RowsByKind::most);
/// Mark of an answer: the row is left to the kernel of flat faces.
constexpr int faces_to_come = -2;

/// Position of a contact frame (model/contact/contact_frame.hpp) [m].
const Vec3& place_of(const State<3>& state, const Work<3>& work, int contact_frame) {
  return contact_frame < 0 ? work.solids.fitted[static_cast<std::size_t>(-1 - contact_frame)].place
                           : state.position[static_cast<std::size_t>(contact_frame)];
}

/// Input of the rows of one evaluation. Each row writes its own data alone, and `room`.
struct SolidPass {
  const Model<3>& model;
  const State<3>& state;
  Work<3>& work;
  double dt;

  void respond(int first, int last, SolidRoom& room, SolidAnswer* answers) const;

 private:
  void respond_bonded(int row, const JointMemory& before, SolidRoom& room, SolidAnswer& answer) const;
  void respond_alone(int row, SolidRoom& room, SolidAnswer& answer) const;
  void respond_shapes(int row, bool may_be_flat, SolidRoom& room, SolidAnswer& answer) const;
  void respond_beside_bearing(int row, const MovingSolid& a, const MovingSolid& b, const SolidPressure& whole,
                              SolidRoom& room, SolidAnswer& answer) const;
  void face_contact_forces(std::span<const int> rows, int first, SolidRoom& room, SolidAnswer* answers) const;
  void begin_answer(const FlatResponses& out, std::size_t i, int row, SolidAnswer& answer, FlatPlaces& places) const;
  void ask_early(int row) const;
  [[nodiscard]] bool stays_apart(int row) const;
  [[nodiscard]] bool looks_flat(int row) const;
  [[nodiscard]] bool is_flat_still(std::size_t row, const Contacts<3>& before) const;
  void finish(int row, bool joint_changed, const SolidResponse& response, SolidAnswer& answer) const;
};

/// Evaluates faces that mortar bonds, or did until now.
void SolidPass::respond_bonded(int row, const JointMemory& before, SolidRoom& room, SolidAnswer& answer) const {
  const auto r = static_cast<std::size_t>(row);
  const NearPair& pair = work.pairs[r];
  JointMemory& after = *work.contacts.joint_at(r);
  const LawInUse law{model.laws[pair.law], model.thickness, dt};
  const SolidMemory& contact = contacts_before(state, work).memory[r];
  JointResponse joint =
      respond_joint(body_motion(model, state, work, pair.piece_a, before.plan->face_a),
                    body_motion(model, state, work, pair.piece_b, before.plan->face_b), contact, before, law, after);
  joint.contact.face_a = before.plan->face_a, joint.contact.face_b = before.plan->face_b;
  if (joint.ends) {
    // If the joint stores more energy than an unbonded contact in this position, the difference is dissipated when it
    // ends.
    const double left = !joint.contact.touching
                            ? 0.0
                            : solid_contact_energy(work.solids.placed[pair.piece_a], work.solids.placed[pair.piece_b],
                                                   joint.contact.memory, law, room.shared, room.part);
    joint.contact.lost_friction += joint_energy(after, law) - left;
    after = {};
    work.solids.separation[r].distance = 0;
  }
  finish(row, joint.changed, joint.contact, answer);
  answer.was_touching = true;
}

/// moving_solid() of a piece that may be a sphere: its centre and radius in addition to its corners, of which a sphere
/// has one. `face`: see leading_face.
SphereSide sphere_side(const Model<3>& model, const State<3>& state, const Work<3>& work, int piece, int face) {
  const MovingSolid moving = moving_solid(model, state, work, piece).by_face(face);
  return {work.solids.sphere[piece], moving.placed, moving.origin, moving.velocity, moving.spin, moving.behind};
}

/// The face of a deforming piece that a sphere is nearest to, -1 for other pieces.
int face_near_sphere(const Model<3>& model, const State<3>& state, const Work<3>& work, int piece, int sphere) {
  if (!model.is_fitted(piece)) return -1;
  const MovingSolid of = moving_solid(model, state, work, piece);
  const Vec3& centre = work.solids.placed[sphere].corners[0];
  int best = -1;
  for (int f = 0; f < of.placed.solid->shape.faces.count(); ++f)
    if (of.placed.solid->is_surface(f) &&
        (best < 0 || depth_below(of.placed, f, centre) < depth_below(of.placed, best, centre)))
      best = f;
  return best;
}

/// Evaluates a row by itself. The answer remains empty if the pieces were apart and still are. Marks rows that are left
/// to the kernel of flat faces.
void SolidPass::respond_alone(int row, SolidRoom& room, SolidAnswer& answer) const {
  const auto r = static_cast<std::size_t>(row);
  const Contacts<3>& contacts = contacts_before(state, work);
  if (const JointMemory* joint = contacts.joint_at(r); joint != nullptr) {
    if (!joint->empty()) return respond_bonded(row, *joint, room, answer);
    if (JointMemory& over = *work.contacts.joint_at(r); !over.empty()) over = {};
  }
  const SolidMemory& before = contacts.memory[r];
  const bool was = (before.state & contact_touching) != 0;
  // A row with crushed mortar is evaluated in every step, so that both sides of the history have its memory.
  const bool may_sleep = !was && before.crushed == 0;
  if (may_sleep && sleeps(work, r)) return;
  const NearPair& pair = work.pairs[r];
  if (has_sphere(work, pair)) {
    const LawInUse law{model.laws[pair.law], model.thickness, dt};
    const int face_a = face_near_sphere(model, state, work, pair.piece_a, pair.piece_b),
              face_b = face_near_sphere(model, state, work, pair.piece_b, pair.piece_a);
    SolidResponse response = respond_spheres(sphere_side(model, state, work, pair.piece_a, face_a),
                                             sphere_side(model, state, work, pair.piece_b, face_b), before, law,
                                             work.solids.separation[r].distance);
    response.face_a = face_a, response.face_b = face_b;
    finish(row, false, response, answer);
    return;
  }
  if (may_sleep && stays_apart(row)) return;
  if (looks_flat(row)) {
    answer.row = faces_to_come;
    return;
  }
  respond_shapes(row, work.solids.faces[r].a != FacePair::none, room, answer);
}

/// Direction from a to b of a contact of any shape, as far as it is known before its pressure.
Vec3 known_direction(const SolidMemory& before, const Separation3& last, const MovingSolid& a, const MovingSolid& b) {
  if ((before.state & contact_touching) != 0 && before.normal != Vec3::Zero()) return before.normal;
  return last.distance > 0 ? last.axis : separation(a.placed, b.placed).axis;
}

/// Evaluates two polyhedra of any shape and position.
void SolidPass::respond_shapes(int row, bool may_be_flat, SolidRoom& room, SolidAnswer& answer) const {
  const auto r = static_cast<std::size_t>(row);
  const NearPair& pair = work.pairs[r];
  const SolidMemory& before = contacts_before(state, work).memory[r];
  const MovingSolid whole_a = moving_solid(model, state, work, pair.piece_a),
                    whole_b = moving_solid(model, state, work, pair.piece_b);
  // A deforming piece moves by the face that is pressed. By the mean of all its nodes it would take another work than
  // the overlap stores.
  int side_a = -1, side_b = -1;
  if (whole_a.faces != nullptr || whole_b.faces != nullptr) {
    const Vec3 way = known_direction(before, work.solids.separation[r], whole_a, whole_b);
    side_a = leading_face(whole_a, way), side_b = leading_face(whole_b, -way);
  }
  const MovingSolid a = whole_a.by_face(side_a), b = whole_b.by_face(side_b);
  const LawInUse law{model.laws[pair.law], model.thickness, dt};
  Vec3 along;
  const bool met = direction_at_shared_edges(work, row, along);
  const SolidPressure pressed = pressure_between(a, b, law, work.solids.separation[r], room.shared, may_be_flat,
                                                 before.crushed, met ? &along : nullptr);
  if (pair.replaced && pressed.area > 0) return respond_beside_bearing(row, whole_a, whole_b, pressed, room, answer);
  // Two pieces that did not touch and do not touch have no memory to reset.
  const bool never = !(pressed.area > 0) && (before.state & contact_touching) == 0 && before.crushed == 0;
  if (never) return finish(row, false, {}, answer);
  SolidResponse response = polyhedron_contact_forces(a, b, before, law, pressed, room);
  if (response.face_a < 0) response.face_a = side_a, response.face_b = side_b;
  finish(row, !(before.crushed > 0) && response.memory.crushed > 0, response, answer);
}

/// Evaluates two overlapping pieces with a live bearing between them; `whole` is their pressure without the bearing.
/// The bearing carries the load of its two faces. Flat contact is suppressed and its depth is stored; a piece that
/// tilts or hits from the side presses only with the additional depth. The remaining energy of the contact is
/// dissipated when it lies flat again.
void SolidPass::respond_beside_bearing(int row, const MovingSolid& a, const MovingSolid& b, const SolidPressure& whole,
                                       SolidRoom& room, SolidAnswer& answer) const {
  const NearPair& pair = work.pairs[row];
  const SolidMemory& before = contacts_before(state, work).memory[row];
  const LawInUse law = law_beside_bearings(model, state, work, pair, dt);
  const bool flat = presses_flat<3>(model, state, work, state.bearing, pair, whole.force);
  stand_for<3>(model, work.search, pair, flat ? whole.depth : law.held, work.stood_for);
  SolidPressure pressed;
  if (!flat)
    pressed = law.held > 0
                  ? pressure_between(a, b, law, work.solids.separation[row], room.shared, false, before.crushed)
                  : whole;
  SolidResponse response = polyhedron_contact_forces(a, b, before, law, pressed, room);
  if (flat && (before.state & contact_touching) != 0) {
    SolidMemory normal;
    normal.crushed = before.crushed;
    response.lost_friction += solid_contact_energy(a.placed, b.placed, normal, law, room.shared, room.part);
  }
  finish(row, !(before.crushed > 0) && response.memory.crushed > 0, response, answer);
}

/// True if two pieces that were apart remain apart by more than rounding, usually along the last separating axis; then
/// their faces need no test. If the axis fails, the full test follows, so the stored axis does not change any result.
bool SolidPass::stays_apart(int row) const {
  const auto r = static_cast<std::size_t>(row);
  const NearPair& pair = work.pairs[r];
  const PlacedSolid &a = work.solids.placed[pair.piece_a], &b = work.solids.placed[pair.piece_b];
  const double enough = 1e-9 * (a.solid->size + b.solid->size);
  Separation3& apart = work.solids.separation[r];
  if (!(apart.distance > enough)) return false;
  apart = separation_from(apart, a, b, enough);
  if (!(apart.distance > enough)) return false;
  let_sleep(work, r);
  return true;
}

/// True if a row may be two faces that lie flat, and no other pair of faces of the two pieces. The time of a repeated
/// test does not change any result.
bool SolidPass::looks_flat(int row) const {
  const NearPair& pair = work.pairs[row];
  // Meshed bodies, and all bodies under an implicit scheme, are evaluated one by one.
  if (model.is_fitted(pair.piece_a) || model.is_fitted(pair.piece_b) || !work.solids.behind.empty()) return false;
  if (pair.replaced || !work.solids.law[static_cast<std::size_t>(pair.law)].is_linear) return false;
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
bool SolidPass::is_flat_still(std::size_t row, const Contacts<3>& before) const {
  const FacePair& faces = work.solids.faces[row];
  return (before.memory[row].state & contact_touching) != 0 && way_of(work, work.pairs[row]) < faces.until &&
         faces.a >= 0 && before.joint_at(row) == nullptr && model.bearings.empty() && work.solids.behind.empty();
}

/// Completes rows that are evaluated one by one: forces about the positions of their contact frames, memory, and
/// contact area.
void SolidPass::finish(int row, bool joint_changed, const SolidResponse& r, SolidAnswer& answer) const {
  const auto i = static_cast<std::size_t>(row);
  const NearPair& pair = work.pairs[i];
  answer.row = row, answer.touching = r.touching, answer.joint_changed = joint_changed;
  answer.was_touching = (contacts_before(state, work).memory[i].state & contact_touching) != 0;
  answer.lost_damping = r.lost_damping, answer.lost_friction = r.lost_friction, answer.lost_fracture = r.lost_fracture;
  work.contacts.memory[i] = r.memory;
  if (!r.touching) return;
  answer.carrier_a = model.carrier_of(pair.piece_a, r.face_a);
  answer.carrier_b = model.carrier_of(pair.piece_b, r.face_b);
  answer.moment_a = -r.moment - cross(Vec3(r.centre - place_of(state, work, answer.carrier_a)), r.force);
  answer.moment_b = r.moment + cross(Vec3(r.centre - place_of(state, work, answer.carrier_b)), r.force);
  answer.force = r.force, answer.normal_force = r.normal_force, answer.centre = r.centre;
  answer.area = r.area, answer.depth = r.depth;
  const JointMemory* joint = work.contacts.joint_at(i);
  const double area = joint != nullptr && joint->bonds != 0 ? joint->plan->whole.area : r.area;
  work.solids.areas[i] = {r.middle, r.normal, area, r.radius, r.friction_arm, r.arm, r.face_a, r.face_b};
}

/// True if the faces lie flat and rounding does not prevent the result of the kernel.
bool is_answered(const FlatResponses& out, std::size_t i) {
  const auto lane = static_cast<int>(i);
  return out.rough[lane] == 0 && out.flat[lane] != 0;
}

/// Writes the answer of a row with flat faces except for its largest part; `places` receives the destination of that
/// part.
void SolidPass::begin_answer(const FlatResponses& out, std::size_t i, int row, SolidAnswer& answer,
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

/// Evaluates four rows of faces in lanes. Lanes beyond the last row repeat it.
void SolidPass::face_contact_forces(std::span<const int> rows, int first, SolidRoom& room, SolidAnswer* answers) const {
  FlatContacts in;
  FlatResponses out;
  std::array<int, lane_count> row;
  for (std::size_t i = 0; i < row.size(); ++i) row[i] = rows[std::min(i, rows.size() - 1)];
  load_flat(state, work, row, dt, in);
  respond_flat(in, out);
  std::array<double, 20> nowhere;
  FlatPlaces places(nowhere);
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (is_answered(out, i)) begin_answer(out, i, row[i], answers[row[i] - first], places);
  store_flat(out, places);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto lane = static_cast<int>(i);
    work.solids.faces[static_cast<std::size_t>(row[i])].kind = static_cast<std::int32_t>(out.kind[lane]);
    if (!is_answered(out, i)) respond_shapes(row[i], out.rough[lane] != 0, room, answers[row[i] - first]);
  }
}

/// Prefetches the memory of a row with flat faces, which is scattered in large models.
void SolidPass::ask_early(int row) const {
  const auto r = static_cast<std::size_t>(row);
  ask_for<Asked::read, sizeof(SolidMemory)>(&contacts_before(state, work).memory[r]);
  ask_for<Asked::write, sizeof(SolidMemory)>(&work.contacts.memory[r]);
  ask_for<Asked::write, sizeof(ContactArea)>(&work.solids.areas[r]);
}

/// Evaluates rows one by one, except flat faces: these are evaluated four of a kind at a time, separately for faces
/// with few and with many corners. The grouping does not change the results.
void SolidPass::respond(int first, int last, SolidRoom& room, SolidAnswer* answers) const {
  RowsByKind flat;
  const Contacts<3>& before = contacts_before(state, work);
  for (int row = first; row < last; ++row) {
    const auto r = static_cast<std::size_t>(row);
    if (!is_flat_still(r, before)) {
      SolidAnswer& answer = answers[row - first];
      answer.row = -1;
      respond_alone(row, room, answer);
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
    face_contact_forces({four.data(), taken}, first, room, answers);
    taken = 0;
  }
}

/// Parameters of the laws for the kernel of flat faces.
void list_law_numbers(const Model<3>& model, std::vector<LawNumbers>& numbers) {
  numbers.clear();
  for (const ContactLaw& law : model.laws) {
    const PlainFriction k = plain_friction({law, model.thickness, 0});
    numbers.push_back({k.kn, k.ks, k.mu, k.beta, is_linear(law) && has_closed_form(law)});
  }
}

}  // namespace

void contact_row_forces(const Model<3>& model, const State<3>& state, Work<3>& work, int row, double dt,
                        SolidAnswer& answer) {
  SolidPass{model, state, work, dt}.respond(row, row + 1, work.solids.room.front(), &answer);
}

/// Each thread processes its runs of rows (see assembly/contact/general_contact_partition.hpp).
void polygon_contact_forces(const Model<3>& model, const State<3>& state, Work<3>& work, double dt) {
  begin_to_stand(model, work);
  work.solids.force.assign(model.mass.size(), Vec3::Zero());
  work.solids.moment.assign(model.mass.size(), Vec3::Zero());
  work.solids.fit_force.assign(model.fits.size(), Vec3::Zero());
  work.solids.fit_moment.assign(model.fits.size(), Vec3::Zero());
  SolidWork<3>& solids = work.solids;
  solids.areas.resize(work.pairs.size());
  list_law_numbers(model, solids.law);
  solids.room.resize(static_cast<std::size_t>(work.threads));
  solids.answer.resize(static_cast<std::size_t>(work.threads) * solid_row_stretch);
  join_shared_edges(model, state, work, dt);
  const int runs = partition_general_contacts(model, work);
  const SolidPass pass{model, state, work, dt};
  share(work.threads, runs, 1, [&](int from, int to, int thread) {
    const auto t = static_cast<std::size_t>(thread);
    SolidAnswer* const answers = &solids.answer[t * solid_row_stretch];
    for (int r = from; r < to; ++r) {
      GeneralRun<3>& run = work.general_runs[static_cast<std::size_t>(r)];
      for (int first = run.first; first < run.last; first += solid_row_stretch) {
        const int last = std::min(first + solid_row_stretch, run.last);
        pass.respond(first, last, solids.room[t], answers);
        take_up(model, work, run, first, last, answers);
      }
    }
  });
  join_general_partitions(work);
}

}  // namespace trilith
