#include "bindings/stages/mass_scaling_stage.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "base/error.hpp"
#include "bindings/core/bindings.hpp"
#include "bindings/core/host.hpp"

namespace trilith::script {
namespace {

/// "shake: mass scaling: ..." for the screen and the results, if a stage scaled masses.
std::string scaling_text(const StageReport& report, const ScaledMass& s, const std::string& worst) {
  std::string text = fmt::format("{}: mass scaling: steps up to {:.3g} s, {:.3g} s without it; ", report.name,
                                 report.longest_dt, s.before);
  if (s.bodies == 0) return text + "no body needs added mass";
  text += fmt::format(
      "{} bodies have added mass against deformation, {:.3g} times the mass of all moving bodies, at most {:.3g} "
      "times the mass of a body ('{}'); its kinetic energy is at most {:.2g} J, the model's {:.3g} J",
      s.bodies, s.share, s.most, worst, s.energy, s.kinetic);
  if (s.kinetic > 0) text += fmt::format(" ({:.2g} %)", 100 * s.energy / s.kinetic);
  return text;
}

}  // namespace

void read_scaling(Keys& keys, const ScriptModel& m, StageOptions& o) {
  lua_State* L = keys.lua();
  const int type = keys.push("mass_scaling");
  if (type == LUA_TTABLE) {
    Keys own(L, -1, "mass_scaling");
    MassScaling asked;
    try {
      asked.step = own.number("step", "s");
      asked.most = own.number("most", "1", asked.most);
      if (own.push("bodies") != LUA_TNIL) asked.bodies = some_bodies_at(L, -1, m, "mass_scaling: bodies");
      lua_pop(L, 1);
      own.finish();
    } catch (const InputError& e) {
      keys.problem(e.what());
    }
    o.mass_scaling = std::move(asked);
  } else if (type != LUA_TNIL) {
    keys.wrong("mass_scaling", "a table { step = , most = , bodies = }");
  }
  lua_pop(L, 1);
}

void tell_scaling(lua_State* L, ScriptModel& m, const StageReport& report) {
  if (!report.scaled) return;
  const int worst = report.scaled->body;
  const std::string said = scaling_text(report, *report.scaled, worst >= 0 ? m.body_name(worst) : "");
  m.note(said);
  if (host(L).observer != nullptr) host(L).observer->note(said);
}

}  // namespace trilith::script
