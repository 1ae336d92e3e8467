// The Lua C API. Debian's headers give it C linkage in C++ too. So the same objects serve the program (liblua5.4-c++,
// where a Lua error is a C++ exception) and the module (stock lua5.4, where it is a longjmp).
#pragma once

#include <lauxlib.h>
#include <lua.h>
#include <lualib.h>
