-- A frame of 2,000 beams under implicit steps: a grid of 20 storeys and 20 bays on fixed feet, shaken at 1 Hz.
--
-- `trilith run tests/bench/frame.lua` prints the seconds of statics, of modes and of a step.
local trilith = require "trilith"
local p = trilith.params { storeys = { 20, "storeys" }, bays = { 20, "bays" }, steps = { 20, "implicit steps" },
                           dt = { 0.005, unit = "s", "of a step" },
                           mass_matrix = { "lumped", choices = { "lumped", "consistent" } } }
local m = trilith.model { name = "frame of 2,000 beams", thickness = 1 }
m:material { name = "steel", density = 7850, E = 2.1e11, nu = 0.3 }
local column = trilith.rectangle_section { width = 0.4, depth = 0.4 }
local girder = trilith.rectangle_section { width = 0.3, depth = 0.5 }
local joints, members = {}, {}
local function name(i, j) return ("j%02d_%02d"):format(j, i) end
for j = 0, p.storeys do
  for i = 0, p.bays do joints[name(i, j)] = { at = { 6*i, 3.5*j }, support = j == 0 and "fixed" or nil } end
end
local function member(a, b, section, divisions)
  members[#members + 1] = { from = a, to = b, section = section, divisions = divisions }
end
for j = 1, p.storeys do
  for i = 0, p.bays do member(name(i, j - 1), name(i, j), column, 2) end
  for i = 1, p.bays do member(name(i - 1, j), name(i, j), girder, 3) end
end
local frame = m:frame { name = "frame", material = "steel", floating = true, mass_matrix = p.mass_matrix,
                        joints = joints, members = members }
local beams = p.storeys*(2*(p.bays + 1) + 3*p.bays)
local samples = {}
for k = 0, 200 do samples[k + 1] = 2*math.cos(2*math.pi*k/100) end
local began = os.clock()
m:consolidate { integrator = "static" }
print(("statics of %d beams: %.2f s"):format(beams, os.clock() - began))
began = os.clock()
local modes = m:modes { count = 3 }
print(("three modes (%.3f Hz the first): %.2f s"):format(modes[1].frequency, os.clock() - began))
local motion = trilith.motion { acceleration = samples, dt = 0.01 }
began = os.clock()
local before = m.steps
m:shake { body = frame, x = motion, duration = p.steps*p.dt, integrator = "implicit", dt = p.dt }
local steps = m.steps - before
print(("%d implicit steps of %d beams: %.3f s a step"):format(steps, beams, (os.clock() - began)/steps))
