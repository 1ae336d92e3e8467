// Beams and frames of models in space as scripts make and read them.
#pragma once

#include "handles.hpp"

namespace trilith::script {

/// m:beam{...} and m:frame{...} on a model in space.
int add_space_beam(lua_State* L);
int add_frame_in_space(lua_State* L);

/// body:forces and body:point of a body in space; argument 2 is the member, or the point or joint.
int push_space_forces(lua_State* L, SpaceModel& m, int body);
int push_space_fibres(lua_State* L, SpaceModel& m, int body);
int push_space_point(lua_State* L, SpaceModel& m, int body);

}  // namespace trilith::script
