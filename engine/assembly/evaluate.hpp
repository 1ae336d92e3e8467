// M a = loads + internal forces + contact forces + bearing forces: one evaluation, shared by every integrator. It
// writes Work only.
#pragma once

#include "assembly/step_times.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Kinematics, contact pairs, contact and bearing forces, internal forces, loads, and their sum, at the present pose
/// and velocity, over a step `dt` [s] since the last commit. A second evaluation changes nothing. `times` receives
/// the time of each stage. In space, polyhedra take the place of surface points.
template <int D>
void evaluate(const Model<D>& model, const State<D>& state, Work<D>& work, double dt, StepTimes* times = nullptr);

// The stages, each the only writer of its part of Work.
template <int D>
void update_kinematics(const Model<D>& model, const State<D>& state, Work<D>& work);
template <>
void update_kinematics(const Model<2>& model, const State<2>& state, Work<2>& work);
template <>
void update_kinematics(const Model<3>& model, const State<3>& state, Work<3>& work);
void update_contact_pairs(const Model<2>& model, const State<2>& state, Work<2>& work);
void update_contact_pairs(const Model<3>& model, const State<3>& state, Work<3>& work);
void face_contact_forces(const Model<2>& model, const State<2>& state, Work<2>& work, double dt,
                         StepTimes* times = nullptr);
void polygon_contact_forces(const Model<2>& model, const State<2>& state, Work<2>& work, double dt);
void polygon_contact_forces(const Model<3>& model, const State<3>& state, Work<3>& work, double dt);
template <int D>
void bearing_forces(const Model<D>& model, const State<D>& state, Work<D>& work, double dt);
/// Makes the waiting bearing `i` live in the present position: sliders start unstressed there, springs act from
/// `begun_at`, by direction [m], [rad]. Writes its trial memory. Returns its initial elastic energy [J].
template <int D>
double start_bearing(const Model<D>& model, const State<D>& state, Work<D>& work, int i,
                     const std::array<double, Space<D>::dofs>& begun_at);
/// Deformable bodies: forces and damping forces of their elements on their nodes, trial plastic memory, energies. `dt`:
/// as for evaluate; 0 if no time has passed after the last commit.
void internal_forces(const Model<2>& model, const State<2>& state, Work<2>& work, double dt = 0);
void internal_forces(const Model<3>& model, const State<3>& state, Work<3>& work, double dt = 0);
/// Present loads on the nodes. Work::load remains empty if the model has only steady loads.
template <int D>
void apply_loads(const Model<D>& model, const State<D>& state, Work<D>& work);
template <int D>
void assemble_forces(const Model<D>& model, const State<D>& state, Work<D>& work);

}  // namespace trilith
