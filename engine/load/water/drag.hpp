// Drag of a flow on a body.
//
//     F = c rho A |u - v| (u - v) / 2
//
// u: velocity of the flow times the load curve, v: velocity of the point of action, c: drag coefficient, A: area across
// the flow.
#pragma once

#include <string>
#include <tuple>

#include "load/load_kind.hpp"

namespace trilith {

template <int D>
struct Drag {
  std::string name;
  int body = -1;
  Attachment<D> at;              ///< point of action
  Vec<D> flow = Vec<D>::Zero();  ///< [m/s]
  double coefficient = 0;        ///< [1]
  double area = 0;               ///< [m2]
  double density = 1000;         ///< [kg/m3]
  LoadCurve curve;

  static constexpr std::string_view kind = "drag", sentence = "drag of a flow on a body";
  static constexpr bool in_space = true, is_water = true;
  static constexpr auto members() {
    using L = Drag;
    return std::tuple(&L::name, &L::body, &L::at, &L::flow, &L::coefficient, &L::area, &L::density, &L::curve);
  }
  void scale(double factor) { density *= factor; }
  [[nodiscard]] static constexpr int parts() { return 1; }
  [[nodiscard]] int body_of(int /*part*/) const { return body; }
  template <class See>
  void visit(int /*part*/, See&& see) const {
    see(at);
  }
  template <class Target>
  void apply(Target& on, int /*part*/) const {
    const Vec<D> past = curve.at(on.time()) * flow - on.velocity_of(at);
    on.push(at, 0.5 * coefficient * density * area * past.norm() * past, nothing<Moment<D>>());
  }
};

}  // namespace trilith
