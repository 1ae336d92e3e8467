// Reactions of supports: body:reactions and body.reaction_x, ...
#include "bindings/readings/reaction_binding.hpp"

#include <array>

#include "bindings/core/bindings.hpp"
#include "bindings/core/table_fields.hpp"
#include "bindings/model/built_model.hpp"
#include "readings/reactions.hpp"

namespace trilith::script {
namespace {

template <int D>
std::vector<Reaction<D>> reactions_now(SimulatedModel<D>& m, int body) {
  const Simulation<D>& s = m.evaluated();
  return m.has_body(body) ? reactions(s.model(), s.state(), s.work(), body) : std::vector<Reaction<D>>{};
}

template <int D>
double sum_along(SimulatedModel<D>& m, int body, int axis) {
  double sum = 0;
  for (const Reaction<D>& r : reactions_now(m, body)) sum += r.force[axis];
  return sum;
}

void set_moment(lua_State* L, double moment) {
  set_number(L, "m", moment);
}
void set_moment(lua_State* L, const Vec3& moment) {
  set_number(L, "mx", moment.x());
  set_number(L, "my", moment.y());
  set_number(L, "mz", moment.z());
}

template <int D>
int push_list(lua_State* L, const std::vector<Reaction<D>>& list) {
  constexpr std::array places{"x", "y", "z"}, forces{"fx", "fy", "fz"};
  lua_newtable(L);
  lua_Integer count = 0;
  for (const Reaction<D>& r : list) {
    lua_createtable(L, 0, 3 * D);
    for (int k = 0; k < D; ++k) {
      set_number(L, places[static_cast<std::size_t>(k)], r.place[k]);
      set_number(L, forces[static_cast<std::size_t>(k)], r.force[k]);
    }
    set_moment(L, r.moment);
    lua_rawseti(L, -2, ++count);
  }
  return 1;
}

}  // namespace

int push_body_reactions(lua_State* L) {
  const auto& b = handle<BodyHandle>(L, 1);
  require_readable(b, "reactions");
  if (SpaceModel* space = as_space(b.model())) return push_list(L, reactions_now(*space, b.index));
  return push_list(L, reactions_now(require_plane(b.model(), "reactions"), b.index));
}

double reaction_along(const BodyHandle& b, int axis) {
  if (SpaceModel* space = as_space(b.model())) return sum_along(*space, b.index, axis);
  return sum_along(require_plane(b.model(), "reaction"), b.index, axis);
}

}  // namespace trilith::script
