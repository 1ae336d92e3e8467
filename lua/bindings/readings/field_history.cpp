#include "bindings/readings/field_history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "bindings/core/handles.hpp"
#include "bindings/fields/heat_reading.hpp"
#include "bindings/fields/seepage_reading.hpp"
#include "bindings/loads/load_reading.hpp"

namespace trilith::script {
namespace {

/// A reading of a joint, the number it gives, and its unit. Readings of a cell need a place.
struct JointQuantity {
  std::string_view name, unit, sentence;
  double JointReading::*whole = nullptr;
  std::vector<double> JointReading::*cells = nullptr;
};
const std::array<JointQuantity, 8> joint_quantities{
    {{"pressure", "Pa", "pressure of the water", nullptr, &JointReading::pressure},
     {"head", "m", "head of the water", nullptr, &JointReading::head},
     {"aperture", "m", "aperture", nullptr, &JointReading::aperture},
     {"fill", "1", "share that water fills", nullptr, &JointReading::fill},
     {"volume", "m3", "volume of the water", &JointReading::volume, nullptr},
     {"wet_length", "m", "length that water fills", &JointReading::wet_length, nullptr},
     {"inflow", "m3/s", "flow into the first end", &JointReading::inflow, nullptr},
     {"outflow", "m3/s", "flow out of the second end", &JointReading::outflow, nullptr}}};

template <int D>
double joint_number(SimulatedModel<D>& m, const std::string& name, const JointQuantity& quantity, double at,
                    const std::string& owner) {
  const Simulation<D>& s = m.simulation();
  const FlowJoint& joint = require_flow_joint(require_seepage(s.model(), owner), name, owner);
  const JointReading now = SeepageNow<D>(s).joint(joint);
  if (quantity.whole != nullptr) return now.*quantity.whole;
  const std::vector<double>& cells = now.*quantity.cells;
  const int cell = std::clamp(static_cast<int>(at / joint.cell_length()), 0, static_cast<int>(cells.size()) - 1);
  return cells[static_cast<std::size_t>(cell)];
}

double joint_number(ScriptModel& m, const std::string& name, const JointQuantity& quantity, double at,
                    const std::string& owner) {
  if (SpaceModel* space = as_space(m)) return joint_number<3>(*space, name, quantity, at, owner);
  return joint_number<2>(*as_plane(m), name, quantity, at, owner);
}

const FlowJoint& declared_joint(ScriptModel& m, const std::string& name, const std::string& owner) {
  if (SpaceModel* space = as_space(m))
    return require_flow_joint(require_seepage(space->simulation().model(), owner), name, owner);
  return require_flow_joint(require_seepage(as_plane(m)->simulation().model(), owner), name, owner);
}

/// A point of a body: {x, y}, in space {x, y, z}.
struct BodyPoint {
  std::optional<Vec2> plane;
  std::optional<Vec3> space;
};

/// NaN where the body, or all its parts, are removed.
template <int D, class M, class P>
double temperature_now(M& m, int body, const std::optional<P>& at, const std::string& owner) {
  std::vector<int> bodies = at ? std::vector<int>{m.part_with(body, *at)} : parts_of(m, body);
  std::erase_if(bodies, [&](int part) { return m.is_out(part); });
  if (bodies.empty()) return std::numeric_limits<double>::quiet_NaN();
  const Simulation<D>& s = m.simulation();
  require_heat(s.model(), owner);
  const FieldValues heat = values_of(s.model().fields, s.state().fields, FieldKind::heat);
  return (at ? temperature_of(s.model(), heat, bodies.front(), *at, owner) : temperature_of(heat, bodies, owner)).value;
}

double temperature_now(ScriptModel& m, int body, const BodyPoint& at, const std::string& owner) {
  if (SpaceModel* space = as_space(m)) return temperature_now<3>(*space, body, at.space, owner);
  return temperature_now<2>(*as_plane(m), body, at.plane, owner);
}

BodyPoint read_body_point(Keys& keys, const ScriptModel& m) {
  BodyPoint at;
  if (!keys.has("point")) return at;
  if (m.dim() == 3)
    at.space = keys.vector("point");
  else
    at.plane = keys.point("point");
  return at;
}

/// The place along a joint, in its length.
double read_joint_place(Keys& keys, const FlowJoint& joint, const std::string& what) {
  const std::optional<double> at = keys.maybe_number("at", "m");
  if (!at)
    keys.problem(
        fmt::format("'at' is missing: '{}' differs along the joint; give the distance from its first end, from "
                    "0 to {:g} m",
                    what, joint.length));
  else if (!(*at >= 0 && *at <= joint.length))
    keys.problem(fmt::format("'at' is {:g} m, must be from 0 to {:g} m, the length of the joint", *at, joint.length));
  return at.value_or(0);
}

}  // namespace

bool follow_temperature(Keys& keys, History& history, const std::string& what, ScriptModel& m) {
  if (what != "temperature" || !keys.has("body")) return false;
  const int body = read_one_body(keys, "body", m);
  const BodyPoint at = read_body_point(keys, m);
  history.unit = "degC";
  if (body < 0) return true;
  const std::string owner = fmt::format("history '{}'", history.name);
  history.sentence = fmt::format("temperature of {}{}", m.body_name(body), at.plane || at.space ? " at a point" : "");
  history.sample = [kept = Owner(m.shared_from_this()), body, at, owner] {
    return temperature_now(kept.get(), body, at, owner);
  };
  return true;
}

bool follow_seepage(Keys& keys, History& history, const std::string& what, ScriptModel& m) {
  if (!keys.has("seepage")) return false;
  const std::string name = keys.text("seepage"), owner = fmt::format("history '{}'", history.name);
  std::vector<std::string> names;
  for (const JointQuantity& one : joint_quantities) names.emplace_back(one.name);
  const auto known = std::find(names.begin(), names.end(), what);
  if (known == names.end()) {
    keys.problem(
        fmt::format("'what' is '{}', which is not a reading of a joint with seepage{}", what, name_hint(what, names)));
    keys.know({"at"});
    return true;
  }
  const JointQuantity& quantity = joint_quantities[static_cast<std::size_t>(known - names.begin())];
  try {
    const FlowJoint& joint = declared_joint(m, name, owner);
    const double at = quantity.whole == nullptr ? read_joint_place(keys, joint, what) : 0;
    if (quantity.whole != nullptr) keys.refuse("at", fmt::format("'{}' is of the whole joint; leave out at", what));
    history.unit = quantity.unit;
    history.sentence = fmt::format("{} of {}", quantity.sentence, name);
    if (quantity.whole == nullptr) history.sentence += fmt::format(" at {:g} m", at);
    history.sample = [kept = Owner(m.shared_from_this()), name, quantity, at, owner] {
      return joint_number(kept.get(), name, quantity, at, owner);
    };
  } catch (const InputError& e) {
    keys.problem(e.what());
  }
  return true;
}

}  // namespace trilith::script
