// Contacts of solids in space: of faces, bonded or not, of any other shape, or apart by the axis that parted them last.
#include <algorithm>
#include <array>
#include <span>

#include "base/team.hpp"
#include "contact/flat_contact.hpp"
#include "contact/joint.hpp"
#include "contact/sphere_contact.hpp"
#include "detect/bearing_rules.hpp"
#include "step/evaluate.hpp"
#include "step/flat_rows.hpp"
#include "step/solid_joints.hpp"

namespace trilith {
namespace {

/// Rows that threads take at a time: some ten microseconds of what touches.
constexpr int solid_row_stretch = 32;
/// Of an answer: the row is left to those of faces that lie flat.
constexpr int faces_to_come = -2;

/// A piece where its body is now, with the velocity and spin of the node that it goes with, or of its fit.
MovingSolid moving_solid(const Model<3>& model, const State<3>& state, const Work<3>& work, int piece) {
  if (model.is_fitted(piece)) {
    const auto first = static_cast<std::size_t>(model.piece_fit[static_cast<std::size_t>(piece)]);
    const Fitted& whole = work.solids.fitted[first];
    return {work.solids.placed[piece],
            whole.place,
            whole.velocity,
            whole.spin,
            step_behind(work, model.carrier_of(piece)),
            &work.solids.face_motion[first + 1]};
  }
  const int n = model.node_of_piece(piece);
  return {work.solids.placed[piece], state.position[n], state.velocity[n], state.spin[n], step_behind(work, n)};
}

/// Where a carrier (world/carrier.hpp) is [m].
const Vec3& place_of(const State<3>& state, const Work<3>& work, int carrier) {
  return carrier < 0 ? work.solids.fitted[static_cast<std::size_t>(-1 - carrier)].place
                     : state.position[static_cast<std::size_t>(carrier)];
}

/// Adds a force and a moment about a carrier's place to the sums of nodes or of fits.
void add_to_carrier(int carrier, const Vec3& force, const Vec3& moment, SolidWork<3>& solids) {
  const auto i = static_cast<std::size_t>(carrier < 0 ? -1 - carrier : carrier);
  (carrier < 0 ? solids.fit_force : solids.force)[i] += force;
  (carrier < 0 ? solids.fit_moment : solids.moment)[i] += moment;
}

/// The force of a contact on what carries both sides of it.
void add_to_bodies(const Model<3>& model, const NearPair& pair, const SolidAnswer& answer, Work<3>& work) {
  const SolidResponse& r = answer.response;
  add_to_carrier(model.carrier_of(pair.piece_a, r.face_a), -r.force, answer.moment_a, work.solids);
  add_to_carrier(model.carrier_of(pair.piece_b, r.face_b), r.force, answer.moment_b, work.solids);
}

/// Each of two that are apart may come nearer by the path of the fastest point.
void let_sleep(Work<3>& work, std::size_t row) {
  work.asleep_until[row] = work.travel + 0.5 * (1 - 1e-9) * work.solids.separation[row].distance;
}

/// Adds what a contact gives to forces, ledger and lists.
void take_up(const Model<3>& model, Work<3>& work, const SolidAnswer& answer) {
  const auto r = static_cast<std::size_t>(answer.row);
  const SolidResponse& response = answer.response;
  if (answer.was_touching != response.touching || answer.joint_changed) work.changed_rows.push_back(answer.row);
  work.given[EnergyTerm::contact_damping] += response.lost_damping;
  work.given[EnergyTerm::contact_friction] += response.lost_friction;
  work.given[EnergyTerm::contact_fracture] += response.lost_fracture;
  if (!response.touching) return let_sleep(work, r);
  add_to_bodies(model, work.pairs[r], answer, work);
  work.general_touching.push_back({answer.row, response.area, response.depth, response.centre, response.normal_force});
  const JointMemory* joint = work.contacts.joint_at(r);
  const double area = joint != nullptr && joint->bonds != 0 ? joint->plan->whole.area : response.area;
  work.solids.areas.push_back({response.middle, response.normal, area, response.radius, response.friction_arm,
                               response.arm, response.face_a, response.face_b});
}

/// Corners of the faces of a row that may lie flat on each other, of the one that has more.
int corners_of(const Work<3>& work, int row) {
  const FacePair& pair = work.solids.faces[static_cast<std::size_t>(row)];
  const NearPair& near = work.pairs[row];
  const auto corners = [&](int piece, int face) {
    return static_cast<int>(work.solids.placed[piece].solid->shape.faces[face].size());
  };
  return std::max(corners(near.piece_a, pair.a), corners(near.piece_b, pair.b));
}

/// All that the kernel of flat faces asks of four rows.
[[gnu::target_clones("avx2", "default")]] void load_flat(const Model<3>& model, const State<3>& state,
                                                         const Work<3>& work, const std::array<int, lane_count>& row,
                                                         double dt, FlatContacts& in) {
  const std::vector<SolidMemory>& before = contacts_before(state, work).memory;
  FourFacesOfSolids a, b;
  std::array<int, lane_count> node_a, node_b;
  std::array<const SolidMemory*, lane_count> memory;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const auto r = static_cast<std::size_t>(row[i]);
    const NearPair& pair = work.pairs[r];
    const FacePair& faces = work.solids.faces[r];
    const LawNumbers& law = work.solids.law[static_cast<std::size_t>(pair.law)];
    a.solid[i] = &work.solids.placed[pair.piece_a], b.solid[i] = &work.solids.placed[pair.piece_b];
    a.face[i] = faces.a, b.face[i] = faces.b;
    a.loop[i] = a.solid[i]->solid->shape.faces[faces.a], b.loop[i] = b.solid[i]->solid->shape.faces[faces.b];
    node_a[i] = model.node_of_piece(pair.piece_a), node_b[i] = model.node_of_piece(pair.piece_b);
    memory[i] = &before[r];
    const auto lane = static_cast<int>(i);
    in.kn[lane] = law.kn, in.ks[lane] = law.ks, in.mu[lane] = law.mu, in.beta[lane] = law.beta;
    in.near[lane] = near_faces(*a.solid[i], *b.solid[i]);
    in.b_is_larger[lane] = a.solid[i]->solid->size < b.solid[i]->solid->size ? -1 : 0;
  }
  in.dt = dt;
  in.faces.corners_a = a.load(in.faces.a, in.faces.normal_a);
  in.faces.corners_b = b.load(in.faces.b, in.faces.normal_b);
  in.a = four_nodes(state, node_a), in.b = four_nodes(state, node_b);
  load_memory(memory, in.before);
}

/// What the rows of one evaluation are found from. Each writes what is its own row's alone, and `room`.
struct SolidPass {
  const Model<3>& model;
  const State<3>& state;
  Work<3>& work;
  double dt;

  void respond(int first, int last, SolidRoom& room, SolidAnswer* answers) const;

 private:
  void respond_bonded(int row, const JointMemory& before, SolidRoom& room, SolidAnswer& answer) const;
  bool respond_alone(int row, SolidRoom& room, SolidAnswer& answer) const;
  void respond_shapes(int row, bool may_be_flat, SolidRoom& room, SolidAnswer& answer) const;
  void respond_faces(std::span<const int> rows, int first, SolidRoom& room, SolidAnswer* answers) const;
  [[nodiscard]] bool stays_apart(int row) const;
  [[nodiscard]] bool looks_flat(int row) const;
  void finish(SolidAnswer& answer) const;
};

/// Faces that mortar holds together, or did until now.
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
    // What the joint stores more than two other solids there do is given off as it ends.
    const double left = !joint.contact.touching
                            ? 0.0
                            : solid_contact_energy(work.solids.placed[pair.piece_a], work.solids.placed[pair.piece_b],
                                                   joint.contact.memory, law, room.shared, room.part);
    joint.contact.lost_friction += joint_energy(after, law) - left;
    after = {};
    work.solids.separation[r].distance = 0;
  }
  answer.row = row, answer.was_touching = true, answer.joint_changed = joint.changed;
  answer.response = joint.contact;
}

bool has_sphere(const Work<3>& work, const NearPair& pair) {
  const std::vector<Sphere>& sphere = work.solids.sphere;
  return !sphere.empty() && (sphere[pair.piece_a].radius > 0 || sphere[pair.piece_b].radius > 0);
}

/// The same of a piece that may be a sphere: its centre and radius beside its corners, of which a sphere has one.
SphereSide sphere_side(const Model<3>& model, const State<3>& state, const Work<3>& work, int piece) {
  const MovingSolid moving = moving_solid(model, state, work, piece);
  return {work.solids.sphere[piece], moving.placed, moving.origin, moving.velocity, moving.spin, moving.behind};
}

/// False where there is nothing to be found out (the two were apart, and still are), or where the row is left to
/// those of faces that lie flat.
bool SolidPass::respond_alone(int row, SolidRoom& room, SolidAnswer& answer) const {
  const auto r = static_cast<std::size_t>(row);
  const Contacts<3>& contacts = contacts_before(state, work);
  if (const JointMemory* joint = contacts.joint_at(r); joint != nullptr) {
    if (!joint->empty()) return respond_bonded(row, *joint, room, answer), true;
    if (JointMemory& over = *work.contacts.joint_at(r); !over.empty()) over = {};
  }
  const SolidMemory& before = contacts.memory[r];
  const bool was = (before.state & contact_touching) != 0;
  // A pair found apart sleeps until the fastest point has gone far enough to have brought it together. One that
  // remembers crushed mortar is answered in every step, so that both sides of the history have it.
  const bool may_sleep = !was && before.crushed == 0;
  if (may_sleep && work.travel < work.asleep_until[r]) return false;
  const NearPair& pair = work.pairs[r];
  if (has_sphere(work, pair)) {
    const LawInUse law{model.laws[pair.law], model.thickness, dt};
    answer.response =
        respond_spheres(sphere_side(model, state, work, pair.piece_a), sphere_side(model, state, work, pair.piece_b),
                        before, law, work.solids.separation[r].distance);
    answer.row = row, answer.was_touching = was, answer.joint_changed = false;
    return true;
  }
  if (may_sleep && stays_apart(row)) return false;
  if (looks_flat(row)) {
    answer.row = faces_to_come;
    return false;
  }
  respond_shapes(row, work.solids.faces[r].a != FacePair::none, room, answer);
  return true;
}

/// Two polyhedra of any shape and pose.
void SolidPass::respond_shapes(int row, bool may_be_flat, SolidRoom& room, SolidAnswer& answer) const {
  const auto r = static_cast<std::size_t>(row);
  const NearPair& pair = work.pairs[r];
  const SolidMemory& before = contacts_before(state, work).memory[r];
  const MovingSolid a = moving_solid(model, state, work, pair.piece_a),
                    b = moving_solid(model, state, work, pair.piece_b);
  const LawInUse law{model.laws[pair.law], model.thickness, dt};
  const SolidPressure pressed =
      pressure_between(a, b, law, work.solids.separation[r], room.shared, may_be_flat, before.crushed);
  // A bearing carries what its two faces would: flat contact is held off, a corner that strikes is not.
  const bool held_off = pair.replaced && presses_flat(model, state, work.search, state.bearing, pair, pressed.force);
  answer.row = row, answer.was_touching = (before.state & contact_touching) != 0;
  answer.response = respond_solids(a, b, before, law, held_off ? SolidPressure{} : pressed, room);
  answer.joint_changed = !(before.crushed > 0) && answer.response.memory.crushed > 0;
}

/// Whether two that were apart are so still by more than rounding, mostly along the axis that parted them last: then no
/// faces need to be looked at. Who goes on is asked with every figure, so the axis remembered changes no answer.
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

/// Whether a row may be one of two faces that lie flat, and no other pair of faces of the two. Who asks anew, and when,
/// changes no answer.
bool SolidPass::looks_flat(int row) const {
  const NearPair& pair = work.pairs[row];
  // Bodies of elements, and what an implicit scheme moves, are answered one by one.
  if (model.is_fitted(pair.piece_a) || model.is_fitted(pair.piece_b) || !work.solids.behind.empty()) return false;
  if (pair.replaced || !work.solids.law[static_cast<std::size_t>(pair.law)].is_linear) return false;
  FacePair& faces = work.solids.faces[static_cast<std::size_t>(row)];
  if (work.travel >= faces.until)
    faces = facing_pair(work.solids.placed[pair.piece_a], work.solids.placed[pair.piece_b], work.travel);
  return faces.a >= 0;
}

/// Forces about the places of what carries the two, and what is remembered: of rows that are answered one by one.
void SolidPass::finish(SolidAnswer& answer) const {
  const NearPair& pair = work.pairs[answer.row];
  const SolidResponse& r = answer.response;
  const Vec3 &a = place_of(state, work, model.carrier_of(pair.piece_a, r.face_a)),
             &b = place_of(state, work, model.carrier_of(pair.piece_b, r.face_b));
  answer.moment_a = -r.moment - cross(Vec3(r.centre - a), r.force);
  answer.moment_b = r.moment + cross(Vec3(r.centre - b), r.force);
  work.contacts.memory[answer.row] = r.memory;
}

/// Four rows of faces into lanes and their answers out of them. Lanes beyond the last row repeat it.
void SolidPass::respond_faces(std::span<const int> rows, int first, SolidRoom& room, SolidAnswer* answers) const {
  FlatContacts in;
  FlatResponses out;
  std::array<int, lane_count> row;
  for (std::size_t i = 0; i < row.size(); ++i) row[i] = rows[std::min(i, rows.size() - 1)];
  load_flat(model, state, work, row, dt, in);
  respond_flat(in, out);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto lane = static_cast<int>(i);
    SolidAnswer& answer = answers[row[i] - first];
    if (out.rough[lane] == 0 && out.flat[lane] != 0) {
      answer.row = row[i];
      answer.was_touching = (contacts_before(state, work).memory[row[i]].state & contact_touching) != 0;
      work.solids.separation[row[i]].distance = 0;
      store_flat(out, lane, answer, work.contacts.memory[row[i]]);
      continue;
    }
    respond_shapes(row[i], out.rough[lane] != 0, room, answer);
    finish(answer);
  }
}

/// Rows one by one, and those of faces that lie flat four at a time, those of few corners and those of many apart. How
/// many corners they have is asked of all in a row: solids that are far in memory are waited for together.
void SolidPass::respond(int first, int last, SolidRoom& room, SolidAnswer* answers) const {
  std::array<int, solid_row_stretch> flat;
  std::size_t flat_rows = 0;
  for (int row = first; row < last; ++row) {
    SolidAnswer& answer = answers[row - first];
    answer.row = -1;
    if (respond_alone(row, room, answer)) finish(answer);
    if (answer.row == faces_to_come) flat[flat_rows++] = row;
  }
  std::array<std::array<int, solid_row_stretch>, 2> rows;
  std::array<std::size_t, 2> count{};
  for (std::size_t i = 0; i < flat_rows; ++i) {
    const std::size_t kind = corners_of(work, flat[i]) > 4 ? 1 : 0;
    rows[kind][count[kind]++] = flat[i];
  }
  for (std::size_t kind = 0; kind < 2; ++kind)
    for (std::size_t i = 0; i < count[kind]; i += lane_count)
      respond_faces({rows[kind].data() + i, std::min<std::size_t>(lane_count, count[kind] - i)}, first, room, answers);
}

/// What faces that lie flat ask of the laws.
void list_law_numbers(const Model<3>& model, std::vector<LawNumbers>& numbers) {
  numbers.clear();
  for (const ContactLaw& law : model.laws)
    with_kernel({law, model.thickness, 0}, [&](const Coulomb& k) {
      numbers.push_back({k.kn, k.ks, k.mu, k.beta, is_linear(law)});
    });
}

}  // namespace

/// Several threads answer the rows; the answers are taken up in the order of rows, so that sums and lists have the bits
/// of one row after the other.
void respond_general(const Model<3>& model, const State<3>& state, Work<3>& work, double dt) {
  work.general_touching.clear();
  work.solids.areas.clear();
  work.solids.force.assign(model.mass.size(), Vec3::Zero());
  work.solids.moment.assign(model.mass.size(), Vec3::Zero());
  work.solids.fit_force.assign(model.fits.size(), Vec3::Zero());
  work.solids.fit_moment.assign(model.fits.size(), Vec3::Zero());
  SolidWork<3>& solids = work.solids;
  list_law_numbers(model, solids.law);
  solids.room.resize(static_cast<std::size_t>(work.threads));
  solids.answer.resize(static_cast<std::size_t>(stretches_under_way(work.threads)) * solid_row_stretch);
  const SolidPass pass{model, state, work, dt};
  const auto answer_of = [&](int slot, int i) -> SolidAnswer& {
    return solids.answer[static_cast<std::size_t>(slot * solid_row_stretch + i)];
  };
  share_in_order(
      work.threads, static_cast<int>(work.pairs.size()), solid_row_stretch,
      [&](int first, int last, int thread, int slot) {
        pass.respond(first, last, solids.room[static_cast<std::size_t>(thread)], &answer_of(slot, 0));
      },
      [&](int first, int last, int slot) {
        for (int i = 0; i < last - first; ++i)
          if (answer_of(slot, i).row >= 0) take_up(model, work, answer_of(slot, i));
      });
}

}  // namespace trilith
