-- Disc under two opposite loads (Brazilian test): two halves of elements, joined along the diameter of the load.
local trilith = require "trilith"

local radius, thickness, modulus, nu, kn = 0.05, 0.05, 30e9, 0.2, 1e14
local load, arc = 50e3, 5 -- [N], and half of the loaded arc [degrees]
local pressure = load/(2*radius*math.sin(math.rad(arc))*thickness)

-- Nodes of a half disc: squares with the centre at the disc's, mapped onto circles.
local function half(sign, k)
  local nodes, elements, id = {}, {}, {}
  local function place(a, b)
    local reach = math.max(math.abs(a), math.abs(b))
    if reach == 0 then return { 0, 0 } end
    if math.abs(a) >= math.abs(b) then
      local angle = math.pi/4*b/a
      return { sign*radius*reach*math.cos(angle), radius*reach*math.sin(angle) }
    end
    local angle, up = math.pi/4*a/b, b > 0 and 1 or -1
    return { sign*radius*reach*math.sin(angle)*up, radius*reach*math.cos(angle)*up }
  end
  for i = 0, k do
    for j = -k, k do
      nodes[#nodes + 1] = place(i/k, j/k)
      id[i*(2*k + 1) + j + k] = #nodes
    end
  end
  for i = 0, k - 1 do
    for j = -k, k - 1 do
      local a, b = i*(2*k + 1) + j + k, (i + 1)*(2*k + 1) + j + k
      local e = { id[a], id[b], id[b + 1], id[a + 1] }
      elements[#elements + 1] = sign > 0 and e or { e[4], e[3], e[2], e[1] }
    end
  end
  return { nodes = nodes, elements = elements }
end

local function at(degrees) return { radius*math.cos(math.rad(degrees)), radius*math.sin(math.rad(degrees)) } end

local function disc(p, curve)
  local m = trilith.model { name = "disc", thickness = thickness, gravity = 0 }
  m:material { name = "concrete", density = 2400, E = modulus, nu = nu }
  m:contact { between = { "*", "*" }, law = trilith.bonded { kn = kn, ks = kn/2, mu = 0.5, tension = p.tension,
    cohesion = 1e9 } }
  local right
  for _, sign in ipairs { 1, -1 } do
    local body = m:body { name = sign > 0 and "right" or "left", mesh = half(sign, p.rings), material = "concrete",
      floating = true }
    right = right or body
    for _, from in ipairs(sign > 0 and { 90 - arc, -90 } or { 90, -90 - arc }) do
      m:pressure { body = body, value = pressure, from = at(from), to = at(from + arc), load_curve = curve }
    end
  end
  return m, right
end

-- Stresses of the elements at the centre, from the strains between nodes.
local function stresses(p)
  local m, right = disc(p)
  m:consolidate { integrator = "static" }
  local h = radius/p.rings
  local function strain(a, b)
    local ax, ay = right:point(a)
    local bx, by = right:point(b)
    return math.sqrt((ax - bx)^2 + (ay - by)^2)/math.sqrt((a[1] - b[1])^2 + (a[2] - b[2])^2) - 1
  end
  local ex, ey = strain({ 0, 0 }, { h, 0 }), strain({ 0, -h }, { 0, h })
  local stiff = modulus/(1 - nu^2)
  return { ["stress across"] = stiff*(ex + nu*ey), ["stress along"] = stiff*(ey + nu*ex) }
end

local function cracks(p)
  local duration, share = 1e-3, 1.2
  local m = disc(p, { { 0, 0 }, { duration, share } })
  local first, height
  m:on("bond.broken", function(e)
    if not first then first, height = e.time, e.y end
  end)
  m:run { duration = duration, until_true = function() return first ~= nil end }
  return { ["load at the first crack"] = load*share*first/duration, ["its distance from the centre"] = height }
end

return {
  title = "Splitting of a disc",
  source = "Hondros (1959), Australian Journal of Applied Science 10(3): stresses of a disc under two loaded arcs",
  formula = [[\sigma_x = \frac{2 p}{\pi}\left(\sin 2\alpha - \alpha\right), \qquad
\sigma_y = -\frac{2 p}{\pi}\left(\sin 2\alpha + \alpha\right)]],
  text = "A disc of 0.1 m under 50 kN on arcs of 10 degrees. Its halves are meshes that are joined along the loaded " ..
    "diameter. With a joint of 6 MPa the first crack is in the middle; the load grows so slowly " ..
    "that waves matter little.",
  cases = { { name = "disc_stress", title = "stress in the middle",
    parameters = { { "rings", 18 }, { "tension", 1e9, "Pa" } },
    checks = { { "stress across", unit = "Pa", exact = 6.3017e6, tolerance = 0.02 },
      { "stress along", unit = "Pa", exact = -19.034e6, tolerance = 0.02 } },
    run = stresses },
  { name = "disc_crack", title = "joint of 6 MPa along the diameter",
    parameters = { { "rings", 9 }, { "tension", 6e6, "Pa" } },
    checks = { { "load at the first crack", unit = "N", exact = 47.6e3, tolerance = 0.05 },
      { "its distance from the centre", unit = "m", exact = 0, within = 0.2*radius } },
    run = cracks } },
}
