// A straight beam in space between two rotating ends: large displacements, small strains, co-rotational with its chord.
//
//     e        along the chord from end 0 to end 1, l its length; t_k, q_k axes of the sections at end 0 and end 1
//     u        = l - L                                             stretch
//     theta_i  = rotation vector from e to the axis t_1 of section i, which is normal to both: bend about y and z
//     tau      = angle about e from section 0 to section 1, after both are rotated back by their bends     twist
//
//     N = EA/L (u + L q_y + L q_z),   M = K theta + N L dq/dtheta about y and about z,   T = GJ/L tau
//
// K and q are those in element/beam/beam_element.hpp for either plane, so a beam that moves in a plane equals the plane
// beam. Bends are measured along axes midway between the two sections. The frame of the chord is co-rotational (M. A.
// Crisfield, "A consistent co-rotational formulation for non-linear, three-dimensional, beam-elements", Comput. Methods
// Appl. Mech. Eng. 81, 1990). The twist uses the parallel transport from t_1 to e, as in M. Bergou et al., "Discrete
// elastic rods", ACM Trans. Graph. 27(3), 2008. It needs no mean of the two sections. Its derivative is simple, with
// spins w_i of the sections and velocities v_i.
//
//     d tau = beta_1 . (w_1 - psi) - beta_0 . (w_0 - psi)
//     beta_i = (t_1 + e) / (1 + t_1 . e),   psi = e x (v_1 - v_0) / l
//
// Forces are the exact derivatives of one energy that depends on relative positions and rotations alone. So no rigid
// motion of any size causes a force, and energy, momentum and angular momentum are conserved. A section must not bend
// by half a turn relative to the chord.
#pragma once

#include <array>

#include "base/rotation_3d.hpp"
#include "element/beam/beam_3d.hpp"
#include "element/beam/beam_element.hpp"
#include "element/section/section_3d.hpp"

namespace trilith {

/// Material of a beam in space: with `shears` false there is no shear deformation; torsion still needs G.
struct BeamMaterial3 {
  double young = 0;  ///< [Pa]
  double shear = 0;  ///< [Pa]
  bool shears = false;
};

/// `length` [m] above 0. A pinned end carries no moment about y and z; it carries torsion.
BeamStiffness3 beam_stiffness_in_space(const BeamMaterial3& material, const Section3& section, double length,
                                       const std::array<bool, 2>& pinned);

/// Motion of an end.
struct BeamEnd3 {
  Vec3 place;     ///< [m]
  Turn3 axes;     ///< of the section
  Vec3 velocity;  ///< [m/s]
  Vec3 spin;      ///< [rad/s]
};

/// Stretch [m]; bends of end 0 about y and z, of end 1 about y and z, twist [rad]; or their rates.
using BeamStrain3 = std::array<double, 6>;
/// Normal force, tension positive [N]; moments on the ends in the same order, torque on end 1 [N m].
using BeamStress3 = std::array<double, 6>;

/// Actions of a beam on its ends: the force on end 0, whose opposite acts on end 1 [N], and moments [N m].
struct BeamAction3 {
  Vec3 force;
  std::array<Vec3, 2> moment;
};

/// Present configuration of a beam.
class BeamNow3 {
 public:
  /// `length_0` [m]: the initial length.
  BeamNow3(const BeamEnd3& from, const BeamEnd3& to, double length_0);

  [[nodiscard]] const BeamStrain3& strain() const { return strain_; }
  [[nodiscard]] const BeamStrain3& rate() const { return rate_; }
  /// Subtracts a strain without stress: a stretch [m], and bends about z [rad].
  void subtract_free(double stretch, const std::array<double, 2>& bend) {
    strain_[0] -= stretch, strain_[2] -= bend[0], strain_[4] -= bend[1];
  }
  /// Length of its chord [m].
  [[nodiscard]] double length() const { return length_; }
  /// The transpose of `rate`: the actions conjugate to a stress.
  [[nodiscard]] BeamAction3 action(const BeamStress3& stress) const;

 private:
  /// Bend of one section relative to the chord.
  struct Bend {
    Vec3 chord;                   ///< e in the axes of the section
    double factor, slope;         ///< angle over its sine, and its derivative with respect to e . t_1
    std::array<double, 2> angle;  ///< about y and z of the section [rad]
    Vec3 lever;                   ///< beta, in world axes
  };
  [[nodiscard]] Bend bend_of(const Turn3& axes) const;
  [[nodiscard]] std::array<double, 2> bend_rate(const Bend& bend, const Turn3& axes, const Vec3& spin) const;
  [[nodiscard]] Vec3 bend_moment(const Bend& bend, const Turn3& axes, const std::array<double, 2>& moment) const;

  double length_;
  Vec3 along_;
  std::array<Turn3, 2> axes_;
  std::array<Bend, 2> bend_;
  double cosine_, sine_;  ///< of half the twist
  BeamStrain3 strain_, rate_;
};

/// K times the strain or its rate, without the bow.
BeamStress3 linear_stress(const BeamStiffness3& k, const BeamStrain3& d);
BeamStress3 stress_of(const BeamStiffness3& k, const BeamStrain3& d);
/// Elastic energy [J].
double stored_in(const BeamStiffness3& k, const BeamStrain3& d);

/// An upper bound of the highest squared frequency of the free beam [1/s2], with equal mass and inertia at both ends.
/// `inertia`: about x, y and z of the beam [kg m2]; `arm`: rigid parts from the nodes to the ends, in the beam's axes
/// [m]. The nodes have the additional inertia of `mass` at these arms.
double beam_frequency2(const BeamStiffness3& stiffness, double length, double mass, const Vec3& inertia,
                       const std::array<Vec3, 2>& arm = {Vec3(0, 0, 0), Vec3(0, 0, 0)});

/// Inertia of a mass at `arm` about the origin of the arm [kg m2].
Eigen::Matrix3d inertia_at(double mass, const Vec3& arm);

}  // namespace trilith
