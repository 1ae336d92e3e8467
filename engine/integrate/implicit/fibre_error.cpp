#include "integrate/implicit/fibre_error.hpp"

#include <algorithm>

#include "assembly/implicit_turn.hpp"

namespace trilith {
namespace {

constexpr int passes = 2;

/// Inertia forces of the accelerations `jump` at a node [N], [N m].
Dofs<2> inertia_forces(const Model<2>& model, const State<2>& state, int n, const Dofs<2>& jump) {
  const Dofs<2> mass = mass_of(model, state, n);
  return {mass[0] * jump[0], mass[1] * jump[1], mass[2] * jump[2]};
}
Dofs<3> inertia_forces(const Model<3>& model, const State<3>& state, int n, const Dofs<3>& jump) {
  return dofs_of(Vec3(model.mass[n] * along_of(jump)),
                 Vec3(momentum_of(model.inertia[n], state.rotation[n], about_of(jump))));
}

template <class Forces>
bool any_force(const Forces& forces, int first, int count) {
  if (forces.empty()) return false;
  return std::any_of(forces.begin() + first, forces.begin() + first + count,
                     [](const auto& f) { return !f.isZero(0); });
}
/// True if contacts act on the body at the instant of the last evaluation.
bool is_touched(const Work<2>& work, const BodyRow& body) {
  return any_force(work.skin_force, body.skin, body.skins);
}
bool is_touched(const Work<3>& work, const BodyRow& body) {
  return any_force(work.solids.force, body.node, body.nodes) || any_force(work.solids.fit_force, body.fit, body.fits);
}

/// One multiplication by A^-1 a_m M.
template <int D>
void filter(const Model<D>& model, const State<D>& state, const Tangent<D>& tangent, double inertia,
            std::vector<Dofs<D>>& jump) {
  const DofGraph<D>& graph = tangent.coupling();
  Eigen::VectorXd right(graph.size());
  for (int i = 0; i < graph.size(); ++i) {
    const auto [n, k] = graph.freedom[i];
    right[i] = inertia * inertia_forces(model, state, n, jump[n])[k];
  }
  const Eigen::VectorXd left = tangent.solve(right);
  for (int i = 0; i < graph.size(); ++i) jump[graph.freedom[i].node][graph.freedom[i].k] = left[i];
}

}  // namespace

template <int D>
bool has_fibres(const Model<D>& model) {
  if constexpr (D == 2)
    return !model.yields.fibre_beams.empty();
  else
    return !model.yields_3d.fibre_beams.empty();
}

template <int D>
void filter_fibre_error(const Model<D>& model, const State<D>& state, const Work<D>& work, const Tangent<D>& tangent,
                        double inertia, std::vector<Dofs<D>>& jump) {
  std::vector<Dofs<D>> left = jump;
  for (int i = 0; i < passes; ++i) filter(model, state, tangent, inertia, left);
  std::vector<std::uint8_t> touched(work.body.size());
  for (std::size_t b = 0; b < touched.size(); ++b) touched[b] = is_touched(work, work.body[b]) ? 1 : 0;
  for (const auto& beam : beams_of(model)) {
    if (beam.yield != BeamYield::in_fibres || touched[static_cast<std::size_t>(beam.body)] != 0) continue;
    for (const int n : beam.node) jump[n] = left[n];
  }
}

template bool has_fibres(const Model<2>&);
template bool has_fibres(const Model<3>&);
template void filter_fibre_error(const Model<2>&, const State<2>&, const Work<2>&, const Tangent<2>&, double,
                                 std::vector<Dofs<2>>&);
template void filter_fibre_error(const Model<3>&, const State<3>&, const Work<3>&, const Tangent<3>&, double,
                                 std::vector<Dofs<3>>&);

}  // namespace trilith
