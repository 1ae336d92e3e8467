// Supports and drives of a body's nodes, changed between stages.
#include <fmt/format.h>

#include "base/error.hpp"
#include "model/builder/builder.hpp"

namespace trilith {

/// All nodes of a body along one direction; nodes of elements have no rotation. A node that is no longer driven loses
/// its drive.
void set_support(Model<2>& model, int body, int dof, Support support) {
  const Body& b = model.bodies[body];
  if (!b.nodes_turn() && dof == 2) return;
  for (int node = b.first_node; node < b.first_node + b.nodes; ++node) {
    model.support[node][dof] = support;
    if (support != Support::driven) model.drive_of[node][dof] = -1;
  }
}

/// The body's first node follows the motion from `origin` on, the others keep their distances from it. For a frame the
/// held joints are driven.
void set_drive(Model<2>& model, int body, int dof, const std::shared_ptr<const GroundMotion>& motion, double start,
               double origin, const State<2>* state) {
  const Body& b = model.bodies[body];
  if (!b.is_rigid() && dof == 2)
    throw InputError(
        fmt::format("body '{}' deforms and has no rotation to drive; drive x and y, or make it rigid", b.name));
  // The initial displacement of the motion must not cause a jump of the ground.
  const double from = origin - motion->displacement(0);
  const auto place = [&](int node) { return (state != nullptr ? state->position : model.start_position)[node][dof]; };
  const bool frame = b.skin_is_sections();
  const auto is_held = [&](int node) { return model.support[node][dof] != Support::free; };
  const int end = b.first_node + b.nodes;
  int first = b.first_node;
  while (frame && first < end && !is_held(first)) ++first;
  if (first == end)
    throw InputError(fmt::format(
        "body '{}' is a frame and none of its joints is held along {}, so nothing follows the motion; give a joint "
        "support = \"fixed\"",
        b.name, dof == 0 ? "x" : "y"));
  for (int node = first; node < end; ++node) {
    if (frame && !is_held(node)) continue;
    const double beside = node == b.first_node ? 0 : place(node) - place(b.first_node);
    model.support[node][dof] = Support::driven;
    model.drive_of[node][dof] = static_cast<int>(model.drives.size());
    model.drives.push_back({node, dof, from + beside, start, motion});
  }
}

}  // namespace trilith
