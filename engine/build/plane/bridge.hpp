// The rigid pieces of a simple-span bridge seen from the side: piers, abutments and spans.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "build/builder_keys.hpp"
#include "build/plane/part.hpp"

namespace trilith {

/// A pier of footing, stem and head, one rigid body symmetric about its middle line.
struct Pier {
  std::string name = "pier";
  double x = 0;                  ///< middle line [m]
  double ground_level = 0;       ///< y of the footing's underside [m]
  double height = 0;             ///< from there to the seat [m]
  double stem_width = 0;         ///< [m]
  double top_width = 0;          ///< of the seat [m]; 0: the stem's
  double cap_thickness = 0;      ///< height of the cap [m]; 0: no cap, the stem tapers evenly to the top width
  double footing_width = 0;      ///< [m]; 0: no footing
  double footing_thickness = 0;  ///< [m], above 0 where there is a footing
  double seat = 0;  ///< length of each of its two seats [m], with `gap`: the top contains both seats and the joint, and
                    ///< is the stem's width too if that is not given. 0: determined by the widths
  std::optional<double> gap = std::nullopt;  ///< joint between the decks on it [m]; none: the spans determine it

  static constexpr std::string_view kind = "pier";
  static constexpr std::string_view sentence = "a pier of footing, stem and cap";
  static constexpr bool is_single = true;
  static constexpr auto keys() {
    using K = KeysOf<Pier>;
    return std::tuple(
        K::Number{&Pier::x, "station", "m", "position of the axis along the bridge", any_number, must_be_given},
        K::Number{&Pier::ground_level, "ground_level", "m", "top of the ground"},
        K::Number{&Pier::height, "height", "m", "height above the ground", above_zero, must_be_given},
        K::Number{&Pier::stem_width,
                  "stem_width",
                  "m",
                  "width of the stem; not needed with seat and gap",
                  not_below_zero,
                  {"the top's"}},
        K::Number{&Pier::top_width, "top_width", "m", "width of the cap", not_below_zero, {"the stem's"}},
        K::Number{&Pier::cap_thickness, "cap_thickness", "m", "thickness of the cap", not_below_zero},
        K::Number{&Pier::footing_width, "footing_width", "m", "width of the footing", not_below_zero},
        K::Number{&Pier::footing_thickness, "footing_thickness", "m", "thickness of the footing", not_below_zero},
        K::Number{&Pier::seat,
                  "seat",
                  "m",
                  "length of each of the two seats; the top is as wide as both and the joint",
                  not_below_zero,
                  {"from the widths"}},
        K::MaybeNumber{&Pier::gap, "gap", "m", "joint between the two decks on the pier", not_below_zero},
        OneOf{"stem_width", "seat", "a number in m, or seat and gap"});
  }
  /// build_pier.
  [[nodiscard]] std::vector<Part> parts() const;
};

/// The pier with the widths that follow from `seat` and `gap`. Throws InputError if only one of them is usable, if the
/// top width is given too, and if the joint leaves no seat.
Pier with_seats(const Pier& pier);

/// One part, group "piers". The outline begins at the lower left corner of the footing, or of the stem without a
/// footing. Throws InputError for sizes not above 0, a footing narrower than the stem, a height that leaves no stem,
/// and as with_seats() does.
Part build_pier(const Pier& pier);

/// Side of the bridge at which an abutment stands.
enum class AbutmentSide { left, right };

/// A stub abutment: a block whose seat carries the end of a span, with or without a back wall behind the end of the
/// deck.
struct Abutment {
  std::string name = "abutment";
  AbutmentSide side = AbutmentSide::left;
  double x = 0;                               ///< of the front face, towards the span [m]; or `axis`
  double ground_level = 0;                    ///< y of the underside [m]
  double height = 0;                          ///< from there to the seat [m]
  double width = 0;                           ///< from the front face away from the bridge [m]
  double back_wall_height = 0;                ///< above the seat [m]; 0: no back wall
  double back_wall_width = 0;                 ///< [m], below `width`: seat and joint are as long as the rest
  std::optional<double> axis = std::nullopt;  ///< middle of the joint between deck and back wall [m], instead of `x`
  double seat = 0;                            ///< length of the seat [m], with `gap`, instead of the back wall's width
  std::optional<double> gap = std::nullopt;   ///< joint between deck and back wall [m]; none: the span determines it

  static constexpr std::string_view kind = "abutment";
  static constexpr std::string_view sentence = "a stub abutment with a back wall";
  static constexpr bool is_single = true;
  static constexpr auto keys() {
    using K = KeysOf<Abutment>;
    return std::tuple(
        K::Choice<AbutmentSide, 2>{&Abutment::side, "side", "end of the bridge", {"left", "right"}},
        K::Number{&Abutment::x, "x", "m", "edge of the seat; or station", any_number, {"from station"}},
        K::MaybeNumber{&Abutment::axis, "station", "m",
                       "middle of the joint between deck and back wall; needs seat and gap"},
        OneOf{"x", "station", "a number in m, the edge of the seat, or station",
              ": the edge of the seat, or the position of the axis"},
        K::Number{&Abutment::ground_level, "ground_level", "m", "bottom of the abutment"},
        K::Number{&Abutment::height, "height", "m", "height of the seat above the bottom", above_zero, must_be_given},
        K::Number{&Abutment::width, "width", "m", "total width", above_zero, must_be_given},
        K::Number{&Abutment::back_wall_height, "back_wall_height", "m", "height of the back wall above the seat",
                  not_below_zero},
        K::Number{&Abutment::back_wall_width,
                  "back_wall_width",
                  "m",
                  "width of the back wall; or seat and gap",
                  not_below_zero,
                  {"from seat and gap"}},
        K::Number{
            &Abutment::seat, "seat", "m", "length of the seat under the deck", not_below_zero, {"from the widths"}},
        K::MaybeNumber{&Abutment::gap, "gap", "m", "joint between deck and back wall", not_below_zero});
  }
  /// build_abutment.
  [[nodiscard]] std::vector<Part> parts() const;
};

/// The abutment with the front face and the back wall width that follow from `axis`, `seat` and `gap`. Throws
/// InputError if one of them is missing, if the wall's width is given too, and if no width remains for the wall.
Abutment with_seats(const Abutment& abutment);

/// One part, group "abutments": a rectangle or an L whose seat lies at the front. Left and right are mirror images.
/// Throws InputError for sizes not above 0 or a back wall that leaves no seat, and as with_seats() does.
Part build_abutment(const Abutment& abutment);

/// A deck between two supports.
struct Span {
  std::string name = "span";
  double x0 = 0, x1 = 0;    ///< left and right end of the opening that it fills [m]
  double end_gap = 0;       ///< clearance at each of the two ends [m]: half of the joint between two decks
  double soffit_level = 0;  ///< y of the underside [m]
  double depth = 0;         ///< [m]

  static constexpr std::string_view kind = "span";
  static constexpr std::string_view sentence = "a deck between two places";
  static constexpr bool is_single = true;
  static constexpr auto keys() {
    using K = KeysOf<Span>;
    return std::tuple(K::Number{&Span::x0, "x0", "m", "axis of the left support", any_number, must_be_given},
                      K::Number{&Span::x1, "x1", "m", "axis of the right support", any_number, must_be_given},
                      K::Number{&Span::end_gap, "end_gap", "m", "from the axis to its end", not_below_zero},
                      K::Number{&Span::soffit_level, "soffit_level", "m", "its underside", any_number, must_be_given},
                      K::Number{&Span::depth, "depth", "m", "its height", above_zero, must_be_given});
  }
  /// The single part of build_span.
  [[nodiscard]] std::vector<Part> parts() const;
};

/// One rectangle, group "spans", from x0 + end_gap to x1 - end_gap. Throws InputError if no length remains or the depth
/// is not above 0.
Part build_span(const Span& span);

}  // namespace trilith
