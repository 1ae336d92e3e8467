// Contacts in space: faces with or without bond, any other shape, or apart by the last separating axis.
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "assembly/contact/general_contact_partition.hpp"
#include "assembly/contact/moving_solid.hpp"
#include "assembly/contact/pair_sleeping.hpp"
#include "assembly/contact/shared_edge_normal.hpp"
#include "assembly/contact/solid_joints.hpp"
#include "assembly/contact/solid_pass.hpp"
#include "assembly/evaluate.hpp"
#include "assembly/single_terms.hpp"
#include "base/team.hpp"
#include "broad_phase/bearing_rules.hpp"
#include "contact/joint/joint.hpp"
#include "contact/space/cut_pressure.hpp"
#include "contact/space/sphere_contact.hpp"

namespace trilith {
namespace {

/// Position of a contact frame (model/contact/contact_frame.hpp) [m].
const Vec3& place_of(const State<3>& state, const Work<3>& work, int contact_frame) {
  return contact_frame < 0 ? work.solids.fitted[static_cast<std::size_t>(-1 - contact_frame)].place
                           : state.position[static_cast<std::size_t>(contact_frame)];
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

/// Direction from a to b of a contact of any shape, as far as it is known before its pressure.
Vec3 known_direction(const SolidMemory& before, const Separation3& last, const MovingSolid& a, const MovingSolid& b) {
  if ((before.state & contact_touching) != 0 && before.normal != Vec3::Zero()) return before.normal;
  return last.distance > 0 ? last.axis : separation(a.placed, b.placed).axis;
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

/// Evaluates a row by itself. The answer remains empty if the pieces were apart and still are. Marks rows that are left
/// to a kernel of four.
void SolidPass::respond_alone(int row, SolidRoom& room, PressedRows& pressed, SolidAnswer& answer) const {
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
  respond_other(row, work.solids.faces[r].a != FacePair::none, room, pressed, answer);
}

/// Evaluates a row that the kernel of flat faces does not answer. The choice of the method depends on the pose alone.
void SolidPass::respond_other(int row, bool may_be_flat, SolidRoom& room, PressedRows& pressed,
                              SolidAnswer& answer) const {
  switch (respond_fast(row, may_be_flat, room, pressed, answer)) {
    case FastResponse::given:
      return;
    case FastResponse::unfit:
      return respond_shapes(row, may_be_flat, true, room, answer);
    case FastResponse::failed:
      return respond_shapes(row, false, false, room, answer);
  }
}

/// Completes a row that is evaluated by itself. Two pieces that did not touch and do not touch have no memory to reset.
void SolidPass::respond_pressure(int row, const MovingSolid& a, const MovingSolid& b, const LawInUse& law,
                                 const SolidPressure& pressed, SolidRoom& room, SolidAnswer& answer,
                                 const std::array<int, 2>& sides) const {
  const SolidMemory& before = contacts_before(state, work).memory[static_cast<std::size_t>(row)];
  const bool never = !(pressed.area > 0) && (before.state & contact_touching) == 0 && before.crushed == 0;
  if (never) return finish(row, false, {}, answer);
  SolidResponse response = polyhedron_contact_forces(a, b, before, law, pressed, room);
  if (response.face_a < 0) response.face_a = sides[0], response.face_b = sides[1];
  finish(row, !(before.crushed > 0) && response.memory.crushed > 0, response, answer);
}

/// Evaluates two polyhedra of any shape and position. `by_edges` false: their overlap is not found from edges.
void SolidPass::respond_shapes(int row, bool may_be_flat, bool by_edges, SolidRoom& room, SolidAnswer& answer) const {
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
  Separation3& apart = work.solids.separation[r];
  const Vec3* const given = met ? &along : nullptr;
  const SolidPressure pressed =
      by_edges ? pressure_between(a, b, law, apart, room.shared, may_be_flat, before.crushed, given)
               : cut_pressure(a, b, law, apart, room.shared, before.crushed, given);
  if (pair.replaced && pressed.area > 0) return respond_beside_bearing(row, whole_a, whole_b, pressed, room, answer);
  respond_pressure(row, a, b, law, pressed, room, answer, {side_a, side_b});
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
