// Common part of all terms; elements and loads.
#include "assembly/tangent/fd_tangent.hpp"

#include <cmath>

#include "assembly/bearing_motion.hpp"
#include "assembly/load_target.hpp"
#include "assembly/single_terms.hpp"

namespace trilith {

PlacedSkin placed_skin(const Model<2>& model, const State<2>& state, int skin) {
  const int n = model.skin_node[skin], t = model.skin_turn[skin];
  const Vec2 arm = Turn(state.rotation[t]).apply(model.skin_place[skin]);
  const Vec2 x = state.position[n] + arm, v = state.velocity[n] + cross(state.spin[t], arm);
  return {{x.x(), x.y(), v.x(), v.y()}, arm};
}

template <int D>
void TermSum<D>::add_column(const TermNodes& nodes, int column, const TermForces& more, const TermForces& less,
                            double apart) {
  constexpr auto dofs = static_cast<std::size_t>(Space<D>::dofs);
  const double scale = -options.force / apart;
  for (std::size_t i = 0; i < more.size(); ++i) {
    const int row = unknown[nodes.list()[i / dofs]][i % dofs];
    if (row < 0 || more[i] == less[i]) continue;
    matrix.coeffRef(row, column) += scale * (more[i] - less[i]);
  }
}

/// Terms of single elements: stresses and damping, as in internal_forces.
void add_element_terms(TermSum<2>& sum) {
  const Model<2>& model = sum.model;
  if (model.elements.empty()) return;
  Work<2> own;
  own.element_force.assign(model.mass.size(), Vec2::Zero());
  own.element_damping.assign(model.mass.size(), Vec2::Zero());
  own.plastic.resize(sum.state.plastic.size());
  TermNodes nodes;
  for (int i = 0; i < static_cast<int>(model.elements.size()); ++i) {
    const Element& e = model.elements[i];
    nodes.clear();
    for (int j = 0; j < e.nodes; ++j) nodes.add(e.node[j]);
    sum.add(nodes, [&](const Freedom& /*moved*/, TermForces& out) {
      element_forces(model, sum.state, own, i);
      double* to = out.data();
      for (const int n : nodes.list()) {
        const Vec2 f = own.element_force[n] + own.element_damping[n];
        *to++ = f.x(), *to++ = f.y(), *to++ = 0;
        own.element_force[n].setZero(), own.element_damping[n].setZero();
      }
    });
  }
}

/// The places that a part of a load depends on, in the form of `visit` (load/load_kind.hpp).
template <int D>
struct SeenPlaces {
  const Model<D>& model;
  TermNodes& nodes;
  void operator()(const Attachment<D>& at) const { nodes.add(model, at); }
  void operator()(int skin) const {
    if constexpr (D == 2) nodes.add_skin(model, skin);
  }
};

/// Point loads rotate with their arms, following loads rotate themselves too, and pressures move with the faces.
template <int D>
void add_load_terms(TermSum<D>& sum, const Work<D>& work) {
  const Model<D>& model = sum.model;
  if (model.loads.empty()) return;
  NodeArrays<D> all(model);
  TermNodes nodes;
  model.loads.for_each([&](const auto& load) {
    for (int part = 0; part < load.parts(); ++part) {
      nodes.clear();
      load.visit(part, SeenPlaces<D>{model, nodes});
      sum.add(nodes, [&](const Freedom& /*moved*/, TermForces& out) {
        LoadTarget<D> to{{model, sum.state, nullptr, &work.closed_joints}, all.force, all.moment};
        load.apply(to, part);
        all.take(nodes, out);
      });
    }
  });
}

/// Terms of single bearings, in all directions.
template <int D>
void add_bearing_terms(TermSum<D>& sum) {
  const Model<D>& model = sum.model;
  if (model.bearings.empty()) return;
  Work<D> own;
  start_bearings(model, own);
  NodeArrays<D> all(model);
  TermNodes nodes;
  for (std::size_t i = 0; i < model.bearings.size(); ++i) {
    const Bearing<D>& b = model.bearings[i];
    nodes.clear(), nodes.add(model, b.end_a), nodes.add(model, b.end_b);
    sum.add(nodes, [&](const Freedom& /*moved*/, TermForces& out) {
      bearing_force(model, sum.state, own, i, sum.options.dt);
      push_ends(model, sum.state, b, own.bearing_force[i], own.bearing_moment[i], all.force, all.moment);
      all.take(nodes, out);
    });
  }
}

template struct TermSum<2>;
template struct TermSum<3>;
template void add_load_terms(TermSum<2>& sum, const Work<2>& work);
template void add_load_terms(TermSum<3>& sum, const Work<3>& work);
template void add_bearing_terms(TermSum<2>& sum);
template void add_bearing_terms(TermSum<3>& sum);

}  // namespace trilith
