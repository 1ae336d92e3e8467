// Storeys of a building, from the groups "storey 1", "storey 2", ... of its bodies: drift and twist.
#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

struct Storey {
  int number = 0;
  std::vector<int> bodies;        ///< all of it
  std::vector<int> top;           ///< its floors (groups "slabs", "slab", "floors"; of them those not in "beams" where
                                  ///< there are such), or else its topmost bodies
  double bottom = 0, height = 0;  ///< at the start, from the top of the storey below, or of the base under it, or its
                                  ///< own lowest point [m]
};

/// Lowest first; a storey without a body in between is not there. Bodies of several walls that stand beside each other
/// with the same groups make one storey.
template <int D>
std::vector<Storey> find_storeys(const Model<D>& model);

/// Bodies the structure stands on: group "base", or where there is none all that are not free to move along any level
/// axis.
template <int D>
std::vector<int> find_base(const Model<D>& model);

/// Number of the storey that a group names ("storey 2"), 0: none does.
int storey_in(const std::vector<std::string>& groups);

/// Number of the storey that `body` belongs to, 0: none.
template <int D>
int storey_of(const Model<D>& model, int body);

/// Storey of what is between two bodies: that of the one whose first node began higher, or else of the other; 0: none.
template <int D>
int storey_between(const Model<D>& model, int body_a, int body_b);

/// Mean displacement of the bodies' nodes since the start, each body for the mean of its own [m]; 0 for none.
template <int D>
Vec<D> mean_displacement(const Model<D>& model, const State<D>& state, const std::vector<int>& bodies);

/// Mean displacement of a storey's top against that of the storey below, or of the base [m]: its drift along the level
/// axes, and how much higher it has got along the upright one. `index` into `storeys`.
template <int D>
Vec<D> storey_drift(const Model<D>& model, const State<D>& state, const std::vector<Storey>& storeys,
                    const std::vector<int>& base, std::size_t index);

/// Of the topmost storey against the base [m]; 0 without storeys.
template <int D>
Vec<D> top_drift(const Model<D>& model, const State<D>& state, const std::vector<Storey>& storeys,
                 const std::vector<int>& base);

/// The part along the level axes: of the plane with the sign of x, in space a length.
double level_part(const Vec2& drift);
double level_part(const Vec3& drift);

/// Turn of bodies about the upright axis since the start, counter-clockwise as seen from above [rad, -pi to pi]: the
/// plane turn that brings the points of their skin nearest to where they are, by least squares.
double mean_twist(const Model<3>& model, const State<3>& state, const std::vector<int>& bodies);

/// Twist of a storey's top against that of the storey below, or of the base [rad, -pi to pi].
double storey_twist(const Model<3>& model, const State<3>& state, const std::vector<Storey>& storeys,
                    const std::vector<int>& base, std::size_t index);

}  // namespace trilith
