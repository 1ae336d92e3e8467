// Rotary inertia of bodies of one finite element.
//
// The mass of an element is lumped at its nodes, so that explicit steps divide by it. In a body of one element all mass
// lies at the corners, which makes the moment of inertia too large. The factor is 3 for a quad or brick, 4 for a
// triangle, 5 for a tetrahedron, and 1 + 2/n^2 for n elements across. Such a body has the mass matrix
//
//     M = D - D T B T' D,     B = Jl^-1 (Jl - J) Jl^-1.
//
// Here D are the lumped masses, T w = w x r is the rotation of all nodes about the centroid, Jl = T' D T is the moment
// of inertia of the lumped masses, and J the moment of inertia of the body. Translation and all other motions keep the
// lumped mass, and a rotation has J. The momentum is conserved because T' D 1 = 0. The free directions satisfy D dv/dt
// = f + D T y with
//
//     y = (1 - B Jf)^-1 B (T' f + T' D a of driven nodes),     Jf = T' D T of the free directions.
//
// This follows from Sherman, Morrison and Woodbury, so no system of equations is solved. Without constraints y = (J^-1
// - Jl^-1) (moment of f). In space T, J and Jl rotate with the body. The angular momentum J s, with the spin s = Jl^-1
// T' D v, follows the moment only if B ( ) in y is replaced by B ( ) + Jl^-1 (J Jl^-1 (s x Jl s) - s x J s). The
// additional term does no work. It is 0 if J is a multiple of Jl, as for parallelepipeds and tetrahedra.
//
// Because K T = 0, the frequencies of the element are unchanged. Contacts with the frequency n on the lumped masses
// have at most n Jl/J on the rotation. The step follows from max(n + e, n Jl/J), with e of the element.
#pragma once

#include <Eigen/LU>
#include <optional>
#include <type_traits>

#include "assembly/node_forces.hpp"
#include "assembly/step_options.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

template <int D>
inline constexpr int turns_in = D == 2 ? 1 : 3;
/// A rotation or moment, and a matrix of inertia between them.
template <int D>
using TurnVector = Eigen::Matrix<double, turns_in<D>, 1>;
template <int D>
using TurnMatrix = Eigen::Matrix<double, turns_in<D>, turns_in<D>>;

/// The velocity along axis k of a point at `arm` is turn_row . w.
inline TurnVector<2> turn_row(int k, const Vec2& arm) {
  return TurnVector<2>(k == 0 ? -arm.y() : arm.x());
}
inline TurnVector<3> turn_row(int k, const Vec3& arm) {
  if (k == 0) return {0, arm.z(), -arm.y()};
  if (k == 1) return {-arm.z(), 0, arm.x()};
  return {arm.y(), -arm.x(), 0};
}

/// Inertia of a body of one element, in the present position of its nodes.
template <int D>
struct RotaryInertia {
  Vec<D> centre;
  TurnMatrix<D> lumped, own;  ///< Jl, J [kg m2]
  double multiple = 0;        ///< Jl over J in space if they are proportional, otherwise 0

  [[nodiscard]] TurnMatrix<D> taken_off() const {
    const TurnMatrix<D> back = lumped.inverse();
    return back * (lumped - own) * back;
  }
};

/// True for a body of one element with corrected rotary inertia: a quad or triangle, in space a brick or a tetrahedron
/// of four nodes.
bool is_one_element(const Model<2>& model, int body);
bool is_one_element(const Model<3>& model, int body);
template <int D>
bool has_one_element_bodies(const Model<D>& model);

RotaryInertia<2> rotary_inertia(const Model<2>& model, const State<2>& state, int body);
RotaryInertia<3> rotary_inertia(const Model<3>& model, const State<3>& state, int body);

/// Largest Jl over J; 1 for other bodies.
template <int D>
double lumped_over_own(const Model<D>& model, const State<D>& state, int body);

/// Adds D T y to `added` [node] for all bodies of one element; the forces on their nodes must be complete.
template <int D>
void add_rotary_inertia(const Model<D>& model, const State<D>& state, const Work<D>& work, const StepOptions& options,
                        bool all_count, std::vector<Vec<D>>& added);

/// Additional kinetic energy in the ledger of explicit steps, half of v(-) M v(+) [J]. It is 0 if the next step does
/// not use it, because its forces have not been added.
template <int D>
double rotary_kinetic(const Model<D>& model, const State<D>& state, const Work<D>& work, const StepOptions& options);

/// - T' D v B T' D v / 2 with velocities at the instant [J].
template <int D>
double rotary_energy(const Model<D>& model, const State<D>& state);

/// Adds (M - D) v to `out`.
template <int D>
void add_rotary_momentum(const Model<D>& model, const State<D>& state, const std::vector<Dofs<D>>& v,
                         std::vector<Dofs<D>>& out);
/// Adds the diagonal of M - D to `out`.
template <int D>
void add_rotary_diagonal(const Model<D>& model, const State<D>& state, std::vector<Dofs<D>>& out);
/// Adds the inertia forces of M - D, from accelerations (if `rising`) and rotation.
template <int D>
void add_rotary_forces(const Model<D>& model, const State<D>& state, bool rising, std::vector<Dofs<D>>& out);

/// Calls add(node i, axis, node j, axis, value) for every entry of M - D.
template <int D, class Add>
void each_rotary_entry(const Model<D>& model, const State<D>& state, Add&& add) {
  for (int b = 0; b < static_cast<int>(model.bodies.size()); ++b) {
    if (!is_one_element(model, b) || !model.body_moves(b)) continue;
    const RotaryInertia<D> of = rotary_inertia(model, state, b);
    const TurnMatrix<D> off = of.taken_off();
    const Body& body = model.bodies[static_cast<std::size_t>(b)];
    const int end = body.first_node + body.nodes;
    for (int i = body.first_node; i < end; ++i)
      for (int k = 0; k < D; ++k) {
        const TurnVector<D> row = model.mass[i] * (off * turn_row(k, Vec<D>(state.position[i] - of.centre)));
        for (int j = body.first_node; j < end; ++j)
          for (int l = 0; l < D; ++l)
            add(i, k, j, l, -model.mass[j] * row.dot(turn_row(l, Vec<D>(state.position[j] - of.centre))));
      }
  }
}

}  // namespace trilith
