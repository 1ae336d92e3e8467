// Longer explicit steps for bodies of finite elements, by mass that only their deformation feels.
//
// The step of a meshed body is that of a wave through its smallest element, which nothing of interest depends on. With
// D its lumped masses and P what takes from any motion its rigid part (with the same momentum and angular momentum),
// the mass matrix becomes
//
//     M = D + share (D - D P),        M (dv/dt - a) = f - D a,
//     dv/dt = a + (D^-1 f - a) / (1 + share),
//
// with a the acceleration that the forces f give the body as if it were rigid: that of its centre, that of its turn
// (of the moment less w x I w), and w x (w x arm), which a turn needs and the added mass is not to feel. No system is
// to be solved. The body's translation and rotation, its weight and all momenta stay as they are, as D (dv/dt - a) is
// in balance; motions that deform it are as slow as if (1 + share) times its mass took part in them. (After Olovsson,
// Simonsson and Unosson, "Selective mass scaling for explicit finite element analyses", Int. J. Numer. Meth. Engng 63,
// 2005, who do so element by element and solve for it; here it is done body by body.) Along an axis along which some
// node of a body is held it has no rigid motion, nor any turn that goes there (assembly/whole_body.hpp): that is
// slowed.
//
// How large the share is: with q(k, c, dt) = k dt^2 / 4 + c dt / 2, which must not exceed 1
// (integrate/explicit/stable_step.hpp), r of contacts and bearings on the rigid body, n of these on its nodes and e of
// its elements,
//     q_e + q_n / (1 - q_r) <= 1 + share,
// as motions x = rigid + deforming do work of at most (1 + 1/a) of the one and (1 + a) of the other for any a > 0.
#pragma once

#include <vector>

#include "integrate/explicit/central_difference.hpp"
#include "integrate/explicit/stable_step.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// What a stage asks for.
struct MassScaling {
  double step = 0;          ///< length of a step [s], above 0
  double most = 30;         ///< largest share that a body may be given [1], above 0
  std::vector<int> bodies;  ///< those that may be given one; empty: all
};

/// What it came to, up to now.
struct ScaledMass {
  int bodies = 0;                  ///< that have a share
  double share = 0;                ///< of the mass of all that moves
  double most = 0;                 ///< the largest of a body, of its own mass
  int body = -1;                   ///< that one
  double before = 0;               ///< the step without it [s]
  double energy = 0, kinetic = 0;  ///< largest energies of motion of the added mass, and of the model's own [J]
};

/// Share that a body of these rates takes for a stable step dt [s]; `unbounded` where none is enough.
double share_for(const BodyRates& rates, double mass_damping, double dt);
/// Longest stable step with that share [s].
double scaled_step(const BodyRates& rates, double share, double mass_damping);
/// Brings `found` down to the step of body `body` with that share, where this is shorter.
void shorten_to_scaled(const BodyRates& rates, double share, double mass_damping, int body, StableStep& found);

/// Gives bodies the shares they lack for steps of asked.step at this `safety`, after an evaluation. The ledger has what
/// that adds to their energy of motion. Shares only grow. True where something was changed: State is to be evaluated
/// anew. With `must`, InputError where the step cannot be had; else bodies have as much as they may.
template <int D>
bool scale_masses(const Model<D>& model, State<D>& state, const Work<D>& work, const MassScaling& asked, double safety,
                  bool must, ScaledMass& found);
/// What the shares and the energy of their motion come to by now, where none had to grow.
template <int D>
void measure_scaled(const Model<D>& model, const State<D>& state, ScaledMass& found);
/// Takes all of it away again; the ledger has what it held.
template <int D>
void unscale_masses(const Model<D>& model, State<D>& state);
/// Fills Work::added_inertia: forces on the nodes, in balance over each free body, that slow what deforms it. After all
/// other forces of the step are known. Those of assembly/element/rotary_inertia.hpp are among them.
template <int D>
void add_inertia(const Model<D>& model, const State<D>& state, Work<D>& work, const StepOptions& options);
/// Energy of motion of the added mass at the last half step [J].
template <int D>
double added_energy(const Model<D>& model, const State<D>& state);
/// The same as the ledger has it: half of v(-) M v(+); `span`: between the two velocities [s], 0 at the very start.
template <int D>
double added_kinetic(const Model<D>& model, const State<D>& state, const Work<D>& work, const StepOptions& options,
                     double span);

}  // namespace trilith
