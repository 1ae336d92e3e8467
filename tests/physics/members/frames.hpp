// Beams and frames for the physics tests.
#pragma once

#include <Eigen/Dense>

#include <string>
#include <vector>

#include "assembly/evaluate.hpp"
#include "model/loads.hpp"
#include "physics/scene.hpp"
#include "readings/member_forces.hpp"

namespace trilith::testing {

inline constexpr std::array<Support, 3> hinged{Support::fixed, Support::fixed, Support::free};

inline Section rectangle_section(double width, double depth) {
  return RectangleSection{width, depth}.numbers();
}

/// A section of given stiffness: area, and second moment, with a depth of `depth` [m].
inline Section given_section(double area, double second_moment, double depth) {
  return GivenSection{area, second_moment, depth, 0, 0}.numbers();
}

/// A straight beam of one member as a body; it needs no ground.
inline BodySpec beam_body(const std::string& name, const Vec2& from, const Vec2& to, const Section& section,
                          const std::string& material, int divisions) {
  BodySpec spec;
  spec.name = name, spec.kind = BodyKind::frame, spec.material = material, spec.floating = true;
  FrameSpec frame;
  frame.joints = {{.name = "from", .place = from}, {.name = "to", .place = to}};
  FrameMember member;
  member.name = name, member.from = 0, member.to = 1, member.section = section, member.divisions = divisions;
  frame.members = {member};
  spec.frame = frame;
  return spec;
}

inline Material elastic_material(const std::string& name, double density, double young, double poisson = 0,
                                 double damping = 0) {
  return {name, density, Solid{LinearElastic{young, poisson, damping}}};
}

/// A model of bodies of one material, without weight or contact.
inline Model<2> of_frames(const Material& material, std::vector<BodySpec> specs) {
  ModelBuilder builder;
  builder.gravity = Vec2::Zero();
  builder.add_material(material);
  for (BodySpec& spec : specs) builder.add_body(std::move(spec));
  return builder.build();
}

/// A load on a body at a point of it, with its full value at once or along `curve`.
inline void add_load(Model<2>& model, const std::string& body, const Vec2& at, const Vec2& force, double moment = 0,
                     const LoadCurve& curve = {}) {
  PointLoadSpec spec;
  spec.name = "load " + body, spec.at = at, spec.force = force, spec.moment = moment, spec.curve = curve;
  for (PointLoad<2>& load : make_point_load(model, model.find_body(body), spec))
    loads_of<PointLoad<2>>(model).push_back(load);
}

/// Degrees of freedom of a node.
using NodeDofs = std::array<double, 3>;

/// Sum of the beams' forces on every node.
inline std::vector<NodeDofs> forces_at(const Model<2>& model, const State<2>& state) {
  Work<2> work;
  internal_forces(model, state, work);
  std::vector<NodeDofs> out;
  for (std::size_t n = 0; n < work.element_force.size(); ++n)
    out.push_back({work.element_force[n].x(), work.element_force[n].y(), work.element_moment[n]});
  return out;
}

inline double& dof_of(State<2>& state, int node, int k) {
  return k == 2 ? state.rotation[node] : state.position[node][k];
}

/// The free degrees of freedom (node, direction), and the tangent stiffness between them at `state` by central
/// differences of the beams' forces.
struct FreeStiffness {
  std::vector<std::pair<int, int>> dofs;
  Eigen::MatrixXd matrix;
};
inline FreeStiffness stiffness_at(const Model<2>& model, State<2> state) {
  FreeStiffness out;
  for (int n = 0; n < model.nodes(); ++n)
    for (const int k : {0, 1, 2})
      if (model.support[n][k] == Support::free) out.dofs.emplace_back(n, k);
  const auto count = static_cast<Eigen::Index>(out.dofs.size());
  out.matrix.resize(count, count);
  const double size = 1e-6 * model.body_radius[0];
  for (Eigen::Index j = 0; j < count; ++j) {
    double& at = dof_of(state, out.dofs[j].first, out.dofs[j].second);
    const double was = at, step = out.dofs[j].second == 2 ? 1e-6 : size;
    at = was + step;
    const std::vector<NodeDofs> high = forces_at(model, state);
    at = was - step;
    const std::vector<NodeDofs> low = forces_at(model, state);
    at = was;
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto [n, k] = out.dofs[i];
      out.matrix(i, j) = -(high[n][k] - low[n][k]) / (2 * step);
    }
  }
  return out;
}

/// Equilibrium under steady loads at nodes, by Newton's iteration from `state` on.
inline State<2> balance(const Model<2>& model, State<2> state, const std::vector<NodeDofs>& load, int most = 30) {
  for (int turn = 0; turn < most; ++turn) {
    const FreeStiffness k = stiffness_at(model, state);
    const std::vector<NodeDofs> inner = forces_at(model, state);
    Eigen::VectorXd left(k.matrix.rows());
    for (Eigen::Index i = 0; i < left.size(); ++i)
      left[i] = load[k.dofs[i].first][k.dofs[i].second] + inner[k.dofs[i].first][k.dofs[i].second];
    const Eigen::VectorXd go = k.matrix.partialPivLu().solve(left);
    for (Eigen::Index i = 0; i < go.size(); ++i) dof_of(state, k.dofs[i].first, k.dofs[i].second) += go[i];
    if (go.cwiseAbs().maxCoeff() < 1e-9 * model.body_radius[0]) return state;
  }
  FAIL("no equilibrium found");
  return state;
}

inline std::vector<NodeDofs> no_load(const Model<2>& model) {
  return std::vector<NodeDofs>(static_cast<std::size_t>(model.nodes()), NodeDofs{});
}

}  // namespace trilith::testing
