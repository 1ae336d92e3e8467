-- A reactivated bearing starts without force at the current position of its points; with from = "start" it counts from
-- its first position. A prop under a beam that has sagged, in the plane and in space.
local trilith = require "trilith"
local near = dofile "near_expected.lua"
local stiffness = 1e11

local function propped(dim)
  local m = trilith.model { name = "prop", dim = dim }
  m:material { name = "c", density = 2400, E = 30e9, nu = 0.2 }
  m:contact { between = { "*", "*" }, law = "none" }
  local function at(x, z) return dim == 2 and { x, z } or { x, 0, z } end
  local ground = dim == 2
    and m:block { name = "ground", width = 12, height = 1, at = { -6, -2 }, material = "c", support = "fixed" }
    or m:block { name = "ground", size = { 12, 1, 1 }, at = { -6, -0.5, -2 }, material = "c", support = "fixed" }
  local hold = dim == 2 and { x = "fixed", y = "fixed" }
    or { x = "fixed", y = "fixed", z = "fixed", rotation_x = "fixed" }
  local hold_too = dim == 2 and { y = "fixed" } or { y = "fixed", z = "fixed" }
  local beam = m:beam { name = "beam", from = at(-5, 0), to = at(5, 0), material = "c", divisions = 4,
    section = trilith.rectangle_section { width = 0.3, depth = 0.5 }, from_support = hold, to_support = hold_too }
  m:bearing { name = "prop", between = { ground, beam }, from = at(0, -1), to = at(0, 0),
    axial = trilith.linear { stiffness = stiffness } }
  return m
end

for _, dim in ipairs { 2, 3 } do
  for _, how in ipairs { "explicit", "implicit", "static" } do
    for _, from in ipairs { "here", "start" } do
      local m = propped(dim)
      m:consolidate { integrator = "static" }
      local prop = m.bearings.prop
      local held = prop.force_axial
      m:remove "prop"
      m:consolidate { integrator = "static" }
      local added = m.energy.added
      if from == "here" then m:put_back "prop" else m:put_back("prop", { from = "start" }) end
      local sagged = -prop.displacement_axial
      local said = table.concat(m.notes, "; ")
      if from == "here" then
        assert(prop.force_axial == 0 and not said:find "at once", said)
      else
        near("force at once", math.abs(prop.force_axial), stiffness*math.abs(sagged), 1e-6)
        assert(said:find("bearing 'prop' acts with ", 1, true) and said:find("weigh", 1, true), said)
      end
      if how == "static" then m:consolidate { integrator = "static" }
      else m:run { duration = 1e-5, integrator = how, dt = how == "implicit" and 1e-5 or nil } end
      local put_in = m.energy.added - added
      if from == "here" then
        assert(math.abs(put_in) < 1e-6, put_in)
        assert(math.abs(prop.force_axial) < 1e-3*math.abs(held))
      else
        near("energy put in", put_in, 0.5*stiffness*sagged^2, 1e-6)
        if how == "static" then near("held as before", prop.force_axial, held, 1e-3) end
      end
      m:close()
    end
  end
end

local m = propped(2)
m:consolidate { integrator = "static" }
m:remove "prop"
local ok, message = pcall(m.put_back, m, "prop", { from = "there" })
assert(not ok and message:find("'from' is 'there', must be one of here, start", 1, true), message)
ok, message = pcall(m.put_back, m, "prop", { at = 1 })
assert(not ok and message:find("unknown key 'at'", 1, true), message)
m:remove "beam"
ok, message = pcall(m.put_back, m, "beam", { from = "start" })
assert(not ok and message:find("'from' is for bearings, and none is put back", 1, true), message)
