// Contact of two convex pieces of any shape and pose, from the overlap of their areas.
//
// The elastic energy is W = kn/2 ( integral of e(phi_A) + integral of e(phi_B) ) over the overlap, phi being the
// distance to the nearest face of a piece, and kn e(phi) the law's pressure at an overlap of phi; e(phi) = phi where it
// is linear. Its derivative is a pressure kn/2 e(phi_A) on the faces of B inside A, along their own
// normals, and the same for A's faces inside B. So energy is kept by construction, the normal never flips, and for
// two parallel faces the sum of both pressures is kn times the overlap, the stress of contact/face_pair. (A
// distance potential over the overlap area is used in the combined finite-discrete element method: Munjiza, "The
// combined finite-discrete element method", 2004, ch. 2; Feng and Owen, Int. J. Numer. Meth. Engng 61, 2004.)
// Damping acts on the motion along the resultant of the springs (contact/plane/overlap_press.hpp), total pressure never
// below 0. Friction acts on the resultant, at the centre of pressure.
//
// Mortar crushed by a depth z takes the place of phi by phi - z where that is above 0, in energy and pressure alike. It
// is crushed on while the mean pressure is above its strength; faces that had two depths go on with the greater.
#pragma once

#include <cstdint>
#include <span>

#include "base/space.hpp"
#include "contact/plane/edge_lanes.hpp"
#include "law/contact/list.hpp"

namespace trilith {

/// A convex piece where it stands. Corners counter-clockwise; edge i runs from corner i to i + 1.
struct PlacedPiece {
  std::span<const Vec2> corner;           ///< [m]
  std::span<const std::uint8_t> is_face;  ///< 1: edge is part of the body's surface, 0: an inner cut
  Vec2 origin, velocity;                  ///< a point of the piece and its velocity [m], [m/s]
  double spin;                            ///< [rad/s]
  /// Of a piece that deforms; empty where it is rigid. Its origin, velocity and spin are then those of the rigid piece
  /// that fits it best.
  std::span<const Vec2> corner_velocity = {};  ///< [m/s]
  /// The same piece with its mean velocities over the step; nullptr: they are those of now.
  const PlacedPiece* over_step = nullptr;
  /// Its edges, where somebody has placed them: a piece has several contacts.
  PieceSides sides = {};

  [[nodiscard]] const PlacedPiece& mean() const { return over_step == nullptr ? *this : *over_step; }

  /// As of a rigid piece.
  [[nodiscard]] Vec2 velocity_at(const Vec2& x) const { return velocity + cross(spin, Vec2(x - origin)); }
  /// Of what moves at `x` with edge e: the velocity that the corner forces of a force at x have their power by.
  [[nodiscard]] Vec2 velocity_at(int e, const Vec2& x) const {
    return corner_velocity.empty() ? velocity_at(x) : velocity_of_edge(e, x);
  }

 private:
  [[nodiscard]] Vec2 velocity_of_edge(int e, const Vec2& x) const;
};

/// What the general contact gives; forces on the corners of both pieces are added to `on_a` and `on_b`.
struct OverlapResponse {
  ContactMemory memory;
  Vec2 force = Vec2::Zero();   ///< resultant of the pressure on b [N]
  Vec2 centre = Vec2::Zero();  ///< centre of pressure [m]
  double length = 0;           ///< length in contact [m]
  double depth = 0;            ///< greatest depth of a pressed face in the other piece [m]
  double lost_damping = 0, lost_friction = 0, lost_fracture = 0;  ///< [J]
  double separation = 0;  ///< lower bound of the distance where not touching [m]
  int apart_by = -1;      ///< where it is above 0 the edge that showed it: of a, or of b from max_piece_corners on
  bool touching = false;
};

/// What a contact remembers: what every one does, and the row of its law (see law_memory).
struct Remembered {
  const ContactMemory& contact;
  const double* law;
};

/// Which corners of a pair lie in the other piece: one of the wedge below a face of the owner; or one of each in the
/// other, where the wedge is the second piece.
struct CornerOnFace {
  static constexpr std::uint8_t none = 255;
  std::uint8_t corner = none;  ///< of the wedge
  std::uint8_t face = none;    ///< of the owner, the one that is nearest; or its corner that lies in the wedge
  bool wedge_is_b = false;
  bool both = false;  ///< a corner of each lies in the other

  [[nodiscard]] bool is_there() const { return corner != none; }
  friend bool operator==(const CornerOnFace&, const CornerOnFace&) = default;
};

/// `on_a`, `on_b`: force per corner [N], same sizes as the pieces' corners, added to. `law_after`: the row its law
/// remembers from now on, written where the two touch; else what parted leaves. `alone`: where it is given and just one
/// corner of either, or one of both, lies in the other, it is set to those, and nothing is answered. `along`: of length
/// 1, where other pieces of the two bodies press at the same place the direction of all their springs: damping and
/// friction know that one, in place of the pair's own.
OverlapResponse respond_overlap(const PlacedPiece& a, const PlacedPiece& b, const Remembered& before,
                                const LawInUse& law, std::span<Vec2> on_a, std::span<Vec2> on_b, double* law_after,
                                CornerOnFace* alone = nullptr, const Vec2* along = nullptr);

}  // namespace trilith
