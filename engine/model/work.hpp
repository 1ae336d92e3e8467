// Everything computed from Model and State. Dropping it between two steps changes no bit of the result.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/space.hpp"
#include "contact/plane/corner_overlap.hpp"
#include "contact/space/placed_pieces.hpp"
#include "contact/space/solid_contact.hpp"
#include "contact/space/solid_faces.hpp"
#include "geometry/space/overlap_3d.hpp"
#include "geometry/space/separation_3d.hpp"
#include "law/bearing/bearing.hpp"
#include "law/contact/step_increment.hpp"
#include "model/builder/shared_edges.hpp"
#include "model/contact/broad_phase_state.hpp"
#include "model/contact/general_contacts.hpp"
#include "model/contact/row_shares.hpp"
#include "model/event.hpp"
#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// Two pieces near each other. Row i belongs to row i of Work::contacts.
struct NearPair {
  int piece_a, piece_b;
  int law;             ///< index into Model::laws
  int facing;          ///< number of pairs of faces that look at each other: 0, 1, 2 (more counts as 2)
  int a0, a1, b0, b1;  ///< skin points of the two faces, where facing > 0
  double corner;       ///< see FaceOverlap::is_flat, where facing > 0
  bool replaced;       ///< a live bearing stands for the flat contact of these pieces; corners still touch
  // What was found last, tried first: of general contact. No result depends on it. Writer: respond
  CornerOnFace corner_at = {};  ///< the one corner that lies in the other piece
  std::int16_t apart_by = -1;   ///< the edge that kept the two apart, see OverlapResponse::apart_by
  // Likewise. Writer: respond, see broad_phase/face_tilt_cache.hpp
  float tilted_from = 1, tilted_to = 0;  ///< no faces oppose each other while b's rotation less a's is between [rad]
};

/// Rows of `pairs` that are handled alike: one contact law, faces that look at each other.
struct FaceBatch {
  int law;
  std::vector<int> row;                 ///< one pair of facing faces
  std::vector<int> choice;              ///< several: one of them may be chosen at each step
  std::vector<std::uint8_t> has_faces;  ///< [choice] 1: it has a pair of faces at this step. Writer: respond
  std::vector<int> chosen;              ///< those of `choice` that have a pair of faces at this step. Writer: respond
  std::vector<int> now;                 ///< rows of this step, where `choice` is not empty. Writer: respond
};

/// A skin point's position [m] and velocity [m/s], in the order the contact kernel loads them.
template <int D>
struct SkinMotion;
template <>
struct alignas(32) SkinMotion<2> {
  double x, y, u, v;
};
template <>
struct alignas(32) SkinMotion<3> {
  double x, y, z, unused_place;
  double u, v, w, unused_velocity;
};

/// Where the rows of a body are: all that a pass over the bodies reads of Body, without its names.
struct BodyRow {
  int node, nodes;  ///< the first, and how many
  int skin, skins;
  SkinLayout layout;
  int fit = 0, fits = 0;
};

/// How the area of a contact in space lies, for the step estimate.
struct ContactArea {
  Vec3 middle, normal;           ///< [m], of length 1
  double area;                   ///< pressed, or held by mortar [m2]
  double radius;                 ///< see SolidPressure [m]
  double friction_arm;           ///< likewise [m]
  std::array<Vec3, 2> arm;       ///< likewise [m]
  int face_a = -1, face_b = -1;  ///< likewise
};

/// What the contact of one row came to, before it is added to anything.
struct SolidAnswer {
  int row = -1;  ///< -1: there was nothing to find out
  bool was_touching = false, touching = false, joint_changed = false;
  int carrier_a = 0, carrier_b = 0;  ///< what the two act on (model/contact/contact_frame.hpp)
  double area = 0, depth = 0;        ///< [m2], [m]
  double lost_damping = 0, lost_friction = 0, lost_fracture = 0;  ///< [J]
  Vec3 force, moment_a, moment_b;                                 ///< on b [N]; on both, about their places [N m]
  Vec3 normal_force, centre;                                      ///< see SolidResponse
};

/// What the general contact of one row in the plane came to, before it is added to anything.
struct OverlapAnswer {
  bool counts = false;                     ///< false: there was nothing to find out, and the rest is of no meaning
  bool changed = false, touching = false;  ///< see Work::changed_rows
  CornerOnFace corner_at = {};             ///< where it is there, that answered, and forces are those of `push`; else
  Vec2 *on_a = nullptr, *on_b = nullptr;   ///< [corner] forces, in Work::answer_force [N]
  CornerPush push;
  OverlapResponse response;
  ShapeLoss let_go;  ///< what faces held, where they are of general shape now [J]
};

/// What a row gives off [J].
struct RowLoss {
  double damping = 0, friction = 0, fracture = 0;
};

/// What is added once all rows are answered: in the plane to the force at a skin point, in space to the force on a
/// carrier (model/contact/contact_frame.hpp) and to the moment about its place.
template <int D>
struct LaterForce;
template <>
struct LaterForce<2> {
  int skin;
  Vec2 force;  ///< [N]
};
template <>
struct LaterForce<3> {
  int contact_frame;
  Vec3 force, moment;  ///< [N], [N m]
};

/// Rows of general shape that one thread answers one after the other; see
/// assembly/contact/general_contact_partition.hpp. It may have none: its lists keep their room.
template <int D>
struct GeneralRun {
  int first, last;                   ///< in Work::awake_rows; in space rows
  int end_body;                      ///< bodies from here on are of runs that follow
  std::vector<LaterForce<D>> later;  ///< on bodies of several runs
  std::vector<RowLoss> losses;       ///< where there are several runs
  std::vector<int> touching;         ///< places in Work::general_touching
  std::vector<int> changed;          ///< see Work::changed_rows
};

/// What the contacts of faces of four rows came to beside forces, where threads take them, before it is added to
/// anything: as much as two lines of a cache hold.
struct alignas(64) FourFaces {
  std::array<int, 4> row;
  std::array<std::uint8_t, 4>
      later;  ///< sides that forces are still to be added to, see assembly/contact/face_contact_simd.hpp
  std::array<bool, 4> turns, is_general;              ///< see Work::changed_rows
  std::array<double, 4> damping, friction, fracture;  ///< given off [J]
};
/// Forces of four rows on a0, a1, b0, b1 that are added later [N].
using FourForces = std::array<std::array<Vec2, 4>, 4>;

/// Facing rows of a stretch that go on to the kernel: those that touched, and of the others those that may now; and
/// those that do not, as they are of general shape and were so at the last step.
struct SortedRows {
  std::size_t touched, fresh, tumbling;
};

/// What elements in space of a stretch give their nodes, where threads take them, before it is added to anything.
struct SpaceElementAnswer {
  std::array<Vec3, max_space_nodes> force, damping;  ///< [N]
  double stored, plastic;                            ///< [J]
};

/// A contact that closes, opens or is pressed by a blow: see integrate/explicit/impact_step.hpp.
struct Blow {
  double begins;  ///< from now [s]
  double power;   ///< k v^2 / 2 + k^2 d^2 / 2 mu: times the square of a step what it may miss [J/s2]
};

/// What the step estimate knows of blows.
struct ImpactWork {
  std::vector<double> mass;          ///< [body] 0 where it does not move. Writer: find kg
  double total = 0, lightest = 0;    ///< of those that move, and of their nodes the lightest. Writer: find kg
  int still = -1;                    ///< the first node of a body that does not move, -1: all do. Writer: find
  std::vector<double> speed;         ///< room: [body] m/s
  std::vector<std::uint8_t> counts;  ///< room: [body] 1: it could miss more than it may
  std::vector<ContactKey> key;       ///< room: pairs of pieces
  std::vector<Blow> blows;           ///< room
};

/// Elements in a row, all of some bodies.
struct ElementRange {
  int first, count;
};

/// What elements, or beams, add to the ledger.
struct ElementEnergy {
  double stored = 0;   ///< [J]
  double plastic = 0;  ///< given off in this step [J]
};

/// Stiffnesses, friction and damping of a law whose pressure goes with the overlap.
struct LawNumbers {
  double kn, ks, mu, beta;  ///< [Pa/m], [Pa/m], [1], [s]
  bool is_linear;
};

/// Solids in space where they stand, and what their contacts give.
template <int D>
struct SolidWork {};
template <>
struct SolidWork<3> {
  std::vector<PlacedSolid> placed;       ///< [piece]. Writer: place
  std::vector<Sphere> sphere;            ///< [piece] radius 0 of a polyhedron; empty without spheres. Writer: place
  std::vector<StepBehind> behind;        ///< [node] of an implicit step; else empty. Writer: place
  std::vector<double> speed2;            ///< [piece] largest square of the speeds of its corners [m2/s2]. Writer: place
  std::vector<double> way;               ///< [piece] path of the corner that went farthest since the pairs were found
                                         ///< anew, from pose to pose, an upper bound [m]. Writer: place
  std::vector<Separation3> separation;   ///< [contact] along the axis that parted them last. Writer: respond
  std::vector<Separation3> spare;        ///< room
  std::vector<FacePair> faces;           ///< [contact] that may lie flat on each other. Writer: respond
  std::vector<FacePair> spare_faces;     ///< room
  std::vector<LawNumbers> law;           ///< [law] what faces that lie flat ask of it. Writer: respond
  std::vector<ContactArea> areas;        ///< [contact] of those that touch. Writer: respond
  std::vector<Vec3> force, moment;       ///< [node] of all contacts, about the node [N], [N m]. Writer: respond
  std::vector<Fitted> fitted;            ///< [fit]. Writer: place
  std::vector<MovingPlace> face_motion;  ///< [fit] of them what contact asks for. Writer: place
  std::vector<std::vector<Vec3>> before;    ///< [piece] room: corners as they were placed last
  std::vector<Vec3> fit_force, fit_moment;  ///< [fit] likewise, about its place [N], [N m]. Writer: respond
  std::vector<SolidRoom> room;              ///< [thread]
  std::vector<SolidAnswer> answer;          ///< of the rows that are worked on
};

/// A row of contact in which a ridge that several pieces share lies in the other piece.
template <int D>
struct MetRow {
  int row;
  Vec<D> push;  ///< on b, of its springs [N]
};

/// What a step needs and the next one can do without. `evaluate` writes nothing else; `commit` makes a State of it.
template <int D>
struct Work {
  bool valid = false;            ///< false: pairs must be found anew. Writer: detect
  int threads = 1;               ///< that may share a step; no bit of any result depends on it. Never dropped
  bool leave_out_beams = false;  ///< resist adds none of their forces: the tangent has theirs by itself. Writer: it

  // Writer: place
  std::vector<BodyRow> body;        ///< [body], anew where the pairs must be found anew
  std::vector<SkinMotion<D>> skin;  ///< [skin]; in space none, see SolidWork::placed
  std::vector<Vec<D>> skin_mean;    ///< [skin] mean velocity over the step; empty in explicit stages m/s
  double fastest = 0;               ///< largest speed of any skin point, in space of any corner m/s
  double fastest_moving = 0;        ///< ... of a body that is free to move m/s

  std::vector<ElementRange> element_stretches;  ///< anew with `body`

  // Writer: detect
  std::vector<NearPair> pairs;        ///< [contact]
  std::vector<FaceBatch> batches;     ///< by law
  std::vector<int> general;           ///< rows that have no single pair of facing faces
  std::vector<double> asleep_until;   ///< [contact] not touching while `travel`, in space the way of both pieces
                                      ///< together, is below this m
  std::vector<double> clear_until;    ///< [contact] see clear_path m
  BroadPhaseState<D> search;          ///< where pieces were looked up
  std::vector<NearPair> spare_pairs;  ///< room for the list to come
  std::vector<double> spare_asleep, spare_clear;
  std::vector<RateBound> face_bound;    ///< [body] lying on its stiffest face
  std::vector<RateBound> around_bound;  ///< [body] of elements: in contact all around, as if it were rigid
  ImpactWork impacts;
  SharedEdges ridges;       ///< anew where the pairs must be found anew. Writer: find
  Contacts<D> matched;      ///< the state's contacts in the rows of the pairs, where these were found after
                            ///< the last commit; else room for them
  bool is_matched = false;  ///< they were
  double travel = 0;        ///< path of the skin point that went farthest since the pairs were found anew, from one
                            ///< evaluated pose to the next, an upper bound. Writer: place m

  SolidWork<D> solids;  ///< in space

  // Writer: respond
  Contacts<D> contacts;                      ///< [contact] trial
  std::vector<BearingMemory<D>> bearing;     ///< [bearing] trial
  std::vector<double> stood_for;             ///< [bearing] see BearingMemory; empty where none stands for a contact [m]
  std::vector<int> face_rows, fresh_rows;    ///< of a batch: rows that touched or may touch now; the latter alone
  std::vector<SortedRows> sorted_rows;       ///< room, by stretch
  std::vector<FourFaces> four_faces;         ///< room for what threads take ...
  std::vector<FourForces> four_forces;       ///< ... and their forces
  RowShares row_shares;                      ///< of the rows of faces, between them
  std::vector<RowRun> row_runs;              ///< of a batch, room
  std::vector<int> general_now;              ///< rows that were to be faces and are of general shape now
  std::vector<Vec2> answer_force;            ///< room of `answer` N
  std::vector<std::uint8_t> is_general;      ///< [contact] room: 1: one of those or of `general`
  std::vector<int> awake_rows;               ///< those of them that are worked on
  std::vector<int> awake_counts;             ///< room: how many of them are in each stretch of rows
  std::vector<GeneralRun<D>> general_runs;   ///< of these, in space of all
  std::vector<std::uint8_t> at_border;       ///< room: 1: a body has rows in several runs
  std::vector<std::uint8_t> meets;           ///< room, by row: 1: a ridge lies in the other piece
  std::vector<MetRow<D>> met;                ///< those rows, see assembly/contact/shared_edge_normal.hpp
  std::vector<OverlapAnswer> answer;         ///< of rows that threads take
  PlacedPieces placed;                       ///< the pieces of these rows
  GeneralContacts<D> general_touching;       ///< those of them that touch
  std::vector<int> changed_rows;             ///< rows that began or ceased to touch, or lost a bond
  std::vector<Vec<D>> skin_force;            ///< [skin] N; in space none
  std::vector<Vec<D>> bearing_force;         ///< [bearing] on body b, in world axes N
  std::vector<Moment<D>> bearing_moment;     ///< [bearing] on body b N m
  std::vector<Vec<D>> bearing_displacement;  ///< [bearing] in its axes, as its limits count it [m]
  Energy given;                              ///< trial: energy given off and put in up to this instant J
  std::vector<double> bearing_energy;        ///< [bearing] elastic energy J
  double bearing_stored = 0;                 ///< their sum J

  // Writer: resist
  std::vector<PointMemory<D>> plastic;             ///< [plastic point] trial
  std::vector<double> beam_memory;                 ///< trial
  std::vector<Vec<D>> element_force;               ///< [node] of elastic and plastic stress N; empty without elements
  std::vector<Vec<D>> element_damping;             ///< [node] of the dampings of elements N
  std::vector<Moment<D>> element_moment;           ///< [node] of beams N m; empty without them
  std::vector<Moment<D>> element_damping_moment;   ///< [node] N m
  std::vector<ElementEnergy> element_energy;       ///< room, by stretch of elements
  std::vector<SpaceElementAnswer> element_answer;  ///< room, by element in space that threads take
  double element_stored = 0;                       ///< elastic energy of elements J

  // Writer: apply_loads. All empty where Model::loaded() is false.
  std::vector<Vec<D>> load;            ///< [node] all forces from outside but weight, steady ones included N
  std::vector<Moment<D>> load_moment;  ///< [node] N m

  // Writer: control_displacement. The forces of Model::pushes are part of `load`, `force` and so on from then on.
  std::vector<double> push_force;  ///< [push] without what makes up for dampings N
  std::vector<Vec<D>> correction;  ///< [node] the part of them that makes up for dampings; empty without pushes N
  std::vector<Moment<D>> correction_moment;  ///< [node] N m

  // Writer: sum
  std::vector<Vec<D>> force;      ///< [node] N
  std::vector<Moment<D>> moment;  ///< [node] N m
  std::vector<Vec<D>>
      added_inertia;  ///< [node] see integrate/explicit/mass_scaling.hpp; empty without it N. Writer: it
  double unbalanced = 0, carried = 0;  ///< largest unbalanced and largest carried force of a moving node N

  std::vector<NodeWork> node_work;  ///< room of advance, by stretch of nodes J

  // Writer: find_events
  std::vector<Event> events;             ///< of this step
  std::vector<ContactKey> closing;       ///< contacts that begin to touch in this step, sorted
  std::vector<ContactKey> closed_again;  ///< those of them that had parted a moment ago, sorted
  std::vector<std::uint8_t> may_close;   ///< room: flags of them

  double clear_path =
      0;  ///< no two pieces get too deep into each other while `travel` is below this, those of a
          ///< row while it is below clear_until. Writer: the watch of integrate/explicit/deep_penetration.hpp; detect
          ///< puts both back where it looks up a piece m

  /// Drops everything; see above.
  void drop() {
    const int kept = threads;
    *this = {};
    threads = kept;
  }
};

/// What the contacts remember up to now, in the rows of the pairs.
template <int D>
const Contacts<D>& contacts_before(const State<D>& state, const Work<D>& work) {
  return work.is_matched ? work.matched : state.contacts;
}

}  // namespace trilith
