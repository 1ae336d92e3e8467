#include "world/usual.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace trilith {
namespace {

constexpr std::array usual_ranges{
    UsualRange{"mu", "1", 0, 2, "it is the tangent of the friction angle, as in math.tan(35*deg)"},
    UsualRange{"beta", "s", 0, 0.1,
               "no step is as long; it is 2*zeta/omega, with omega = sqrt(kn*area/mass) of a body on its contact"},
    UsualRange{"damping", "s", 0, 0.1, "no step is as long; it is 2*zeta/omega of the vibration to be damped"},
    UsualRange{"E", "Pa", 1e4, unbounded, "is it in GPa or MPa? 30 GPa are 30e9 Pa"},
    UsualRange{"density", "kg/m3", 25, unbounded, "is it in t/m3 or g/cm3? 2.4 t/m3 are 2400 kg/m3"},
    UsualRange{"least side", "m", 0, 40,
               "is it in mm? multiply it by trilith.units \"mm\", or give a file scale = 0.001"},
    UsualRange{"rate", "rad/s", -0.5, 0.5, "is it in degrees? multiply it by trilith.units \"deg\""},
    UsualRange{"by", "rad", 0, 3.2, "is it in degrees? multiply it by trilith.units \"deg\""},
};

std::string with_unit(double value, std::string_view unit) {
  return unit == "1" ? fmt::format("{:g}", value) : fmt::format("{:g} {}", value, unit);
}

}  // namespace

const UsualRange* usual_range(std::string_view name, std::string_view unit) {
  const auto it = std::find_if(usual_ranges.begin(), usual_ranges.end(),
                               [&](const UsualRange& r) { return r.name == name && r.unit == unit; });
  return it == usual_ranges.end() ? nullptr : &*it;
}

std::string doubt(std::string_view name, std::string_view unit, double value) {
  const UsualRange* r = usual_range(name, unit);
  if (r == nullptr || (value >= r->least && value <= r->most) || value == unbounded) return "";
  const bool over = value > r->most;
  return fmt::format("{} = {} is {} the usual {}: {}", name, with_unit(value, unit), over ? "above" : "below",
                     with_unit(over ? r->most : r->least, unit), r->question);
}

std::string usual_text(std::string_view name, std::string_view unit) {
  const UsualRange* r = usual_range(name, unit);
  if (r == nullptr) return "";
  if (r->least == 0) return fmt::format("usually at most {:g}", r->most);
  if (r->most == unbounded) return fmt::format("usually at least {:g}", r->least);
  return fmt::format("usually {:g} to {:g}", r->least, r->most);
}

void add_doubt(std::vector<std::string>& list, const std::string& owner, std::string_view name, std::string_view unit,
               double value) {
  if (const std::string text = doubt(name, unit, value); !text.empty()) list.push_back(owner + ": " + text);
}

void add_doubt_once(std::vector<std::string>& list, const std::string& owner, std::string_view name,
                    std::string_view unit, double value) {
  const UsualRange* r = usual_range(name, unit);
  const auto asks = [&](const std::string& told) { return told.ends_with(r->question); };
  if (r != nullptr && std::none_of(list.begin(), list.end(), asks)) add_doubt(list, owner, name, unit, value);
}

}  // namespace trilith
