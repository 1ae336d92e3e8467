// A frame to be: joints, and beams between them. World coordinates at the start.
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

/// A node that members meet at, rigidly but where they are pinned.
struct FrameJoint {
  std::string name;           ///< unique in the frame
  Vec2 place = Vec2::Zero();  ///< [m]
  double mass = 0;            ///< beside that of the members [kg]
  double inertia = 0;         ///< ... [kg m2]
  Polygon block = {};         ///< a rigid block that is the joint, convex, with its centroid in `place`; or none [m]
  std::optional<double> density = {};    ///< of the block; else of the body [kg/m3]
  std::optional<double> thickness = {};  ///< of the block, for its mass; else the model's [m]
  std::array<Support, 3> support{};      ///< x, y, rotation
};

/// Plastic hinges where a member's flexible part begins and ends; without one, that end stays elastic.
struct MemberHinges {
  std::array<std::optional<HingeLaw>, 2> end;
};

/// A straight member. Its top is the side to the left of the way from `from` to `to`.
struct FrameMember {
  std::string name;                         ///< for messages and readings
  int from = -1, to = -1;                   ///< indices of joints
  std::array<std::optional<Vec2>, 2> ends;  ///< where the flexible part begins and ends, which turns rigidly
                                            ///< with the joint; without it, at the joint itself [m]
  Section section;
  std::optional<Section3> in_space;                                 ///< the same section of a member in space
  std::string material;                                             ///< "": the body's
  int divisions = 8;                                                ///< beam elements in a row
  std::array<bool, 2> pinned{};                                     ///< carries no moment there
  bool shear = false;                                               ///< with shear deformation
  std::variant<std::monostate, MemberFibres, MemberHinges> yields;  ///< not at all, or how
};

struct FrameSpec {
  std::vector<FrameJoint> joints;
  std::vector<FrameMember> members;
  bool consistent = false;  ///< mass of members under implicit steps and in modes; else lumped at nodes
};

/// A place on a member at which a beam ends: its node, and the arm from there [m].
struct Station {
  int node;  ///< index within the frame: joints first, then what lies between
  Vec2 arm;
  int turn;  ///< the node that the section turns with
};

/// Nodes and sections of a frame, and the way round it.
struct FramePlan {
  std::vector<Vec2> node;                      ///< [m]
  std::vector<std::vector<Station>> stations;  ///< [member]
  struct Side {
    int member, station, side;  ///< side 0: right of its direction (bottom), 1: left (top)
    int joint = -1;             ///< instead: `side` is a corner of this joint's block
  };
  std::vector<Side> outline;                ///< counter-clockwise round the frame
  std::vector<std::array<bool, 2>> is_tip;  ///< [member] its end is the only one at the joint

  [[nodiscard]] Vec2 place_of(const Station& s) const { return node[s.node] + s.arm; }
};

/// Throws InputError, with `owner` in front, where the frame is none: no member, members without length, joints that
/// nothing connects.
FramePlan plan_frame(const FrameSpec& spec, const std::string& owner);

/// Members that say nothing else begin where their way leaves the block of their joint.
void begin_at_blocks(FrameSpec& spec);

/// Its name, or "A-B" after its joints.
std::string name_of(const FrameSpec& spec, const FrameMember& member);

/// Where the section's bottom (side 0) and top (side 1) are from its station [m].
Vec2 section_edge(const FrameSpec& spec, const FramePlan& plan, int member, int side);

}  // namespace trilith
