// Both ends of a beam with hinges in space at a given normal force: which ends flow, and how.
//
// Unknown are amount and direction of each end's flow (element/beam/hinge_flow_3d.hpp). The condition is that the
// elastic moments equal the capacity, K (turn - p) = most, which Newton's method solves for both ends at once. If it
// fails, the ends are solved in turn as in the plane. If this fails too, a continuation starts from surfaces so large
// that no end flows and reduces them to their size.
#pragma once

#include <Eigen/Core>

#include <array>

#include "element/beam/beam_element_3d.hpp"
#include "element/beam/hinge_flow_3d.hpp"

namespace trilith {

/// Vectors of four: y and z of end 0, y and z of end 1. Bends and moments are positive as the side to z and the bottom
/// lengthen, and are scaled by the hinges' sqrt(s) (element/beam/hinge_flow_3d.hpp).
using Bends = Eigen::Vector4d;
using Hinges = std::array<SpaceHinge, 2>;

struct SpaceBeamOfStep {
  double axial;
  Eigen::Matrix4d bend = Eigen::Matrix4d::Zero(), bow = Eigen::Matrix4d::Zero();
  double stretch;      ///< [m]
  Bends turn, factor;  ///< [rad]; ratio of scaled rotations to the beam's, with signs

  SpaceBeamOfStep(const BeamStiffness3& k, const BeamStrain3& d, const std::array<double, 2>& scale)
      : axial(k.axial), stretch(d[0]), factor(-scale[0], -1, scale[1], 1) {
    turn = factor.cwiseProduct(Bends(d[1], d[2], d[3], d[4]));
    for (const int axis : {0, 1}) {
      const BeamStiffness& plane = k.bend[static_cast<std::size_t>(axis)];
      const int a = axis, b = 2 + axis;
      bend(a, a) = plane.bend[0], bend(b, b) = plane.bend[2], bend(a, b) = bend(b, a) = plane.bend[1];
      bow(a, a) = 2 * plane.bow[0], bow(b, b) = 2 * plane.bow[2], bow(a, b) = bow(b, a) = plane.bow[1];
    }
    const Bends per = factor.cwiseInverse();
    bend = per.asDiagonal() * bend * per.asDiagonal(), bow = per.asDiagonal() * bow * per.asDiagonal();
  }
  [[nodiscard]] double bowed(const Bends& p) const { return 0.5 * (turn - p).dot(bow * (turn - p)); }
};

/// Both ends at a given normal force.
struct SpaceEnds {
  std::array<bool, 2> flows{};
  std::array<SpaceFlow, 2> flow;
  Bends p = Bends::Zero(), moment = Bends::Zero();
  double stretch = 0;  ///< plastic stretch due to the flow of both ends in this step [m]
  bool settled = true;
};

/// `near`: start of the search, from a similar normal force; or null.
SpaceEnds ends_beside(const SpaceBeamOfStep& beam, const Hinges& hinge, double normal, const SpaceEnds* near);

}  // namespace trilith
