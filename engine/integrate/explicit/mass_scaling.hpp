// Selective mass scaling: longer explicit steps for meshed bodies, by added mass that acts only on their deformation.
//
// The stable step of a meshed body is the travel time of a wave through its smallest element, although this wave rarely
// matters for the results. D are the lumped masses. P projects any motion onto its rigid part with the same momentum
// and angular momentum. The mass matrix becomes
//
//     M = D + share (D - D P),        M (dv/dt - a) = f - D a,
//     dv/dt = a + (D^-1 f - a) / (1 + share).
//
// Here a is the rigid-body acceleration under the forces f. It contains the acceleration of the centre, the angular
// acceleration (moment minus w x I w), and w x (w x arm), which the added mass must not affect. No system of equations
// is solved. Translation, rotation, weight and all momenta of the body remain unchanged, because D (dv/dt - a) is
// self-balanced. Deforming motions are as slow as with (1 + share) times the mass. The method follows Olovsson,
// Simonsson and Unosson, "Selective mass scaling for explicit finite element analyses", Int. J. Numer. Meth. Engng 63,
// 2005. They scale each element and solve a system; here each body is scaled. If a node of a body is fixed along an
// axis, the body has no rigid motion along this axis and no rotation that moves along it (assembly/whole_body.hpp);
// such motion is slowed down.
//
// Size of the share: q(k, c, dt) = k dt^2 / 4 + c dt / 2 must not exceed 1 (integrate/explicit/stable_step.hpp). Its
// indices are r for contacts and bearings on the rigid body, n for the same on its nodes, and e for its elements:
//     q_e + q_n / (1 - q_r) <= 1 + share.
// This holds, because a motion x = rigid + deforming does work of at most (1 + 1/a) times the rigid part plus (1 + a)
// times the deforming part, for any a > 0.
#pragma once

#include <vector>

#include "integrate/explicit/central_difference.hpp"
#include "integrate/explicit/stable_step.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Options of mass scaling in a stage.
struct MassScaling {
  double step = 0;          ///< target length of a step [s], above 0
  double most = 30;         ///< largest allowed share of a body [1], above 0
  std::vector<int> bodies;  ///< bodies that may be scaled; empty: all
};

/// Mass scaling in use, up to now.
struct ScaledMass {
  int bodies = 0;                  ///< number of bodies with a share
  double share = 0;                ///< added mass over the mass of all moving bodies [1]
  double most = 0;                 ///< largest share of a body, of its own mass [1]
  int body = -1;                   ///< the body with the largest share
  double before = 0;               ///< stable step without mass scaling [s]
  double energy = 0, kinetic = 0;  ///< largest kinetic energies of the added mass and of the model [J]
};

/// Share that a body with these rates needs for a stable step dt [s]; `unbounded` if no share is sufficient.
double share_for(const BodyRates& rates, double mass_damping, double dt);
/// Longest stable step with the given share [s].
double scaled_step(const BodyRates& rates, double share, double mass_damping);
/// Reduces `found` to the step of body `body` with the given share if it is shorter.
void shorten_to_scaled(const BodyRates& rates, double share, double mass_damping, int body, StableStep& found);

/// Increases the shares of bodies to the values needed for steps of asked.step at this `safety`, after an evaluation.
/// The ledger receives the kinetic energy that this adds. Shares never decrease. Returns true if a share was changed;
/// State must then be evaluated again. With `must`, throws InputError if the step cannot be reached; otherwise bodies
/// receive their largest allowed share.
template <int D>
bool scale_masses(const Model<D>& model, State<D>& state, const Work<D>& work, const MassScaling& asked, double safety,
                  bool must, ScaledMass& found);
/// Updates the totals of shares and kinetic energy if no share had to increase.
template <int D>
void measure_scaled(const Model<D>& model, const State<D>& state, ScaledMass& found);
/// Removes all added mass; the ledger receives its energy.
template <int D>
void unscale_masses(const Model<D>& model, State<D>& state);
/// Fills Work::added_inertia with the forces on the nodes that slow down deformation; they are self-balanced over each
/// free body. All other forces of the step must be known. The forces of assembly/element/rotary_inertia.hpp are
/// included.
template <int D>
void add_inertia(const Model<D>& model, const State<D>& state, Work<D>& work, const StepOptions& options);
/// Kinetic energy of the added mass at the last half step [J].
template <int D>
double added_energy(const Model<D>& model, const State<D>& state);
/// Kinetic energy of the added mass in the ledger: half of v(-) M v(+). `span`: time between the two velocities [s], 0
/// at the start.
template <int D>
double added_kinetic(const Model<D>& model, const State<D>& state, const Work<D>& work, const StepOptions& options,
                     double span);

}  // namespace trilith
