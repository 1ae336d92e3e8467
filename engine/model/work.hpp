// Everything computed from Model and State. Discarding it between two steps does not change the results.
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
#include "load/water/closed_joints.hpp"
#include "model/builder/shared_edges.hpp"
#include "model/contact/broad_phase_state.hpp"
#include "model/contact/general_contacts.hpp"
#include "model/contact/row_shares.hpp"
#include "model/event/event.hpp"
#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// Two pieces near each other. Row i belongs to row i of Work::contacts.
struct NearPair {
  int piece_a, piece_b;
  int law;             ///< index into Model::laws
  int facing;          ///< number of opposed pairs of faces: 0, 1, 2 (more counts as 2)
  int a0, a1, b0, b1;  ///< skin points of the two faces, if facing > 0
  double corner;       ///< see FaceOverlap::is_flat, if facing > 0
  bool replaced;       ///< a live bearing replaces the flat contact of these pieces; corners still touch
  // Cache of the general contact, tested first. No result depends on it. Writer: contact forces
  CornerOnFace corner_at = {};  ///< the only corner inside the other piece
  std::int16_t apart_by = -1;   ///< the separating edge, see OverlapResponse::apart_by
  // Cache, see broad_phase/face_tilt_cache.hpp. Writer: contact forces
  float tilted_from = 1, tilted_to = 0;  ///< no faces oppose each other for relative rotations in this range [rad]
};

/// Rows of `pairs` that are processed alike: one contact law, opposed faces.
struct FaceBatch {
  int law;
  std::vector<int> row;                 ///< one pair of opposed faces
  std::vector<int> choice;              ///< several pairs: one of them may be chosen in each step
  std::vector<std::uint8_t> has_faces;  ///< [choice] 1: it has a face pair in this step. Writer: contact forces
  std::vector<int> chosen;              ///< rows of `choice` with a face pair in this step. Writer: contact forces
  std::vector<int> now;                 ///< rows of this step, if `choice` is not empty. Writer: contact forces
};

/// Position [m] and velocity [m/s] of a skin point, in the order in which the contact kernel loads them.
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

/// Ranges of a body's rows: the part of Body that loops over bodies read, without its names.
struct BodyRow {
  int node, nodes;  ///< the first, and their number
  int skin, skins;
  SkinLayout layout;
  int fit = 0, fits = 0;
};

/// Geometry of a contact area in space, for the step estimate.
struct ContactArea {
  Vec3 middle, normal;           ///< [m], unit vector
  double area;                   ///< pressed, or bonded by mortar [m2]
  double radius;                 ///< see SolidPressure [m]
  double friction_arm;           ///< see SolidPressure [m]
  std::array<Vec3, 2> arm;       ///< see SolidPressure [m]
  int face_a = -1, face_b = -1;  ///< see SolidPressure
};

/// Result of one row's contact in space, before summation.
struct SolidAnswer {
  int row = -1;  ///< -1: not computed
  bool was_touching = false, touching = false, joint_changed = false;
  int carrier_a = 0, carrier_b = 0;  ///< the contact frames that they act on (model/contact/contact_frame.hpp)
  double area = 0, depth = 0;        ///< [m2], [m]
  double lost_damping = 0, lost_friction = 0, lost_fracture = 0;  ///< [J]
  Vec3 force, moment_a, moment_b;                                 ///< on b [N]; on both, about their positions [N m]
  Vec3 normal_force, centre;                                      ///< see SolidResponse
};

/// Result of one row's general contact in the plane, before summation.
struct OverlapAnswer {
  bool counts = false;                     ///< false: not computed, the rest is undefined
  bool changed = false, touching = false;  ///< see Work::changed_rows
  CornerOnFace corner_at = {};             ///< if valid, the corner that was used, and `push` has the forces; else
  Vec2 *on_a = nullptr, *on_b = nullptr;   ///< [corner] forces, in Work::answer_force [N]
  CornerPush push;
  OverlapResponse response;
  ShapeLoss let_go;  ///< energy that a face contact loses as it becomes a general one [J]
};

/// Energy dissipated by a row [J].
struct RowLoss {
  double damping = 0, friction = 0, fracture = 0;
};

/// Forces that are added after all rows: in the plane at a skin point, in space on a contact frame
/// (model/contact/contact_frame.hpp) with the moment about its position.
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

/// Rows of general contact processed by one thread in order; see assembly/contact/general_contact_partition.hpp. May be
/// empty: its lists keep their capacity.
template <int D>
struct GeneralRun {
  int first, last;                   ///< in Work::awake_rows; in space row indices
  int end_body;                      ///< bodies from here on belong to later runs
  std::vector<LaterForce<D>> later;  ///< on bodies shared by several runs
  std::vector<RowLoss> losses;       ///< if there are several runs
  std::vector<int> touching;         ///< slots in Work::general_touching
  std::vector<int> changed;          ///< see Work::changed_rows
};

/// Results of four rows of face contacts, except forces, when computed by several threads, before summation. Size: two
/// cache lines.
struct alignas(64) FourFaces {
  std::array<int, 4> row;
  std::array<std::uint8_t, 4>
      later;  ///< sides whose forces are added later, see assembly/contact/face_contact_simd.hpp
  std::array<bool, 4> turns, is_general;              ///< see Work::changed_rows
  std::array<double, 4> damping, friction, fracture;  ///< dissipated energy [J]
};
/// Forces of four rows on a0, a1, b0, b1 that are added later [N].
using FourForces = std::array<std::array<Vec2, 4>, 4>;

/// Opposed rows of a chunk, sorted: rows that touched; other rows that may touch now; rows that are general contacts
/// now and were in the last step. The kernel computes the first two groups.
struct SortedRows {
  std::size_t touched, fresh, tumbling;
};

/// Nodal forces of the elements of a chunk in space when computed by several threads, before summation.
struct SpaceElementAnswer {
  std::array<Vec3, max_space_nodes> force, damping;  ///< [N]
  double stored, plastic;                            ///< [J]
};

/// A contact that closes, opens or is loaded by an impact: see integrate/explicit/impact_step.hpp.
struct Blow {
  double begins;  ///< from now [s]
  double power;   ///< k v^2 / 2 + k^2 d^2 / 2 mu: times the squared step it is the energy error [J/s2]
};

/// Impact data of the step estimate.
struct ImpactWork {
  std::vector<double> mass;        ///< [body] [kg], 0 if it does not move. Writer: update_contact_pairs
  double total = 0, lightest = 0;  ///< of all moving bodies, and their lightest node [kg]. Writer: update_contact_pairs
  int still = -1;             ///< first node of a body that does not move, -1: all move. Writer: update_contact_pairs
  std::vector<double> speed;  ///< scratch: [body] [m/s]
  std::vector<std::uint8_t> counts;  ///< scratch: [body] 1: its error could exceed the limit
  std::vector<ContactKey> key;       ///< scratch: pairs of pieces
  std::vector<Blow> blows;           ///< scratch
};

/// Consecutive elements, all elements of some bodies.
struct ElementRange {
  int first, count;
};

/// Contributions of elements or beams to the ledger.
struct ElementEnergy {
  double stored = 0;   ///< [J]
  double plastic = 0;  ///< dissipated in this step [J]
};

/// Stiffnesses, friction and damping of a law with pressure proportional to the overlap.
struct LawNumbers {
  double kn, ks, mu, beta;  ///< [Pa/m], [Pa/m], [1], [s]
  bool is_linear;
};

/// Placed solids in space, and results of their contacts. Writers: update_kinematics (kinematics) and the contact force
/// stages (contact).
template <int D>
struct SolidWork {};
template <>
struct SolidWork<3> {
  std::vector<PlacedSolid> placed;  ///< [piece]. Writer: kinematics
  std::vector<Sphere> sphere;       ///< [piece] radius 0 for a polyhedron; empty without spheres. Writer: kinematics
  std::vector<StepBehind> behind;   ///< [node] of an implicit step; else empty. Writer: kinematics
  std::vector<double> speed2;       ///< [piece] largest squared speed of its corners [m2/s2]. Writer: kinematics
  std::vector<double> way;  ///< [piece] upper bound of the path length of its fastest corner from the last pair update,
                            ///< summed over poses [m]. Writer: kinematics
  std::vector<Separation3> separation;      ///< [contact] along the last separating axis. Writer: contact
  std::vector<Separation3> spare;           ///< scratch
  std::vector<FacePair> faces;              ///< [contact] faces that may lie flat on each other. Writer: contact
  std::vector<FacePair> spare_faces;        ///< scratch
  std::vector<LawNumbers> law;              ///< [law] parameters for flat faces. Writer: contact
  std::vector<ContactArea> areas;           ///< [contact] if touching. Writer: contact
  std::vector<Vec3> force, moment;          ///< [node] of all contacts, about the node [N], [N m]. Writer: contact
  std::vector<Fitted> fitted;               ///< [fit]. Writer: kinematics
  std::vector<MovingPlace> face_motion;     ///< [fit] their motion, for contact. Writer: kinematics
  std::vector<std::vector<Vec3>> before;    ///< [piece] scratch: previous positions of its corners
  std::vector<Vec3> fit_force, fit_moment;  ///< [fit] of all contacts, about its position [N], [N m]. Writer: contact
  std::vector<SolidRoom> room;              ///< [thread]
  std::vector<SolidAnswer> answer;          ///< results of the rows that are computed
};

/// A contact row in which an edge shared by several pieces is inside the other piece.
template <int D>
struct MetRow {
  int row;
  Vec<D> push;  ///< spring force on b [N]
};

/// Data of a step that the next one does not need. `evaluate` writes nothing else; `commit` makes a State from it.
template <int D>
struct Work {
  bool valid = false;            ///< false: all pairs must be searched again. Writer: update_contact_pairs
  int threads = 1;               ///< number of threads of a step; affects no result. Kept by drop()
  bool leave_out_beams = false;  ///< internal_forces omits beams: the tangent includes them

  // Writer: update_kinematics
  std::vector<BodyRow> body;        ///< [body], rebuilt with the pairs
  std::vector<SkinMotion<D>> skin;  ///< [skin]; in space empty, see SolidWork::placed
  std::vector<Vec<D>> skin_mean;    ///< [skin] mean velocity over the step [m/s]; empty in explicit stages
  double fastest = 0;               ///< largest speed of any skin point, in space of any corner [m/s]
  double fastest_moving = 0;        ///< the same for bodies that are free to move [m/s]

  std::vector<ElementRange> element_stretches;  ///< rebuilt with `body`

  // Writer: update_contact_pairs
  std::vector<NearPair> pairs;        ///< [contact]
  std::vector<FaceBatch> batches;     ///< by law
  std::vector<int> general;           ///< rows without a single pair of opposed faces
  std::vector<double> asleep_until;   ///< [contact] no contact while `travel`, in space the sum of both pieces' path
                                      ///< lengths, is below this [m]
  std::vector<double> clear_until;    ///< [contact] see clear_path [m]
  BroadPhaseState<D> search;          ///< state of the broad phase
  std::vector<NearPair> spare_pairs;  ///< scratch for the next list
  std::vector<double> spare_asleep, spare_clear;
  std::vector<RateBound> face_bound;    ///< [body] in contact at its stiffest face
  std::vector<RateBound> around_bound;  ///< [body] of elements: in contact all around, as if it were rigid
  ImpactWork impacts;
  SharedEdges ridges;   ///< rebuilt with the pairs. Writer: update_contact_pairs
  Contacts<D> matched;  ///< the state's contacts in the rows of the pairs, if these were updated after the last commit;
                        ///< else scratch
  bool is_matched = false;  ///< `matched` is valid
  double travel = 0;  ///< upper bound of the path length of the fastest skin point from the last full search, summed
                      ///< over evaluated poses [m]. Writer: update_kinematics

  SolidWork<D> solids;  ///< in space

  // Writer: contact and bearing forces
  Contacts<D> contacts;                      ///< [contact] trial state
  std::vector<BearingMemory<D>> bearing;     ///< [bearing] trial state
  std::vector<double> stood_for;             ///< [bearing] see BearingMemory; empty if none replaces a contact [m]
  std::vector<int> face_rows, fresh_rows;    ///< of a batch: rows that touched or may touch; only rows that may touch
  std::vector<SortedRows> sorted_rows;       ///< scratch, by chunk
  std::vector<FourFaces> four_faces;         ///< scratch of several threads
  std::vector<FourForces> four_forces;       ///< their forces
  RowShares row_shares;                      ///< partition of face rows over threads
  std::vector<RowRun> row_runs;              ///< of a batch, scratch
  std::vector<int> general_now;              ///< rows of `batches` that are general contacts now
  std::vector<Vec2> answer_force;            ///< scratch of `answer` [N]
  std::vector<std::uint8_t> is_general;      ///< [contact] scratch: 1: in general_now or `general`
  std::vector<int> awake_rows;               ///< those rows that are computed
  std::vector<int> awake_counts;             ///< scratch: number of these in each chunk of rows
  std::vector<GeneralRun<D>> general_runs;   ///< of these rows, in space of all rows
  std::vector<std::uint8_t> at_border;       ///< scratch: 1: a body has rows in several runs
  std::vector<std::uint8_t> meets;           ///< scratch, by row: 1: a shared edge is inside the other piece
  std::vector<MetRow<D>> met;                ///< these rows, see assembly/contact/shared_edge_normal.hpp
  std::vector<OverlapAnswer> answer;         ///< of rows computed by several threads
  PlacedPieces placed;                       ///< the pieces of these rows
  GeneralContacts<D> general_touching;       ///< the general contacts that touch
  std::vector<int> changed_rows;             ///< rows that began or ceased to touch, or lost a bond
  std::vector<Vec<D>> skin_force;            ///< [skin] [N]; empty in space
  std::vector<Vec<D>> bearing_force;         ///< [bearing] on body b, in world axes [N]
  std::vector<Moment<D>> bearing_moment;     ///< [bearing] on body b [N m]
  std::vector<Vec<D>> bearing_displacement;  ///< [bearing] in its axes, as its limits measure it [m]
  Energy given;                              ///< trial: energies dissipated and supplied up to this instant [J]
  std::vector<double> bearing_energy;        ///< [bearing] elastic energy [J]
  double bearing_stored = 0;                 ///< their sum [J]

  // Writer: internal_forces
  std::vector<PointMemory<D>> plastic;             ///< [plastic point] trial state
  std::vector<double> beam_memory;                 ///< trial state; then assembly/element/fibre_answers.hpp
  std::vector<Vec<D>> element_force;               ///< [node] of elastic and plastic stress [N]; empty without elements
  std::vector<Vec<D>> element_damping;             ///< [node] of element damping [N]
  std::vector<Moment<D>> element_moment;           ///< [node] of beams [N m]; empty without beams
  std::vector<Moment<D>> element_damping_moment;   ///< [node] [N m]
  std::vector<ElementEnergy> element_energy;       ///< scratch, by chunk of elements
  std::vector<SpaceElementAnswer> element_answer;  ///< scratch, by element in space when several threads are used
  double element_stored = 0;                       ///< elastic energy of elements [J]

  // Writer: apply_loads. All empty where Model::loaded() is false.
  std::vector<Vec<D>> load;            ///< [node] all external forces except weight, including steady ones [N]
  std::vector<Moment<D>> load_moment;  ///< [node] [N m]
  // The share of water in these forces; empty without water.
  std::vector<Vec<D>> water;            ///< [node] [N]
  std::vector<Moment<D>> water_moment;  ///< [node] [N m]
  ClosedJoints<D> closed_joints;
  std::vector<double> added_system;  ///< scratch of assembly/water/water_mass.hpp

  // Writer: control_displacement. From then on `load`, `force` etc. include the forces of Model::pushes.
  std::vector<double> push_force;  ///< [push] without the damping correction [N]
  std::vector<Vec<D>> correction;  ///< [node] part of these forces that compensates damping [N]; empty without pushes
  std::vector<Moment<D>> correction_moment;  ///< [node] [N m]

  // Writer: assemble_forces
  std::vector<Vec<D>> force;           ///< [node] [N]
  std::vector<Moment<D>> moment;       ///< [node] [N m]
  std::vector<Vec<D>> added_inertia;   ///< [node] [N], see integrate/explicit/mass_scaling.hpp; empty without it
  double unbalanced = 0, carried = 0;  ///< largest residual and largest carried force of a moving node [N]

  std::vector<NodeWork> node_work;  ///< scratch of advance, by chunk of nodes [J]

  // Writer: find_events
  std::vector<Event> events;             ///< of this step
  std::vector<ContactKey> closing;       ///< contacts that begin to touch in this step, sorted
  std::vector<ContactKey> closed_again;  ///< contacts of `closing` that had opened recently, sorted
  std::vector<std::uint8_t> may_close;   ///< scratch: flags of contacts

  double clear_path = 0;  ///< while `travel` is below this, and a row's while it is below clear_until, no two pieces
                          ///< reach excessive penetration [m]. Writer: integrate/explicit/deep_penetration.hpp;
                          ///< update_contact_pairs resets both for updated pieces

  /// Resets everything; see above.
  void drop() {
    const int kept = threads;
    *this = {};
    threads = kept;
  }
};

/// Memory of the contacts before the step, in the rows of the pairs.
template <int D>
const Contacts<D>& contacts_before(const State<D>& state, const Work<D>& work) {
  return work.is_matched ? work.matched : state.contacts;
}

}  // namespace trilith
