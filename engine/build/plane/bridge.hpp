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
