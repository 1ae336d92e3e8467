-- Axial strains of members are checked against strain_limit. Runs that diverge end the program with exit code 3, so
-- this script prints at its end that all checks have passed.
local trilith = require "trilith"

local function near(value, expected, allowed)
  assert(math.abs(value - expected) <= allowed*math.abs(expected), ("%.9g instead of %.9g"):format(value, expected))
end

-- A bar stretched or compressed along its axis beyond the strain limit of its material ends the stage, as an element
-- does; below the limit it comes to rest at F = E A u / L.
for _, share in ipairs { -0.6, -0.09, 0.09, 0.7 } do
  local bar = trilith.model { name = "bar", gravity = 0 }
  bar:material { name = "soft", density = 1000, E = 2e8, strain_limit = 0.1 }
  local rod = bar:beam { name = "b", material = "soft", floating = true, from = { 0, 0 }, to = { 1, 0 }, divisions = 1,
    section = trilith.rectangle_section { width = 1, depth = 0.5 }, from_support = "fixed",
    to_support = { y = "fixed", rotation = "fixed" } }
  bar:point_load { body = rod, at = { 1, 0 }, force = { share*2e8*0.5, 0 }, load_curve = { smooth = 0.2 } }
  local report = bar:run { duration = 5, local_damping = 0.8, rest = { ratio = 1e-6, from = 0.3 } }
  if math.abs(share) < 0.1 then
    assert(report.ending == "rest" and bar.verdict.sound, report.reason)
    near((rod:point { 1, 0 }), 1 + share, 1e-4)
  else
    assert(report.ending == "diverged" and not bar.verdict.sound, report.ending)
    local words = ("element 1 of b was %s by"):format(share < 0 and "squeezed" or "stretched")
    assert(report.reason:find(words, 1, true) and report.reason:find("its material is valid up to 10 %", 1, true),
      report.reason)
  end
  bar:close()
end

-- A member's axial strain is limited in both signs.
for _, share in ipairs { -0.6, 0.09, 0.7 } do
  local bar = trilith.model { name = "bar", dim = 3, gravity = 0 }
  bar:material { name = "soft", density = 1000, E = 2e8, nu = 0.2, strain_limit = 0.1 }
  local f = bar:frame { name = "f", material = "soft", floating = true,
    joints = { A = { at = { 0, 0, 0 }, support = "fixed" }, B = { 0.6, 0, 0.8 } },
    members = { { name = "tie", from = "A", to = "B", divisions = 2,
      section = trilith.rectangle_section { width = 0.5, depth = 0.5 } } } }
  local force = share*2e8*0.25
  bar:point_load { body = f, at = { 0.6, 0, 0.8 }, force = { 0.6*force, 0, 0.8*force }, load_curve = { smooth = 0.2 } }
  local report = bar:run { duration = 1, local_damping = 0.8, rest = { ratio = 1e-5, from = 0.3 } }
  if share == 0.09 then
    assert(bar.verdict.sound, report.reason)
  else
    assert(report.ending == "diverged", report.ending)
    assert(report.reason:find(" of tie of f was " .. (share < 0 and "squeezed" or "stretched"), 1, true), report.reason)
  end
  bar:close()
end

-- Statics checks strains as dynamic stages do, for beams and elements, in the plane and in space; below the limit the
-- equilibrium is F = E A u / L.
local square = trilith.rectangle_section { width = 0.5, depth = 0.5 }
local function bar_of(kind, dim)
  local bar = trilith.model { name = "bar", gravity = 0, dim = dim }
  bar:material { name = "soft", density = 1000, E = 2e8, nu = 0, strain_limit = 0.1 }
  local zero, one = dim == 2 and { 0, 0 } or { 0, 0, 0 }, dim == 2 and { 1, 0 } or { 1, 0, 0 }
  if kind == "beam" and dim == 2 then
    return bar, bar:beam { name = "b", material = "soft", floating = true, from = zero, to = one, divisions = 4,
      section = square, from_support = "fixed" }
  elseif kind == "beam" then
    return bar, bar:frame { name = "b", material = "soft", floating = true,
      joints = { A = { at = zero, support = "fixed" }, B = one },
      members = { { from = "A", to = "B", divisions = 4, section = square } } }
  elseif dim == 2 then
    return bar, bar:block { name = "b", width = 1, height = 0.5, at = zero, material = "soft", floating = true,
      body = { mesh = { 4, 1 } }, body_thickness = 0.5, hold = { { from = { 0, 0 }, to = { 0, 0.5 } } } }
  end
  return bar, bar:block { name = "b", size = { 1, 0.5, 0.5 }, at = zero, material = "soft", floating = true,
    body = { mesh = { 4, 1, 1 } }, hold = { { from = { 0, 0, 0 }, to = { 0, 0.5, 0.5 } } } }
end
for _, kind in ipairs { "beam", "mesh" } do
  for _, dim in ipairs { 2, 3 } do
    for _, share in ipairs { -0.15, 0.08, 0.12 } do
      local bar, rod = bar_of(kind, dim)
      local force = share*2e8*0.25
      if kind == "beam" then
        bar:point_load { body = rod, at = dim == 2 and { 1, 0 } or { 1, 0, 0 },
          force = dim == 2 and { force, 0 } or { force, 0, 0 } }
      else
        bar:pressure { body = rod, face = "right", value = -force/0.25 }
      end
      local report = bar:consolidate { integrator = "static", or_go_on = true }
      if share == 0.08 then
        assert(report.rests and bar.verdict.sound, report.reason)
        if kind == "beam" then near(rod:point(dim == 2 and { 1, 0 } or { 1, 0, 0 }), 1 + share, 1e-6) end
        bar:run { duration = 1e-4 }
        assert(bar.verdict.sound)
      else
        assert(report.ending == "diverged" and not bar.verdict.sound, report.ending)
        for _, words in ipairs { "element ", " of b was " .. (share < 0 and "squeezed" or "stretched") .. " by ",
          "its material is valid up to 10 %", "load factor 1", "larger strain_limit" } do
          assert(report.reason:find(words, 1, true), report.reason)
        end
        local ok, message = pcall(function() bar:run { duration = 0.1 } end)
        assert(not ok and tostring(message):find("cannot begin", 1, true), message)
      end
      bar:close()
    end
  end
end

-- An equilibrium path ends at the first point beyond the limit, which is not part of its curve; the message has the
-- load factor.
for _, dim in ipairs { 2, 3 } do
  for _, far in ipairs { 0.05, 0.3 } do
    local bar, rod = bar_of("beam", dim)
    bar:consolidate { integrator = "static" }
    local report = bar:pushover { body = rod, at = dim == 2 and { 1, 0 } or { 1, 0, 0 }, control = "arc",
      displacement = far, arc = 0.004 }
    local curve = report.curve
    for i, u in ipairs(curve.displacement) do
      assert(u <= 0.1 + 1e-9 or far == 0.05, u)
      assert(math.abs(curve.force[i] - 2e8*0.25*u) <= 1e-6*2e8*0.25*0.1, curve.force[i])
    end
    if far == 0.05 then
      assert(report.limit == "displacement" and bar.verdict.sound, report.limit)
    else
      assert(report.limit == "strain" and report.ending == "diverged" and #curve.force > 3, report.limit)
      -- The last point is at most the longest step, five times the first, before it.
      assert(curve.displacement[#curve.displacement] > 0.1 - 5.01*curve.displacement[2])
      local factor = tonumber(report.reason:match "when the load factor of 'pushover' reached ([%d.e+]+)")
      local strain = tonumber(report.reason:match "stretched by ([%d.]+) %%")
      assert(factor and factor > curve.force[#curve.force] and strain > 10, report.reason)
      near(factor, 2e8*0.25*strain/100, 5e-3) -- the message has three digits of the strain
    end
    bar:close()
  end
end

-- A rewind to before this point works.
do
  local bar, rod = bar_of("beam", 2)
  bar:checkpoints { every = 0.01 }
  bar:run { duration = 0.05 }
  bar:point_load { name = "pull", body = rod, at = { 1, 0 }, force = { 1e7, 0 } }
  -- Rest was requested, and the message explains why there is none, as for every search.
  local ok, message = pcall(function() bar:consolidate { integrator = "static" } end)
  for _, words in ipairs { "consolidation did not come to rest: element ", " of b was stretched by ",
    "strain_limit" } do
    assert(not ok and tostring(message):find(words, 1, true), message)
  end
  assert(not bar.verdict.sound)
  bar:rewind(0.03)
  assert(bar.verdict.sound and math.abs((rod:point { 1, 0 }) - 1) < 1e-12)
  assert(bar:run { duration = 0.01 }.ending == "time")
  bar:close()
end

print "every assertion holds"
