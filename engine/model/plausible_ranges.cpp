#include "model/plausible_ranges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace trilith {
namespace {

// Each bound lies far outside of the values of real structures, so that a note means a wrong unit.
// - mu: rough rock joints reach about 1 (Barton and Choubey 1977).
// - kn and ks: mortar joints have 1 to 500 N/mm3 (Lourenco 1996). Dry joints of small tests have 0.01 N/mm3.
// - tension and cohesion: mortar joints have 0.01 to 1 MPa (van der Pluijm 1999), rock has up to 50 MPa.
// - strength and yield in Pa: soft soil has 5 kPa, steel wire 3 GPa.
// - energy_tension and energy_shear: mortar joints have 5 to 500 J/m2 (van der Pluijm 1999).
// - sagging, hogging and across: a steel tube of 40 x 40 x 3 mm yields at about 1 kN m, and in tension at about 100 kN.
// - strength, yield and reference_load in N: the smallest bolt of a structure, M6, shears at some kN.
// - speed: structures move at up to 3 m/s in earthquakes.
// - rate: sliders have 20 to 100 s/m (Constantinou, Mokha and Reinhorn 1990).
// - capping, ultimate and softening: hinges rotate by at most about 0.2 rad (FEMA 356, chapters 5 and 6).
constexpr std::array usual_ranges{
    PlausibleRange{"mu", "1", 0, 2, "it is the tangent of the friction angle, as in math.tan(35*deg)"},
    PlausibleRange{
        "beta", "s", 0, 0.1,
        "it is 2*zeta/omega of the vibration to be damped; of a body on its contact, omega = sqrt(kn*area/mass)"},
    PlausibleRange{"E", "Pa", 5e5, unbounded, "is it in GPa or MPa? 30 GPa are 30e9 Pa"},
    PlausibleRange{"kn", "Pa/m", 1e5, unbounded, "is it in N/mm3 or MPa/mm? 1 N/mm3 is 1e9 Pa/m"},
    PlausibleRange{"ks", "Pa/m", 1e4, unbounded, "is it in N/mm3 or MPa/mm? 1 N/mm3 is 1e9 Pa/m"},
    PlausibleRange{"tension", "Pa", 50, 1e8, "is it in MPa? 0.2 MPa are 0.2e6 Pa"},
    PlausibleRange{"cohesion", "Pa", 50, 1e9, "is it in MPa? 0.3 MPa are 0.3e6 Pa"},
    PlausibleRange{"compression", "Pa", 5e3, 1e10, "is it in MPa? 10 MPa are 10e6 Pa"},
    PlausibleRange{"strength", "Pa", 5e3, 1e10, "is it in MPa? 30 MPa are 30e6 Pa"},
    PlausibleRange{"yield", "Pa", 5e3, 1e10, "is it in MPa? 420 MPa are 420e6 Pa"},
    PlausibleRange{"energy_tension", "J/m2", 0.1, 1e6, "is it in N/mm? 0.01 N/mm are 10 J/m2"},
    PlausibleRange{"energy_shear", "J/m2", 0.1, 1e7, "is it in N/mm? 0.1 N/mm are 100 J/m2"},
    PlausibleRange{"crush_energy", "J/m2", 10, 1e7, "is it in N/mm? 5 N/mm are 5000 J/m2"},
    PlausibleRange{"opening", "m", 0, 1, "is it in mm? multiply it by trilith.units \"mm\""},
    PlausibleRange{"crushing_depth", "m", 0, 1, "is it in mm? multiply it by trilith.units \"mm\""},
    PlausibleRange{"slack", "m", 0, 5, "is it in mm? multiply it by trilith.units \"mm\""},
    PlausibleRange{"radius", "m", 0, 100, "is it in mm? multiply it by trilith.units \"mm\""},
    PlausibleRange{"limit", "m", 0, 10, "is it in mm? multiply it by trilith.units \"mm\""},
    PlausibleRange{"limit", "rad", 0, 3.2, "is it in degrees? multiply it by trilith.units \"deg\""},
    PlausibleRange{"strain", "1", 0, 0.5, "is it in percent or per mille? 2 per mille are 0.002"},
    PlausibleRange{"capping", "rad", 0, 1,
                   "is it in degrees or percent? multiply it by trilith.units \"deg\", or by 0.01"},
    PlausibleRange{"ultimate", "rad", 0, 1,
                   "is it in degrees or percent? multiply it by trilith.units \"deg\", or by 0.01"},
    PlausibleRange{"softening", "rad", 0, 1,
                   "is it in degrees or percent? multiply it by trilith.units \"deg\", or by 0.01"},
    PlausibleRange{"wear", "rad", 0, 10, "is it in percent? multiply it by 0.01"},
    PlausibleRange{"sagging", "N m", 100, unbounded, "is it in kN m? 100 kN m are 100e3 N m"},
    PlausibleRange{"hogging", "N m", 100, unbounded, "is it in kN m? 100 kN m are 100e3 N m"},
    PlausibleRange{"across", "N m", 100, unbounded, "is it in kN m? 100 kN m are 100e3 N m"},
    PlausibleRange{"tension", "N", 1e3, unbounded, "is it in kN? 500 kN are 500e3 N"},
    PlausibleRange{"compression", "N", 1e3, unbounded, "is it in kN? 500 kN are 500e3 N"},
    PlausibleRange{"strength", "N", 10, unbounded, "is it in MN or kN? 2 MN are 2e6 N"},
    PlausibleRange{"yield", "N", 10, unbounded, "is it in MN or kN? 2 MN are 2e6 N"},
    PlausibleRange{"reference_load", "N", 10, unbounded, "is it in MN or kN? 2 MN are 2e6 N"},
    PlausibleRange{"speed", "m/s", 0, 20, "is it in mm/s? 100 mm/s are 0.1 m/s"},
    PlausibleRange{"rate", "s/m", 1, 1e4, "is it in s/mm? 0.05 s/mm are 50 s/m"},
    PlausibleRange{"dilation_slip", "m", 0, 1, "is it in mm? multiply it by trilith.units \"mm\""},
    PlausibleRange{"section area", "m2", 1e-7, 300, "are its sides in mm? multiply them by trilith.units \"mm\""},
    PlausibleRange{"density", "kg/m3", 25, unbounded, "is it in t/m3 or g/cm3? 2.4 t/m3 are 2400 kg/m3"},
    PlausibleRange{"least side", "m", 0, 40,
                   "is it in mm? multiply it by trilith.units \"mm\", or give a file scale = 0.001"},
    PlausibleRange{"greatest side", "m", 0, 1000,
                   "is it in mm? multiply it by trilith.units \"mm\", or give a file scale = 0.001"},
    PlausibleRange{"rate", "rad/s", -0.5, 0.5, "is it in degrees? multiply it by trilith.units \"deg\""},
    PlausibleRange{"by", "rad", 0, 3.2, "is it in degrees? multiply it by trilith.units \"deg\""},
};

std::string with_unit(double value, std::string_view unit) {
  return unit == "1" ? fmt::format("{:g}", value) : fmt::format("{:g} {}", value, unit);
}

}  // namespace

const PlausibleRange* usual_range(std::string_view name, std::string_view unit) {
  const auto it = std::find_if(usual_ranges.begin(), usual_ranges.end(),
                               [&](const PlausibleRange& r) { return r.name == name && r.unit == unit; });
  return it == usual_ranges.end() ? nullptr : &*it;
}

/// 0 is always plausible: it means that there is none.
std::string plausibility_note(std::string_view name, std::string_view unit, double value) {
  const PlausibleRange* r = usual_range(name, unit);
  if (r == nullptr || (value >= r->least && value <= r->most) || value == unbounded || value == 0) return "";
  const bool over = value > r->most;
  return fmt::format("{} = {} is {} the usual {}: {}", name, with_unit(value, unit), over ? "above" : "below",
                     with_unit(over ? r->most : r->least, unit), r->question);
}

std::string plausible_range_text(std::string_view name, std::string_view unit) {
  const PlausibleRange* r = usual_range(name, unit);
  if (r == nullptr) return "";
  if (r->least == 0) return fmt::format("usually at most {:g}", r->most);
  if (r->most == unbounded) return fmt::format("usually at least {:g}", r->least);
  return fmt::format("usually {:g} to {:g}", r->least, r->most);
}

void add_plausibility_note(std::vector<std::string>& list, const std::string& owner, std::string_view name,
                           std::string_view unit, double value) {
  if (const std::string text = plausibility_note(name, unit, value); !text.empty()) list.push_back(owner + ": " + text);
}

void add_plausibility_note_once(std::vector<std::string>& list, const std::string& owner, std::string_view name,
                                std::string_view unit, double value) {
  const PlausibleRange* r = usual_range(name, unit);
  const auto asks = [&](const std::string& told) { return told.ends_with(r->question); };
  if (r != nullptr && std::none_of(list.begin(), list.end(), asks))
    add_plausibility_note(list, owner, name, unit, value);
}

}  // namespace trilith
