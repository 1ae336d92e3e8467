#include "step/release.hpp"

#include "step/evaluate.hpp"
#include "world/loads.hpp"

namespace trilith {
namespace {

/// One degree of freedom that was let go: its acceleration as its support had it.
struct Freed {
  int node, dof;
  double pull;
};

/// Frees them in the model, and tells what acceleration each had.
std::vector<Freed> free_nodes(Model<2>& model, double time, int body, const std::array<bool, 3>& on) {
  const Body& b = model.bodies[body];
  std::vector<Freed> freed;
  for (int n = b.first_node; n < b.first_node + b.nodes; ++n)
    for (const int k : {0, 1, 2}) {
      if (!on[k] || model.support[n][k] == Support::free || (k == 2 && !b.nodes_turn())) continue;
      const int drive = model.drive_of[n][k];
      freed.push_back(
          {n, k, drive < 0 ? 0 : model.drives[drive].motion->acceleration(time - model.drives[drive].start)});
      model.support[n][k] = Support::free;
      model.drive_of[n][k] = -1;
    }
  return freed;
}

}  // namespace

/// A support that goes at once would strike: what it carried is found by one evaluation, R = m a - F, put on the nodes
/// as a load, and faded out over `fade`. Where a node is driven, a is the acceleration of its motion.
int release_supports(Model<2>& model, const State<2>& state, int body, const std::array<bool, 3>& on, double fade) {
  drop_faded(model, state.time);
  const std::vector<Freed> freed = free_nodes(model, state.time, body, on);
  if (freed.empty() || !(fade > 0)) return static_cast<int>(freed.size());
  Work<2> work;
  evaluate(model, state, work, state.last_dt);
  PointLoad<2> load;
  load.body = body, load.curve = ramp_curve(state.time, 1, 0, fade, true);
  for (std::size_t i = 0; i < freed.size(); ++i) {
    const auto& [n, k, pull] = freed[i];
    load.at = Tie<2>::to_node(n, Vec2::Zero());
    if (k == 2)
      load.moment = model.inertia[n] * pull - work.moment[n];
    else
      load.force[k] = model.mass[n] * pull - work.force[n][k];
    if (i + 1 < freed.size() && freed[i + 1].node == n) continue;
    if (load.force.norm() > 0 || load.moment != 0) model.point_loads.push_back(load);
    load.force = Vec2::Zero(), load.moment = 0;
  }
  return static_cast<int>(freed.size());
}

}  // namespace trilith
