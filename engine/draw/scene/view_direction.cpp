#include "draw/scene/view_direction.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/error.hpp"
#include "base/nearest.hpp"

namespace trilith::draw {
namespace {

constexpr std::array<std::pair<const char*, ViewDirection>, 6> named_views = {
    {{"front", {-90, 0}}, {"back", {90, 0}}, {"left", {180, 0}}, {"right", {0, 0}}, {"top", {-90, 90}}, {"iso", {}}}};

bool read_degrees(std::string_view text, double& out) {
  const auto end = std::from_chars(text.data(), text.data() + text.size(), out);
  return end.ec == std::errc{} && end.ptr == text.data() + text.size() && std::isfinite(out);
}

}  // namespace

const std::vector<std::string>& view_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> out;
    for (const auto& [name, from] : named_views) out.emplace_back(name);
    return out;
  }();
  return names;
}

ViewDirection view_direction(std::string_view text) {
  for (const auto& [name, from] : named_views)
    if (text == name) return from;
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos)
    throw InputError(fmt::format("there is no view '{}'{}; or give AZIMUTH,ELEVATION in degrees", text,
                                 name_hint(text, view_names())));
  ViewDirection out;
  if (!read_degrees(text.substr(0, comma), out.azimuth) || !read_degrees(text.substr(comma + 1), out.elevation) ||
      std::abs(out.azimuth) > 360 || std::abs(out.elevation) > 90)
    throw InputError(
        fmt::format("view '{}' must be an azimuth of -360 to 360 and an elevation of -90 to 90, in degrees", text));
  return out;
}

ViewAxes::ViewAxes(const ViewDirection& from) {
  const double azimuth = from.azimuth * std::numbers::pi / 180, elevation = from.elevation * std::numbers::pi / 180;
  const Turn around(azimuth), above(elevation);
  toward = {above.c * around.c, above.c * around.s, above.s};
  right = {-around.s, around.c, 0};
  up = cross(toward, right);
}

}  // namespace trilith::draw
