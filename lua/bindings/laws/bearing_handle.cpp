// The properties of a bearing that a script reads: status, bodies, forces and displacements.
#include <algorithm>
#include <cmath>

#include "assembly/bearing_motion.hpp"
#include "bindings/core/bindings.hpp"
#include "model/pose.hpp"

namespace trilith::script {
namespace {

/// Parts that a handler adds enter the model at the next step border.
void require_there(std::size_t count, std::size_t row, const std::string& title) {
  if (row >= count) throw InputError(title + " is added at the next step border");
}

/// A bearing in its present state, in a model of D dimensions.
template <int D>
struct LiveBearing {
  const Model<D>& model;
  const State<D>& state;
  const Work<D>& work;
  std::size_t row;

  [[nodiscard]] const Bearing<D>& bearing() const { return model.bearings[row]; }
  [[nodiscard]] bool carries() const { return is_live(state.bearing[row].status); }
  [[nodiscard]] double force(std::size_t k) const {
    const DirectionMemory& memory = work.bearing[row].direction[k];
    return carries() ? memory.force + memory.damping : 0;
  }
};

template <int D>
LiveBearing<D> live_in(SimulatedModel<D>& m, const BearingHandle& b) {
  const Simulation<D>& s = m.evaluated();
  require_there(s.model().bearings.size(), static_cast<std::size_t>(b.index), Kind<BearingHandle>::title(b));
  return {s.model(), s.state(), s.work(), static_cast<std::size_t>(b.index)};
}

/// f(LiveBearing) for the dimension of its model.
template <class F>
auto with_live(const BearingHandle& b, F&& f) {
  if (SpaceModel* space = as_space(b.model())) return f(live_in<3>(*space, b));
  return f(live_in<2>(b.plane(), b));
}

std::array<double, 3> displacements(const LiveBearing<2>& l) {
  const Bearing<2>& b = l.bearing();
  const Pose p = pose_at(l.model, l.state, b.end_a), q = pose_at(l.model, l.state, b.end_b);
  const Vec2 d = Turn(p.rotation + b.angle).undo(Vec2(q.place - p.place)) - b.rest;
  return {d.x(), d.y(), q.rotation - p.rotation - b.rest_angle};
}
std::array<double, 6> displacements(const LiveBearing<3>& l) {
  return bearing_motion(l.model, l.state, l.row).displacement;
}

/// Largest displacement over its limit, of all directions.
double share_of(const BearingHandle& b) {
  return with_live(b, []<int D>(const LiveBearing<D>& l) {
    const auto d = bearing_motion(l.model, l.state, l.row).counted(l.state.bearing[l.row]);
    const auto share = [](double size, double limit) { return std::isfinite(limit) ? std::abs(size) / limit : 0.0; };
    double most = 0;
    for (std::size_t k = 0; k < d.size(); ++k) most = std::max(most, share(d[k], l.bearing().limit[k]));
    if constexpr (D == 3) most = std::max(most, share(portable::hypot(d[0], d[1]), l.bearing().horizontal_limit));
    return most;
  });
}

bool is_limited(const BearingHandle& b) {
  return with_live(b, []<int D>(const LiveBearing<D>& l) {
    const auto& limit = l.bearing().limit;
    bool any = std::any_of(limit.begin(), limit.end(), [](double v) { return std::isfinite(v); });
    if constexpr (D == 3) any = any || std::isfinite(l.bearing().horizontal_limit);
    return any;
  });
}

// Directions by their index in the plane and in space.

/// The index in D dimensions.
template <int D, std::size_t in_plane, std::size_t in_space>
constexpr std::size_t direction_in() {
  if constexpr (D == 2)
    return in_plane;
  else
    return in_space;
}

template <std::size_t in_plane, std::size_t in_space>
double force(const BearingHandle& b) {
  return with_live(b, []<int D>(const LiveBearing<D>& l) { return l.force(direction_in<D, in_plane, in_space>()); });
}
template <std::size_t in_plane, std::size_t in_space>
double displacement(const BearingHandle& b) {
  return with_live(
      b, []<int D>(const LiveBearing<D>& l) { return displacements(l)[direction_in<D, in_plane, in_space>()]; });
}
/// Value of a direction that only models in space have.
template <std::size_t k>
double force_in_space(const BearingHandle& b) {
  return force<0, k>(b);
}
template <std::size_t k>
double displacement_in_space(const BearingHandle& b) {
  return displacement<0, k>(b);
}
double resultant_force(const BearingHandle& b) {
  return portable::hypot(force_in_space<0>(b), force_in_space<1>(b));
}
double resultant_displacement(const BearingHandle& b) {
  return portable::hypot(displacement_in_space<0>(b), displacement_in_space<1>(b));
}

template <bool forces>
void push_directions(lua_State* L, const BearingHandle& b) {
  with_live(b, [&]<int D>(const LiveBearing<D>& l) {
    const auto d = displacements(l);
    lua_createtable(L, 0, static_cast<int>(d.size()));
    for (std::size_t k = 0; k < d.size(); ++k) {
      lua_pushnumber(L, forces ? l.force(k) : d[k]);
      lua_setfield(L, -2, Directions<D>::names[k]);
    }
  });
}

const std::string& name_of_row(const BearingHandle& b) {
  return b.model().bearings[static_cast<std::size_t>(b.index)];
}

void push_bodies(lua_State* L, const BearingHandle& b) {
  const auto [first, second] =
      with_live(b, [](const auto& l) { return std::pair(l.bearing().body_a, l.bearing().body_b); });
  lua_getiuservalue(L, 1, 1);
  const int model = lua_gettop(L);
  lua_createtable(L, 2, 0);
  push_body(L, model, first);
  lua_rawseti(L, -2, 1);
  push_body(L, model, second);
  lua_rawseti(L, -2, 2);
}

void push_status(lua_State* L, const BearingHandle& b) {
  lua_pushstring(L, name_of(with_live(b, [](const auto& l) { return l.state.bearing[l.row].status; })));
}

using BearingProperty = Property<BearingHandle>;
constexpr BearingProperty in_dimension(int dim, BearingProperty p) {
  p.dim = dim;
  return p;
}
const std::array bearing_properties{
    BearingProperty{"name", "", "its name", nullptr,
                    [](lua_State* L, const BearingHandle& b) { lua_pushstring(L, name_of_row(b).c_str()); }},
    BearingProperty{"status", "", "waiting, intact, yielded, failed, changed or removed", nullptr, push_status},
    BearingProperty{"bodies", "", "the two bodies it links", nullptr, push_bodies},
    BearingProperty{"force", "",
                    "forces and moments of its laws [N, N m]: { along, axial, turning }, in space { along, across, "
                    "axial, turning_along, turning_across, turning_axial }",
                    nullptr, push_directions<true>},
    BearingProperty{"displacement", "", "displacements and rotations since it was placed [m, rad], likewise", nullptr,
                    push_directions<false>},
    BearingProperty{"force_along", "N", "force of the law along", force<along, 0>},
    in_dimension(3, {"force_across", "N", "force of the law across", force_in_space<1>}),
    BearingProperty{"force_axial", "N", "force of the axial law", force<axial, 2>},
    in_dimension(3, {"force_horizontal", "N", "resultant of the forces along and across", resultant_force}),
    in_dimension(2, {"moment", "N m", "moment of the law of turning", force<turning, 0>}),
    in_dimension(3, {"moment_along", "N m", "moment of the law of turning about along", force_in_space<3>}),
    in_dimension(3, {"moment_across", "N m", "moment of the law of turning about across", force_in_space<4>}),
    in_dimension(3, {"moment_axial", "N m", "moment of the law of turning about axial", force_in_space<5>}),
    BearingProperty{"displacement_along", "m", "displacement along", displacement<along, 0>},
    in_dimension(3, {"displacement_across", "m", "displacement across", displacement_in_space<1>}),
    BearingProperty{"displacement_axial", "m", "axial displacement", displacement<axial, 2>},
    in_dimension(
        3, {"displacement_horizontal", "m", "resultant of the displacements along and across", resultant_displacement}),
    in_dimension(2, {"turning", "rad", "rotation of the second body against the first", displacement<turning, 0>}),
    in_dimension(
        3, {"turning_along", "rad", "turn of the second body against the first about along", displacement_in_space<3>}),
    in_dimension(3, {"turning_across", "rad", "... about across", displacement_in_space<4>}),
    in_dimension(3, {"turning_axial", "rad", "... about axial", displacement_in_space<5>}),
    BearingProperty{"limited", "", "true if a displacement has a limit", nullptr,
                    [](lua_State* L, const BearingHandle& b) { lua_pushboolean(L, is_limited(b) ? 1 : 0); }},
    BearingProperty{"share", "1", "largest displacement over its limit", share_of},
};

}  // namespace

std::span<const Property<BearingHandle>> Kind<BearingHandle>::properties() {
  return bearing_properties;
}
std::span<const Method> Kind<BearingHandle>::methods() {
  return {};
}
std::string Kind<BearingHandle>::title(const BearingHandle& b) {
  return b.open() ? fmt::format("bearing '{}'", name_of_row(b)) : "bearing of a closed model";
}
std::span<const std::pair<const char*, lua_CFunction>> Kind<BearingHandle>::metamethods() {
  return {};
}
bool Kind<BearingHandle>::read_item(lua_State*, const BearingHandle&) {
  return false;
}

}  // namespace trilith::script
