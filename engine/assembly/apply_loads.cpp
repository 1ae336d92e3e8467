// Loads of the present instant on the nodes.
#include "assembly/evaluate.hpp"
#include "assembly/field/joint_water.hpp"
#include "assembly/load_target.hpp"
#include "assembly/water/closed_joints.hpp"

namespace trilith {

// Every kind of load has the members that a target needs. Checked here, as the lists are included nearly everywhere.
static_assert(LoadKinds<2>::all([]<class L>() { return LoadKind<L, 2, LoadTarget<2>>; }));
static_assert(LoadKinds<3>::all([]<class L>() { return !L::in_space || LoadKind<L, 3, LoadTarget<3>>; }));

namespace {

/// Sets the steady loads of the model; false if there are no others. Empty
/// arrays mean no loads beyond the steady ones, and assemble_forces and the
/// nodes read the arrays of the model.
template <int D>
bool begin_loads(const Model<D>& model, Work<D>& work) {
  if (!model.loaded() && !has_joint_water(model)) {
    if (work.load.empty()) return false;
    work.load.clear(), work.load_moment.clear(), work.correction.clear(), work.correction_moment.clear();
    work.push_force.clear(), work.water.clear(), work.water_moment.clear();
    return false;
  }
  work.load.assign(model.load.begin(), model.load.end());
  work.load_moment.assign(model.load.size(), nothing<Moment<D>>());
  work.correction.clear(), work.correction_moment.clear();
  work.push_force.assign(model.pushes.size(), 0);
  return true;
}

/// Forces of water, kept for their work, and added to the others.
template <int D>
void apply_water(const Model<D>& model, const State<D>& state, Work<D>& work) {
  work.water.clear(), work.water_moment.clear();
  if (!has_water(model) && !has_joint_water(model)) return;
  work.water.assign(model.load.size(), Vec<D>::Zero());
  work.water_moment.assign(model.load.size(), nothing<Moment<D>>());
  find_closed_joints(model, work);
  LoadTarget<D> nodes{{model, state, &work, &work.closed_joints}, work.water, work.water_moment};
  model.loads.for_each([&]<class L>(const L& load) {
    if constexpr (is_water<L>)
      for (int part = 0; part < load.parts(); ++part) load.apply(nodes, part);
  });
  press_joints(model, state, work, work.water, work.water_moment);
  for (std::size_t n = 0; n < work.water.size(); ++n)
    work.load[n] += work.water[n], work.load_moment[n] += work.water_moment[n];
}

}  // namespace

template <int D>
void apply_loads(const Model<D>& model, const State<D>& state, Work<D>& work) {
  if (!begin_loads(model, work)) return;
  LoadTarget<D> nodes{{model, state, &work}, work.load, work.load_moment};
  model.loads.for_each([&]<class L>(const L& load) {
    if constexpr (!is_water<L>)
      for (int part = 0; part < load.parts(); ++part) load.apply(nodes, part);
  });
  apply_water(model, state, work);
}

template void apply_loads(const Model<2>&, const State<2>&, Work<2>&);
template void apply_loads(const Model<3>&, const State<3>&, Work<3>&);

}  // namespace trilith
