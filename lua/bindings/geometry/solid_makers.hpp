// The geometry builders of solids as scripts call them on a model in space: one row each, read from one table.
#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "bindings/core/handles.hpp"
#include "build/space/solid_part.hpp"

namespace trilith::script {

/// Makes the parts; to be called after Keys::finish.
using MakeSolids = std::function<SolidParts()>;

struct SolidMaker {
  std::string_view name;
  bool single;  ///< one part, always
  MakeSolids (*read)(Keys&);
  lua_CFunction add;  ///< m:NAME{...}
  std::string_view doc;
  bool falls = false;  ///< what it makes may start with nothing that holds it up
};
std::span<const SolidMaker> solid_makers();

/// turn = { axis = {x, y, z}, angle = }; none where it is not there.
SolidTurn read_turn(Keys& k);

// Readers that lie in solid_masonry_makers.cpp.
MakeSolids read_solid_wall(Keys& k);
MakeSolids read_building(Keys& k);
MakeSolids read_vault(Keys& k);
MakeSolids read_cross_vault(Keys& k);
MakeSolids read_dome(Keys& k);
MakeSolids read_solid_rubble(Keys& k);

// Readers that lie in sphere_makers.cpp.
MakeSolids read_sphere(Keys& k);
MakeSolids read_clump(Keys& k);
MakeSolids read_pour(Keys& k);
/// turn = { axis = {x, y, z}, angle = }.
SolidTurn read_turn(Keys& k);

/// `body`: "rigid", "brick" or { mesh = {nx, ny, nz}, element = }; `preset` where it is not there.
SpaceForm read_space_form(Keys& keys, const SpaceForm& preset);
/// "fixed", "free" or { x =, y =, z =, turn_x =, turn_y =, turn_z = } under `key`.
void read_solid_support(Keys& keys, std::string_view key, std::array<Support, 6>& support);
/// What `keys` say of a solid or a frame besides name and shape; `preset` where they say nothing.
SolidSpec read_solid_spec(Keys& keys, const SolidSpec& preset);

/// m:NAME{...} on a model in space: the parts of the maker of that name become bodies. InputError where there is none.
int add_solids_made(lua_State* L, std::string_view name);
/// m:body{ name =, hull = | pieces = , ... } and m:add(parts, { depth =, ... }) on a model in space.
int make_solid_body(lua_State* L);
int add_solid_parts(lua_State* L);

}  // namespace trilith::script
