#include "run/event_text.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace trilith {
namespace {

/// A length in the unit one reads it in.
std::string length_text(double metres) {
  const double size = std::abs(metres);
  if (size < 0.1) return fmt::format("{:.3g} mm", 1e3 * metres);
  return fmt::format("{:.3g} m", metres);
}

std::string body_name(const Model<2>& model, int body) {
  return body >= 0 ? model.bodies[body].name : "?";
}

std::string failed_text(const Event& e, const Model<2>& model, std::string_view what) {
  const std::string name = e.bearing >= 0 ? model.bearings[e.bearing].name : "?";
  const std::string by = e.value != 0 ? ", " + length_text(e.value) : "";
  return fmt::format("bearing {} {}{}", name, what, by);
}

std::string changed_text(const Event& e, const Model<2>& model) {
  const Bearing<2>& b = model.bearings[e.bearing];
  if (b.becomes_bearing >= 0)
    return fmt::format("bearing {} became {}", b.name, model.bearings[b.becomes_bearing].name);
  const std::string how = b.contact_after >= 0 ? " by " + model.law_names[b.contact_after] : "";
  return fmt::format("bearing {} gave way: {} and {} touch{}", b.name, body_name(model, b.body_a),
                     body_name(model, b.body_b), how);
}

}  // namespace

std::string event_text(const Event& e, const Model<2>& model) {
  const std::string a = body_name(model, e.body_a), b = body_name(model, e.body_b);
  switch (e.type) {
    case EventType::stage_begun:
      return fmt::format("{} began", e.text);
    case EventType::stage_ended:
      return fmt::format("{}", e.text);
    case EventType::bond_broken:
      return fmt::format("bond of {} and {} broke", a, b);
    case EventType::bearing_yielded:
      return failed_text(e, model, "yielded");
    case EventType::bearing_failed:
      return failed_text(e, model, "failed");
    case EventType::bearing_changed:
      return changed_text(e, model);
    case EventType::contact_made:
      return fmt::format("{} touched {}", a, b);
    case EventType::contact_lost:
      return fmt::format("{} left {}", a, b);
    case EventType::seat_lost:
      return fmt::format("{} lost its seat {} on {}", a, e.text, b);
    case EventType::impact:
      return fmt::format("{} hit {} at {:.3g} m/s", a, b, e.value);
    case EventType::body_at_rest:
      return fmt::format("{} came to rest", a);
  }
  return {};
}

std::string_view event_heading(EventType type) {
  constexpr std::array<std::string_view, event_types> headings = {
      "stage begun",  "stage ended",  "bond broken", "bearing yielded", "bearing failed", "bearing changed",
      "contact made", "contact lost", "seat lost",   "impact",          "body at rest"};
  return headings[static_cast<std::size_t>(type)];
}

bool is_important(EventType type) {
  return type != EventType::contact_made && type != EventType::contact_lost && type != EventType::body_at_rest;
}

}  // namespace trilith
