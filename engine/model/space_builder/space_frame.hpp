// Specification of a frame in space: joints, and beams between them. World coordinates at the start.
//
// The skin is attached to the nodes: each node moves a rigid convex solid, the profile of the member over half of the
// beam on either side. Two such solids meet at the middle of a beam. There they separate by the third power of the
// beam's length times the change of curvature, so that a girder of a few beams has a smooth underside. A force on the
// skin is one force and one moment on one node, with exactly its work.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "element/band_damping.hpp"
#include "element/beam/beam_element_3d.hpp"
#include "element/beam/fibre_beam.hpp"
#include "element/beam/hinge_law.hpp"
#include "element/section/section_3d.hpp"
#include "geometry/space/polyhedron.hpp"
#include "model/builder/node_support.hpp"
#include "model/model.hpp"

namespace trilith {

/// A node where members meet rigidly unless they are pinned.
struct SpaceJoint {
  std::string name;           ///< unique in the frame
  Vec3 place = Vec3::Zero();  ///< [m]
  double mass = 0;            ///< in addition to its members' mass [kg]
  double inertia = 0;         ///< in addition to its members' inertia, about any axis [kg m2]
  Polyhedron block = {};      ///< a rigid block that forms the joint, convex, its centroid in `place`; or none [m]
  std::optional<double> density = {};  ///< of the block; default: the body's [kg/m3]
  std::array<Support, 6> support{};    ///< x, y, z, and rotations about them

  [[nodiscard]] bool has_block() const { return !block.corners.empty(); }
};

/// A straight member.
struct SpaceMember {
  std::string name;                         ///< for messages and readings
  int from = -1, to = -1;                   ///< indices of joints
  std::array<std::optional<Vec3>, 2> ends;  ///< ends of the flexible part, rigidly connected; default: the joints [m]
  Section3 section;
  std::optional<Vec3> orientation;     ///< to the top of the section, not along the member; default: see member_axes
  std::string material;                ///< "": the body's
  int divisions = 8;                   ///< number of beam elements
  std::array<bool, 2> pinned{};        ///< carries no bending moment there
  bool shear = false;                  ///< with shear deformation
  std::optional<MemberFibres> fibres;  ///< it yields, in these fibres
  std::array<std::optional<HingeLaw>, 2> hinge{};  ///< it yields at its start and end; else it is elastic
};

struct SpaceFrameSpec {
  std::vector<SpaceJoint> joints;
  std::vector<SpaceMember> members;
  bool consistent = false;  ///< consistent mass in implicit steps and in modes; else lumped at nodes
};

/// Material data of a member.
struct SpaceMemberMaterial {
  double mass;  ///< [kg/m]
  BeamMaterial3 elastic;
  double damping;  ///< [s]
  std::optional<BandDamping> band;
  double strain_limit;
};

/// A frame with all data for its rows of a model.
struct SpaceFrameBody {
  std::string name;
  SpaceFrameSpec frame;
  std::vector<SpaceMemberMaterial> material;  ///< [member]
  double density = 0;                         ///< default for blocks [kg/m3]
  Vec3 velocity = Vec3::Zero();               ///< of its centre of mass [m/s]
  Vec3 spin = Vec3::Zero();                   ///< [rad/s]
  std::array<Support, 6> support{};           ///< for all nodes, in addition to the joints' supports
  std::vector<SpaceNodeSupport> supports;     ///< for some nodes
  int surface = 0;
};

/// Members without given ends begin where they leave the block of their joint.
void begin_at_blocks(SpaceFrameSpec& spec);

/// Start (0) or end (1) of the flexible part of a member [m].
Vec3 end_of(const SpaceFrameSpec& spec, const SpaceMember& member, std::size_t side);

/// Throws InputError, with `owner` in front, if the frame is invalid: no member, members without length, sections
/// without the data required in space, an orientation along the member, unconnected joints.
void check_space_frame(const SpaceFrameSpec& spec, const std::string& owner);

/// Its name, or "A-B" after its joints.
std::string name_of(const SpaceFrameSpec& spec, const SpaceMember& member);
double length_of(const SpaceFrameSpec& spec, const SpaceMember& member);

/// Rotation from world axes to a member's axes: x along it, y to the top of its section. Without an orientation the top
/// is up; for an upright member it points along x.
UnitQuaternion member_axes(const SpaceFrameSpec& spec, const SpaceMember& member);

/// A section of a member's skin and its node. Joints come first among the nodes of a frame, then the inner nodes of the
/// members, one after the other.
struct SkinStretch {
  int node;
  double from, to;    ///< along the member [m]
  bool begins, ends;  ///< at a tip of the member, where its face is part of the surface
};
std::vector<SkinStretch> skin_stretches(const SpaceFrameSpec& spec, std::size_t member);

/// The profile of a member over a section of it, in its initial position.
std::vector<Polyhedron> skin_solids(const SpaceFrameSpec& spec, std::size_t member, const SkinStretch& stretch);

/// Initial positions of the nodes: joints, then inner nodes of members [m].
std::vector<Vec3> node_places(const SpaceFrameSpec& spec);

/// Index of node `i` along a member from its start to its end.
int node_within(const SpaceFrameSpec& spec, std::size_t member, int i);

}  // namespace trilith
