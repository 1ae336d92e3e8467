-- The module alone, for LuaRocks: `luarocks --lua-version 5.4 make lua/trilith-scm-1.rockspec` at the root of the tree.
-- It is built from this tree, so that it has the tree's version; libraries come from Debian (docs/guide/install.md).
rockspec_format = "3.0"
package = "trilith"
version = "scm-1"
source = { url = "git+file://." }
description = {
  summary = "Simulates structures of separate bodies, through an earthquake to collapse",
  detailed = [[
    Masonry, bridges on bearings, arches and columns are simulated from rest through an earthquake to collapse.
    Models are Lua scripts; results are one HDF5 file.]],
  license = "MIT",
}
supported_platforms = { "linux" }
dependencies = { "lua ~> 5.4" }
build = {
  type = "cmake",
  variables = {
    CMAKE_BUILD_TYPE = "Release",
    CMAKE_UNITY_BUILD = "ON",
    CMAKE_INSTALL_PREFIX = "$(PREFIX)",
    TRILITH_MODULE_DIR = "$(LIBDIR)",
    TRILITH_MODULE_ONLY = "ON",
    TRILITH_TESTS = "OFF",
  },
}
