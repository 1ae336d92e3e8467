// Contact of two convex pieces of any shape and pose, from the overlap of their areas.
//
// The elastic energy is W = kn/2 ( integral of e(phi_A) + integral of e(phi_B) ) over the overlap. Here phi is the
// distance to the nearest face of a piece, and kn e(phi) the law's pressure at the overlap phi; e(phi) = phi for a
// linear law. Its derivative is a pressure kn/2 e(phi_A) on the faces of B inside A, along their own normals, and
// likewise for A's faces inside B. So energy is conserved by construction, and the normal never flips. For two parallel
// faces the sum of both pressures is kn times the overlap, the stress of contact/plane/face_pair.hpp. The combined
// finite-discrete element method uses a distance potential over the overlap area: Munjiza, "The combined
// finite-discrete element method", 2004, ch. 2; Feng and Owen, Int. J. Numer. Meth. Engng 61, 2004.
//
// Damping acts on the motion along the resultant of the springs (contact/plane/overlap_press.hpp); the total pressure
// is never negative. Friction acts on the resultant, at the centre of pressure.
//
// If mortar is crushed by a depth z, phi is replaced by max(phi - z, 0) in energy and pressure. Crushing continues
// while the mean pressure exceeds the strength; faces with two crushed depths continue with the larger one.
#pragma once

#include <cstdint>
#include <span>

#include "base/space.hpp"
#include "contact/plane/edge_lanes.hpp"
#include "law/contact/list.hpp"

namespace trilith {

/// A placed convex piece. Corners counter-clockwise; edge i runs from corner i to i + 1.
struct PlacedPiece {
  std::span<const Vec2> corner;           ///< [m]
  std::span<const std::uint8_t> is_face;  ///< 1: edge is part of the body's surface, 0: an inner cut
  Vec2 origin, velocity;                  ///< a point of the piece and its velocity [m], [m/s]
  double spin;                            ///< [rad/s]
  /// Corner velocities of a deforming piece; empty for a rigid one. Its origin, velocity and spin are then the best
  /// rigid fit.
  std::span<const Vec2> corner_velocity = {};  ///< [m/s]
  /// The same piece with its mean velocities over the step; nullptr: equal to the present ones.
  const PlacedPiece* over_step = nullptr;
  /// Its edges, if they have been placed already: a piece has several contacts.
  PieceSides sides = {};

  [[nodiscard]] const PlacedPiece& mean() const { return over_step == nullptr ? *this : *over_step; }

  /// Velocity of a rigid piece.
  [[nodiscard]] Vec2 velocity_at(const Vec2& x) const { return velocity + cross(spin, Vec2(x - origin)); }
  /// Velocity at `x` on edge e that is conjugate to the corner forces of a force at x.
  [[nodiscard]] Vec2 velocity_at(int e, const Vec2& x) const {
    return corner_velocity.empty() ? velocity_at(x) : velocity_of_edge(e, x);
  }

 private:
  [[nodiscard]] Vec2 velocity_of_edge(int e, const Vec2& x) const;
};

/// Result of the general contact; forces on the corners of both pieces are added to `on_a` and `on_b`.
struct OverlapResponse {
  ContactMemory memory;
  Vec2 force = Vec2::Zero();   ///< resultant of the pressure on b [N]
  Vec2 centre = Vec2::Zero();  ///< centre of pressure [m]
  double length = 0;           ///< length in contact [m]
  double depth = 0;            ///< largest depth of a pressed face in the other piece [m]
  double lost_damping = 0, lost_friction = 0, lost_fracture = 0;  ///< [J]
  double separation = 0;  ///< lower bound of the distance where not touching [m]
  int apart_by = -1;      ///< if it is positive, the edge that showed it: of a, or of b from max_piece_corners on
  bool touching = false;
};

/// Memory of a contact: the common part, and the row of its law (see law_memory).
struct Remembered {
  const ContactMemory& contact;
  const double* law;
};

/// The only corners of a pair inside the other piece: one of the wedge below a face of the owner, or one of each inside
/// the other, with the second piece as the wedge.
struct CornerOnFace {
  static constexpr std::uint8_t none = 255;
  std::uint8_t corner = none;  ///< of the wedge
  std::uint8_t face = none;    ///< of the owner: the nearest face, or its corner inside the wedge
  bool wedge_is_b = false;
  bool both = false;  ///< a corner of each is inside the other

  [[nodiscard]] bool is_there() const { return corner != none; }
  friend bool operator==(const CornerOnFace&, const CornerOnFace&) = default;
};

/// `on_a`, `on_b`: force per corner [N], of the size of the pieces' corners; forces are added. `law_after`: the law's
/// new memory, written where the two touch; otherwise the memory of a separated contact. `alone`: if it is given and
/// only one corner of either, or one of both, is inside the other, it is set to these corners and no force is computed.
/// `along`: unit vector, the common direction of all springs if other pieces of the two bodies press at the same
/// position; damping and friction use it instead of the pair's direction.
OverlapResponse respond_overlap(const PlacedPiece& a, const PlacedPiece& b, const Remembered& before,
                                const LawInUse& law, std::span<Vec2> on_a, std::span<Vec2> on_b, double* law_after,
                                CornerOnFace* alone = nullptr, const Vec2* along = nullptr);

}  // namespace trilith
