#include "model/event/event_text.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cmath>

#include "base/quantity_text.hpp"
#include "model/event/event_list.hpp"

namespace trilith {
namespace {

/// A smaller displacement is rounding noise [m].
constexpr double least_displacement = 1e-9;

/// Magnitude of a displacement in a readable unit.
std::string size_text(double metres) {
  const double size = std::abs(metres);
  if (size < least_displacement) return "0 mm";
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

/// "became b" or "was replaced: ...".
template <int D>
std::string becomes_text(const Event& e, const Model<D>& model) {
  const Bearing<D>& b = model.bearings[e.bearing];
  if (b.becomes_bearing >= 0) return fmt::format("became {}", model.bearings[b.becomes_bearing].name);
  const std::string how = b.contact_after >= 0 ? " by " + model.law_names[b.contact_after] : "";
  return fmt::format("was replaced: {} and {} touch{}", body_name(model, b.body_a), body_name(model, b.body_b), how);
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

/// True for a value that says something: not 0, and no displacement of rounding noise.
bool has_value(const Event& e) {
  return std::abs(e.value) >= (info_of(e.type).value.unit == "m" ? least_displacement : 0) && e.value != 0;
}

std::string value_text(const Event& e) {
  const std::string_view unit = info_of(e.type).value.unit;
  if (unit == "m") return size_text(e.value);
  if (unit == "N m") return moment_text(e.value);
  if (unit == "J") return quantity_text(e.value, unit);
  return fmt::format("{:.3g}{}{}", e.value, unit == "1" ? "" : " ", unit == "1" ? "" : unit);
}

/// Text of `word` of event_words.
template <int D>
std::string word_text(std::string_view word, const Event& e, const Model<D>& model) {
  const bool turned = e.body_b >= 0 && stands(model, e.body_a) && !stands(model, e.body_b);
  if (word == "a") return body_name(model, turned ? e.body_b : e.body_a);
  if (word == "b") return body_name(model, turned ? e.body_a : e.body_b);
  if (word == "body_a") return body_name(model, e.body_a);
  if (word == "body_b") return body_name(model, e.body_b);
  if (word == "bearing") return e.bearing >= 0 ? model.bearings[e.bearing].name : "?";
  if (word == "text") return e.text;
  if (word == "value") return value_text(e);
  if (word == "at") return has_value(e) ? " at " + value_text(e) : "";
  if (word == "mode") return joint_text(e);
  if (word == "becomes") return becomes_text(e, model);
  if (word == "strain") return strain_text(e.value);
  assert(word == "ended");
  return ended_text(e.text);
}

}  // namespace

template <int D>
std::string event_text(const Event& e, const Model<D>& model) {
  std::string_view rest = info_of(e.type).sentence;
  std::string out;
  for (std::size_t at = rest.find('{'); at != std::string_view::npos; at = rest.find('{')) {
    const std::size_t end = rest.find('}', at);
    out += rest.substr(0, at);
    out += word_text(rest.substr(at + 1, end - at - 1), e, model);
    rest.remove_prefix(end + 1);
  }
  return out += rest;
}

template std::string event_text(const Event&, const Model<2>&);
template std::string event_text(const Event&, const Model<3>&);

}  // namespace trilith
