#include "bindings/loads/drive_reading.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "bindings/core/bindings.hpp"
#include "bindings/core/host.hpp"
#include "load/motion_check.hpp"
#include "load/motion_measures.hpp"
#include "model/turn_reading.hpp"

namespace trilith::script {
namespace {

/// Degrees of freedom that can follow a motion, in their order.
std::vector<const char*> drive_names(int dim) {
  if (dim == 2) return {"x", "y", "rotation"};
  return {"x", "y", "z", "rotation_x", "rotation_y", "rotation_z"};
}

/// True for rotations, which deformable bodies cannot follow.
bool is_turn(int dim, std::size_t dof) {
  return dof >= static_cast<std::size_t>(dim);
}

bool deforms(const ScriptModel& m, int body) {
  if (const PlaneModel* plane = as_plane(m)) return info_of(plane->spec(body).kind).nodes != 1;
  return static_cast<const SpaceModel&>(m).spec(body).kind() != BodyKind::rigid;
}

DriveOrder read_drive(Keys& keys, const ScriptModel& m) {
  lua_State* L = keys.lua();
  DriveOrder order;
  if (keys.push("body") == LUA_TNIL) {
    keys.missing("body", "a body, a set or a name");
  } else {
    try {
      order.bodies = some_bodies_at(L, -1, m, "body");
    } catch (const InputError& e) {
      keys.problem(e.what());
    }
  }
  lua_pop(L, 1);
  const auto names = drive_names(m.dim());
  bool any = false;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto* motion = keys.maybe_handle<MotionValue>(names[k]);
    if (motion == nullptr) continue;
    any = true;
    order.motion[k] = motion->motion;
    for (const int body : order.bodies)
      if (is_turn(m.dim(), k) && deforms(m, body))
        keys.problem(fmt::format("body '{}' deforms and has no rotation to drive", m.body_name(body)));
    const std::string why = motion->steady ? "" : why_not_usable(*motion->motion);
    if (!why.empty()) keys.problem(fmt::format("'{}': {}", names[k], why));
  }
  if (!any) keys.problem(fmt::format("no motion is given; give x, y or {} = trilith.motion ...", names[2]));
  return order;
}

template <int D>
void apply_drive(SimulatedModel<D>& m, const DriveOrder& order) {
  const SimulatedModel<D>* const self_model = &m;
  m.change_supports([order, self_model](Model<D>& model) {
    const State<D>& state = self_model->if_built()->state();
    for (const int body : order.bodies) {
      for (int k = 0; k < Space<D>::dofs; ++k)
        if (const auto& motion = order.motion[static_cast<std::size_t>(k)])
          set_drive(model, body, k, motion, state.time, drive_origin(model, state, body, k), &state);
    }
  });
}

}  // namespace

void apply_drive(ScriptModel& m, const DriveOrder& order) {
  const auto names = drive_names(m.dim());
  for (const int body : order.bodies)
    for (std::size_t k = 0; k < names.size(); ++k)
      if (order.motion[k])
        m.motions.push_back(fmt::format("{} {}: {}", m.body_name(body), names[k], order.motion[k]->description()));
  if (SpaceModel* space = as_space(m))
    apply_drive<3>(*space, order);
  else
    apply_drive<2>(require_plane(m, "drive"), order);
}

namespace {

/// A motion that ends above this share of its peak velocity, and above this speed [m/s] or [rad/s], stops its bodies
/// abruptly. Corrected records end far below.
constexpr double abrupt_share = 0.1, abrupt_speed = 1e-3;

/// The speed at a motion's end, which is lost at once; 0 if negligible.
double speed_lost(const GroundMotion& motion) {
  const double end = std::abs(motion.samples().back().velocity);
  return end > abrupt_speed && end > abrupt_share * std::abs(motion_peaks(motion).velocity.value) ? end : 0;
}

/// Notes a usable motion that does not end at rest.
void tell_end_drift(ScriptModel& m, const std::string& owner, const char* name, const GroundMotion& motion,
                    Host& host) {
  if (std::abs(motion.samples().back().velocity) < abrupt_speed) return;
  if (const std::string drift = end_drift(motion); !drift.empty())
    m.note_at_once(fmt::format("{}: '{}': motion '{}': {}. To end it at rest, correct its baseline, as by "
                               "motion:baseline(1)",
                               owner, name, motion.description(), drift),
                   host);
}

}  // namespace

void tell_abrupt_ends(ScriptModel& m, const std::string& owner, const std::vector<DriveOrder>& orders, Host& host) {
  const auto names = drive_names(m.dim());
  for (const DriveOrder& order : orders)
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (!order.motion[k] || order.bodies.empty()) continue;
      const double lost = speed_lost(*order.motion[k]);
      if (lost == 0) tell_end_drift(m, owner, names[k], *order.motion[k], host);
      if (lost == 0) continue;
      const std::string others = order.bodies.size() == 1 ? "" : fmt::format(" and {} more", order.bodies.size() - 1);
      m.note_at_once(
          fmt::format(
              "{}: motion '{}' ends at {:.3g} {} after {:.4g} s, and '{}'{} stops there along {} within one step. This "
              "is a shock for everything on it: let the motion end at rest, or give another one that follows in time",
              owner, order.motion[k]->description(), lost, is_turn(m.dim(), k) ? "rad/s" : "m/s",
              order.motion[k]->end_time(), m.body_name(order.bodies.front()), others, names[k]),
          host);
    }
}

void tell_motions(const ScriptModel& m, const std::vector<DriveOrder>& orders, RunObserver* observer) {
  if (observer == nullptr) return;
  const auto names = drive_names(m.dim());
  for (const DriveOrder& order : orders)
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (!order.motion[k] || order.bodies.empty()) continue;
      const double peak = std::abs(motion_peaks(*order.motion[k]).acceleration.value);
      const std::string others = order.bodies.size() == 1 ? "" : fmt::format(" and {} more", order.bodies.size() - 1);
      const std::string size =
          is_turn(m.dim(), k) ? fmt::format("{:.3g} rad/s2", peak) : fmt::format("{:.3g} g", peak / standard_gravity);
      observer->note(fmt::format("shake: '{}'{} {}: {}: peak {}, {:.4g} s", m.body_name(order.bodies.front()), others,
                                 names[k], order.motion[k]->description(), size, order.motion[k]->end_time()));
    }
}

double last_end(const std::vector<DriveOrder>& orders) {
  double end = 0;
  for (const DriveOrder& o : orders)
    for (const auto& motion : o.motion)
      if (motion) end = std::max(end, motion->end_time());
  return end;
}

namespace {

/// Rejects two motions of one body along one axis, of which only the second would act.
void refuse_twice(Keys& keys, const ScriptModel& m, const std::vector<DriveOrder>& orders) {
  const auto names = drive_names(m.dim());
  std::set<std::pair<int, std::size_t>> driven;
  for (const DriveOrder& order : orders)
    for (const int body : std::set<int>(order.bodies.begin(), order.bodies.end()))
      for (std::size_t k = 0; k < names.size(); ++k)
        if (order.motion[k] && !driven.emplace(body, k).second)
          keys.problem(fmt::format("body '{}' is given two motions along {}; keep one", m.body_name(body), names[k]));
}

}  // namespace

std::vector<DriveOrder> read_drives(Keys& keys, const ScriptModel& m) {
  lua_State* L = keys.lua();
  std::vector<DriveOrder> orders;
  const int type = keys.push("motions");
  if (type == LUA_TTABLE) {
    const auto count = static_cast<lua_Integer>(lua_rawlen(L, -1));
    if (count == 0) keys.problem("'motions' is empty; give { {body = , x = }, ... }");
    for (const char* const key : {"body", "x", "y", "z", "rotation", "rotation_x", "rotation_y", "rotation_z"})
      keys.refuse(key, fmt::format("'{}' cannot be given with 'motions'; give it in each row", key));
    for (lua_Integer i = 1; i <= count; ++i) {
      lua_rawgeti(L, -1, i);
      try {
        Keys own(L, -1, fmt::format("motion {}", i));
        orders.push_back(read_drive(own, m));
        own.finish();
      } catch (const InputError& e) {
        keys.problem(e.what());
      }
      lua_pop(L, 1);
    }
    refuse_twice(keys, m, orders);
  } else if (type == LUA_TNIL) {
    orders.push_back(read_drive(keys, m));
  } else {
    keys.wrong("motions", "a list { {body = , x = , y = }, ... }");
  }
  lua_pop(L, 1);
  return orders;
}

}  // namespace trilith::script
