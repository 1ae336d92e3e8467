// The cut along which a mesh parts. In space its faces are rigid plates, which carry its stress and become its
// contacts.
#pragma once

#include <array>
#include <vector>

#include "element/solid/face_products.hpp"
#include "model/crack_planes.hpp"

namespace trilith {

/// The cut of every CrackSection<2> of a mesh.
struct PlaneCut : MeshCut {
  /// [behind, ahead][MeshCut::nodes] area of the elements, to which their masses are proportional [m2]
  std::array<std::vector<double>, 2> area;
};

/// A face between an element behind a cut and an element ahead of it, in the initial position.
struct CutFace {
  int nodes = 0;
  std::array<int, max_face_nodes> node{};  ///< in MeshCut::nodes
  std::array<int, 2> element{-1, -1};      ///< behind and ahead, from the first of the body
  std::array<int, 2> face{-1, -1};         ///< number of the face in the shape of both
  FaceFit fit;                             ///< of the element behind, so its normal points ahead
  FaceProducts integrals;
  CrackSection<3> section;  ///< its polygon, axes and moments
};

/// The cut of every CrackSection<3> of a mesh.
struct SpaceCut : MeshCut {
  std::vector<CutFace> plates;       ///< [MeshCut::faces]
  std::vector<double> behind_share;  ///< [MeshCut::nodes] share of the mass of the node in the part behind
};

/// Share of the mass of node `i` of a cut on a side (0: behind, 1: ahead), of any total.
template <int D>
double mass_on_side(const MeshCut& cut, std::size_t side, std::size_t i) {
  if constexpr (D == 2) {
    return static_cast<const PlaneCut&>(cut).area[side][i];
  } else {
    const double behind = static_cast<const SpaceCut&>(cut).behind_share[i];
    return side == 0 ? behind : 1 - behind;
  }
}

inline const SpaceCut& space_cut(const MeshCut& cut) {
  return static_cast<const SpaceCut&>(cut);
}

}  // namespace trilith
