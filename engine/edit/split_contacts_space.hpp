// Contacts of bodies in space that split: each goes to the part that holds it, with its memory.
#pragma once

#include <optional>
#include <vector>

#include "edit/crack_search.hpp"
#include "edit/split_contacts.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// The area over which two solids touch, in a plane.
struct TouchedArea {
  Vec3 origin = Vec3::Zero(), x = Vec3::UnitX(), y = Vec3::UnitY();  ///< its plane; unit vectors along it
  std::vector<Vec2> corners;                                         ///< convex, counter-clockwise about x times y [m]
  double radius = 0;  ///< of gyration, as the memory of the contact uses it [m]
};

/// The contact of two pieces in space with its memory.
struct SolidRecord {
  int piece_a = -1, piece_b = -1;
  SolidMemory memory = {};
  JointMemory joint = {};                ///< empty without mortar
  std::optional<TouchedArea> area = {};  ///< of faces that lie on each other
  std::optional<Vec3> place = {};        ///< of any other contact that touches [m]
};

/// Records of all contacts with a memory, before the model grows; as contact_records in the plane.
std::vector<SolidRecord> solid_records(const Model<3>& model, const State<3>& state, const Work<3>& work);

/// As handed_over in the plane. `on_plane` and `normal`: the plane of the crack in its present position.
std::vector<SolidRecord> handed_over(const Model<3>& model, const State<3>& state,
                                     const std::vector<SolidRecord>& records, const SplitBody& split,
                                     const Vec3& on_plane, const Vec3& normal);

/// The joint of both parts across the section of their crack, if its law softens. Its seats are apart by the stress of
/// the section over the stiffness of the law, so that it begins with the forces of the section.
std::optional<SolidRecord> crack_contact(const Model<3>& model, const State<3>& state, const SplitBody& split,
                                         const CrackingBody<3>& row, const Crack<3>& crack);

/// The two faces of a crack: pieces, and faces of pieces that deform (-1: the piece moves with a node).
struct CrackFaces {
  int piece_a = -1, face_a = -1, piece_b = -1, face_b = -1;
};

/// The intact joint of two faces across a section, with these forces. `centre` and `axes` (x, y and normal as columns):
/// its present position. `kn`: stiffness of its law [Pa/m]. Compression is overlap, so the opening is the stress over
/// the stiffness.
SolidRecord section_joint(const Model<3>& model, const State<3>& state, const CrackFaces& faces,
                          const CrackSection<3>& section, const Vec3& centre, const Eigen::Matrix3d& axes,
                          const SpaceForces& forces, double kn);

/// Puts the pieces of a record in their order, lower index first.
SolidRecord ordered(const Model<3>& model, const State<3>& state, SolidRecord record);

/// Writes all records to the state, in the order of their pieces.
void put_contacts(State<3>& state, std::vector<SolidRecord> records);

// Joints (edit/split_joints.cpp).

/// The joint over a part of its outline: `corners` in its axes. Empty where the part has no area.
JointMemory part_of_joint(const JointMemory& whole, std::span<const Vec2> corners);
/// A joint whose seat on its first or second body moves with another body from now on.
void move_seat(JointMemory& joint, bool first, const BodyMotion& from, const BodyMotion& to);
/// The joint with its two bodies in the other order.
JointMemory turned_joint(const JointMemory& joint);

}  // namespace trilith
