// The cut along which a mesh in space parts: its faces as rigid plates, which carry its stress and become its contacts.
#pragma once

#include <array>
#include <vector>

#include "element/solid/face_products.hpp"
#include "model/crack_planes.hpp"

namespace trilith {

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

inline const SpaceCut& space_cut(const MeshCut& cut) {
  return static_cast<const SpaceCut&>(cut);
}

}  // namespace trilith
