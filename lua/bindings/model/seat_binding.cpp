// Seats: ends of bodies on edges of supports.
#include "bindings/core/bindings.hpp"
#include "bindings/laws/bearing_reading.hpp"
#include "events/find_events.hpp"

namespace trilith::script {
namespace {

Vec2 read_place(Keys& keys, std::string_view key, const SeatSpecOf<2>& /*spec*/) {
  return keys.point(key);
}
Vec3 read_place(Keys& keys, std::string_view key, const SeatSpecOf<3>& /*spec*/) {
  return keys.vector(key);
}

/// Horizontal direction from the edge towards the end that lies beyond it. A problem is noted if it is zero.
template <int D>
Vec<D> inward_of(Keys& keys, const SeatSpecOf<D>& spec) {
  Vec<D> way = spec.end - spec.edge;
  way[D - 1] = 0;
  if (way.norm() > 0) return way.normalized();
  keys.problem(
      "'at_end' is over the edge, so 'inward' does not follow from them; give inward, from the edge over the seat");
  return Vec<D>::UnitX();
}

/// A seat that is lost before anything moves has a wrong direction or wrong points.
template <int D>
void check_length(Keys& keys, const SeatSpecOf<D>& spec) {
  const double length = spec.inward.norm() > 0 ? (spec.end - spec.edge).dot(spec.inward.normalized()) : 0;
  if (length < 0)
    keys.problem(
        fmt::format("'at_end' lies {:g} m beyond the edge, so the seat is lost at the start; 'inward' points from the "
                    "edge over the seat: reverse it, or leave it out",
                    -length));
}

template <int D, class M>
void add_seat_to(lua_State* L, M& m) {
  m.adding();
  Keys keys(L, 2, "seat");
  SeatSpecOf<D> spec;
  spec.name = keys.text("name");
  keys.name_owner(spec.name);
  spec.body = body_name(keys, "body", m);
  spec.support = body_name(keys, "support", m);
  spec.end = read_place(keys, "at_end", spec);
  spec.edge = read_place(keys, "edge", spec);
  const bool given = keys.has("inward");
  if (given) spec.inward = read_place(keys, "inward", spec);
  keys.finish();
  if (!given) spec.inward = inward_of(keys, spec);
  check_length(keys, spec);
  keys.finish();
  m.builder.add_seat(spec);
  m.seats.push_back(spec.name);
  m.catch_up();
}

const std::string& name_of_seat(const SeatHandle& s) {
  return s.model().seats[static_cast<std::size_t>(s.index)];
}

template <int D>
double length_in(SimulatedModel<D>& m, const SeatHandle& s) {
  const Simulation<D>& sim = m.simulation();
  return seat_length(sim.model(), sim.state(), sim.model().seats[static_cast<std::size_t>(s.index)]);
}
double length_of(const SeatHandle& s) {
  if (SpaceModel* space = as_space(s.model())) return length_in<3>(*space, s);
  return length_in<2>(s.plane(), s);
}
void push_lost(lua_State* L, const SeatHandle& s) {
  const auto row = static_cast<std::size_t>(s.index);
  SpaceModel* space = as_space(s.model());
  lua_pushboolean(
      L, space != nullptr ? space->simulation().state().seat_lost[row] : s.plane().simulation().state().seat_lost[row]);
}

using SeatProperty = Property<SeatHandle>;
const std::array seat_properties{
    SeatProperty{"name", "", "its name", nullptr,
                 [](lua_State* L, const SeatHandle& s) { lua_pushstring(L, name_of_seat(s).c_str()); }},
    SeatProperty{"length", "m", "remaining length of the end over the edge", length_of},
    SeatProperty{"lost", "", "true once the end has left its seat", nullptr, push_lost},
};

}  // namespace

int add_seat(lua_State* L) {
  ScriptModel& m = this_model(L);
  if (SpaceModel* space = as_space(m))
    add_seat_to<3>(L, *space);
  else
    add_seat_to<2>(L, *as_plane(m));
  push_seat(L, 1, static_cast<int>(m.seats.size()) - 1);
  return 1;
}

std::span<const Property<SeatHandle>> Kind<SeatHandle>::properties() {
  return seat_properties;
}
std::span<const Method> Kind<SeatHandle>::methods() {
  return {};
}
std::string Kind<SeatHandle>::title(const SeatHandle& s) {
  return s.open() ? fmt::format("seat '{}'", name_of_seat(s)) : "seat of a closed model";
}
std::span<const std::pair<const char*, lua_CFunction>> Kind<SeatHandle>::metamethods() {
  return {};
}
bool Kind<SeatHandle>::read_item(lua_State*, const SeatHandle&) {
  return false;
}

}  // namespace trilith::script
