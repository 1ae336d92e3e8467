// Common parts of both controls of m:pushover.
#include <algorithm>
#include <cmath>
#include <utility>

#include "bindings/core/bindings.hpp"
#include "bindings/stages/pushover_parts.hpp"
#include "model/builder/builder.hpp"
#include "model/pushes.hpp"
#include "model/space_builder/solid_model_builder.hpp"

namespace trilith::script {
namespace {

/// The horizontal unit vector of a push's direction; none if it is vertical.
template <int D>
std::optional<Vec<D>> level_direction(Vec<D> direction) {
  direction[D - 1] = 0;
  const double size = direction.norm();
  if (!(size > 1e-9)) return std::nullopt;
  return Vec<D>(direction / size);
}

void set_array(lua_State* L, const char* key, const std::vector<double>& values) {
  lua_createtable(L, static_cast<int>(values.size()), 0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    lua_pushnumber(L, values[i]);
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
  lua_setfield(L, -2, key);
}

}  // namespace

template <int D>
Push<D> order_push(const Model<D>& model, const PushOrder<D>& o) {
  Push<D> push;
  push.name = o.stage.name, push.direction = o.direction;
  push.rows = push_rows(model, o.bodies, o.at, o.pattern, o.direction);
  return push;
}

template <int D>
void hold_top(SimulatedModel<D>& m, const PushOrder<D>& o) {
  if (o.top == PushTop::free) return;
  const Model<D>& now = m.simulation().model();
  for (const int body : o.bodies)
    if (!now.bodies[static_cast<std::size_t>(body)].nodes_turn())
      throw InputError(fmt::format(
          "pushover: 'top' holds the rotation of body '{}', which is made of elements, whose nodes have no rotation; "
          "push a rigid beam on top of it",
          now.bodies[static_cast<std::size_t>(body)].name));
  m.change_supports([bodies = o.bodies, top = o.top](Model<D>& model) {
    const int first = top == PushTop::locked ? D - 1 : D;  // the vertical direction comes before the rotations
    for (const int body : bodies)
      for (int k = first; k < Space<D>::dofs; ++k) set_support(model, body, k, Support::fixed);
  });
}

/// The findings are asked for at each reading, because bodies that crack or are added during the push replace them. The
/// order of the storeys remains.
template <int D>
std::function<double(const Model<D>&, const State<D>&)> storey_reading(
    const std::function<const Findings<D>&()>& findings, const PushOrder<D>& o) {
  const Findings<D>& f = findings();
  if (f.storeys.empty()) {
    if (o.storey != 0) throw InputError("pushover: there are no storeys; leave 'storey' out");
    return {};
  }
  const std::optional<Vec<D>> along = D == 2 ? Vec<D>(Vec<D>::UnitX()) : level_direction<D>(o.direction);
  if (!along) {
    if (o.storey != 0) throw InputError("pushover: an upright push has no drift; leave 'storey' out");
    return {};
  }
  if (o.storey == 0)
    return [findings, e = *along](const Model<D>& model, const State<D>& state) {
      const Findings<D>& now = findings();
      return e.dot(top_drift(model, state, now.storeys, now.base));
    };
  for (std::size_t i = 0; i < f.storeys.size(); ++i)
    if (f.storeys[i].number == o.storey)
      return [findings, i, e = *along](const Model<D>& model, const State<D>& state) {
        const Findings<D>& now = findings();
        return e.dot(storey_drift(model, state, now.storeys, now.base, i));
      };
  throw InputError(fmt::format("pushover: there is no storey {}; there are {}", o.storey, f.storeys.size()));
}

void add_curve(lua_State* L, const PushCurve& curve, std::size_t peak, std::string_view limit) {
  const auto number = [&](const char* key, double value) {
    lua_pushnumber(L, value);
    lua_setfield(L, -2, key);
  };
  lua_createtable(L, 0, 4);
  set_array(L, "t", curve.time);
  set_array(L, "displacement", curve.displacement);
  set_array(L, "force", curve.force);
  set_array(L, "drift", curve.drift);
  lua_setfield(L, -2, "curve");
  const bool any = !curve.force.empty();
  number("peak_force", any ? curve.force[peak] : 0);
  number("displacement_at_peak", any ? curve.displacement[peak] : 0);
  number("drift_at_peak", any ? curve.drift[peak] : 0);
  number("force", any ? curve.force.back() : 0);
  number("displacement", any ? curve.displacement.back() : 0);
  number("drift", any ? curve.drift.back() : 0);
  lua_pushlstring(L, limit.data(), limit.size());
  lua_setfield(L, -2, "limit");
}

void push_sample(lua_State* L, const PushCurve& curve, std::size_t point) {
  lua_createtable(L, 0, 4);
  for (const auto& [key, values] : {std::pair{"t", &curve.time}, std::pair{"displacement", &curve.displacement},
                                    std::pair{"force", &curve.force}, std::pair{"drift", &curve.drift}}) {
    lua_pushnumber(L, (*values)[point]);
    lua_setfield(L, -2, key);
  }
}

void add_statics(lua_State* L, double carried, bool is_static) {
  lua_pushnumber(L, carried);
  lua_setfield(L, -2, "carried_at_peak");
  lua_pushboolean(L, is_static ? 1 : 0);
  lua_setfield(L, -2, "quasi_static");
}

template void hold_top(SimulatedModel<2>&, const PushOrder<2>&);
template void hold_top(SimulatedModel<3>&, const PushOrder<3>&);
template Push<2> order_push(const Model<2>&, const PushOrder<2>&);
template Push<3> order_push(const Model<3>&, const PushOrder<3>&);
template std::function<double(const Model<2>&, const State<2>&)> storey_reading(
    const std::function<const Findings<2>&()>&, const PushOrder<2>&);
template std::function<double(const Model<3>&, const State<3>&)> storey_reading(
    const std::function<const Findings<3>&()>&, const PushOrder<3>&);

}  // namespace trilith::script
