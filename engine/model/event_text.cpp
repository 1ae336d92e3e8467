#include "model/event_text.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "base/quantity_text.hpp"

namespace trilith {
namespace {

/// Magnitude of a displacement in a readable unit.
std::string size_text(double metres) {
  const double size = std::abs(metres);
  return size < 0.1 ? fmt::format("{:.3g} mm", 1e3 * size) : fmt::format("{:.3g} m", size);
}

std::string moment_text(double moment) {
  return moment < 1e6 ? fmt::format("{:.3g} kN m", 1e-3 * moment) : fmt::format("{:.3g} MN m", 1e-6 * moment);
}

template <int D>
std::string body_name(const Model<D>& model, int body) {
  return body >= 0 ? model.bodies[body].name : "?";
}

/// Ground, fixed or driven: other bodies hit it, it hits none.
template <int D>
bool stands(const Model<D>& model, int body) {
  return body >= 0 && !model.body_moves(body);
}

/// " in shear at 12 kN", or with another figure where the event has one; without a figure if the net force is 0.
std::string joint_text(const Event& e) {
  const std::string in = fmt::format(" in {}", name_of(e.mode));
  if (!e.text.empty()) return fmt::format("{} at {}", in, e.text);
  return e.value != 0 ? fmt::format("{} at {:.3g} kN", in, 1e-3 * e.value) : in;
}

template <int D>
std::string failed_text(const Event& e, const Model<D>& model, std::string_view what) {
  const std::string name = e.bearing >= 0 ? model.bearings[e.bearing].name : "?";
  const std::string by = e.value != 0 ? " at " + size_text(e.value) : "";
  return fmt::format("bearing {} {}{}", name, what, by);
}

template <int D>
std::string changed_text(const Event& e, const Model<D>& model) {
  const Bearing<D>& b = model.bearings[e.bearing];
  if (b.becomes_bearing >= 0)
    return fmt::format("bearing {} became {}", b.name, model.bearings[b.becomes_bearing].name);
  const std::string how = b.contact_after >= 0 ? " by " + model.law_names[b.contact_after] : "";
  return fmt::format("bearing {} gave way: {} and {} touch{}", b.name, body_name(model, b.body_a),
                     body_name(model, b.body_b), how);
}

/// The compression of an element with zero area is 1.
std::string strain_text(double strain) {
  if (strain <= -1) return "turned inside out";
  return fmt::format("was {} by {:.3g} %", strain < 0 ? "squeezed" : "stretched", 100 * std::abs(strain));
}

/// From "shaking: rest".
std::string ended_text(const std::string& text) {
  const std::size_t at = text.rfind(": ");
  if (at == std::string::npos) return fmt::format("{} ended", text);
  return fmt::format("{} ended ({})", text.substr(0, at), text.substr(at + 2));
}

}  // namespace

template <int D>
std::string event_text(const Event& e, const Model<D>& model) {
  const bool turned =
      e.type != EventType::seat_lost && e.body_b >= 0 && stands(model, e.body_a) && !stands(model, e.body_b);
  const std::string a = body_name(model, turned ? e.body_b : e.body_a);
  const std::string b = body_name(model, turned ? e.body_a : e.body_b);
  switch (e.type) {
    case EventType::stage_begun:
      return fmt::format("{} began", e.text);
    case EventType::stage_ended:
      return ended_text(e.text);
    case EventType::bond_broken:
      return fmt::format("bond of {} and {} broke{}", a, b, joint_text(e));
    case EventType::bond_cracked:
      return fmt::format("bond of {} and {} cracked{}", a, b, joint_text(e));
    case EventType::joint_crushed:
      return fmt::format("joint of {} and {} crushed{}", a, b, joint_text(e));
    case EventType::bearing_yielded:
      return failed_text(e, model, "yielded");
    case EventType::bearing_failed:
      return failed_text(e, model, "failed");
    case EventType::bearing_changed:
      return changed_text(e, model);
    case EventType::member_yielded:
      return fmt::format("{}: {} yielded under {}", a, e.text, moment_text(e.value));
    case EventType::member_failed:
      return fmt::format("{}: {} lost its moment after {:.3g} rad", a, e.text, e.value);
    case EventType::member_removed:
      return fmt::format("{}: {} was removed and let go of {}", a, e.text, quantity_text(e.value, "J"));
    case EventType::contact_made:
      return fmt::format("{} touched {}", a, b);
    case EventType::contact_lost:
      return fmt::format("{} left {}", a, b);
    case EventType::seat_lost:
      return fmt::format("{} lost its seat on {} ({})", a, b, e.text);
    case EventType::impact:
      return fmt::format("{} hit {} at {:.3g} m/s", a, b, e.value);
    case EventType::body_at_rest:
      return fmt::format("{} came to rest", a);
    case EventType::body_left:
      return fmt::format("{} left the bounds at {:.3g} m/s", a, e.value);
    case EventType::body_passed:
      return fmt::format("{} passed into {}: {} deep {}", a, b, size_text(e.value), e.text);
    case EventType::element_overstrained:
      return fmt::format("{} of {} {}", e.text, a, strain_text(e.value));
    case EventType::stage_diverged:
      return fmt::format("diverged, as {}", e.text);
    case EventType::stage_unsettled:
      return fmt::format("did not come to rest: {}", e.text);
    case EventType::integrator_changed:
      return e.text;
    case EventType::body_added:
      return fmt::format("{} was added", a);
    case EventType::body_removed:
      return fmt::format("{} was removed", a);
    case EventType::bearing_added:
    case EventType::bearing_removed:
      return failed_text(e, model, e.type == EventType::bearing_added ? "was added" : "was removed");
  }
  return {};
}

std::optional<EventType> event_type_called(std::string_view name) {
  for (int i = 0; i < event_types; ++i)
    if (event_type_info[static_cast<std::size_t>(i)].name == name) return static_cast<EventType>(i);
  return std::nullopt;
}

template std::string event_text(const Event&, const Model<2>&);
template std::string event_text(const Event&, const Model<3>&);

}  // namespace trilith
