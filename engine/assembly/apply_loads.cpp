// Loads of the present instant on the nodes.
#include "assembly/evaluate.hpp"
#include "assembly/load_target.hpp"

namespace trilith {
namespace {

/// Sets the steady loads of the model; false if there are no others. Empty arrays mean no loads beyond the steady ones,
/// and assemble_forces and the nodes read the arrays of the model.
template <int D>
bool begin_loads(const Model<D>& model, Work<D>& work) {
  if (!model.loaded()) {
    if (work.load.empty()) return false;
    work.load.clear(), work.load_moment.clear(), work.correction.clear(), work.correction_moment.clear();
    work.push_force.clear();
    return false;
  }
  work.load.assign(model.load.begin(), model.load.end());
  work.load_moment.assign(model.load.size(), nothing<Moment<D>>());
  work.correction.clear(), work.correction_moment.clear();
  work.push_force.assign(model.pushes.size(), 0);
  return true;
}

}  // namespace

template <int D>
void apply_loads(const Model<D>& model, const State<D>& state, Work<D>& work) {
  if (!begin_loads(model, work)) return;
  LoadTarget<D> nodes{{model, state, &work}, work.load, work.load_moment};
  model.loads.for_each([&](const auto& load) {
    for (int part = 0; part < load.parts(); ++part) load.apply(nodes, part);
  });
}

template void apply_loads(const Model<2>&, const State<2>&, Work<2>&);
template void apply_loads(const Model<3>&, const State<3>&, Work<3>&);

}  // namespace trilith
