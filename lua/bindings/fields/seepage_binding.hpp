// Seepage: water that flows through joints and fissures. Methods of a model.
#pragma once

#include <string>

#include "run/stage.hpp"

struct lua_State;

namespace trilith::script {

class ScriptModel;

/// m:seepage{ name =, upper =, lower =, heel = | length =, width =, elevation =, stiffness =, aperture =, divisions =,
/// from =, to =, filled =, density =, viscosity =, bulk_modulus = }: returns its name.
int seepage(lua_State* L);
/// m:seepage_head{ node =, head = | water = }.
int seepage_head(lua_State* L);
/// m:seepage_motion{ flows = }.
int seepage_motion(lua_State* L);
/// Text for the user where the water of a model with seepage is held in a stage of motion; empty where it flows.
std::string held_water_note(ScriptModel& m, const StageOptions& o);
/// m:seepage_state(name): a joint, or the network without a name.
int seepage_state(lua_State* L);

}  // namespace trilith::script
