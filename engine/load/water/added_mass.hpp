// Mass of water that moves with a body, and resists its acceleration along one direction at each point.
//
//     f_i = -m_i n_i (n_i . a_i)
//
// a_i: acceleration of the point, n_i: its direction, which rotates with the body, m_i: mass. The forces follow from
// the accelerations of the step (assembly/water/water_mass.hpp), so `apply` adds nothing.
#pragma once

#include <string>
#include <tuple>
#include <vector>

#include "load/load_kind.hpp"

namespace trilith {

/// A mass at an attached point.
template <int D>
struct MassPoint {
  Attachment<D> at;
  Vec<D> along = Vec<D>::UnitX();  ///< unit vector in the axes of the attached point
  double mass = 0;                 ///< [kg]

  static constexpr auto members() { return std::tuple(&MassPoint::at, &MassPoint::along, &MassPoint::mass); }
};

template <int D>
struct AddedMass {
  std::string name;
  int body = -1;
  std::vector<MassPoint<D>> points;
  LoadCurve curve;  ///< without points

  static constexpr std::string_view kind = "added_mass", sentence = "mass of water that moves with a body";
  static constexpr bool in_space = true, is_water = true, is_inertia = true;
  static constexpr auto members() {
    using L = AddedMass;
    return std::tuple(&L::name, &L::body, &L::points, &L::curve);
  }
  void scale(double /*factor*/) {}
  [[nodiscard]] int parts() const { return static_cast<int>(points.size()); }
  [[nodiscard]] int body_of(int /*part*/) const { return body; }
  template <class See>
  void visit(int part, See&& see) const {
    see(points[static_cast<std::size_t>(part)].at);
  }
  template <class Target>
  void apply(Target& /*on*/, int /*part*/) const {}
};

}  // namespace trilith
