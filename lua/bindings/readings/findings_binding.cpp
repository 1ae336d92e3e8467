// Engineering results of a model for scripts: storeys, joints, base shear, line of thrust.
#include <algorithm>
#include <cmath>

#include "bindings/core/bindings.hpp"
#include "bindings/core/table_fields.hpp"
#include "bindings/readings/touching_now.hpp"
#include "run/findings.hpp"
#include "run/record/body_forces.hpp"

namespace trilith::script {
namespace {

/// A model, evaluated at the present instant, and its findings.
template <int D>
struct Present {
  const Simulation<D>& sim;
  const Findings<D>& findings;
  explicit Present(SimulatedModel<D>& m) : sim(m.evaluated()), findings(m.findings()) {}

  [[nodiscard]] const Model<D>& model() const { return sim.model(); }
  [[nodiscard]] JointDisplacement displacement(const JointOf<D>& joint) const {
    return joint_displacement(joint, sim.model(), sim.state(), sim.work());
  }
  [[nodiscard]] Vec<D> base_force() const { return force_on(sim.model(), sim.work(), findings.base); }
  [[nodiscard]] Vec<D> top_drift() const {
    return trilith::top_drift(sim.model(), sim.state(), findings.storeys, findings.base);
  }
  /// Index of a storey, storeys.size() if there is no such number.
  [[nodiscard]] std::size_t storey(int number) const {
    const auto it = std::ranges::find(findings.storeys, number, &Storey::number);
    return static_cast<std::size_t>(it - findings.storeys.begin());
  }
  [[nodiscard]] Vec<D> drift(int number) const {
    const std::size_t i = storey(number);
    if (i == findings.storeys.size()) return Vec<D>::Zero();
    return storey_drift(sim.model(), sim.state(), findings.storeys, findings.base, i);
  }
  [[nodiscard]] double height(int number) const {
    const std::size_t i = storey(number);
    return i == findings.storeys.size() ? 0 : findings.storeys[i].height;
  }
};

/// f of the model at the present instant, in the plane or in space.
template <class F>
double of_present(ScriptModel& m, F&& f) {
  if (SpaceModel* space = as_space(m)) return f(Present<3>(*space));
  return f(Present<2>(require_plane(m, "this")));
}
/// As above, in space only.
template <class F>
double of_space(ScriptModel& m, F&& f) {
  SpaceModel* space = as_space(m);
  if (space == nullptr) throw InputError(fmt::format("this is for models in space, but {} is in the plane", m.title()));
  return f(Present<3>(*space));
}

double drift_of(const StoreyHandle& h) {
  return of_present(h.model(), [&](const auto& now) { return level_part(now.drift(h.index + 1)); });
}
template <int Axis>
double drift_along(const StoreyHandle& h) {
  return of_space(h.model(), [&](const Present<3>& now) { return now.drift(h.index + 1)[Axis]; });
}
double twist_of(const StoreyHandle& h) {
  return of_space(h.model(), [&](const Present<3>& now) {
    const std::size_t i = now.storey(h.index + 1);
    const Findings<3>& f = now.findings;
    return i == f.storeys.size() ? 0 : storey_twist(now.sim.model(), now.sim.state(), f.storeys, f.base, i);
  });
}
double height_of(const StoreyHandle& h) {
  return of_present(h.model(), [&](const auto& now) { return now.height(h.index + 1); });
}
double ratio_of(const StoreyHandle& h) {
  return height_of(h) > 0 ? drift_of(h) / height_of(h) : 0;
}

/// Mean over the bonded joints that `wanted` selects by their two bodies; 0 if there are none.
template <class Wanted>
double mean_damage(ScriptModel& m, Wanted&& wanted) {
  return of_present(m, [&](const auto& now) {
    double lost = 0, all = 0;
    for (const auto& joint : now.findings.joints) {
      if (!is_bonded(joint) || !wanted(now.model(), joint.body_a, joint.body_b)) continue;
      lost += joint_damage(joint, now.sim.state());
      all += 1;
    }
    return all > 0 ? lost / all : 0;
  });
}

double damage_of(const StoreyHandle& h) {
  return mean_damage(h.model(),
                     [&](const auto& model, int a, int b) { return storey_between(model, a, b) == h.index + 1; });
}

template <class Value>
double largest_joint(const ModelBox& box, Value&& value) {
  return of_present(box.get(), [&](const auto& now) {
    double most = 0;
    for (const auto& joint : now.findings.joints) most = std::max(most, value(now.displacement(joint)));
    return most;
  });
}

double base_shear(const ModelBox& box) {
  return of_present(box.get(), [](const auto& now) { return level_part(now.base_force()); });
}
template <int Axis>
double base_shear_along(const ModelBox& box) {
  return of_space(box.get(), [](const Present<3>& now) { return now.base_force()[Axis]; });
}
double drift_of_top(const ModelBox& box) {
  return of_present(box.get(), [](const auto& now) { return level_part(now.top_drift()); });
}
template <int Axis>
double drift_of_top_along(const ModelBox& box) {
  return of_space(box.get(), [](const Present<3>& now) { return now.top_drift()[Axis]; });
}

using FindingProperty = Property<ModelBox>;
FindingProperty in_space(std::string_view name, std::string_view unit, std::string_view doc,
                         double (*number)(const ModelBox&)) {
  return {name, unit, doc, number, nullptr, nullptr, 3};
}
const std::array model_findings{
    FindingProperty{
        "base_shear", "N",
        "base shear: horizontal force of contacts and bearings on the base (group base, or fixed bodies); in space "
        "its size",
        base_shear},
    in_space("base_shear_x", "N", "force along x of contacts and bearings on the base", base_shear_along<0>),
    in_space("base_shear_y", "N", "force along y of contacts and bearings on the base", base_shear_along<1>),
    FindingProperty{"top_drift", "m",
                    "horizontal displacement of the topmost storey relative to the base; in space its length",
                    drift_of_top},
    in_space("top_drift_x", "m", "displacement along x of the topmost storey against the base", drift_of_top_along<0>),
    in_space("top_drift_y", "m", "displacement along y of the topmost storey against the base", drift_of_top_along<1>),
    FindingProperty{
        "damage", "1", "lost part of all bonds",
        [](const ModelBox& box) { return mean_damage(box.get(), [](const auto&, int, int) { return true; }); }},
    FindingProperty{
        "largest_opening", "m", "of all joints since the start",
        [](const ModelBox& box) { return largest_joint(box, [](const JointDisplacement& j) { return j.opening; }); }},
    FindingProperty{"largest_slip", "m", "of all joints since the start",
                    [](const ModelBox& box) {
                      return largest_joint(box, [](const JointDisplacement& j) { return std::abs(j.slip); });
                    }},
};

using S = Property<StoreyHandle>;
const std::array storey_properties{
    S{"number", "1", "its number, from 1 at the bottom", [](const StoreyHandle& h) { return h.index + 1.0; }},
    S{"height", "m", "height from the top of the storey below, or the base", height_of},
    S{"drift", "m",
      "interstorey drift: displacement of its top relative to the storey below, or the base; in space its length",
      drift_of},
    S{"drift_x", "m", "displacement along x of its top against the storey below, or the base", drift_along<0>, nullptr,
      nullptr, 3},
    S{"drift_y", "m", "displacement along y of its top against the storey below, or the base", drift_along<1>, nullptr,
      nullptr, 3},
    S{"drift_ratio", "1", "drift over height", ratio_of},
    S{"twist", "rad", "rotation of its top about the vertical axis relative to the storey below, or the base", twist_of,
      nullptr, nullptr, 3},
    S{"damage", "1", "lost part of its bonds", damage_of},
};

void set_place(lua_State* L, const Joint& joint, const Present<2>& now) {
  const auto ends = joint_place(joint, now.sim.work());
  set_number(L, "x", 0.5 * (ends[0].x() + ends[1].x()));
  set_number(L, "y", 0.5 * (ends[0].y() + ends[1].y()));
}
void set_place(lua_State* L, const FaceJoint& joint, const Present<3>& now) {
  const Vec3 middle = joint_middle(joint, now.sim.model(), now.sim.state());
  set_number(L, "x", middle.x());
  set_number(L, "y", middle.y());
  set_number(L, "z", middle.z());
  set_number(L, "area", joint.area);
}

template <int D>
void push_joint(lua_State* L, const Present<D>& now, const JointOf<D>& joint) {
  const JointDisplacement moved = now.displacement(joint);
  lua_createtable(L, 0, 10);
  push_body(L, 1, joint.body_a);
  lua_setfield(L, -2, "a");
  push_body(L, 1, joint.body_b);
  lua_setfield(L, -2, "b");
  set_number(L, "opening", moved.opening);
  set_number(L, "slip", moved.slip);
  set_number(L, "storey", storey_between(now.model(), joint.body_a, joint.body_b));
  set_place(L, joint, now);
  if (is_bonded(joint)) set_number(L, "damage", joint_damage(joint, now.sim.state()));
}

template <int D>
void push_joints(lua_State* L, const Present<D>& now) {
  lua_newtable(L);
  lua_Integer count = 0;
  for (const JointOf<D>& joint : now.findings.joints) {
    push_joint<D>(L, now, joint);
    lua_rawseti(L, -2, ++count);
  }
}

/// m:joints(): all joints that existed at the start; `damage` only for joints with a bond.
int joints(lua_State* L) {
  ScriptModel& m = this_model(L);
  if (SpaceModel* space = as_space(m))
    push_joints(L, Present<3>(*space));
  else
    push_joints(L, Present<2>(require_plane(m, "joints")));
  return 1;
}

constexpr std::array place_keys{"x", "y", "z"}, force_keys{"fx", "fy", "fz"};

template <int D>
void push_line(lua_State* L, const std::vector<ThrustPoint<D>>& line) {
  lua_newtable(L);
  lua_Integer count = 0;
  for (const ThrustPoint<D>& p : line) {
    lua_createtable(L, 0, 2 + 2 * D);
    push_body(L, 1, p.body_a);
    lua_setfield(L, -2, "a");
    push_body(L, 1, p.body_b);
    lua_setfield(L, -2, "b");
    for (int k = 0; k < D; ++k) {
      set_number(L, place_keys[static_cast<std::size_t>(k)], p.point[k]);
      set_number(L, force_keys[static_cast<std::size_t>(k)], p.force[k]);
    }
    lua_rawseti(L, -2, ++count);
  }
}

/// m:thrust_line(bodies): in their order, which for a set is the order of creation.
int thrust(lua_State* L) {
  ScriptModel& m = this_model(L);
  const std::vector<int> chain = bodies_at(L, 2, m, "thrust_line");
  if (SpaceModel* space = as_space(m))
    push_line(L, thrust_line(chain, touching_now(space->evaluated())));
  else
    push_line(L, thrust_line(chain, touching_now(require_plane(m, "thrust_line").evaluated())));
  return 1;
}

/// m:stresses(): mean stress of each free body.
int stresses(lua_State* L) {
  PlaneModel& m = this_plane(L);
  const Simulation<2>& sim = m.evaluated();
  std::vector<TouchingContact> touching;
  contact_resultants(sim.model(), sim.state(), sim.work(), touching);
  const std::vector<MeanStress> all = mean_stress(sim.model(), sim.state(), sim.work(), touching);
  lua_createtable(L, 0, static_cast<int>(all.size()));
  for (std::size_t i = 0; i < all.size(); ++i) {
    lua_createtable(L, 0, 5);
    set_number(L, "xx", all[i].xx);
    set_number(L, "yy", all[i].yy);
    set_number(L, "xy", all[i].xy);
    set_number(L, "major", all[i].major());
    set_number(L, "minor", all[i].minor());
    lua_setfield(L, -2, sim.model().bodies[i].name.c_str());
  }
  return 1;
}

const std::array finding_method_list{
    Method{"joints", guarded<joints>},
    Method{"thrust_line", guarded<thrust>},
    Method{"stresses", guarded<stresses>, 2},
};

}  // namespace

int storey_count(const ScriptModel& model) {
  int most = 0;
  for (int b = 0; b < model.body_count(); ++b) most = std::max(most, storey_in(model.groups_of(b)));
  return most;
}

std::span<const Property<ModelBox>> finding_properties() {
  return model_findings;
}
std::span<const Method> finding_methods() {
  return finding_method_list;
}

std::span<const Property<StoreyHandle>> Kind<StoreyHandle>::properties() {
  return storey_properties;
}
std::span<const Method> Kind<StoreyHandle>::methods() {
  return {};
}
std::string Kind<StoreyHandle>::title(const StoreyHandle& h) {
  return fmt::format("storey {}", h.index + 1);
}
std::span<const std::pair<const char*, lua_CFunction>> Kind<StoreyHandle>::metamethods() {
  return {};
}
bool Kind<StoreyHandle>::read_item(lua_State*, const StoreyHandle&) {
  return false;
}

}  // namespace trilith::script
