// Storeys of a building, from the groups "storey 1", "storey 2", ... of its bodies: drift and twist.
#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

struct Storey {
  int number = 0;
  std::vector<int> bodies;        ///< all bodies of the storey
  std::vector<int> top;           ///< its floors (groups "slabs", "slab", "floors"; if some of these are not in
                                  ///< "beams", only they), otherwise its topmost bodies
  double bottom = 0, height = 0;  ///< at the start, from the top of the storey below, from the base below it, or from
                                  ///< its own lowest point [m]
};

/// Storeys from the lowest one up; a number without bodies gives no storey. Bodies of several neighbouring walls with
/// the same groups form one storey.
template <int D>
std::vector<Storey> find_storeys(const Model<D>& model);

/// Bodies that the structure stands on: the group "base". Without this group, all bodies that are not free to move
/// along any horizontal axis.
template <int D>
std::vector<int> find_base(const Model<D>& model);

/// Number of the storey that a group names ("storey 2"); 0 if none does.
int storey_in(const std::vector<std::string>& groups);

/// Number of the storey that `body` belongs to; 0 if none.
template <int D>
int storey_of(const Model<D>& model, int body);

/// Storey of an object between two bodies: the storey of the body whose first node began higher, otherwise of the other
/// one; 0 if none.
template <int D>
int storey_between(const Model<D>& model, int body_a, int body_b);

/// Mean displacement of the bodies from the start, each body by the mean of its nodes [m]; 0 without bodies.
template <int D>
Vec<D> mean_displacement(const Model<D>& model, const State<D>& state, const std::vector<int>& bodies);

/// Mean displacement of a storey's top relative to the top of the storey below, or to the base [m]. The horizontal
/// components are its drift; the vertical component is its change of height. `index` into `storeys`.
template <int D>
Vec<D> storey_drift(const Model<D>& model, const State<D>& state, const std::vector<Storey>& storeys,
                    const std::vector<int>& base, std::size_t index);

/// Displacement of the topmost storey relative to the base [m]; 0 without storeys.
template <int D>
Vec<D> top_drift(const Model<D>& model, const State<D>& state, const std::vector<Storey>& storeys,
                 const std::vector<int>& base);

/// Horizontal component: in the plane with the sign of x, in space as a length.
double level_part(const Vec2& drift);
double level_part(const Vec3& drift);

/// Rotation of bodies about the vertical axis from the start, counter-clockwise seen from above [rad], -pi to pi. It is
/// the least-squares rotation of the points of their skin.
double mean_twist(const Model<3>& model, const State<3>& state, const std::vector<int>& bodies);

/// Twist of a storey's top relative to the top of the storey below, or to the base [rad], -pi to pi.
double storey_twist(const Model<3>& model, const State<3>& state, const std::vector<Storey>& storeys,
                    const std::vector<int>& base, std::size_t index);

}  // namespace trilith
