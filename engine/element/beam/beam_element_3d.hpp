// A straight beam in space between two ends that turn: large motion, small strain, in axes that go with its chord.
//
//   e        along the chord from end 0 to end 1, l its length; t_k, q_k axes of the sections at end 0 and end 1
//   u        = l - L                                             stretch
//   theta_i  = rotation vector from e to the axis t_1 of section i, which is square to both: bend about y and z
//   tau      = angle about e from section 0 to section 1, once both are turned back by their bends     twist
//
//   N = EA/L (u + L q_y + L q_z),   M = K theta + N L dq/dtheta about y and about z,   T = GJ/L tau
//
// with K and q of element/beam/beam_element.hpp in either plane, so that a beam which moves in a plane is the plane's.
// Bends are taken along axes half way between the two sections. The frame of the chord is that of co-rotation (M. A.
// Crisfield, "A consistent co-rotational formulation for non-linear, three-dimensional, beam-elements", Comput. Methods
// Appl. Mech. Eng. 81, 1990); the twist is that of a parallel transport from t_1 to e, as in M. Bergou et al.,
// "Discrete elastic rods", ACM Trans. Graph. 27(3), 2008, which needs no mean of the two sections and has a plain
// derivative:
//
//   d tau = beta_1 . (w_1 - psi) - beta_0 . (w_0 - psi),   beta_i = (t_1 + e) / (1 + t_1 . e),   psi = e x (v_1 - v_0)
//   / l
//
// for spins w_i of the sections and velocities v_i. Forces are the exact derivatives of one energy that knows relative
// places and turns alone: so no rigid motion of any size makes a force, and energy, momentum and angular momentum are
// kept at any size of motion. A section must not be bent by half a turn against the chord.
#pragma once

#include <array>

#include "base/rotation_3d.hpp"
#include "element/beam/beam_3d.hpp"
#include "element/beam/beam_element.hpp"
#include "element/section/section_3d.hpp"

namespace trilith {

/// What a beam in space is made of: `shears` false leaves shear deformation out; torsion needs G all the same.
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
/// Normal force, tension above 0 [N]; moments on the ends likewise, torque on end 1 [N m].
using BeamStress3 = std::array<double, 6>;

/// What a beam does to its ends: the force on end 0, the opposite of which acts on end 1 [N], and moments [N m].
struct BeamAction3 {
  Vec3 force;
  std::array<Vec3, 2> moment;
};

/// A beam as it stands.
class BeamNow3 {
 public:
  /// `length_0` [m]: at the start.
  BeamNow3(const BeamEnd3& from, const BeamEnd3& to, double length_0);

  [[nodiscard]] const BeamStrain3& strain() const { return strain_; }
  [[nodiscard]] const BeamStrain3& rate() const { return rate_; }
  /// Of its chord [m].
  [[nodiscard]] double length() const { return length_; }
  /// The transpose of `rate`: a stress of that power.
  [[nodiscard]] BeamAction3 action(const BeamStress3& stress) const;

 private:
  /// How one section is bent against the chord.
  struct Bend {
    Vec3 chord;                   ///< e in the axes of the section
    double factor, slope;         ///< angle over its sine, and its derivative by e . t_1
    std::array<double, 2> angle;  ///< about y and z of the section [rad]
    Vec3 lever;                   ///< beta, in the world
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

/// K alone on the strain, or on its rate.
BeamStress3 linear_stress(const BeamStiffness3& k, const BeamStrain3& d);
BeamStress3 stress_of(const BeamStiffness3& k, const BeamStrain3& d);
/// Elastic energy [J].
double stored_in(const BeamStiffness3& k, const BeamStrain3& d);

/// An upper bound of the highest frequency squared of the beam alone, free, on the mass and the inertias of its ends,
/// of which both have as much [1/s2]. `inertia`: about x, y and z of the beam [kg m2]; `arm`: rigid parts from the
/// nodes to the ends, in the beam's axes [m], for which the nodes have the inertia of `mass` so far away besides.
double beam_frequency2(const BeamStiffness3& stiffness, double length, double mass, const Vec3& inertia,
                       const std::array<Vec3, 2>& arm = {Vec3(0, 0, 0), Vec3(0, 0, 0)});

/// Inertia about a point of a mass that is `arm` away [kg m2].
Eigen::Matrix3d inertia_at(double mass, const Vec3& arm);

}  // namespace trilith
