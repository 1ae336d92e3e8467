// Content of a results file as plain values, without HDF5 and model. The schema is described in docs/results.md. SI
// throughout: m, kg, s, N, J, rad. Indices count from 0; -1 means none.
#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "geometry/space/polyhedron.hpp"

namespace trilith::results {

/// A results file cannot be written or read: unwritable path, full disk, not a results file, truncated, newer version.
/// One line with the file, the reason and, if possible, advice.
class ResultsError : public std::runtime_error {
 public:
  explicit ResultsError(const std::string& message) : std::runtime_error(message) {}
};

/// Version of the layout. A reader accepts this and earlier ones; a change that old readers would misread increases it.
inline constexpr int format_version = 1;

/// Numbers per rotation: 1 (angle [rad], anticlockwise) in 2D; 4 (unit quaternion w, x, y, z) in 3D.
constexpr int rotation_width(int dim) {
  return dim == 2 ? 1 : 4;
}
/// Numbers per angular velocity or moment of inertia: 1 in 2D, 3 in 3D.
constexpr int spin_width(int dim) {
  return dim == 2 ? 1 : 3;
}

/// A named column: a history or a term of the energy ledger.
struct Quantity {
  std::string name;         ///< not empty, no '/', not "time", unique in its group
  std::string unit;         ///< SI, e.g. "m", "N", "J"; "1" for a pure number
  std::string description;  ///< one sentence
};

/// A parameter of the script, as text, with its value in this run.
struct ParameterRow {
  std::string name, value, unit, fallback, text;  ///< `fallback`: the declared default; `text`: its sentence
};

/// Origin of the file. `start_time` is the only clock in the file.
struct Provenance {
  std::string script;           ///< full text
  std::string script_path;      ///< as given on the command line
  std::string program_version;  ///< e.g. "1.0.0"
  std::string git_commit;       ///< empty if unknown
  std::string compiler;
  std::string platform;
  std::string start_time;    ///< UTC, ISO 8601, e.g. "2025-11-21T09:30:00Z"
  std::string command_line;  ///< arguments, separated by blanks
  std::vector<ParameterRow> parameters;
  std::vector<std::string> motions;  ///< one line per ground motion used
  std::string model;                 ///< its name; may be empty
  std::string units;                 ///< of the script, in which results are shown, e.g. "kN m"; empty: SI
};

/// One body. Its nodes, outline points and faces are slices of the arrays in Header.
struct BodyRow {
  std::string name, kind, material;
  std::string groups;   ///< names separated by blanks
  std::string support;  ///< "free", "fixed", "moved", ... as in the model
  std::int32_t first_node = 0, node_count = 1;
  std::int32_t first_vertex = 0, vertex_count = 0;
  std::int32_t first_face = 0, face_count = 0;  ///< in space only; outer faces
};

/// A material, a contact law between two materials or groups, or the yielding section or hinge of members; `text` lists
/// its parameters with units.
struct LawRow {
  std::string name;
  std::string role;    ///< "material", "contact" or "section"
  std::string first;   ///< contact: one side; material: empty; section: names of members
  std::string second;  ///< contact: other side; material: empty
  std::string text;
};

/// A bearing between two points fixed to two bodies.
struct BearingRow {
  std::string name;
  std::int32_t body_a = -1, body_b = -1;
  double point_a[3] = {0, 0, 0};  ///< in the axes of body a, from its first node; dim numbers are used [m]
  double point_b[3] = {0, 0, 0};  ///< in the axes of body b [m]
  std::string law;                ///< law and parameters as text
};

/// Two faces that lie on each other at the start.
struct JointRow {
  std::int32_t body_a = -1, body_b = -1;
  std::int32_t storey = 0;      ///< 0: none
  std::int32_t bonded = 0;      ///< 1: with a bond
  double end_0[3] = {0, 0, 0};  ///< positions of its ends at the start, world axes; in space ends of its longer axis
                                ///< [m]
  double end_1[3] = {0, 0, 0};
  double area = 0;  ///< in space [m2]
};

/// A straight member of a frame. Its beams are consecutive rows of Header::beams.
struct MemberRow {
  std::string name, from, to;  ///< `from`, `to`: joints at its start and its end
  std::string yields;          ///< "elastic", "hinges" or "fibres"
  std::int32_t body = -1, first_beam = 0, beam_count = 0;
  double yield_rotation[2] = {0, 0};  ///< of hinges at its start and its end: chord rotation at the yield moment in
                                      ///< double bending, M L / (6 EI); 0: none [rad]
};

/// A beam element of a member, between two nodes.
struct BeamRow {
  std::int32_t member = -1, node_a = -1, node_b = -1;
  double arm_a[3] = {0, 0, 0};  ///< from the node to the end of the beam, in the axes of the node; dim numbers are used
  double arm_b[3] = {0, 0, 0};  ///< [m]
  double up[3] = {0, 0, 0};     ///< unit vector to the top of the section, in the axes of node a
  double length = 0;            ///< initial [m]
};

/// Values in every frame in addition to motion and contacts: one row of `width` for each of `rows` objects.
struct Field {
  std::string name;  ///< of its data set in /frames
  std::string unit, description;
  std::size_t rows = 0;
  int width = 1;
};

/// All data that are constant during a run. Arrays are flat, row after row.
struct Header {
  int dim = 2;
  Provenance provenance;
  std::vector<BodyRow> bodies;
  std::vector<double> node_position;        ///< [N][dim] at the start [m]
  std::vector<double> node_rotation;        ///< [N][rotation_width] at the start
  std::vector<double> node_mass;            ///< [N] 0 for a driven or fixed node without mass [kg]
  std::vector<double> node_inertia;         ///< [N][spin_width] about the node [kg m2]
  std::vector<double> vertices;             ///< [V][dim] outline points in body axes, from their node [m]
  std::vector<std::int32_t> vertex_node;    ///< [V] node of each outline point
  std::vector<std::int32_t> face_vertex;    ///< loops of rows of `vertices`, counter-clockwise seen from outside (3D)
  std::vector<std::int32_t> face_first;     ///< [F + 1] begin of each loop in face_vertex, and the end; or empty
  std::vector<std::int32_t> sphere_vertex;  ///< [S] row of `vertices` of the centre of each sphere (3D); or empty
  std::vector<double> sphere_radius;        ///< [S] [m]
  std::vector<std::int32_t> element_node;   ///< [E][4] nodes of each finite element, -1 after a triangle's third (2D)
  std::vector<std::int32_t> element_body;   ///< [E]
  std::vector<LawRow> laws;
  std::vector<BearingRow> bearings;
  std::vector<JointRow> joints;
  std::vector<MemberRow> members;  ///< of frames; their forces in each frame are fields (run/record/member_fields.hpp)
  std::vector<BeamRow> beams;
  std::vector<Field> fields;
  std::vector<Quantity> histories;
  std::vector<Quantity> energy_terms;
  bool with_velocity = false;  ///< frames contain velocities too

  std::size_t node_count() const { return node_mass.size(); }
  std::size_t element_count() const { return element_body.size(); }
  std::size_t face_count() const { return face_first.empty() ? 0 : face_first.size() - 1; }

  /// Adds a one-node body: fills its slices and appends its node and outline. `position`: dim numbers [m]; `rotation`:
  /// rotation_width; `inertia`: spin_width; `outline`: [v][dim] in body axes.
  void add_rigid_body(BodyRow body, std::span<const double> position, std::span<const double> rotation, double mass,
                      std::span<const double> inertia, std::span<const double> outline);

  /// Adds a body in space (dim 3) with its faces. `corners`: [v][3] in body axes [m]; `faces`: loops of indices into
  /// `corners`, counter-clockwise seen from outside.
  void add_solid_body(BodyRow body, std::span<const double> position, std::span<const double> rotation, double mass,
                      std::span<const double> inertia, std::span<const double> corners, const FaceLoops& faces);

  /// Makes a point of the body added last the centre of a sphere. `corner`: index of the point in the body.
  void add_sphere(int corner, double radius);
  /// Radius of the sphere about each vertex, 0 without a sphere; empty without any spheres.
  std::vector<double> vertex_radius() const;
};

enum class ContactState : std::int8_t { bonded = 0, sticking = 1, sliding = 2 };
/// `waiting`: without force until another bearing fails. `absent`: not placed yet, or removed.
enum class BearingState : std::int8_t { intact = 0, yielded = 1, failed = 2, changed = 3, waiting = 4, absent = 5 };

/// Resultant of one contact in a frame: the force on body a at `point`; the opposite acts on body b.
struct ContactForce {
  double point[3] = {0, 0, 0};  ///< world axes [m]
  double force[3] = {0, 0, 0};  ///< world axes [N]
  std::int32_t body_a = -1, body_b = -1;
  ContactState state = ContactState::sticking;
  double area = 0;               ///< contact area (3D only) [m2]
  double normal[3] = {0, 0, 0};  ///< unit vector from body a to body b, world axes (3D only); zero if unknown
};

/// One frame for the writer: views into the caller's arrays, read only during the call.
struct FrameRow {
  double time = 0;                   ///< not below the time of the previous frame [s]
  std::int64_t step = 0;             ///< number of steps done
  std::int32_t stage = 0;            ///< row of the stages table
  std::span<const double> position;  ///< [N][dim] m
  std::span<const double> rotation;  ///< [N][rotation_width]
  std::span<const double> velocity;  ///< [N][dim] m/s; empty unless Header::with_velocity
  std::span<const double> spin;      ///< [N][spin_width] rad/s; as velocity
  std::span<const ContactForce> contacts;
  std::span<const BearingState> bearing_state;       ///< [B]
  std::span<const double> bearing_force;             ///< [B][dim] N, on body b, world axes
  std::span<const double> bearing_displacement;      ///< [B][dim] m, of point b relative to point a, from the start
  std::span<const double> stress = {};               ///< [E][3] Pa: mean sxx, syy, sxy of each element, world axes
  std::span<const double> plastic = {};              ///< [E] mean measure of plastic strain
  std::span<const std::vector<double>> fields = {};  ///< [Header::fields][rows][width]
};

/// One frame from the reader. Members as in FrameRow.
struct Frame {
  double time = 0;
  std::int64_t step = 0;
  std::int32_t stage = 0;
  std::vector<double> position, rotation, velocity, spin, stress, plastic;
  std::vector<ContactForce> contacts;
  std::vector<BearingState> bearing_state;
  std::vector<double> bearing_force, bearing_displacement;
  std::vector<std::vector<double>> fields;
};

/// A value of an event, e.g. {"speed", "m/s", 3.2}.
struct Figure {
  std::string name, unit;
  double value = 0;
};

/// One event. The writer fills in the names of bodies and bearing from the indices.
struct EventRow {
  std::int64_t id = 0;
  double time = 0;  ///< [s]
  std::int64_t step = 0;
  std::int32_t stage = 0;
  std::string type;  ///< e.g. "bearing.failed"; at most 32 bytes
  std::int32_t body_a = -1, body_b = -1, bearing = -1;
  std::string body_a_name, body_b_name, bearing_name;
  bool has_place = false;
  double place[3] = {0, 0, 0};  ///< world axes; zero unless has_place [m]
  Figure first, second;         ///< empty names if unused
  std::int64_t cause = -1;      ///< id of the event that caused this one
  std::string text;             ///< one sentence; longer than 160 bytes is cut and marked with an ellipsis
};

/// One stage. While it runs `ended` is false and `end` equals `begin`.
struct StageRow {
  std::string name, kind;
  double begin = 0, end = 0;  ///< [s]
  bool ended = false;
  std::string why;  ///< reason for its end, e.g. "at rest"
};

/// A natural mode at some time of the run: its row in the table, the positions of the nodes and their mode shape,
/// scaled to phi' M phi = 1.
struct ModeRow {
  std::int32_t analysis = 0;         ///< modes found together share the index; from 0
  std::int32_t number = 1;           ///< by increasing frequency, from 1
  double time = 0;                   ///< [s]
  double frequency = 0;              ///< 0 if it does not vibrate [Hz]
  double damping = 0;                ///< ratio to critical
  double mass[3] = {0, 0, 0};        ///< effective mass along each axis; dim numbers are used [kg]
  std::vector<double> position;      ///< [N][dim] positions of the nodes [m]
  std::vector<double> rotation;      ///< [N][rotation_width]
  std::vector<double> displacement;  ///< [N][dim] 1/sqrt(kg)
  std::vector<double> turn;          ///< [N][spin_width] 1/(m sqrt(kg))
};

/// A ground motion of a body along one direction. GroundMotion of these samples gives the displacement: the node is at
/// origin + displacement(t - begin).
struct MotionRow {
  std::int32_t body = -1;         ///< row of the bodies
  std::int32_t node = -1;         ///< the node of that body that follows it; the others keep their distance
  std::string direction;          ///< "x", "y", "z" or "rotation"
  double begin = 0;               ///< time of the run at which the motion's time is 0 [s]
  double origin = 0;              ///< coordinate of the node at displacement 0 [m], [rad]
  double step = 0;                ///< [s]
  double start_time = 0;          ///< of the first sample, in the motion's time [s]
  double start_velocity = 0;      ///< [m/s], at the first sample
  double start_displacement = 0;  ///< [m]
  std::int64_t first_sample = 0, sample_count = 0;  ///< its samples in the file; set by the writer
  std::string record;                               ///< file of the record; may be empty, as the next
  std::string title;                                ///< event and station
  std::string text;                                 ///< its processing; text beyond 240 bytes is cut
  std::vector<double> acceleration;                 ///< [sample] [m/s2], or [rad/s2] for a rotation
};

/// The energy ledger: one column per term of Header::energy_terms [J].
struct EnergyTable {
  std::vector<double> time;
  std::vector<std::vector<double>> terms;
  std::vector<double> residual;
};

}  // namespace trilith::results
