// The law of a plastic hinge: moment as a function of plastic rotation, and its reduction by a normal force.
//
// With the plastic rotation p (positive: the bottom lengthens), the largest |p| so far r and the share c left by N:
//
//     D (X - (hogging + Hi r) c) <= M <= D (X + (sagging + Hi r) c),   X = Hk p,   Hk + Hi = hardening.
//
// Beyond |p| = `capping` X and Hi r stay constant, and D falls linearly from 1 to `residual` over `softening`. D is
// further reduced linearly with the dissipated energy, down to `residual` once that is `wear` times the sagging moment.
// Beyond `ultimate` the hinge has lost its moment permanently; if it `removes`, its beam is then removed. The backbone
// with a cap and the reduction by energy follow Ibarra, Medina and Krawinkler, Earthquake Eng. Struct. Dyn. 34, 2005,
// without their pinching and loss of stiffness.
//
// The share c of the moment at a normal force N is c = 1 - |N/Np|^exponent (2: a rectangle, Neal, "The plastic methods
// of structural analysis", 1956), with Np in tension and compression. Alternatively it is given by points: a concave
// line, 0 at both of its ends. Flow is associated: plastic stretch dp_u = -(dc/dN) D (sagging + Hi r) |dp|. Rotation to
// either side wears and softens the hinge as a whole.
//
// In space both moments act together, see element/beam/end_hinge_3d.hpp; for bending about z alone it is this law.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/portable.hpp"
#include "base/schema.hpp"

namespace trilith {

/// Share c of the moment at a normal force, and its derivatives by the force.
struct AxialShare {
  double share = 1;  ///< [1]
  double slope = 0;  ///< [1/N]
  double bend = 0;   ///< [1/N2]
};

struct HingeLaw {
  double sagging = 0;                          ///< [N m]
  double hogging = 0;                          ///< [N m]
  double hardening = 0;                        ///< [N m/rad]
  double isotropic = 0;                        ///< [1]
  double capping = 0;                          ///< [rad]
  double softening = 0;                        ///< [rad]
  double residual = 0;                         ///< [1]
  double ultimate = 0;                         ///< [rad]
  double wear = 0;                             ///< [rad]
  double tension = 0;                          ///< [N]
  double compression = 0;                      ///< [N]
  double exponent = 2;                         ///< [1]
  double across = 0;                           ///< in space: sagging moment about the other axis of the section [N m]
  double contour = 2;                          ///< in space [1]
  std::vector<double> force = {}, share = {};  ///< points of c, N increasing [N], [1]; empty: uses the exponent
  bool removes = false;                        ///< the beam carries nothing once this hinge has lost its moment

  static constexpr std::string_view name = "end_hinge";
  static constexpr std::string_view sentence = "plastic hinge at the end of a beam";
  static constexpr auto parameters() {
    using P = Parameter<HingeLaw>;
    return std::array{
        P{&HingeLaw::sagging, "sagging", "N m", no_default, 0, unbounded, false,
          "yield moment with the bottom in tension"},
        P{&HingeLaw::hogging, "hogging", "N m", 0, 0, unbounded, true,
          "yield moment with the top in tension; 0: as sagging"},
        P{&HingeLaw::hardening, "hardening", "N m/rad", 0, 0, unbounded, true, "moment gained per plastic rotation"},
        P{&HingeLaw::isotropic, "isotropic", "1", 0, 0, 1, true, "share of isotropic hardening; the rest is kinematic"},
        P{&HingeLaw::capping, "capping", "rad", 0, 0, unbounded, true,
          "plastic rotation from which it softens; 0: never"},
        P{&HingeLaw::softening, "softening", "rad", 0, 0, unbounded, true, "further rotation to the residual moment"},
        P{&HingeLaw::residual, "residual", "1", 0, 0, 1, true,
          "residual share of the moment after softening and degradation"},
        P{&HingeLaw::ultimate, "ultimate", "rad", 0, 0, unbounded, true,
          "plastic rotation beyond which the moment is 0; 0: never"},
        P{&HingeLaw::wear, "wear", "rad", 0, 0, unbounded, true,
          "dissipated energy at the residual moment, over the sagging moment; 0: no degradation"},
        P{&HingeLaw::tension, "tension", "N", 0, 0, unbounded, true,
          "normal force at yield in tension; 0: no interaction"},
        P{&HingeLaw::compression, "compression", "N", 0, 0, unbounded, true,
          "normal force at yield in compression; 0: as tension"},
        P{&HingeLaw::exponent, "exponent", "1", 2, 1, 10, true, "exponent of the normal force in the interaction"},
        P{&HingeLaw::across, "across", "N m", 0, 0, unbounded, true,
          "needed in space: yield moment of lateral bending, about the section's y axis"},
        P{&HingeLaw::contour, "contour", "1", 2, 1.1, 2, true,
          "in space: exponent of both moments in the interaction; 2 round, 1.7 rectangle or I, 1.2 to 1.5 concrete"}};
  }
  static HingeLaw sample() {
    HingeLaw law;
    law.sagging = 1e5, law.exponent = 2;
    return law;
  }
  /// For an end that never yields.
  static HingeLaw never() {
    HingeLaw law;
    law.sagging = unbounded;
    return law;
  }
  /// Throws InputError where the parameters are inconsistent.
  void check() const;

  [[nodiscard]] double yield(int way) const { return way < 0 && hogging > 0 ? hogging : sagging; }
  /// Plastic rotation where hardening ends [rad].
  [[nodiscard]] double cap() const { return capping > 0 ? capping : unbounded; }
  [[nodiscard]] double moving() const { return (1 - isotropic) * hardening; }
  /// X at p [N m] and its stored energy [J], before D.
  [[nodiscard]] double back(double p) const { return moving() * std::clamp(p, -cap(), cap()); }
  [[nodiscard]] double stored(double p) const {
    const double linear = std::min(std::abs(p), cap());
    return moving() * linear * (std::abs(p) - 0.5 * linear);
  }
  /// Elastic range to one side without normal force, before D [N m].
  [[nodiscard]] double width(int way, double reach) const {
    return yield(way) + isotropic * hardening * std::min(reach, cap());
  }
  /// D due to rotation, and due to energy [1].
  [[nodiscard]] double kept(double reach) const {
    if (reach <= cap()) return 1;
    return std::max(residual, 1 - (1 - residual) * (reach - capping) / softening);
  }
  [[nodiscard]] double worn(double dissipated) const {
    return wear > 0 ? std::max(residual, 1 - (1 - residual) * dissipated / (wear * sagging)) : 1.0;
  }

  [[nodiscard]] bool has_axial() const { return tension > 0 || !force.empty(); }
  [[nodiscard]] double most_normal() const { return force.empty() ? tension : force.back(); }
  [[nodiscard]] double least_normal() const {
    return force.empty() ? -(compression > 0 ? compression : tension) : force.front();
  }
  /// For N from least_normal() to most_normal(); at a corner the side away from 0.
  [[nodiscard]] AxialShare beside(double normal) const;
};

/// Throws InputError where `law` softens faster than the beam's stiffness in uniform bending, 2 EI/L [N m]: no static
/// path could follow it.
void check_softening(const HingeLaw& law, double even_bending);

}  // namespace trilith
