// Arches of voussoirs with radial joints: semicircular, segmental and pointed, and the abutments they spring from.
#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "build/builder_keys.hpp"
#include "build/plane/part.hpp"

namespace trilith {

/// An arch of one circle, or a pointed arch of two circles with centres on one level.
struct Arch {
  std::string name = {};
  int voussoirs = 15;                        ///< 1 to 10000
  double radius = 1;                         ///< of the line midway between intrados and extrados [m]
  double thickness = 0.15;                   ///< [m], below twice the radius
  double half_angle = std::numbers::pi / 2;  ///< from the vertical through a circle's centre to a springing [rad],
                                             ///< above 0, at most pi/2 (semicircle, or pointed arch with level
                                             ///< springings)
  double offset = 0;  ///< distance of the centre of each side's circle beyond the middle, on the other side [m], not
                      ///< below 0; above 0 the arch is pointed: radius/2 makes its mid line equilateral
  double key = 1;     ///< width of the middle voussoir of an odd number over the width of the others, above 0
  int sub_edges = 1;  ///< straight edges per voussoir and side, 1 to 1000; 1: straight-sided voussoirs
  Vec2 centre = Vec2::Zero();  ///< of the circle; of a pointed arch: midway between the centres [m]
  bool abutments = true;       ///< with a block behind each springing
  double abutment_depth = 0;   ///< of the abutments, away from the arch [m]; 0: the thickness
  /// By which the abutments extend beyond intrados and extrados in the plane of the springing joint [m], not below 0
  /// and below the inner radius. If absent: half of the thickness or of the inner radius, whichever is less.
  std::optional<double> abutment_margin = std::nullopt;
  double jitter = 0;  ///< every joint between voussoirs, except at a pointed crown, is moved along the mid
                      ///< line by up to this distance [m], below a quarter of a voussoir
  int seed = 1;       ///< seed of the jitter: the same number gives the same bits everywhere
  std::optional<double> span = std::nullopt, rise = std::nullopt;  ///< clear ones [m], above 0, instead of radius,
                                                                   ///< half_angle and offset: see with_span_and_rise

  static constexpr std::string_view kind = "arch";
  static constexpr std::string_view sentence = "an arch of voussoirs: semicircular, segmental or pointed";
  static constexpr bool is_single = false;
  static constexpr auto keys() {
    using K = KeysOf<Arch>;
    return std::tuple(
        K::Count{&Arch::voussoirs, "voussoirs", "number of voussoirs", 1, 10000},
        K::Number{&Arch::radius, "radius", "m", "radius of the centre line", above_zero},
        K::Number{&Arch::thickness, "thickness", "m", "thickness of the ring", above_zero},
        K::Number{&Arch::half_angle, "half_angle", "rad", "half of the opening angle", above_zero, {"pi/2"}},
        K::Number{&Arch::offset, "offset", "m", "offset of the two centres of a pointed arch", not_below_zero},
        K::MaybeNumber{&Arch::span, "span", "m", "instead of radius: clear span, with rise", above_zero},
        K::MaybeNumber{&Arch::rise, "rise", "m", "clear rise, with span", above_zero}, Together{"span", "rise"},
        Instead{"span", {"radius", "half_angle", "offset"}, "span and rise", "radius, half_angle and offset"},
        K::Number{&Arch::key, "key", "1", "width of the keystone over the width of the others", above_zero},
        K::Count{&Arch::sub_edges, "sub_edges", "number of edges of each curved side", 1, 1000},
        K::Point{&Arch::centre, "centre", "centre of the circle"},
        K::Flag{&Arch::abutments, "abutments", "make abutments"},
        K::Number{
            &Arch::abutment_depth, "abutment_depth", "m", "depth of the abutments", any_number, {"the thickness"}},
        K::MaybeNumber{&Arch::abutment_margin, "abutment_margin", "m",
                       "width of the abutments beyond the ring; half the thickness if left out", not_below_zero},
        K::Number{&Arch::jitter, "jitter", "m", "largest random shift of joints", not_below_zero},
        K::Count{&Arch::seed, "seed", "of the random numbers"});
  }
  /// build_arch.
  [[nodiscard]] std::vector<Part> parts() const;
};

/// Keys of the arch that is the profile of a vault: the keys of an arch in the plane without its position and jitter.
struct ProfileKeys {
  static constexpr auto keys() {
    using K = KeysOf<Arch>;
    return std::tuple(
        K::Count{&Arch::voussoirs, "voussoirs", "number of voussoirs of the arch", 1, 10000},
        K::Number{&Arch::radius, "radius", "m", "radius of the centre line", above_zero},
        K::Number{&Arch::thickness, "thickness", "m", "thickness of the ring", above_zero},
        K::Number{&Arch::half_angle, "half_angle", "rad", "half of the opening angle", above_zero, {"pi/2"}},
        K::Number{&Arch::offset, "offset", "m", "offset of the two centres of a pointed arch", not_below_zero},
        K::MaybeNumber{&Arch::span, "span", "m", "instead of radius: clear span, with rise", above_zero},
        K::MaybeNumber{&Arch::rise, "rise", "m", "clear rise, with span", above_zero}, Together{"span", "rise"},
        Instead{"span", {"radius", "half_angle", "offset"}, "span and rise", "radius, half_angle and offset"},
        K::Flag{&Arch::abutments, "abutments", "make abutments; not for cross vaults"},
        K::Number{
            &Arch::abutment_depth, "abutment_depth", "m", "depth of the abutments", any_number, {"the thickness"}},
        K::MaybeNumber{&Arch::abutment_margin, "abutment_margin", "m",
                       "width of the abutments beyond the ring; half the thickness if left out", not_below_zero});
  }
};

/// Sets radius, half angle and offset for a clear span and rise of the intrados [m]. The arch is segmental for a rise
/// below half of the span, a semicircle for equality, and pointed with level springings above. The thickness must be
/// set. Throws InputError for sizes that are not above 0.
void set_span_and_rise(Arch& arch, double span, double rise);

/// The arch that `span` and `rise` give; the same arch where they are absent.
Arch with_span_and_rise(Arch arch);

/// Parts "v1" (left) to "vn" (right), group "voussoirs", the middle one of an odd number also in group "key", and
/// "left" and "right", group "abutments". Neighbouring voussoirs share the two corners of their joint to the bit. The
/// arch is its own mirror image to the bit if its centre is at x = 0 and nothing is jittered. All corners lie on the
/// circles, equally spaced along the mid line. Without key or offset, and with k sub-edges, the area of a voussoir is
/// the curved area times sin(d)/d, d = 2 half_angle/(n k), so 1 - d^2/6.
///
/// The crown of a pointed arch of an even number is a vertical joint; for an odd number the middle voussoir has
/// sub_edges on either side of the crown. Faces i of any other outline: 0 .. k-1 intrados from left to right, k right
/// joint, k+1 .. 2k extrados from right to left, 2k+1 left joint. Without a margin an abutment shares the corners of
/// the springing joint to the bit. With a margin its face is one straight edge through them, to rounding. Throws
/// InputError for numbers out of range.
std::vector<Part> build_arch(const Arch& arch);

/// The arch as the profile of a larger structure: names of parts do not contain the name of the arch, and `owner`
/// begins messages.
std::vector<Part> build_profile(Arch arch, std::string_view owner);

}  // namespace trilith
