// Specification of a frame: joints, and beams between them. World coordinates at the start.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "element/beam/fibre_beam.hpp"
#include "element/beam/hinge_law.hpp"
#include "element/section/section_3d.hpp"
#include "geometry/plane/polygon.hpp"
#include "model/model.hpp"

namespace trilith {

/// A node where members meet rigidly unless they are pinned.
struct FrameJoint {
  std::string name;           ///< unique in the frame
  Vec2 place = Vec2::Zero();  ///< [m]
  double mass = 0;            ///< in addition to its members' mass [kg]
  double inertia = 0;         ///< in addition to its members' inertia [kg m2]
  Polygon block = {};         ///< a rigid block that forms the joint, convex, with its centroid in `place`; or none [m]
  std::optional<double> density = {};    ///< of the block; default: the body's [kg/m3]
  std::optional<double> thickness = {};  ///< of the block, for its mass; default: the model's [m]
  std::array<Support, 3> support{};      ///< x, y, rotation
};

/// Plastic hinges at the start and the end of a member's flexible part; an end without one stays elastic.
struct MemberHinges {
  std::array<std::optional<HingeLaw>, 2> end;
};

/// A straight member. Its top is the side to the left of the direction from `from` to `to`.
struct FrameMember {
  std::string name;                         ///< for messages and readings
  int from = -1, to = -1;                   ///< indices of joints
  std::array<std::optional<Vec2>, 2> ends;  ///< ends of the flexible part, rigidly connected; default: the joints [m]
  Section section;
  std::optional<Section3> in_space;                                 ///< the section as a member in space
  std::string material;                                             ///< "": the body's
  int divisions = 8;                                                ///< number of beam elements
  std::array<bool, 2> pinned{};                                     ///< carries no moment there
  bool shear = false;                                               ///< with shear deformation
  std::variant<std::monostate, MemberFibres, MemberHinges> yields;  ///< elastic, or its way of yielding
};

struct FrameSpec {
  std::vector<FrameJoint> joints;
  std::vector<FrameMember> members;
  bool consistent = false;  ///< consistent mass in implicit steps and in modes; else lumped at nodes
};

/// A position on a member where a beam ends: its node, and the arm from there [m].
struct Station {
  int node;  ///< index within the frame: joints first, then inner nodes
  Vec2 arm;
  int turn;  ///< the node with which the section rotates
};

/// Nodes and sections of a frame, and its outline.
struct FramePlan {
  std::vector<Vec2> node;                      ///< [m]
  std::vector<std::vector<Station>> stations;  ///< [member]
  struct Side {
    int member, station, side;  ///< side 0: right of its direction (bottom), 1: left (top)
    int joint = -1;             ///< alternatively: `side` is a corner of this joint's block
  };
  std::vector<Side> outline;                ///< counter-clockwise around the frame
  std::vector<std::array<bool, 2>> is_tip;  ///< [member] its end is the only one at the joint

  [[nodiscard]] Vec2 place_of(const Station& s) const { return node[s.node] + s.arm; }
};

/// Throws InputError, with `owner` in front, if the frame is invalid: no member, members without length, unconnected
/// joints.
FramePlan plan_frame(const FrameSpec& spec, const std::string& owner);

/// Members without given ends begin where they leave the block of their joint.
void begin_at_blocks(FrameSpec& spec);

/// Its name, or "A-B" after its joints.
std::string name_of(const FrameSpec& spec, const FrameMember& member);

/// Position of the section's bottom (side 0) or top (side 1) relative to its station [m].
Vec2 section_edge(const FrameSpec& spec, const FramePlan& plan, int member, int side);

}  // namespace trilith
