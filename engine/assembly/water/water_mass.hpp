// Added mass of water (load/water/added_mass.hpp): a directed mass m at a point of a body has the acceleration
//
//     a = sum of c_k . a_k
//
// along its direction, with the coefficients c_k of the nodes k, and acts on them with -m a c_k. Its kinetic energy is
// m (sum c_k . v_k)^2 / 2. Terms of the square of the velocity, from the rotation of the direction, are left out.
//
// Explicit steps need the accelerations a, on which the forces of the water depend:
//
//     (M + C' diag(m) C) a = F,    y = -diag(m) C a,    forces C' y,
//
// with the masses M of the nodes, F, the forces without the water, and the rows C of all points. The system has the
// free directions of the touched nodes only: it falls into blocks of single rigid bodies, and is banded along a mesh.
//
// Implicit steps and modes have the entries m c_i c_j in their mass matrix.
#pragma once

#include <array>
#include <vector>

#include "assembly/node_forces.hpp"
#include "base/attachment.hpp"

namespace trilith {

/// A row of C: the nodes and their coefficients.
template <int D>
struct DirectedMass {
  int count = 0;
  std::array<int, 2 * Attachment<D>::most_nodes> node{};
  std::array<Dofs<D>, 2 * Attachment<D>::most_nodes> along{};
  double mass = 0;  ///< [kg]

  void add(int n, const Dofs<D>& c) {
    node[static_cast<std::size_t>(count)] = n, along[static_cast<std::size_t>(count++)] = c;
  }
  /// The sum of c_k . v_k for one vector of numbers by node.
  template <class Of>
  [[nodiscard]] double times(Of&& of) const {
    double sum = 0;
    for (int i = 0; i < count; ++i)
      sum += dot(along[static_cast<std::size_t>(i)], of(node[static_cast<std::size_t>(i)]));
    return sum;
  }
};

/// A row in the present position of the nodes.
DirectedMass<2> directed_mass(const Model<2>& model, const State<2>& state, const MassPoint<2>& point);
DirectedMass<3> directed_mass(const Model<3>& model, const State<3>& state, const MassPoint<3>& point);

template <int D>
bool has_water_mass(const Model<D>& model) {
  return !loads_of<AddedMass<D>>(model).empty();
}

/// Calls f(row) for each point.
template <int D, class F>
void for_water_masses(const Model<D>& model, const State<D>& state, F&& f) {
  for (const AddedMass<D>& load : loads_of<AddedMass<D>>(model))
    for (const MassPoint<D>& point : load.points) f(directed_mass(model, state, point));
}

/// Calls add(node i, axis, node j, axis, value) for every entry of the mass matrix.
template <int D, class Add>
void each_water_entry(const Model<D>& model, const State<D>& state, Add&& add) {
  for_water_masses(model, state, [&](const DirectedMass<D>& row) {
    for (int i = 0; i < row.count; ++i)
      for (int j = 0; j < row.count; ++j) {
        const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
        for (std::size_t k = 0; k < row.along[a].size(); ++k)
          for (std::size_t l = 0; l < row.along[b].size(); ++l)
            if (row.along[a][k] != 0 && row.along[b][l] != 0)
              add(row.node[a], static_cast<int>(k), row.node[b], static_cast<int>(l),
                  row.mass * row.along[a][k] * row.along[b][l]);
      }
  });
}

/// Adds the forces of the water to the forces on the nodes, for an explicit step. All other forces must be complete.
template <int D>
void add_water_inertia(const Model<D>& model, const State<D>& state, Work<D>& work, const StepOptions& options);
/// The sum of these forces on the nodes, which add_water_inertia has added [N], [N m].
template <int D>
std::vector<Dofs<D>> water_inertia(const Model<D>& model, const State<D>& state, const Work<D>& work);

/// Kinetic energy at the instant [J].
template <int D>
double water_energy(const Model<D>& model, const State<D>& state);
/// Kinetic energy in the ledger of explicit steps, half of m v(-) v(+) [J].
template <int D>
double water_kinetic(const Model<D>& model, const State<D>& state, const Work<D>& work, const StepOptions& options);

}  // namespace trilith
