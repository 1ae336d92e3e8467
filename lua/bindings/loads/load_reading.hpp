// Common readers of all loads: bodies, load curve, name.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bindings/core/keys.hpp"
#include "bindings/model/built_model.hpp"
#include "bindings/model/script_model.hpp"
#include "load/load_curve.hpp"

namespace trilith::script {

/// `body`: a body, a set or a name; none if that is wrong, which Keys::finish reports.
std::vector<int> read_loaded_bodies(Keys& keys, const ScriptModel& m);

/// One body by the key; -1 if it is missing or wrong, which Keys::finish reports.
int read_one_body(Keys& keys, const char* key, const ScriptModel& m);

/// `load_curve`: nothing (full value at once, constant), a share, { ramp = T }, { smooth = T } or { {t, share}, ... ,
/// smooth = true } with times from `now` on [s].
LoadCurve read_load_curve(Keys& keys, double now);

/// Initial position of a named joint of a frame [m]; none if the body has no such joint. `spec`: a BodySpec or a
/// SolidSpec.
template <class Spec>
auto joint_place(const Spec& spec, const std::string& name) {
  std::optional<decltype(spec.frame->joints.front().place)> place;
  if (spec.frame)
    for (const auto& joint : spec.frame->joints)
      if (joint.name == name) place = joint.place;
  return place;
}
/// `at` of a body in space by name: "centroid", which returns none, or a joint. InputError, beginning with `owner`, for
/// others.
std::optional<Vec3> named_place(const SpaceModel& m, int body, const std::string& name, const std::string& owner);
/// `at` of a body in the plane by name: a place (model/loads.hpp), or a joint. InputError likewise.
Vec2 named_place(PlaneModel& m, int body, const std::string& name, const std::string& owner);

/// Names of the loads and pushes of a model; builds it.
std::vector<std::string> names_of_loads(ScriptModel& m);
/// The first unused name of "kind 1", "kind 2", ...
std::string free_load_name(ScriptModel& m, const char* kind);
int push_load_name(lua_State* L, const std::string& name);

}  // namespace trilith::script
