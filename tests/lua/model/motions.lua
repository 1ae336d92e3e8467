-- Ground motion records in scripts: plain columns, filters, rotation, scaling, wave passage.
local trilith = require "trilith"
local function near(value, expected, relative)
  if math.abs(value - expected) > relative*math.abs(expected) then
    error(("%.9g, expected %.9g"):format(value, expected), 2)
  end
end
local function refused(text, f, ...)
  local good, message = pcall(f, ...)
  if good or not message:find(text, 1, true) then error(("not refused with '%s': %s"):format(text, message), 2) end
end

local name = os.tmpname()
local file = assert(io.open(name, "w"))
file:write "made up\n"
for i = 0, 400 do
  file:write(("%.3f %.6f\n"):format(i*0.01, 100*math.sin(2*math.pi*i*0.01)*math.sin(math.pi*i/400)^2))
end
file:close()
local wave = trilith.motion { file = name, unit = "cm/s2" }
near(wave.dt, 0.01, 1e-12)
assert(wave.npts == 401)
near(wave:at(1.75), -math.sin(math.pi*1.75/4)^2, 1e-5)
refused("must be one of g", trilith.motion, { file = name, unit = "stone" })
refused("unit", trilith.motion, { file = name, dt = 0.01 })
refused("give unit", trilith.motion, name)

-- Other columns: by name, by number, after a header, with decimal commas.
local function write(text)
  local f <close> = assert(io.open(name, "w"))
  f:write(text)
end
local rows = {}
for i = 0, 400 do rows[#rows + 1] = ("%.2f;%.6f;%.6f"):format(i*0.01, wave:at(i*0.01), -0.5*wave:at(i*0.01)) end
write("t;ns;ew\n" .. table.concat(rows, "\n"))
refused('column = 2 or column = "ns"', trilith.motion, { file = name, unit = "m/s2" })
refused('column = 2 or column = "ns"', trilith.motion, { file = name, unit = "m/s2", dt = 0.01 })
refused("did you mean 'ew'", trilith.motion, { file = name, unit = "m/s2", column = "we" })
refused("must be a whole number of lines", trilith.motion, { file = name, unit = "m/s2", column = 2, skip = 0.5 })
refused('must be "." or ","', trilith.motion, { file = name, unit = "m/s2", column = 2, decimal = "x" })
refused("'unit'", trilith.motion, { file = name, column = 2 })
near(trilith.motion { file = name, unit = "m/s2", column = "ns" }.pga, wave.pga, 1e-5)
near(trilith.motion { file = name, unit = "m/s2", column = 3, skip = 1 }.pga, 0.5*wave.pga, 1e-5)
write("t;ns;ew\n" .. table.concat(rows, "\n"):gsub("%.", ","))
refused("decimal commas", trilith.motion, { file = name, unit = "m/s2", column = "ew" })
near(trilith.motion { file = name, unit = "m/s2", column = "ew", decimal = "," }.pga, 0.5*wave.pga, 1e-5)
refused("cannot be given with", trilith.motion, { velocity = 1, duration = 1, column = 2 })
os.remove(name)

-- Scaling by the spectrum, and back; a factor of 0 is a control run.
near(wave:scale { sa = 3, period = 0.7 }:sa(0.7), 3, 1e-12)
near(wave:match { spectrum = { { 0.5, 2*wave:sa(0.5) }, { 1, 2*wave:sa(1) } } }.pga, 2*wave.pga, 1e-12)
near(wave:match { spectrum = { { 0.5, 1 }, { 1, 3 } }, from = 0.8 }:sa(1), 3, 1e-12)
assert(wave:scale { factor = 0 }.pga == 0 and wave:scale { pga = 0 }.pga == 0)
refused("give either", wave.scale, wave, { pga = 1, factor = 2 })
refused("are for sa", wave.scale, wave, { pga = 1, period = 2 })
refused("no point", wave.match, wave, { spectrum = { { 0.5, 1 } }, from = 0.8 })

-- A quarter turn makes the second component the first, and the reversed first the second.
local other = wave:scale { factor = 1 }:reverse()
refused("already", wave.rotate, wave, other, 1)
local x, y = wave:rotate(wave, math.pi/2)
near(x:at(1.2), wave:at(1.2), 1e-12)
near(y:at(1.2), -wave:at(1.2), 1e-12)

near(wave:passage { distance = 300, velocity = 600 }:at(2.2), wave:at(1.7), 1e-12)
refused("must be above 0", wave.passage, wave, { distance = 300, velocity = 0 })
assert(wave:resample(0.02).npts == 201)
assert(wave:filter { low = 0.1, high = 20, pad = 1 }.npts == 601)
assert(wave:baseline(2).npts == 401)
refused("must be whole", wave.baseline, wave, 1.5)
refused("below 50 Hz", wave.filter, wave, { high = 80 })

-- Relative motion of two supports: zero for the same motion, twice the displacement for opposite motions.
local together, against = wave:difference(wave), wave:difference(wave:reverse())
assert(together.displacement == 0 and together.velocity == 0)
near(math.abs(against.displacement), 2*wave.pgd, 1e-3)
near(math.abs(against.velocity), 2*wave.pgv, 1e-3)
