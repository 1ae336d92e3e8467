// Return mapping to yield planes in principal stress space.
//
// Plane k: f = normal . s - limit <= 0, with flow along `flow`. Koiter, 1953: the flow at an edge or corner is the sum
// of the planes' flows, each with a multiplier that is not negative. The active planes are found by trying one, then
// two, then three of them. The equations are linear, and the first set that violates no plane and has no negative
// multiplier is the solution. This is the geometric form of Clausen, Damkilde and Andersen, Int. J. Numer. Meth. Engng
// 66, 2006, without its table of regions; see also de Souza Neto, Peric and Owen, "Computational Methods for
// Plasticity", 2008, sec. 8.2.
#pragma once

#include <Eigen/Core>

#include <array>
#include <span>

namespace trilith {

struct YieldPlane {
  Eigen::Vector3d normal, flow;
  double limit;  ///< [Pa]
};

struct PrincipalReturn {
  Eigen::Vector3d stress;   ///< [Pa]
  Eigen::Vector3d plastic;  ///< growth of principal plastic strains
  bool found = false;
};

/// `trial`: principal stresses [Pa]; `elastic`: matrix from principal strains to stresses [Pa]; `size`: stress scale of
/// the yield tolerance [Pa].
PrincipalReturn return_to_planes(const Eigen::Vector3d& trial, const Eigen::Matrix3d& elastic,
                                 std::span<const YieldPlane> planes, double size);

}  // namespace trilith
