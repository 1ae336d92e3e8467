// Keys that several kinds of stages have.
#pragma once

#include <initializer_list>
#include <string_view>

#include "bindings/core/handles.hpp"
#include "bindings/core/keys.hpp"

namespace trilith::script {

/// `rest`: true or a table of the rest criterion { speed =, ratio =, hold =, from = }. True if given and not false.
bool read_rest_table(Keys& keys, StageOptions& o);
/// dt, safety and watch.
void read_step(Keys& keys, StageOptions& o);
/// Rejects keys that have no meaning unless the stage's integrator is `of`.
void refuse(Keys& keys, std::initializer_list<const char*> names, std::string_view of);
/// Replaces a nil argument by an empty table.
void read_nothing_for_nil(lua_State* L);

/// m:consolidate{...}: runs the stage and pushes its report.
int push_consolidation(lua_State* L);

}  // namespace trilith::script
