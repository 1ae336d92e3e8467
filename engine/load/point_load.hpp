// A force and a moment at a point of a body.
#pragma once

#include <string>
#include <tuple>

#include "base/rotation_3d.hpp"
#include "load/load_kind.hpp"

namespace trilith {

/// A force and a moment at a point of a body, times their load curve.
template <int D>
struct PointLoad {
  std::string name;
  int body = -1;
  Attachment<D> at;                         ///< point of action
  Vec<D> force = Vec<D>::Zero();            ///< [N]
  Moment<D> moment = nothing<Moment<D>>();  ///< [N m]
  bool follows = false;                     ///< rotates with the point; given for its initial orientation
  LoadCurve curve;

  static constexpr std::string_view kind = "load";
  static constexpr std::string_view sentence = "a force and a moment at a point of a body";
  static constexpr bool in_space = true;
  static constexpr auto members() {
    using L = PointLoad;
    return std::tuple(&L::name, &L::body, &L::at, &L::force, &L::moment, &L::follows, &L::curve);
  }
  void scale(double factor) { force *= factor, moment *= factor; }
  [[nodiscard]] static constexpr int parts() { return 1; }
  [[nodiscard]] int body_of(int /*part*/) const { return body; }
  template <class See>
  void visit(int /*part*/, See&& see) const {
    see(at);
  }
  /// A following load rotates with its attachment, in space its moment too.
  template <class Target>
  void apply(Target& on, int /*part*/) const {
    const double share = curve.at(on.time());
    if (share == 0) return;
    if (!follows) {
      on.push(at, share * force, share * moment);
      return;
    }
    const auto turn = on.turn_of(at);
    if constexpr (D == 2)
      on.push(at, share * turn.apply(force), share * moment);
    else
      on.push(at, share * turn.apply(force), share * turn.apply(moment));
  }
};

}  // namespace trilith
