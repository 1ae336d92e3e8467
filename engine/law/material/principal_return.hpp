// Return to a yield surface of planes in the space of principal stresses.
//
// Plane k: f = normal . s - limit <= 0, flow along `flow` (Koiter, 1953: the flow at an edge or corner is a sum of
// those of the planes that meet there, each with a multiplier that is not negative). The planes that hold in the end
// are found by trying one, then two, then three of them: the equations are linear and the first set that leaves no
// plane exceeded and no multiplier negative is the answer (the geometric form of Clausen, Damkilde and Andersen, Int.
// J. Numer. Meth. Engng 66, 2006, without its table of regions; de Souza Neto, Peric and Owen, "Computational Methods
// for Plasticity", 2008, sec. 8.2).
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

/// `trial`: principal stresses [Pa]; `elastic`: their matrix by principal strains [Pa]; `size`: of stresses, for what
/// counts as exceeded [Pa].
PrincipalReturn return_to_planes(const Eigen::Vector3d& trial, const Eigen::Matrix3d& elastic,
                                 std::span<const YieldPlane> planes, double size);

}  // namespace trilith
