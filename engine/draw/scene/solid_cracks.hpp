// Cracks between solids: the outlines of joints that have come apart, where their bodies have taken them.
#pragma once

#include <set>
#include <utility>
#include <vector>

#include "draw/scene/scene_picture.hpp"
#include "draw/scene/solid_joints.hpp"
#include "draw/scene/solid_piece.hpp"
#include "draw/scene/view_direction.hpp"

namespace trilith::draw {

/// A crack as one of its two bodies carries it.
struct SolidCrack {
  int body = 0;
  std::vector<Vec3> outline;  ///< [m, world]
  CrackMark mark = CrackMark::opened;
};

/// Pairs of bodies, the smaller number first: those that have lost some of their bond, and those with a bond now.
struct PairBonds {
  std::set<std::pair<int, int>> lost, held;
};

/// Joints of pairs that have lost some of their bond, and of pairs without one those whose faces touched at the start
/// and are open, or have slid, by least_crack; two for each, one for each body. A joint that is farther open than it is
/// long is none any more.
std::vector<SolidCrack> solid_cracks(const std::vector<SolidJoint>& joints, const results::Placement& at,
                                     const PairBonds& bonds, const std::vector<bool>& left_out);

/// What is seen of a crack on a face of its body: sides that lie on the face, and where a section goes through it.
/// `slack` [m]: how far off the face still counts.
void add_cracks_on(const PieceFace& face, const SolidCrack& crack, double slack, const ViewAxes& view,
                   std::vector<SceneCrack>& out);

}  // namespace trilith::draw
