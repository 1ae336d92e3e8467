// Planes inside bodies on which they may crack: the input of a user, and the rows of a model.
//
// A plane divides a body into two parts: one behind it and one ahead of it along its normal. Until the body cracks it
// is one body, and its planes change nothing. A rigid body parts along the plane, a mesh along the faces of its
// elements next to it. See edit/crack_search.hpp and edit/split.hpp.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/space.hpp"

namespace trilith {

/// A plane through a body, in its initial position.
template <int D>
struct CrackPlane {
  Vec<D> point = Vec<D>::Zero();    ///< [m]
  Vec<D> normal = Vec<D>::UnitX();  ///< any length above 0
};

/// Arrangements of planes by name.
enum class CrackPattern : std::uint8_t {
  planes,    ///< given one by one
  equal,     ///< `count` planes across the longer axis that divide the body into equal lengths
  diagonals  ///< the two diagonals of the rectangle around the body; of bodies in the plane
};

/// The planes of a body as a user gives them; none by default.
template <int D>
struct CrackSpec {
  CrackPattern pattern = CrackPattern::planes;
  int count = 0;                      ///< of CrackPattern::equal
  std::vector<CrackPlane<D>> planes;  ///< of CrackPattern::planes
  std::vector<int> numbers;           ///< of `planes` in the whole body; empty: from 1 on
  bool where_met = false;             ///< true: planes that miss the body are left out; false: they are errors
  std::string law;                    ///< contact law with the strengths; it acts between the parts afterwards

  [[nodiscard]] bool empty() const { return pattern == CrackPattern::planes && planes.empty(); }
};

/// Where a mesh parts: the faces between the elements on both sides of a plane, edges in the plane. Nodes and elements
/// count from the first of the body.
struct MeshCut {
  std::vector<std::uint8_t> behind;       ///< [element] 1: in the part behind, 0: in the part ahead
  std::vector<std::array<int, 4>> faces;  ///< nodes of each face, in the order of its element behind; -1: no node. In
                                          ///< the plane one face follows the other along the crack
  std::vector<int> nodes;                 ///< on the faces; in the plane in the order of the crack
  std::vector<int> elements;              ///< with a node on the faces, ascending
};

/// A plane's section of a body, and the part behind it. Positions are relative to the body's node, in its axes. Of a
/// mesh they are initial positions in the world, and mass, inertia and centroid are not used.
template <int D>
struct CrackSection {};
template <>
struct CrackSection<2> {
  int number = 0;                           ///< of the plane in the whole body, from 1
  Vec2 from = Vec2::Zero();                 ///< end of the section [m]
  Vec2 to = Vec2::Zero();                   ///< its other end, to the left of the normal [m]
  Vec2 normal = Vec2::UnitX();              ///< unit vector, from the part behind to the part ahead
  double mass = 0;                          ///< of the part behind [kg]
  double inertia = 0;                       ///< of the part behind about its centroid [kg m2]
  Vec2 centroid = Vec2::Zero();             ///< of the part behind [m]
  std::shared_ptr<const MeshCut> cut = {};  ///< of a mesh; none: the body is rigid

  [[nodiscard]] Vec2 middle() const { return 0.5 * (from + to); }
  [[nodiscard]] double length() const { return (to - from).norm(); }
};

/// In space the section is a convex polygon with axes x and y of its own, which with the normal are right-handed.
template <>
struct CrackSection<3> {
  int number = 0;                 ///< of the plane in the whole body, from 1
  Vec3 centre = Vec3::Zero();     ///< centroid of the section [m]
  Vec3 normal = Vec3::UnitX();    ///< unit vector, from the part behind to the part ahead
  Vec3 x = Vec3::UnitY();         ///< unit vector
  Vec3 y = Vec3::UnitZ();         ///< unit vector
  std::vector<Vec2> corners;      ///< along x and y from the centre, counter-clockwise about the normal [m]
  double area = 0;                ///< [m2]
  double xx = 0, xy = 0, yy = 0;  ///< second moments of area about the centre [m4]
  double mass = 0;                ///< of the part behind [kg]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< of the part behind about its centroid [kg m2]
  Vec3 centroid = Vec3::Zero();                       ///< of the part behind [m]
  std::shared_ptr<const MeshCut> cut = {};            ///< of a mesh; none: the body is rigid

  [[nodiscard]] const Vec3& middle() const { return centre; }
  [[nodiscard]] Vec3 at(const Vec2& p) const { return centre + p.x() * x + p.y() * y; }
  [[nodiscard]] double polar() const { return xx + yy; }
};

/// A body that may crack.
template <int D>
struct CrackingBody {
  int body = -1;
  int law = -1;      ///< index into Model::laws
  double depth = 1;  ///< thickness of its sections out of the plane [m]; of bodies in the plane
  std::vector<CrackSection<D>> sections;
};

/// Distance of the two parts at both ends of a section, along its normal, negative where they overlap [m].
struct CrackOpening {
  double from = 0, to = 0;
};

/// The next time at which the sections of a body are computed, see edit/crack_search.hpp.
struct CrackWatch {
  std::int64_t next = 0;  ///< step at which they are computed at the latest
  double load = 0;        ///< sum of the forces on its surface when they were computed [N]
  double change = 0;      ///< change of this sum beyond which they are computed at once [N]
};

/// All bodies of a model that may crack.
template <int D>
struct Cracking {
  std::vector<CrackingBody<D>> bodies;  ///< in the order of bodies
  std::vector<CrackWatch> watch;        ///< [bodies]; may be shorter: rows that are missing are due
};

}  // namespace trilith
