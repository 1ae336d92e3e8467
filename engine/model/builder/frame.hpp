// Specification of a frame in the plane or in space: joints, and members between them. World coordinates at the start.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "element/beam/fibre_beam.hpp"
#include "element/beam/hinge_law.hpp"
#include "element/section/section_3d.hpp"
#include "geometry/plane/polygon.hpp"
#include "geometry/space/polyhedron.hpp"
#include "model/model.hpp"

namespace trilith {

/// A node where members meet rigidly unless they are pinned.
template <int D>
struct FrameJointOf {
  using Block = std::conditional_t<D == 2, Polygon, Polyhedron>;

  std::string name;                   ///< unique in the frame
  Vec<D> place = Vec<D>::Zero();      ///< [m]
  double mass = 0;                    ///< in addition to its members' mass [kg]
  double inertia = 0;                 ///< in addition to its members' inertia, about any axis [kg m2]
  Block block = {};                   ///< rigid, forms the joint, convex, with its centroid in `place`; or none [m]
  std::optional<double> density{};    ///< of the block; default: the body's [kg/m3]
  std::optional<double> thickness{};  ///< of a block in the plane; default: the model's [m]
  std::array<Support, Space<D>::dofs> support{};  ///< x, y and, in space, z; then rotations

  [[nodiscard]] bool has_block() const {
    if constexpr (D == 2)
      return !block.empty();
    else
      return !block.corners.empty();
  }
};

/// Plastic hinges at the start and the end of a member's flexible part; an end without one stays elastic.
struct MemberHinges {
  std::array<std::optional<HingeLaw>, 2> end;
};

/// Section of a member, and its position about the axis. In the plane the top of the section is the side to the left of
/// the direction from `from` to `to`.
template <int D>
struct MemberSection {
  Section section;
  std::optional<Section3> in_space;  ///< the section as a member in space
};
template <>
struct MemberSection<3> {
  Section3 section;
  std::optional<Vec3> orientation;  ///< to the top of the section, not along the member; default: see member_axes
};

/// A straight member.
template <int D>
struct FrameMemberOf : MemberSection<D> {
  std::string name;                                                 ///< for messages and readings; unique in the frame
  int from = -1, to = -1;                                           ///< indices of joints
  std::array<std::optional<Vec<D>>, 2> ends;                        ///< of the flexible part, rigidly connected;
                                                                    ///< default: the joints [m]
  std::string material;                                             ///< "": the body's
  int divisions = 8;                                                ///< number of beam elements
  std::array<bool, 2> pinned{};                                     ///< carries no bending moment there
  bool shear = false;                                               ///< with shear deformation
  std::variant<std::monostate, MemberFibres, MemberHinges> yields;  ///< elastic, or its way of yielding
};

template <int D>
struct FrameSpecOf {
  std::vector<FrameJointOf<D>> joints;
  std::vector<FrameMemberOf<D>> members;
  bool consistent = false;  ///< consistent mass in implicit steps and in modes; else lumped at nodes
};

using FrameJoint = FrameJointOf<2>;
using FrameMember = FrameMemberOf<2>;
using FrameSpec = FrameSpecOf<2>;
using SpaceJoint = FrameJointOf<3>;
using SpaceMember = FrameMemberOf<3>;
using SpaceFrameSpec = FrameSpecOf<3>;

/// A position on a member where a beam ends: its node, and the arm from there [m].
template <int D>
struct StationOf {
  int node;  ///< index within the frame
  Vec<D> arm;
  int turn;  ///< the node with which the section rotates: the next one where the member is pinned to its joint
};

/// Nodes of a frame, and the stations of its members. Joints come first among the nodes, then the inner nodes of member
/// after member.
template <int D>
struct FramePlanOf {
  std::vector<Vec<D>> node;                         ///< [m]
  std::vector<std::vector<StationOf<D>>> stations;  ///< [member]
  std::vector<std::array<bool, 2>> is_tip;          ///< [member] its end is the only one at the joint, without a block

  [[nodiscard]] Vec<D> place_of(const StationOf<D>& s) const { return node[s.node] + s.arm; }
};
using FramePlan = FramePlanOf<2>;

/// Throws InputError, with `owner` in front, if the frame is invalid: no member, members without length, with one name
/// or without the data of their section, an orientation along the member, unconnected joints.
template <int D>
FramePlanOf<D> plan_frame(const FrameSpecOf<D>& spec, const std::string& owner);

/// Members without given ends begin where they leave the block of their joint.
template <int D>
void begin_at_blocks(FrameSpecOf<D>& spec);

/// Its name, or "A-B" after its joints.
template <int D>
std::string name_of(const FrameSpecOf<D>& spec, const FrameMemberOf<D>& member);

/// Start (0) or end (1) of the flexible part of a member [m].
template <int D>
Vec<D> end_of(const FrameSpecOf<D>& spec, const FrameMemberOf<D>& member, int side);

/// Length of the flexible part of a member [m].
template <int D>
double length_of(const FrameSpecOf<D>& spec, const FrameMemberOf<D>& member);

/// Rotation from world axes to a member's axes: x along it, y to the top of its section. Without an orientation the top
/// is up; for an upright member it points along x.
UnitQuaternion member_axes(const SpaceFrameSpec& spec, const SpaceMember& member);

}  // namespace trilith
