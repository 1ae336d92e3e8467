-- A wall of one leaf between a fixed base and a stiff beam, loaded by N and pushed sideways at the beam.
local trilith = require "trilith"

local W = {}

-- One unit. A whole unit has a plane across its middle on which it may crack, where there is a law for that.
local function add_unit(m, s, course, number, x0, x1)
  local may_crack = s.crack and x1 - x0 > 0.75*s.unit_width
  m:block { name = ("c%d.u%d"):format(course, number), width = x1 - x0, height = s.unit_height,
    at = { x0, (course - 1)*s.unit_height }, material = "units", groups = "units",
    mass = (s.mass_factor or 1)*s.density*(x1 - x0)*s.unit_height*s.thickness,
    cracks = may_crack and (s.crack_planes or "mid") or nil, crack_law = may_crack and "unit" or nil }
end

-- Pieces [from, to] of a course outside its openings.
local function clear_pieces(s, course, x0, x1)
  for _, o in ipairs(s.openings or {}) do
    if course >= o.first_course and course <= o.last_course and x0 < o.to - 1e-9 and x1 > o.from + 1e-9 then
      local pieces = {}
      if x0 < o.from - 1e-9 then pieces[#pieces + 1] = { x0, o.from } end
      if x1 > o.to + 1e-9 then pieces[#pieces + 1] = { o.to, x1 } end
      return pieces
    end
  end
  return { { x0, x1 } }
end

-- Running bond on a length that need not be a multiple of the unit: every second course begins with a half unit.
local function add_courses(m, s)
  for course = 1, s.courses do
    local half = (course % 2 == 0) == (s.half_courses ~= "odd")
    local x, number = 0, 0
    while x < s.length - 1e-9 do
      local to = x + (x == 0 and half and s.unit_width/2 or s.unit_width)
      if s.length - to < 0.2*s.unit_width then to = s.length end -- no slivers
      to = math.min(to, s.length)
      for _, piece in ipairs(clear_pieces(s, course, x, to)) do
        number = number + 1
        add_unit(m, s, course, number, piece[1], piece[2])
      end
      x = to
    end
  end
end

-- The law of cracks is stated first, so that later statements replace it between units.
local function add_laws(m, s)
  if s.crack then m:contact { between = { "*", "*" }, law = s.crack, name = "unit" } end
  m:contact { between = { "*", "*" }, law = s.joint, name = "joint" }
  m:contact { between = { "ends", "*" }, law = s.ends or s.joint, name = "ends" }
end

--- Builds the wall and brings it to rest under its weight and N. The table s has length, courses, unit_width,
--- unit_height, thickness [m], density [kg/m3], vertical (N) [N] and beam_height [m]. `joint`, `ends` and `crack` are
--- the laws of joints, of the joints to base and beam, and of cracks in units. `top` is "cantilever", "double fixed" or
--- "locked". `openings` is a list of { from, to [m], first_course, last_course }. `mass_factor` multiplies the masses
--- and divides gravity: weights stay, and steps become longer. `control` "arc" uses statics, for units without cracks.
function W.build(s)
  local more = s.mass_factor or 1
  local m = trilith.model { name = s.name or "wall", thickness = s.thickness, gravity = 9.80665/more, threads = 1 }
  m:material { name = "units", density = s.density }
  m:material { name = "ends", density = 7850 }
  add_laws(m, s)
  add_courses(m, s)
  local height = s.courses*s.unit_height
  local base = m:block { name = "base", width = s.length + 0.4, height = 0.1, at = { -0.2, -0.1 }, material = "ends",
    support = "fixed" }
  local beam_mass = 100*more
  local beam = m:block { name = "beam", width = s.length, height = s.beam_height or 0.2, at = { 0, height },
    material = "ends", mass = beam_mass, support = s.top ~= "cantilever" and { rotation = "fixed" } or nil }
  if s.file then m:results { file = s.file, frames = s.frames or 1, histories = 0.1 } end
  local statics = s.control == "arc"
  m:point_load { body = beam, force = { 0, -(s.vertical - 100*9.80665) },
    load_curve = not statics and { smooth = 0.2 } or nil }
  m:consolidate(statics and { integrator = "static" }
    or { grow = 0.2, rest = { ratio = s.rest or 1e-4 }, duration = 20 })
  return m, beam, base
end

-- Force of a curve at a displacement, between its points.
function W.force_at(curve, displacement)
  local d, f = curve.displacement, curve.force
  for i = 2, #d do
    if d[i] >= displacement then
      return f[i - 1] + (f[i] - f[i - 1])*(displacement - d[i - 1])/math.max(d[i] - d[i - 1], 1e-12)
    end
  end
  return 0/0
end

-- Joints by kind: cracks within a unit, head joints, and bed joints by their level.
local function kinds_of(m)
  local kinds = { crack = {}, head = {}, bed = {} }
  for _, j in ipairs(m:joints()) do
    local course_a, unit_a = j.a.name:match "^c(%d+)%.(u%d+)"
    local course_b, unit_b = j.b.name:match "^c(%d+)%.(u%d+)"
    local kind = "bed"
    if course_a and course_a == course_b then kind = unit_a == unit_b and "crack" or "head" end
    table.insert(kinds[kind], j)
  end
  return kinds
end

local function largest(joints, key)
  local most = 0
  for _, j in ipairs(joints) do most = math.max(most, math.abs(j[key])) end
  return most
end

-- Rotation that a fifth of the units exceed, times the height of the top, over its drift: 1 where a part rocks.
local function rocking_share(m, drift, height)
  local rotations = {}
  for body in m:bodies { group = "units" } do rotations[#rotations + 1] = math.abs(body.rotation) end
  table.sort(rotations)
  return rotations[math.ceil(0.8*#rotations)]*height/drift
end

--- Motion of the joints over the drift of the top: largest openings, and rotation of units.
function W.motion_of_joints(m, drift, height)
  local kinds = kinds_of(m)
  return { bed_opening = largest(kinds.bed, "opening")/drift, rotation = rocking_share(m, drift, height),
    head_opening = largest(kinds.head, "opening")/drift, crack_opening = largest(kinds.crack, "opening")/drift }
end

--- Name of the mechanism: "diagonal through units" where cracks of units open, "sliding" where the units turn by less
--- than half the drift, "stepped rocking" where head joints open too, else "rocking".
function W.mechanism(found)
  if found.crack_opening > 0.15 then return "diagonal through units" end
  if found.rotation < 0.5 then return "sliding" end
  if found.head_opening > 0.25 then return "stepped rocking" end
  return "rocking"
end

-- Counts of the events of a push: joints crushed, halves of bonds broken, units cracked, by mode.
local function count_events(m)
  local n = { crushed = 0, broken = 0, cracked = 0, by_mode = { tension = 0, shear = 0, compression = 0 } }
  m:on("joint.crushed", function() n.crushed = n.crushed + 1 end)
  m:on("bond.broken", function() n.broken = n.broken + 1 end)
  m:on("unit.cracked", function(e)
    n.cracked, n.by_mode[e.mode] = n.cracked + 1, n.by_mode[e.mode] + 1
  end)
  return n
end

-- True at the step at which the force, averaged over about 0.02 s, has fallen to a share of its peak.
local function fallen(m, share)
  local mean, most, last = 0, 0, m.time
  return function()
    local part = math.min(1, (m.time - last)/0.02)
    last, mean = m.time, mean + part*(m.push_force - mean)
    most = math.max(most, mean)
    return mean < share*most
  end
end

-- Integrals over the time of a push [N s]: of its force, and of the reactions: of the base along and across it, and of
-- base and beam across it.
local function integrate_forces(m, base, beam, every, force)
  local all, last, next_one = { { m.time, 0, 0, 0, 0 } }, m.time, m.time
  local pushed, along, across, both = 0, 0, 0, 0
  return all, function()
    local dt, up = m.time - last, base.reaction_y
    last = m.time
    pushed, along = pushed + dt*force(), along + dt*base.reaction_x
    across, both = across + dt*up, both + dt*(up + beam.reaction_y)
    if m.time >= next_one then
      all[#all + 1], next_one = { m.time, pushed, along, across, both }, m.time + every
    end
  end
end

-- Share of inertia and damping [%] between two times. Along the push it is the part of the force that does not reach
-- the base. Across the push it is the part of the base's reaction that exceeds the `load` of weight and N.
local function share_of_inertia(integrals, from, to, load)
  local a, b = integrals[1], integrals[#integrals]
  for _, row in ipairs(integrals) do
    if row[1] <= from then a = row end
    if row[1] >= to then b = row; break end
  end
  local excess = b[5] - a[5] - load*(b[1] - a[1])
  return { along = 100*math.abs(1 + (b[3] - a[3])/(b[2] - a[2])), across = 100*math.abs(excess/(b[4] - a[4])) }
end

-- Displacements [m] at which a cyclic protocol turns: `repeats` (1) cycles of each amplitude, then the last push.
local function turning_points(s)
  local points = {}
  for _, amplitude in ipairs(s.cycles) do
    for _ = 1, s.repeats or 1 do
      points[#points + 1], points[#points + 2] = amplitude, -amplitude
    end
  end
  points[#points + 1] = s.displacement
  return points
end

-- Drives the beam along x through the turning points, at steady speed. The mean force of 0.02 s is recorded, and its
-- envelope over the amplitude: the largest force of both directions.
local function drive_cycles(m, beam, s, integrate)
  local at_rest, curve, peak, at, when = beam.x, { displacement = {}, force = {} }, 0, 0, 0
  local mean, last, fell, before = 0, m.time, false, m.time
  local function read()
    integrate()
    local part = math.min(1, (m.time - last)/0.02)
    last, mean = m.time, mean + part*(beam.reaction_x - mean)
    if m.time - before > 0.01 then
      before = m.time
      curve.displacement[#curve.displacement + 1], curve.force[#curve.force + 1] = beam.x - at_rest, mean
    end
    if math.abs(mean) > peak then peak, at, when = math.abs(mean), beam.x - at_rest, m.time end
    fell = #curve.force > 10 and beam.x - at_rest > s.cycles[#s.cycles] and mean < s.drop*peak
    return fell
  end
  for i, to in ipairs(turning_points(s)) do
    local way = to - (beam.x - at_rest)
    local time = math.abs(way)/s.rate
    m:drive { body = beam, x = trilith.motion { velocity = way/time, duration = time } }
    m:run { name = ("leg %d"):format(i), duration = time, local_damping = 0.8, until_true = read }
  end
  return { curve = curve, peak_force = peak, displacement_at_peak = at, time_at_peak = when - 0.01, force = mean,
    displacement = beam.x - at_rest, limit = fell and "until" or "displacement" }
end

--- Builds, pushes and reads. Adds to s: displacement, rate, samples, drop. Returns { curve (m, N), peak, at, last [N],
--- quasi_static, found, mechanism, crushed, broken, cracked, modes, displacement [m] and limit of the end, vertical,
--- inertia, model }. `vertical` is the lowest and highest reaction of a locked top [N]. `inertia` is a function of time
--- for the share of inertia and damping, where s has drop or cycles.
function W.push(s)
  local m, beam, base = W.build(s)
  local load = base.reaction_y
  local interval = s.cycles and 0.01 or (s.rate and s.displacement/s.rate or 1)/(s.samples or 400)
  local integrals, integrate = integrate_forces(m, base, beam, interval/4, function()
    return s.cycles and beam.reaction_x or m.push_force
  end)
  local counts = count_events(m)
  local vertical = s.top == "locked" and m:history { name = "N", body = beam, what = "reaction_y", every = 0.01 }
  local push = { body = beam, displacement = s.displacement, samples = s.samples or 400,
    top = s.top == "locked" and "locked" or nil }
  if s.control == "arc" then
    push.control, push.arc, push.drop = "arc", s.arc, s.drop
  else
    local ends = s.drop and fallen(m, s.drop)
    push.rate, push.local_damping = s.rate, 0.8
    push.until_true = ends and function() integrate() return ends() end
  end
  local p = s.cycles and drive_cycles(m, beam, s, integrate) or m:pushover(push)
  local found = W.motion_of_joints(m, p.displacement, s.courses*s.unit_height)
  local by = counts.by_mode
  return { curve = p.curve, peak = p.peak_force, at = p.displacement_at_peak, last = p.force,
    time = s.cycles and p.time_at_peak,
    quasi_static = p.quasi_static, found = found, mechanism = W.mechanism(found), crushed = counts.crushed,
    broken = counts.broken, cracked = counts.cracked,
    displacement = p.displacement, limit = p.limit,
    modes = ("%d tension, %d shear, %d compression"):format(by.tension, by.shear, by.compression),
    vertical = vertical and { vertical.min, vertical.max }, model = m,
    inertia = function(time) return share_of_inertia(integrals, time - interval, time + interval, load) end }
end

--- Curve over curve: measured points { mm, kN } and the curve of W.push.
function W.plot(r, points, title, name)
  local x, y, mx, my = {}, {}, {}, {}
  for i, d in ipairs(r.curve.displacement) do x[i], y[i] = 1e3*d, r.curve.force[i]/1e3 end
  for i, point in ipairs(points) do mx[i], my[i] = point[1], point[2] end
  return { title = title, x_label = "displacement of the top", x_unit = "mm", y_label = "force", y_unit = "kN",
    { name = "model", x = x, y = y },
    { name = name or "measured", kind = name and "dashed" or "points", x = mx, y = my } }
end

return W
