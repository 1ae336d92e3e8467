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
// The nodal forces f_s of the spin are added to f. This follows from Sherman, Morrison and Woodbury, so no system of
// equations is solved. Without constraints and spin y = (J^-1 - Jl^-1) (moment of f).
//
// Spin. J is the inertia of masses m_g at the integration points r_g = sum N_i(r_g) r_i of the element, which move with
// the nodes. Let s = Jl^-1 H with H = T' D v be the spin, and dJ, dJl the rates of J and Jl by the velocities without
// the rotation s. The lumped masses lie farther out than the body. So their centripetal force becomes the force of
// the masses m_g, and y gets the rate of B H that belongs to it:
//
//     f_s = D s x (s x r) - N' m_g s x (s x r_g),    Jl k = J Jl^-1 (dJl s + s x H) - dJ s - s x H,
//     y = (1 - B Jf)^-1 (B (T' (f + f_s) + ...) + k).
//
// With these terms the angular momentum J s follows the moment of f, and v' M v / 2 its work, as the body deforms. If J
// is a multiple of Jl (parallelograms, parallelepipeds, triangles, tetrahedra), with c = J/Jl
//
//     f_s = (1 - c) D s x (s x r),    k = -(1 - c) Jl^-1 (s x H).
//
// Because K T = 0, the frequencies of the element are unchanged. Contacts with the frequency n on the lumped masses
// have at most n Jl/J on the rotation. The step follows from max(n + e, n Jl/J), with e of the element.
#pragma once

#include <Eigen/LU>

#include <array>

#include "assembly/node_forces.hpp"
#include "assembly/step_options.hpp"
#include "model/element/one_element.hpp"
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

template <int D>
inline constexpr int corners_in = D == 2 ? 4 : 8;
/// A vector for each node of a body of one element, in the order of the body's nodes.
template <int D>
using NodeVectors = std::array<Vec<D>, corners_in<D>>;

/// Masses [kg] at arms from the centroid [m].
template <int D>
struct MassCloud {
  int count = 0;
  std::array<double, corners_in<D>> mass;
  NodeVectors<D> arm;
};

/// Inertia of a body of one element, in the present position of its nodes.
template <int D>
struct RotaryInertia {
  Vec<D> centre = Vec<D>::Zero();
  TurnMatrix<D> lumped = TurnMatrix<D>::Zero(), own = lumped;  ///< Jl, J [kg m2]
  double multiple = 0;                                         ///< Jl over J if they are proportional, otherwise 0
  MassCloud<D> nodes;                                          ///< lumped masses
  MassCloud<D> points;                     ///< masses at the integration points, none if they are proportional
  std::array<int, corners_in<D>> place{};  ///< index in `nodes` of the element's nodes

  [[nodiscard]] TurnMatrix<D> taken_off() const {
    const TurnMatrix<D> back = lumped.inverse();
    return back * (lumped - own) * back;
  }
};

template <int D>
bool has_one_element_bodies(const Model<D>& model);

RotaryInertia<2> rotary_inertia(const Model<2>& model, const State<2>& state, int body);
RotaryInertia<3> rotary_inertia(const Model<3>& model, const State<3>& state, int body);

/// Largest Jl over J; 1 for other bodies.
template <int D>
double lumped_over_own(const Model<D>& model, const State<D>& state, int body);

/// Adds D T y and the forces of the spin to `added` [node] for all bodies of one element; the forces on their nodes
/// must be complete.
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
