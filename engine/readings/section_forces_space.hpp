// Forces in a plane section of a rigid body in space; the plane counterpart is readings/section_forces.hpp.
//
// With the surface forces F and their moment M about the centroid, the spin w, and the inertia tensor I:
//
//     a     = I^-1 (M - w x I w)
//     e(r)  = F / m + a x r + w x (w x r)
//     section force  = m_a e(r_a) - F_a
//     section moment = I_a a + w x I_a w + (r_a - r_s) x m_a e(r_a) - M_a
//
// Contacts of faces act over their area: normal stress and shear are linear over it, and their resultants are the
// resultants of the contact. So a contact that spans the plane is integrated exactly up to it where it is pressed or
// bonded all over.
#pragma once

#include <span>
#include <vector>

#include "model/crack_planes.hpp"
#include "model/state.hpp"
#include "model/work.hpp"
#include "readings/section_loads.hpp"
#include "readings/spread_force.hpp"

namespace trilith {

/// Forces on the part behind a section, from the part ahead, along the axes of the section and about its centre.
struct SpaceForces {
  double normal = 0;            ///< tension positive [N]
  Vec2 shear = Vec2::Zero();    ///< along x and y [N]
  Vec2 bending = Vec2::Zero();  ///< about x and y [N m]
  double torsion = 0;           ///< about the normal [N m]
};

/// Normal stress that is linear over a section: at its centre [Pa], and its slope along x and y [Pa/m].
struct SectionStress {
  double mean = 0;
  Vec2 slope = Vec2::Zero();
  [[nodiscard]] double operator()(const Vec2& p) const { return mean + slope.dot(p); }
};
SectionStress section_stress(const CrackSection<3>& section, const SpaceForces& forces);

/// As SurfaceForces in the plane.
class SurfaceForces3 {
 public:
  SurfaceForces3(const Model<3>& model, const State<3>& state, const Work<3>& work);
  void collect(std::span<const int> bodies);
  [[nodiscard]] SpaceForces in_section(std::size_t i, const CrackSection<3>& section) const;
  /// Sum of the forces on the i-th body, and their moment about its centroid.
  [[nodiscard]] const ForceSum<3>& sum(std::size_t i) const { return bodies_[i].sum; }

 private:
  struct PointForce {
    Vec3 point, force, moment;
  };
  struct BodyForces {
    int body = -1;
    std::vector<PointForce> points;
    std::vector<SpreadForce> areas;
    std::vector<LoadPart> loads;
    ForceSum<3> sum;
  };

  void add_contacts();
  void add_contact(std::size_t place);
  void add_joint(int row, const JointMemory& joint, int a, int b);
  bool add_flat(std::size_t place, int a, int b);
  void add_bearings();
  void add_loads();
  void add_pushes();
  void sum_up(BodyForces& body) const;
  void add_point(int body, const PointForce& force);
  void add_area(const SpreadForce& on_b, int a, int b);
  [[nodiscard]] int slot_of(int body) const { return slot_[static_cast<std::size_t>(body)]; }

  const Model<3>& model_;
  const State<3>& state_;
  const Work<3>& work_;
  std::vector<int> slot_;  // [body] its place in bodies_, or -1
  std::vector<BodyForces> bodies_;
};

}  // namespace trilith
