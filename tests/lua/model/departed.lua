-- Histories of absent parts have no value: bodies that were removed or left the bounds, and their bearings and seats.
-- They continue after the part is reactivated. In the plane and in space, by each integrator.
local trilith = require "trilith"

local function towers(dim)
  local m = trilith.model { name = "towers", dim = dim }
  m:material { name = "stone", density = 2000, E = 1e9, nu = 0.2 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.6, beta = 1e-4 } }
  local function block(name, x, z, wide, high, more)
    local options = { name = name, material = "stone" }
    for k, v in pairs(more or {}) do options[k] = v end
    if dim == 2 then
      options.width, options.height, options.at = wide, high, { x, z }
    else
      options.size, options.at = { wide, 1, high }, { x, 0, z }
    end
    return m:block(options)
  end
  block("ground", -5, -1, 10, 1, { support = "fixed" })
  local a, b = block("a", -0.5, 0, 1, 0.5), block("b", 1.5, 0, 1, 0.5)
  local soft = trilith.linear { stiffness = 1e4 }
  local laws = dim == 2 and { along = soft, axial = soft } or { along = soft, across = soft, axial = soft }
  laws.name, laws.between, laws.at = "link", { a, b }, dim == 2 and { 0.5, 0.25 } or { 0.5, 0.5, 0.25 }
  local link = m:bearing(laws)
  return m, a, b, link, block
end

local function is_number(v) return v == v end
local function check(h, from, there, what)
  assert(#h.values > from, what .. ": nothing was sampled")
  for i = from + 1, #h.values do
    assert(is_number(h.values[i]) == there, what .. ", sample " .. i .. ": " .. h.values[i])
  end
end

for _, dim in ipairs { 2, 3 } do
  for _, how in ipairs { "explicit", "implicit", "static" } do
    local m, a, b, link = towers(dim)
    local place = m:history { name = "place", body = b, what = dim == 2 and "y" or "z", every = 0.01 }
    local other = m:history { name = "other", body = a, what = "ux" }
    local force = m:history { name = "force", bearing = link, what = "force_along" }
    local function go()
      local before = #place.values
      if how == "static" then m:consolidate { integrator = "static" }
      else m:run { duration = 0.03, integrator = how, dt = how == "implicit" and 1e-3 or nil } end
      return before
    end
    local function expect(b_there, link_there, what)
      local before = go()
      check(place, before, b_there, how .. " " .. what .. ": body")
      check(force, before, link_there, how .. " " .. what .. ": bearing")
      check(other, before, true, how .. " " .. what .. ": other body")
    end
    expect(true, true, "at first")
    m:remove(b)
    expect(false, false, "removed")
    assert(not is_number(place.last) and is_number(place.max) and is_number(place.min))
    m:put_back(b)
    expect(true, false, "put back without its bearing")
    m:put_back(link)
    expect(true, true, "both put back")
    m:remove(link)
    expect(true, false, "bearing removed")
    m:close()
  end

  -- A body added later, and one that flies out of the bounds; removed from a handler.
  local m, a, b, _, block = towers(dim)
  m:consolidate { rest = { ratio = 1e-3 } }
  m:bounds { bottom = -2, left = -20, right = 20 }
  local flying = block("flying", 8, 0, 0.5, 0.5, { floating = true })
  local h = m:history { name = "flying", body = flying, what = "speed", every = 0.01 }
  local late = m:history { name = "late", body = a, what = "speed" }
  local left, gone
  m:on("body.left", function(e) left = e.time end)
  m:every(0.2, function() if b.present then m:remove(b) gone = m.time end end)
  local of_b = m:history { name = "b", body = b, what = "speed" }
  local before = #h.values
  m:run { duration = 1.2 }
  assert(left and gone)
  for i = before + 1, #h.values do
    if h.t[i] < left - 1e-9 then assert(is_number(h.values[i])) end
    if h.t[i] > left + 0.011 then assert(not is_number(h.values[i]), h.t[i]) end
    if h.t[i] > gone + 0.011 then assert(not is_number(of_b.values[i])) end
    assert(is_number(late.values[i]))
  end
  m:close()
end
