// The geometry builders in space on a model of a script: one row each, read from one table.
#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "bindings/core/handles.hpp"
#include "build/space/solid_part.hpp"

namespace trilith::script {

/// Makes the parts; call it after Keys::finish.
using MakeSolids = std::function<SolidParts()>;

struct SolidMaker {
  std::string_view name;
  bool single;  ///< always one part
  MakeSolids (*read)(Keys&);
  lua_CFunction add;   ///< m:NAME{...}
  bool falls = false;  ///< its parts may start without support
};
std::span<const SolidMaker> solid_makers();

/// turn = { axis = {x, y, z}, angle = }; none if not given.
SolidTurn read_turn(Keys& k);

// Readers in solid_masonry_makers.cpp.
MakeSolids read_solid_wall(Keys& k);
MakeSolids read_building(Keys& k);
MakeSolids read_vault(Keys& k);
MakeSolids read_cross_vault(Keys& k);
MakeSolids read_dome(Keys& k);
MakeSolids read_solid_rubble(Keys& k);

// Readers in sphere_makers.cpp.
MakeSolids read_sphere(Keys& k);
MakeSolids read_clump(Keys& k);
MakeSolids read_pour(Keys& k);
/// turn = { axis = {x, y, z}, angle = }.
SolidTurn read_turn(Keys& k);

/// `body`: "rigid", "brick" or { mesh = {nx, ny, nz}, element = }; `preset` if not given.
SpaceForm read_space_form(Keys& keys, const SpaceForm& preset);
/// "fixed", "free" or { x =, y =, z =, turn_x =, turn_y =, turn_z = } under `key`.
void read_solid_support(Keys& keys, std::string_view key, std::array<Support, 6>& support);
/// Options of a solid or a frame except name and shape, from `keys`; `preset` for missing ones.
SolidSpec read_solid_spec(Keys& keys, const SolidSpec& preset);

/// m:NAME{...} on a model in space: the parts of the maker of that name become bodies. InputError if there is none.
int add_solids_made(lua_State* L, std::string_view name);
/// m:body{ name =, hull = | pieces = , ... } and m:add(parts, { depth =, ... }) on a model in space.
int make_solid_body(lua_State* L);
int add_solid_parts(lua_State* L);

}  // namespace trilith::script
