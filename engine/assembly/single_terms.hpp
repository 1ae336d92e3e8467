// Stages of `evaluate` for one bearing, element, load, piece or contact by itself.
#pragma once

#include <cstddef>
#include <vector>

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Makes room in `work` for what all bearings answer; bearing_force then writes the rows of one.
template <int D>
void start_bearings(const Model<D>& model, Work<D>& work);
template <int D>
void bearing_force(const Model<D>& model, const State<D>& state, Work<D>& work, std::size_t i, double dt);

/// Adds forces and dampings of a finite element to those of its nodes in `work`, which has room for those of all.
void element_forces(const Model<2>& model, const State<2>& state, Work<2>& work, int element);
/// What a finite element in space resists with; `work` has room for the memories of all.
void element_forces(const Model<3>& model, const State<3>& state, Work<3>& work, int element, SpaceElementAnswer& out);

/// Adds what a load gives now to forces [N] and moments [N m] by node; of a face whose skin points `work` has placed.
void apply_load(const Model<2>& model, const State<2>& state, const PointLoad<2>& load, std::vector<Vec2>& node_force,
                std::vector<double>& node_moment);
void apply_load(const Model<3>& model, const State<3>& state, const PointLoad<3>& load, std::vector<Vec3>& node_force,
                std::vector<Vec3>& node_moment);
void apply_load(const Model<2>& model, const State<2>& state, const FaceLoad<2>& load, const Work<2>& work,
                std::vector<Vec2>& node_force, std::vector<double>& node_moment);

/// Places a piece in space anew in `work`, in which all are placed: with all that its contacts ask of it.
void place_again(const Model<3>& model, const State<3>& state, Work<3>& work, int piece);
/// The answer of one row of contact in space, as its pieces are placed in `work`, which has been evaluated. What `work`
/// remembers of the row is written, and nothing is added up.
void contact_row_forces(const Model<3>& model, const State<3>& state, Work<3>& work, int row, double dt,
                        SolidAnswer& answer);

}  // namespace trilith
