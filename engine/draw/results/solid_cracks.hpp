// Cracks in space: the outlines of joints that have separated, in the present position of their bodies.
#pragma once

#include <set>
#include <utility>
#include <vector>

#include "draw/results/solid_joints.hpp"
#include "draw/scene/scene_picture.hpp"
#include "draw/scene/solid_piece.hpp"
#include "draw/scene/view_direction.hpp"

namespace trilith::draw {

/// A crack on one of its two bodies.
struct SolidCrack {
  int body = 0;
  std::vector<Vec3> outline;  ///< [m, world]
  CrackMark mark = CrackMark::opened;
};

/// Pairs of bodies, the smaller index first: pairs that have lost part of their bond, and pairs with a bond now.
struct PairBonds {
  std::set<std::pair<int, int>> lost, held;
};

/// Joints of pairs that have lost part of their bond. For pairs without bond, joints whose faces touched at the start
/// and are open, or have slid, by least_crack. There are two cracks for each joint, one on each body. A joint with an
/// opening above its length is ignored.
std::vector<SolidCrack> solid_cracks(const std::vector<SolidJoint>& joints, const results::Placement& at,
                                     const PairBonds& bonds, const std::vector<bool>& left_out);

/// The visible part of a crack on a face of its body: sides on the face, and intersections with a section. `slack` [m]:
/// largest distance from the face.
void add_cracks_on(const PieceFace& face, const SolidCrack& crack, double slack, const ViewAxes& view,
                   std::vector<SceneCrack>& out);

}  // namespace trilith::draw
