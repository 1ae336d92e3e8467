// Forces in a section of a rigid body, from the forces on its surface by d'Alembert's principle.
//
// A plane divides the body into a part behind it and a part ahead. Weight, mass damping and all other forces that are
// distributed like mass follow the rigid acceleration, so they cancel against a part of the inertia. The rest of
// the acceleration, e, comes from the forces F and the moment M of the surface alone. With m and I of the body, spin
// w, and r from the body's centroid:
//
//     e(r) = F / m + (M / I) x r - w^2 r
//     section force  = m_a e(r_a) - F_a                                   on the part a behind the plane
//     section moment = I_a M / I + (r_a - r_s) x m_a e(r_a) - M_a         about the middle r_s of the section
//
// F_a and M_a are the contacts, bearings and loads on that part. The stresses of a contact or of a pressure that spans
// the plane are integrated up to it. Nothing is elastic here, so the forces hold at the instant of the evaluation.
#pragma once

#include <span>
#include <vector>

#include "model/crack_planes.hpp"
#include "model/state.hpp"
#include "model/work.hpp"
#include "readings/section_loads.hpp"

namespace trilith {

/// Forces on the part behind a section, from the part ahead.
struct PlaneForces {
  double normal = 0;  ///< along the section's normal: tension positive [N]
  double shear = 0;   ///< to the left of the normal [N]
  double moment = 0;  ///< about the middle of the section, counter-clockwise [N m]
};

/// A force at a point of a body's surface, and a moment about this point.
struct SurfaceForce {
  Vec2 point = Vec2::Zero();  ///< [m]
  Vec2 force = Vec2::Zero();  ///< [N]
  double moment = 0;          ///< [N m]
};

/// All forces on the surfaces of some rigid bodies of a model in the plane, at the instant at which `work` is
/// evaluated. Refers to the three arguments, which must outlive it.
class SurfaceForces {
 public:
  SurfaceForces(const Model<2>& model, const State<2>& state, const Work<2>& work);
  /// Collects the forces on these bodies, in any order; the previous ones are dropped.
  void collect(std::span<const int> bodies);
  /// Forces in a section of the i-th body. Its degrees of freedom must be free: the place at which a support acts is
  /// not known.
  [[nodiscard]] PlaneForces in_section(std::size_t i, const CrackSection<2>& section) const;
  /// Sum of the forces on the i-th body, and their moment about its centroid.
  [[nodiscard]] SurfaceForce sum(std::size_t i) const { return bodies_[i].sum; }

 private:
  /// A contact of two faces as one of its bodies feels it.
  struct FaceForce {
    int row;                     // in Work::pairs
    double sign;                 // 1: on the second body, -1: on the first
    Vec2 origin, along, across;  // at coordinate 0 of FaceOverlap; unit vectors
    double lo, hi;               // ends of the shared length [m]
    SurfaceForce whole;
  };
  struct BodyForces {
    int body = -1;
    std::vector<SurfaceForce> points;
    std::vector<FaceForce> faces;
    std::vector<LoadPart> loads;
    SurfaceForce sum;
  };

  void add_contacts();
  void add_faces(int row, int first, int second);
  void add_bearings();
  void add_loads();
  void add_point(int body, const SurfaceForce& force);
  void add_pushes();
  [[nodiscard]] int slot_of(int body) const { return slot_[static_cast<std::size_t>(body)]; }
  [[nodiscard]] SurfaceForce part_of(const FaceForce& face, double from, double to) const;

  const Model<2>& model_;
  const State<2>& state_;
  const Work<2>& work_;
  std::vector<int> slot_;  // [body] its place in bodies_, or -1
  std::vector<BodyForces> bodies_;
};

}  // namespace trilith
