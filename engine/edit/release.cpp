#include "edit/release.hpp"

#include "assembly/evaluate.hpp"
#include "element/rigid/rigid_turn.hpp"
#include "model/loads.hpp"

namespace trilith {
namespace {

/// Released degrees of freedom of one node: accelerations under its supports [m/s2], [rad/s2]; 0 if it was free.
template <int D>
struct Freed {
  int node;
  std::array<bool, Space<D>::dofs> on{};
  Vec<D> pull = Vec<D>::Zero();
  Moment<D> turn = nothing<Moment<D>>();
};

double& component(double& turn, int /*k*/) {
  return turn;
}
double& component(Vec3& turn, int k) {
  return turn[k];
}

/// Frees the nodes in the model, and returns the acceleration of each.
template <int D>
std::vector<Freed<D>> free_nodes(Model<D>& model, double time, int body, const std::array<bool, Space<D>::dofs>& on) {
  constexpr int along = Space<D>::translations;
  const Body& b = model.bodies[body];
  std::vector<Freed<D>> freed;
  for (int n = b.first_node; n < b.first_node + b.nodes; ++n) {
    Freed<D> node{n};
    bool any = false;
    for (int k = 0; k < Space<D>::dofs; ++k) {
      if (!on[k] || model.support[n][k] == Support::free || (k >= along && !b.nodes_turn())) continue;
      const int drive = model.drive_of[n][k];
      (k < along ? node.pull[k] : component(node.turn, k - along)) =
          drive < 0 ? 0 : model.drives[drive].motion->acceleration(time - model.drives[drive].start);
      model.support[n][k] = Support::free;
      model.drive_of[n][k] = -1;
      node.on[k] = any = true;
    }
    if (any) freed.push_back(node);
  }
  return freed;
}

/// Moment for the angular acceleration `turn` of a node; in space at its present spin (Euler's equation).
double moment_for(const Model<2>& model, const State<2>& /*state*/, int n, double turn) {
  return model.inertia[n] * turn;
}
Vec3 moment_for(const Model<3>& model, const State<3>& state, int n, const Vec3& turn) {
  const auto momentum = [&](const Vec3& w) { return momentum_of(model.inertia[n], state.rotation[n], w); };
  return momentum(turn) + cross(state.spin[n], momentum(state.spin[n]));
}

/// Load in place of a support, whose sudden removal would be an impact: R = m a - F, with the acceleration a of its
/// motion.
template <int D>
PointLoad<D> support_load(const Model<D>& model, const State<D>& state, const Work<D>& work, const Freed<D>& freed) {
  const int n = freed.node;
  const Vec<D> force = model.mass[n] * freed.pull - work.force[n];
  Moment<D> moment = moment_for(model, state, n, freed.turn) - work.moment[n];
  PointLoad<D> load;
  load.at = Attachment<D>::to_node(n, Vec<D>::Zero());
  for (int k = 0; k < Space<D>::translations; ++k)
    if (freed.on[k]) load.force[k] = force[k];
  for (int k = Space<D>::translations; k < Space<D>::dofs; ++k)
    if (freed.on[k]) component(load.moment, k - Space<D>::translations) = component(moment, k - Space<D>::translations);
  return load;
}

int count_of(const auto& freed) {
  int count = 0;
  for (const auto& node : freed)
    for (const bool on : node.on) count += on ? 1 : 0;
  return count;
}

}  // namespace

/// One evaluation gives the support forces; they act on the nodes as a load that fades out over `fade`.
template <int D>
int release_supports(Model<D>& model, const State<D>& state, int body, const std::array<bool, Space<D>::dofs>& on,
                     double fade) {
  drop_faded(model, state.time);
  const std::vector<Freed<D>> freed = free_nodes(model, state.time, body, on);
  if (freed.empty() || !(fade > 0)) return count_of(freed);
  Work<D> work;
  evaluate(model, state, work, state.last_dt);
  for (const Freed<D>& node : freed) {
    PointLoad<D> load = support_load(model, state, work, node);
    if (!(load.force.norm() > 0) && load.moment == nothing<Moment<D>>()) continue;
    load.body = body, load.curve = ramp_curve(state.time, 1, 0, fade, true);
    loads_of<PointLoad<D>>(model).push_back(std::move(load));
  }
  return count_of(freed);
}

template int release_supports(Model<2>&, const State<2>&, int, const std::array<bool, 3>&, double);
template int release_supports(Model<3>&, const State<3>&, int, const std::array<bool, 6>&, double);

}  // namespace trilith
