#include "draw/palette.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>

namespace trilith::draw {
namespace {

double hex_channel(std::string_view two) {
  int value = 0;
  [[maybe_unused]] const auto end = std::from_chars(two.data(), two.data() + two.size(), value, 16);
  assert(end.ptr == two.data() + two.size());
  return value / 255.0;
}

template <std::size_t N>
Colour along(const std::array<const char*, N>& anchors, double share) {
  const double place = std::clamp(share, 0.0, 1.0) * (N - 1);
  const std::size_t first = std::min(static_cast<std::size_t>(place), N - 2);
  return blend(hex_colour(anchors[first]), hex_colour(anchors[first + 1]), place - static_cast<double>(first));
}

}  // namespace

Colour hex_colour(std::string_view text) {
  assert(text.size() == 7 && text[0] == '#');
  return {hex_channel(text.substr(1, 2)), hex_channel(text.substr(3, 2)), hex_channel(text.substr(5, 2)), 1};
}

Colour blend(const Colour& from, const Colour& to, double share) {
  const double s = std::clamp(share, 0.0, 1.0);
  return {std::lerp(from.red, to.red, s), std::lerp(from.green, to.green, s), std::lerp(from.blue, to.blue, s),
          std::lerp(from.opacity, to.opacity, s)};
}

const Palette& palette() {
  static const Palette one;
  return one;
}

Colour body_tint(std::size_t index) {
  static constexpr std::array<const char*, body_tint_count> tints = {"#d8d3c6", "#a9c3da", "#e3bf8f", "#b9cfb2",
                                                                     "#c9bddb", "#d9a9a0", "#9fb8b8"};
  return hex_colour(tints[index % tints.size()]);
}

Colour series_colour(std::size_t index) {
  static constexpr std::array<const char*, series_colour_count> colours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                                           "#3f464e", "#e69f00", "#56b4e9"};
  return hex_colour(colours[index % colours.size()]);
}

Colour sequential_colour(double share) {
  return along<5>({"#f4f0df", "#bcdac6", "#6db3bd", "#2f7ba5", "#1d3c74"}, share);
}

Colour diverging_colour(double share) {
  return along<5>({"#2a659b", "#a3c3de", "#f6f4ef", "#ebb78c", "#b4541b"}, share);
}

}  // namespace trilith::draw
