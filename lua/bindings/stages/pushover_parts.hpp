// What both controls of m:pushover share, and the one by arcs.
#pragma once

#include <functional>
#include <string_view>

#include "bindings/model/simulated_model.hpp"
#include "bindings/stages/pushover_order.hpp"

namespace trilith::script {

/// The points and the direction of a push to be, under the stage's name.
template <int D>
Push<D> order_push(const Model<D>& model, const PushOrder<D>& order);

/// Drift of a storey or of the top one: along x in the plane, in space along the level part of the push. Nothing, where
/// there are no storeys, or nothing level in the push.
template <int D>
std::function<double(const Model<D>&, const State<D>&)> storey_reading(SimulatedModel<D>& m, const PushOrder<D>& order);

/// Adds the curve and its figures to the report on top of the stack; `peak` is one of the curve's points.
void add_curve(lua_State* L, const PushCurve& curve, std::size_t peak, std::string_view limit);
/// Likewise how much of the peak the structure carries as in statics [N], and whether that is as good as all of it.
void add_statics(lua_State* L, double carried, bool is_static);

/// m:pushover{ control = "arc", ... }: by equilibria, past limit points (statics/load_path.hpp). Pushes the report.
template <int D>
int push_by_arc(lua_State* L, SimulatedModel<D>& m, PushOrder<D>& order);

}  // namespace trilith::script
