// Seepage: water that flows through joints and fissures. Methods of a model.
#pragma once

struct lua_State;

namespace trilith::script {

/// m:seepage{ name =, upper =, lower =, heel = | length =, width =, elevation =, stiffness =, aperture =, divisions =,
/// from =, to =, filled =, density =, viscosity =, bulk_modulus = }: returns its name.
int seepage(lua_State* L);
/// m:seepage_head{ node =, head = | water = }.
int seepage_head(lua_State* L);
/// m:seepage_state(name): a joint, or the network without a name.
int seepage_state(lua_State* L);

}  // namespace trilith::script
