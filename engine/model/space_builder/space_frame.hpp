// A frame in space to be: joints, and beams between them. World coordinates at the start.
//
// Its skin hangs on its nodes: each goes with a rigid convex solid for either half of the beams beside it, the profile
// of the member over that length. At the middle of a beam two such solids meet; there they part by the third power of
// the beam's length times the change of curvature, so that a girder of a few beams has an even underside. A force on
// the skin is one force and one moment on one node, with exactly its work.
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

/// A node that members meet at, rigidly but where they are pinned.
struct SpaceJoint {
  std::string name;           ///< unique in the frame
  Vec3 place = Vec3::Zero();  ///< [m]
  double mass = 0;            ///< beside that of the members [kg]
  double inertia = 0;         ///< ... about any axis [kg m2]
  Polyhedron block = {};      ///< a rigid block that is the joint, convex, its centroid in `place`; or none [m]
  std::optional<double> density = {};  ///< of the block; else of the body [kg/m3]
  std::array<Support, 6> support{};    ///< x, y, z, and turns about them

  [[nodiscard]] bool has_block() const { return !block.corners.empty(); }
};

/// A straight member.
struct SpaceMember {
  std::string name;                         ///< for messages and readings
  int from = -1, to = -1;                   ///< indices of joints
  std::array<std::optional<Vec3>, 2> ends;  ///< where the flexible part begins and ends, which turns rigidly with the
                                            ///< joint; without it, at the joint itself [m]
  Section3 section;
  std::optional<Vec3> orientation;     ///< to the top of the section, not along the member; else see member_axes
  std::string material;                ///< "": the body's
  int divisions = 8;                   ///< beam elements in a row
  std::array<bool, 2> pinned{};        ///< carries no bending moment there
  bool shear = false;                  ///< with shear deformation
  std::optional<MemberFibres> fibres;  ///< it yields, in these ...
  std::array<std::optional<HingeLaw>, 2> hinge{};  ///< ... or where it begins and ends; else it is elastic
};

struct SpaceFrameSpec {
  std::vector<SpaceJoint> joints;
  std::vector<SpaceMember> members;
  bool consistent = false;  ///< mass of members under implicit steps and in modes; else lumped at nodes
};

/// What a member is made of.
struct SpaceMemberMaterial {
  double mass;  ///< [kg/m]
  BeamMaterial3 elastic;
  double damping;  ///< [s]
  std::optional<BandDamping> band;
  double strain_limit;
};

/// A frame with all that its rows of a model are made from.
struct SpaceFrameBody {
  std::string name;
  SpaceFrameSpec frame;
  std::vector<SpaceMemberMaterial> material;  ///< [member]
  double density = 0;                         ///< of blocks that say nothing else [kg/m3]
  Vec3 velocity = Vec3::Zero();               ///< of its centre of mass [m/s]
  Vec3 spin = Vec3::Zero();                   ///< [rad/s]
  std::array<Support, 6> support{};           ///< of all nodes, beside those of joints
  std::vector<SpaceNodeSupport> supports;     ///< of some
  int surface = 0;
};

/// Members that say nothing else begin where their way leaves the block of their joint.
void begin_at_blocks(SpaceFrameSpec& spec);

/// Where the flexible part of a member begins (0) or ends (1) [m].
Vec3 end_of(const SpaceFrameSpec& spec, const SpaceMember& member, std::size_t side);

/// Throws InputError, with `owner` in front, where the frame is none: no member, members without length, sections
/// without what space asks for, an orientation along the member, joints that nothing connects.
void check_space_frame(const SpaceFrameSpec& spec, const std::string& owner);

/// Its name, or "A-B" after its joints.
std::string name_of(const SpaceFrameSpec& spec, const SpaceMember& member);
double length_of(const SpaceFrameSpec& spec, const SpaceMember& member);

/// Turns the world's axes to those of a member: x along it, y to the top of its section. Without an orientation the
/// top is up, that of an upright member to x.
UnitQuaternion member_axes(const SpaceFrameSpec& spec, const SpaceMember& member);

/// A stretch of a member's skin and the node it goes with: joints come first among the nodes of a frame, then what lies
/// within members, one after the other.
struct SkinStretch {
  int node;
  double from, to;    ///< along the member [m]
  bool begins, ends;  ///< at a tip of the member, where its face is part of the surface
};
std::vector<SkinStretch> skin_stretches(const SpaceFrameSpec& spec, std::size_t member);

/// The profile of a member over a stretch of it, where it stands.
std::vector<Polyhedron> skin_solids(const SpaceFrameSpec& spec, std::size_t member, const SkinStretch& stretch);

/// Where its nodes stand at the start: joints, then what lies within members [m].
std::vector<Vec3> node_places(const SpaceFrameSpec& spec);

/// Node `i` of those from a member's start to its end.
int node_within(const SpaceFrameSpec& spec, std::size_t member, int i);

}  // namespace trilith
