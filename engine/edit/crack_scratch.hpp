// Arrays of the search for cracks, which a simulation keeps from step to step, so that a search of meshes without a
// crack allocates nothing.
#pragma once

#include <array>
#include <vector>

#include "base/space.hpp"
#include "edit/crack_search.hpp"
#include "model/work.hpp"

namespace trilith {

/// Present position of the plate of a face of a cut: its centroid, and its rotation from the initial position.
struct PlacedPlate {
  Vec3 centre = Vec3::Zero();
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
};

/// Of the cut that is computed at the moment.
template <int D>
struct CutScratch;
template <>
struct CutScratch<2> {
  std::vector<Vec2> along;               ///< [node of the cut] edge to the next one [m]
  std::vector<double> diagonal, beside;  ///< [node of the cut] system of the edges [m2]
};
template <>
struct CutScratch<3> {
  std::vector<Vec3> node;                              ///< [node of the cut] present position [m]
  std::vector<PlacedPlate> plate;                      ///< [face of the cut]
  std::vector<SpaceForces> plate_force;                ///< [face of the cut]
  std::vector<double> diagonal;                        ///< [node of the cut] system of the faces [m2]
  std::vector<Vec3> rest, stress, carried;             ///< [node of the cut] [N], [Pa], [N]
  std::vector<Vec3> solved, unmet, step, moved, next;  ///< [node of the cut] of the conjugate gradients
};

/// No result depends on its content.
template <int D>
struct CrackScratch {
  Work<D> work;                             ///< forces of elements, 0 between two searches
  std::array<std::vector<Vec<D>>, 2> side;  ///< [behind, ahead][node of the cut] forces of the elements [N]
  std::vector<Vec<D>> force;                ///< [node of the cut] of the part ahead on the part behind [N]
  std::vector<double> load;                 ///< [cracking body] sums of the forces on their surfaces [N]
  CutScratch<D> cut;
};

}  // namespace trilith
