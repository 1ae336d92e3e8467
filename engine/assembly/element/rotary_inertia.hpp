// Rotary inertia of bodies of one finite element.
//
// An element's mass is lumped at its nodes, so that explicit steps divide by it. Of a body that is one element this
// makes the moment of inertia too large: three times of a quad or brick, four times of a triangle, five times of a
// tetrahedron, as all mass lies at the corners. (Of n elements across, 1 + 2/n^2 times.) Such a body has the mass
// matrix
//
//     M = D - D T B T' D,     B = Jl^-1 (Jl - J) Jl^-1,
//
// with D the lumped masses, T w = w x r the rotation of all nodes about the centroid, Jl = T' D T the moment of inertia
// of the lumped masses and J that of the body. Translation and every other motion keep their lumped mass, a rotation
// has J, and the momentum is kept as T' D 1 = 0. D dv/dt = f + D T y holds for the free directions, with
//
//     y = (1 - B Jf)^-1 B (T' f + T' D a of what is driven),     Jf = T' D T of the free directions
//
// after Sherman, Morrison and Woodbury, so no system is to be solved. Where nothing is held that is
// y = (J^-1 - Jl^-1) (moment of f). In space T, J and Jl turn with the body: the angular momentum J s, with s the spin
// Jl^-1 T' D v, follows the moment only with B ( ) + Jl^-1 (J Jl^-1 (s x Jl s) - s x J s) for B ( ) in y. That is 0
// where J is a multiple of Jl, as of parallelepipeds and tetrahedra, and does no work. K T = 0, so the frequencies of
// the element are what they were; contacts, whose frequency on the lumped masses is n, have n Jl/J at most on the
// rotation: the step is that of max(n + e, n Jl/J), e of the element.
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
/// A turn, a moment; and what of inertia goes from one to the other.
template <int D>
using TurnVector = Eigen::Matrix<double, turns_in<D>, 1>;
template <int D>
using TurnMatrix = Eigen::Matrix<double, turns_in<D>, turns_in<D>>;

/// Velocity along axis k of a point at `arm` is turn_row . w.
inline TurnVector<2> turn_row(int k, const Vec2& arm) {
  return TurnVector<2>(k == 0 ? -arm.y() : arm.x());
}
inline TurnVector<3> turn_row(int k, const Vec3& arm) {
  if (k == 0) return {0, arm.z(), -arm.y()};
  if (k == 1) return {-arm.z(), 0, arm.x()};
  return {arm.y(), -arm.x(), 0};
}

/// Inertia of a body of one element, as its nodes stand.
template <int D>
struct RotaryInertia {
  Vec<D> centre;
  TurnMatrix<D> lumped, own;  ///< Jl, J [kg m2]
  double multiple = 0;        ///< Jl over J in space where they are alike, else 0

  [[nodiscard]] TurnMatrix<D> taken_off() const {
    const TurnMatrix<D> back = lumped.inverse();
    return back * (lumped - own) * back;
  }
};

/// True of a body of one element whose rotary inertia is mended: a quad or triangle; in space a brick or a tetrahedron
/// of four nodes.
bool is_one_element(const Model<2>& model, int body);
bool is_one_element(const Model<3>& model, int body);
template <int D>
bool has_one_element_bodies(const Model<D>& model);

RotaryInertia<2> rotary_inertia(const Model<2>& model, const State<2>& state, int body);
RotaryInertia<3> rotary_inertia(const Model<3>& model, const State<3>& state, int body);

/// Largest Jl over J; 1 of other bodies.
template <int D>
double lumped_over_own(const Model<D>& model, const State<D>& state, int body);

/// Adds D T y to `added` [node], for all bodies of one element; forces of these nodes are known. `dt`: of the step to
/// come [s].
template <int D>
void add_rotary_inertia(const Model<D>& model, const State<D>& state, const Work<D>& work, const StepOptions& options,
                        bool all_count, std::vector<Vec<D>>& added);

/// What it adds to the kinetic energy as the ledger of explicit steps has it, half of v(-) M v(+) [J]. 0 where the step
/// to come does without it, as its forces have not been added.
template <int D>
double rotary_kinetic(const Model<D>& model, const State<D>& state, const Work<D>& work, const StepOptions& options);

/// - T' D v B T' D v / 2, of velocities of the instant [J].
template <int D>
double rotary_energy(const Model<D>& model, const State<D>& state);

/// Adds (M - D) v to `out`.
template <int D>
void add_rotary_momentum(const Model<D>& model, const State<D>& state, const std::vector<Dofs<D>>& v,
                         std::vector<Dofs<D>>& out);
/// Adds the diagonal of M - D to `out`.
template <int D>
void add_rotary_diagonal(const Model<D>& model, const State<D>& state, std::vector<Dofs<D>>& out);
/// Adds forces that M - D takes as it moves, by accelerations (where `rising`) and turning.
template <int D>
void add_rotary_forces(const Model<D>& model, const State<D>& state, bool rising, std::vector<Dofs<D>>& out);

/// add(node i, axis, node j, axis, value) for every entry of M - D.
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
