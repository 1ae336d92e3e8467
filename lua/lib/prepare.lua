-- Preparation of a Lua state before the script runs: its folder for require, text chunks only, and errors for
-- undeclared globals. The globals of this file belong to the library, _G contains the script's.
local trilith, folder = ...

package.loaded.trilith = trilith
-- The script's table `package` and the library's are separate; `require` uses the first.
local scripts_package = rawget(_G, "package")
scripts_package.path = folder .. "/?.lua;" .. folder .. "/?/init.lua"
package.path = scripts_package.path

-- A binary chunk can crash the interpreter, so only text is loaded. Loaded chunks see the script's globals.
local load_chunk, load_file, G = load, loadfile, _G
function G.load(chunk, name, _, ...) return load_chunk(chunk, name, "t", ...) end
function G.loadfile(file, _, ...) return load_file(file, "t", ...) end
function G.dofile(file)
  local chunk, message = load_file(file, "t")
  if not chunk then error(message, 0) end
  return chunk()
end
scripts_package.searchers[2] = function(name)
  local file, tried = package.searchpath(name, scripts_package.path)
  if not file then return tried end
  local chunk, message = load_file(file, "t")
  if not chunk then error(message, 0) end
  return chunk, file
end

local function is_main_or_c(level)
  local info = debug.getinfo(level + 1, "S")
  return not info or info.what == "main" or info.what == "C"
end

setmetatable(_G, {
  __index = function(_, name)
    error(("there is no global '%s'; check its spelling, or declare it with local"):format(tostring(name)), 2)
  end,
  __newindex = function(globals, name, value)
    if not is_main_or_c(2) then
      error(("global '%s' is set first within a function; declare it with local"):format(tostring(name)), 2)
    end
    rawset(globals, name, value)
  end,
})
