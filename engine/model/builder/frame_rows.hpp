// Rows of a frame in a model: its nodes with their masses, and its beams with their yielding and damping. One code for
// the plane and for space; the skin follows in frame_outline.hpp and in model/space_builder/frame_skin.hpp.
#pragma once

#include <array>
#include <string>
#include <type_traits>
#include <vector>

#include "model/builder/frame.hpp"
#include "model/builder/member_material.hpp"
#include "model/builder/node_support.hpp"

namespace trilith {

/// A frame with all data for its rows of a model.
template <int D>
struct FrameBody {
  std::string name;
  FrameSpecOf<D> frame;
  FramePlanOf<D> plan;
  std::vector<MemberMaterial<D>> material;        ///< [member]
  double density = 0;                             ///< default for blocks [kg/m3]
  Vec<D> velocity = Vec<D>::Zero();               ///< at the start [m/s]
  Spin<D> spin = nothing<Spin<D>>();              ///< at the start [rad/s]
  std::array<Support, Space<D>::dofs> support{};  ///< for all nodes, in addition to the joints' supports
  std::vector<NodeSupportOf<D>> supports;         ///< for some nodes
};
using SpaceFrameBody = FrameBody<3>;

/// Mass of a node and its inertia about itself, in world axes.
template <int D>
struct NodeMass {
  double mass = 0;                                              ///< [kg]
  std::conditional_t<D == 2, double, Eigen::Matrix3d> inertia;  ///< [kg m2]
};

/// Masses of the joints, their blocks, and half of each beam at either end, with the rotary inertia of its section.
/// With more inertia a member of few beams would rotate too slowly, with less the stable step would be shorter.
/// `thickness`: of blocks in the plane [m].
template <int D>
std::vector<NodeMass<D>> node_masses(const FrameBody<D>& body, double thickness);

/// Appends the nodes, in space in their principal axes. Velocity and spin at the start are about `centre` [m].
template <int D>
void append_nodes(const FrameBody<D>& body, const std::vector<NodeMass<D>>& nodes, const Vec<D>& centre,
                  Model<D>& model);

/// Appends the beams of all members, and their bounds to the last row of Model::element_bound. No frequency of all
/// beams exceeds the highest one of a single beam on its share of the nodal masses.
template <int D>
void append_beams(const FrameBody<D>& body, int body_row, int first_node, Model<D>& model);

}  // namespace trilith
