// Colours of all pictures: light tints for bodies, strong colours for marks and lines.
#pragma once

#include <cstddef>
#include <string_view>

namespace trilith::draw {

/// Red, green, blue and opacity, each 0 to 1.
struct Colour {
  double red = 0, green = 0, blue = 0, opacity = 1;
};

/// Colour from "#rrggbb" (asserts on any other form; used for internal tables only).
Colour hex_colour(std::string_view text);

/// `from` at share 0, `to` at share 1, linear in between; share is limited to 0 to 1.
Colour blend(const Colour& from, const Colour& to, double share);

/// Fixed colours of paper, text, axes, ground and marks. The strong ones remain distinguishable with red-green and
/// blue-yellow blindness (after Okabe and Ito, 2008), and every mark differs in shape too.
struct Palette {
  Colour paper = hex_colour("#ffffff");
  Colour ink = hex_colour("#22262b");
  Colour quiet_ink = hex_colour("#5d646c");
  Colour axis = hex_colour("#9aa1a9");
  Colour grid = hex_colour("#e7e9ec");
  Colour zero_line = hex_colour("#c3c8ce");
  Colour outline = hex_colour("#3b4149");
  Colour ground = hex_colour("#f1efe9");
  Colour ground_hatch = hex_colour("#c9c4b6");
  Colour ground_outline = hex_colour("#8b8575");
  Colour no_value = hex_colour("#dddddd");
  Colour ghost = hex_colour("#8d949c");
  Colour force = hex_colour("#0b5fa5");
  Colour intact = hex_colour("#22262b");
  Colour yielded = hex_colour("#e69f00");
  Colour failed = hex_colour("#d03a00");
  Colour changed = hex_colour("#9c4f96");
  Colour opened = hex_colour("#d03a00");
  Colour slid = hex_colour("#0072b2");
  Colour thrust = hex_colour("#9c4f96");
  Colour event = hex_colour("#6b7178");
};

/// The one palette.
const Palette& palette();

/// Fill of the n-th group of bodies; repeats after `body_tint_count`.
Colour body_tint(std::size_t index);
inline constexpr std::size_t body_tint_count = 7;

/// Line colour of the n-th series; repeats after `series_colour_count`.
Colour series_colour(std::size_t index);
inline constexpr std::size_t series_colour_count = 7;

/// Colour of a value from zero (share 0, pale) to the largest (share 1, dark); lightness decreases throughout.
Colour sequential_colour(double share);

/// Colour of a signed value: share 0 deep blue, 0.5 near white, 1 deep orange.
Colour diverging_colour(double share);

}  // namespace trilith::draw
