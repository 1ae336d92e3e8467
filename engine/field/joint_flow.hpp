// Flow of water through joints: a field whose cells are stretches of joints.
//
// The value of a cell is its pressure head psi, and its head h = z + psi, with
// the elevation z. The links follow the cubic law for the present aperture a,
// with the weight w of a unit volume and the viscosity mu:
//
//     q = b a^3 w / (12 mu) dh/dx,    V(psi) = b L (a + w psi (a/K + c)),
//
// b: width, L: length of the cell, K: bulk modulus of the water, c: compliance
// of the walls where they are not bodies of the model. A cell with a linear
// aperture from a0 to a1 has the resistance 12 mu L (a0 + a1) / (2 w b a0^2
// a1^2). Snow, "Rock fracture spacings, openings, and porosities", J. Soil
// Mech. Found. Div. ASCE 94, 1968.
//
// A cell that is not full has psi = 0, because air leaves it freely. So the
// volume is a monotone graph of h: 0 for h < z, between 0 and b L a at h = z,
// and V(psi) for h > z. The implicit step solves this graph exactly, by the
// active set of full, partly filled and empty cells, and so finds the front of
// the water with the pressures. Water volume is conserved to rounding. Nodes,
// at which joints meet, have no volume.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/attachment.hpp"
#include "field/field_state.hpp"

namespace trilith {

struct Field;

/// A face of a body at a joint in the plane.
struct FlowFace {
  int body = -1, skin_a = -1, skin_b = -1;
  double depth = 1;  ///< out-of-plane width [m]
};

/// A joint of flat faces of two rigid bodies in space: a rectangle on the lower
/// body, with which it moves.
struct FlowRectangle {
  Vec3 heel = Vec3::Zero(),
       toe = Vec3::Zero();          ///< middles of its first and its last side, in the
                                    ///< lower body's axes [m]
  Vec3 normal = Vec3::Zero();       ///< towards the upper body, in these axes
  Vec3 face = Vec3::Zero();         ///< a point of the upper body's face, in its axes [m]
  Vec3 face_normal = Vec3::Zero();  ///< of that face into the upper body, in these axes
};

/// A joint between two bodies, or a fissure of given size, in stretches of
/// equal length.
struct FlowJoint {
  std::string name;        ///< the parts of a joint that a crack meets have one name and follow each other
  int from = -1, to = -1;  ///< its nodes
  int first_cell = 0, cells = 0;
  double length = 0, width = 1;       ///< at the start [m]
  std::array<double, 2> elevation{};  ///< of its ends [m]
  std::array<double, 2> aperture{};   ///< of its ends, without load [m]
  double compliance = 0;              ///< c: opening by pressure [m/Pa]
  double coupling = 0;                ///< assumed response of the bodies to pressure [m/Pa]
  double density = 1000;              ///< [kg/m3]
  double viscosity = 1e-3;            ///< [Pa s]
  double bulk_modulus = 2.2e9;        ///< [Pa]
  double crack_aperture = 0;          ///< of a closed crack of its bodies that meets it; 0: its own aperture there [m]
  double weight = 0;                  ///< of a unit volume [N/m3]
  std::vector<FlowFace> upper,
      lower;                ///< none for a fissure; in space one each, without skin points
  Attachment<2> heel, toe;  ///< on the lower body, in the plane
  FlowRectangle rectangle;  ///< in space

  [[nodiscard]] bool has_bodies() const { return !upper.empty(); }
  [[nodiscard]] double cell_length() const { return length / cells; }
  /// Elevation and aperture without load at the relative position `s` [1].
  [[nodiscard]] double elevation_at(double s) const { return elevation[0] + s * (elevation[1] - elevation[0]); }
  [[nodiscard]] double aperture_at(double s) const { return aperture[0] + s * (aperture[1] - aperture[0]); }
};

/// A point at which joints begin and end.
struct FlowNode {
  std::string name;
  double elevation = 0;  ///< [m]
  int surrounding = -1;  ///< row of Field::surroundings with its head; -1:
                         ///< closed, or a junction
};

struct JointFlow {
  std::vector<FlowJoint> joints;
  std::vector<FlowNode> nodes;
  bool in_motion = false;  ///< water flows in stages of motion too; otherwise
                           ///< its pressures are held there
  bool is_chosen = false;  ///< a script has chosen `in_motion`

  /// Cells of all joints; the value of cell i is its pressure head [m], value
  /// cells() + i its volume of water [m3].
  [[nodiscard]] int cells() const { return joints.empty() ? 0 : joints.back().first_cell + joints.back().cells; }
  [[nodiscard]] bool has_bodies() const;
  /// The first joint of that name, or nullptr.
  [[nodiscard]] const FlowJoint* find(const std::string& name) const;
  [[nodiscard]] int find_node(const std::string& name) const;  ///< -1: none
};

/// Present apertures at both ends of each cell [cell] [m].
using Apertures = std::vector<std::array<double, 2>>;

/// Apertures of the joints without load, and of fissures under the pressures of
/// a state.
Apertures own_apertures(const JointFlow& flow, const FieldState& state);

/// Volume of water [m3].
double volume_of(const JointFlow& flow, const FieldState& state);

/// Result of a step.
struct FlowStep {
  std::vector<double> node_head;  ///< [m]
  std::vector<double> into;       ///< [node] water that flowed from the node into its
                                  ///< joints in the step [m3]
  int iterations = 0;
};

/// Implicit Euler steps; they damp jumps of pressure, and keep the front of the
/// water sharp.
class FlowSolver {
 public:
  FlowSolver();
  ~FlowSolver();
  FlowSolver(const FlowSolver&) = delete;
  FlowSolver& operator=(const FlowSolver&) = delete;

  /// A step of `dt` [s] from `before` to `after`. `head`: [surrounding] at its
  /// end [m]. `expected`: pressure heads at which the apertures between bodies
  /// hold [cell] [m]; such a joint is assumed to open by its coupling times the
  /// rest. Empty: bodies do not move.
  /// Throws InputError if no set of full cells satisfies the equations.
  FlowStep advance(const JointFlow& flow, const Apertures& apertures, std::span<const double> head,
                   std::span<const double> expected, double dt, const FieldState& before, FieldState& after);

 private:
  struct Equations;
  std::unique_ptr<Equations> equations_;
};

}  // namespace trilith
