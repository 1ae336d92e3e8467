// Engineering results of a model as scripts read them: storeys, joints, base shear, line of thrust.
#include <algorithm>
#include <cmath>

#include "bindings.hpp"
#include "run/body_forces.hpp"
#include "run/recorded_fields.hpp"
#include "table_fields.hpp"

namespace trilith::script {
namespace {

/// The model, evaluated where it is now, and its findings.
struct Present {
  const Simulation<2>& sim;
  const Findings& findings;
  explicit Present(PlaneModel& m) : sim(m.evaluated()), findings(m.findings()) {}
};

const Storey* find_storey(const Findings& findings, int number) {
  for (const Storey& s : findings.storeys)
    if (s.number == number) return &s;
  return nullptr;
}

double drift_of(const StoreyHandle& h) {
  const Present now(h.plane());
  const Storey* storey = find_storey(now.findings, h.index + 1);
  if (storey == nullptr) return 0;
  return storey_drift(now.sim.model(), now.sim.state(), now.findings.storeys, now.findings.base,
                      static_cast<std::size_t>(storey - now.findings.storeys.data()));
}

double height_of(const StoreyHandle& h) {
  const Storey* storey = find_storey(h.plane().findings(), h.index + 1);
  return storey != nullptr ? storey->height : 0;
}

/// Mean over the bonded joints that `wanted` picks; 0 where there are none.
template <class Wanted>
double mean_damage(PlaneModel& m, Wanted&& wanted) {
  const Present now(m);
  double lost = 0, all = 0;
  for (const Joint& joint : now.findings.joints) {
    if (joint.bonds == 0 || !wanted(now.sim.model(), joint)) continue;
    lost += joint_damage(joint, now.sim.state());
    all += 1;
  }
  return all > 0 ? lost / all : 0;
}

double damage_of(const StoreyHandle& h) {
  return mean_damage(h.plane(),
                     [&](const Model<2>& model, const Joint& joint) { return storey_of(model, joint) == h.index + 1; });
}

template <class Value>
double largest_joint(const ModelBox& box, Value&& value) {
  const Present now(box.plane());
  double most = 0;
  for (const Joint& joint : now.findings.joints) most = std::max(most, value(joint_motion(joint, now.sim.work())));
  return most;
}

double base_shear(const ModelBox& box) {
  const Present now(box.plane());
  return force_on(now.sim.model(), now.sim.work(), now.findings.base).x();
}

double drift_of_top(const ModelBox& box) {
  const Present now(box.plane());
  return top_drift(now.sim.model(), now.sim.state(), now.findings.storeys, now.findings.base);
}

using FindingProperty = Property<ModelBox>;
const std::array model_findings{
    FindingProperty{"base_shear", "N",
                    "horizontal force of contacts and bearings on the base (group base, or what cannot move)",
                    base_shear},
    FindingProperty{"top_drift", "m", "horizontal displacement of the topmost storey against the base", drift_of_top},
    FindingProperty{
        "damage", "1", "part of all bonds that is lost",
        [](const ModelBox& box) { return mean_damage(box.plane(), [](const auto&, const auto&) { return true; }); }},
    FindingProperty{
        "largest_opening", "m", "of all joints since the start",
        [](const ModelBox& box) { return largest_joint(box, [](const JointMotion& j) { return j.opening; }); }},
    FindingProperty{
        "largest_slip", "m", "of all joints since the start",
        [](const ModelBox& box) { return largest_joint(box, [](const JointMotion& j) { return std::abs(j.slip); }); }},
};

using S = Property<StoreyHandle>;
const std::array storey_properties{
    S{"number", "1", "its number, from 1 at the bottom", [](const StoreyHandle& h) { return h.index + 1.0; }},
    S{"height", "m", "from the top of the storey below to its own", height_of},
    S{"drift", "m", "horizontal displacement of its top against that of the storey below, or the base", drift_of},
    S{"drift_ratio", "1", "drift over height",
      [](const StoreyHandle& h) { return height_of(h) > 0 ? drift_of(h) / height_of(h) : 0; }},
    S{"damage", "1", "part of its bonds that is lost", damage_of},
};

void push_joint(lua_State* L, const Present& now, const Joint& joint) {
  const JointMotion motion = joint_motion(joint, now.sim.work());
  const auto ends = joint_place(joint, now.sim.work());
  lua_createtable(L, 0, 8);
  push_body(L, 1, joint.body_a);
  lua_setfield(L, -2, "a");
  push_body(L, 1, joint.body_b);
  lua_setfield(L, -2, "b");
  set_number(L, "opening", motion.opening);
  set_number(L, "slip", motion.slip);
  set_number(L, "storey", storey_of(now.sim.model(), joint));
  set_number(L, "x", 0.5 * (ends[0].x() + ends[1].x()));
  set_number(L, "y", 0.5 * (ends[0].y() + ends[1].y()));
  if (joint.bonds != 0) set_number(L, "damage", joint_damage(joint, now.sim.state()));
}

/// m:joints(): all that were there at the start; `damage` only of those with a bond.
int joints(lua_State* L) {
  const Present now(this_plane(L));
  lua_newtable(L);
  lua_Integer count = 0;
  for (const Joint& joint : now.findings.joints) {
    push_joint(L, now, joint);
    lua_rawseti(L, -2, ++count);
  }
  return 1;
}

/// m:thrust_line(bodies): in their order, which for a set is that in which they were made.
int thrust(lua_State* L) {
  PlaneModel& m = this_plane(L);
  const std::vector<int> chain = bodies_at(L, 2, m, "thrust_line");
  const Simulation<2>& sim = m.evaluated();
  std::vector<TouchingContact> touching;
  contact_resultants(sim.model(), sim.work(), touching);
  lua_newtable(L);
  lua_Integer count = 0;
  for (const ThrustPoint& p : thrust_line(chain, touching)) {
    lua_createtable(L, 0, 6);
    push_body(L, 1, p.body_a);
    lua_setfield(L, -2, "a");
    push_body(L, 1, p.body_b);
    lua_setfield(L, -2, "b");
    set_number(L, "x", p.point.x());
    set_number(L, "y", p.point.y());
    set_number(L, "fx", p.force.x());
    set_number(L, "fy", p.force.y());
    lua_rawseti(L, -2, ++count);
  }
  return 1;
}

/// m:stresses(): mean stress of each free body.
int stresses(lua_State* L) {
  PlaneModel& m = this_plane(L);
  const Simulation<2>& sim = m.evaluated();
  std::vector<TouchingContact> touching;
  contact_resultants(sim.model(), sim.work(), touching);
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
    Method{"joints", guarded<joints>, "joints(): list of {a, b, opening, slip, damage, storey, x, y}", 2},
    Method{"thrust_line", guarded<thrust>, "thrust_line(bodies): list of {a, b, x, y, fx, fy} through a chain", 2},
    Method{"stresses", guarded<stresses>, "stresses(): mean stress {xx, yy, xy, major, minor} by body's name [Pa]", 2},
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
