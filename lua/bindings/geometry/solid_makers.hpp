// The geometry builders of engine/build/space on a model of a script.
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
/// The rows of build/list.hpp.
std::span<const SolidMaker> solid_makers();

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
