// Common parts of both controls of m:pushover, and the arc length control.
#pragma once

#include <functional>
#include <string_view>

#include "bindings/model/built_model.hpp"
#include "bindings/stages/pushover_order.hpp"

namespace trilith::script {

/// The points and the direction of a push, under the stage's name.
template <int D>
Push<D> order_push(const Model<D>& model, const PushOrder<D>& order);

/// Holds the pushed bodies as their `top` says, from now on. Throws InputError for bodies whose nodes do not rotate.
template <int D>
void hold_top(SimulatedModel<D>& m, const PushOrder<D>& order);

/// Drift of a storey or of the top one: along x in the plane, in space along the horizontal part of the push. None
/// without storeys, or for a vertical push. `findings`: of the model that is read; they are asked for at each reading.
template <int D>
std::function<double(const Model<D>&, const State<D>&)> storey_reading(
    const std::function<const Findings<D>&()>& findings, const PushOrder<D>& order);

/// Adds the curve and its results to the report on top of the stack; `peak` is the index of a point of the curve.
void add_curve(lua_State* L, const PushCurve& curve, std::size_t peak, std::string_view limit);
/// Pushes a point of the curve as a table { t, displacement, force, drift }.
void push_sample(lua_State* L, const PushCurve& curve, std::size_t point);
/// Adds the part of the peak that the structure carries statically [N], and whether that is nearly all of it.
void add_statics(lua_State* L, double carried, bool is_static);

/// m:pushover{ control = "arc", ... }: by equilibria, past limit points (statics/load_path.hpp). Pushes the report.
template <int D>
int push_by_arc(lua_State* L, BuiltModel<D>& m, PushOrder<D>& order);

}  // namespace trilith::script
