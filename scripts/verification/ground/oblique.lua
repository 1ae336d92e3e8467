-- Oblique plane waves on an edge with dashpots. A strip whose sides move upwards and not sideways carries pairs of
-- plane waves, u_x ~ sin(k x), u_y ~ cos(k x) with k = pi/L. Their angle follows from the frequency, so two pulses, one
-- of upward and one of sideways forces at the base, give the reflection at all angles.
local trilith = require "trilith"

local density, cs, nu = 1800, 200, 0.25
local cp = cs*math.sqrt((2 - 2*nu)/(1 - 2*nu))
local length, height = 10, 5
local k = math.pi/length

-- Complex numbers { re, im }.
local function mul(a, b) return { a[1]*b[1] - a[2]*b[2], a[1]*b[2] + a[2]*b[1] } end
local function sub(a, b) return { a[1] - b[1], a[2] - b[2] } end
local function div(a, b)
  local s = b[1]^2 + b[2]^2
  return { (a[1]*b[1] + a[2]*b[2])/s, (a[2]*b[1] - a[1]*b[2])/s }
end
local function square(a) return a[1]^2 + a[2]^2 end
local function turn(angle) return { math.cos(angle), math.sin(angle) } end

-- Solves n complex equations by elimination with pivots; each row has its right side at the end.
local function solve(rows)
  local n = #rows
  for i = 1, n do
    local best = i
    for r = i + 1, n do
      if square(rows[r][i]) > square(rows[best][i]) then best = r end
    end
    rows[i], rows[best] = rows[best], rows[i]
    for r = 1, n do
      if r ~= i then
        local share = div(rows[r][i], rows[i][i])
        for c = i, n + 1 do rows[r][c] = sub(rows[r][c], mul(share, rows[i][c])) end
      end
    end
  end
  local out = {}
  for i = 1, n do out[i] = div(rows[i][n + 1], rows[i][i]) end
  return out
end

-- Histories of the parts of the motion along x and y at two levels, after a pulse of forces at the base.
local function pulse(p, upwards)
  local m = trilith.model { name = "strip", gravity = 0 }
  m:material { name = "soil", density = density, E = 2*density*cs^2*(1 + nu), nu = nu, plane = "strain" }
  m:contact { between = { "*", "*" }, law = "none" }
  local n, e = p.elements, 1e-3
  local soil = m:block { name = "soil", width = length, height = height, at = { 0, 0 }, material = "soil",
    body = { mesh = { n, n//2 } }, floating = true, hold = {
      { from = { -e, -e }, to = { e, height + e }, y = "free" },
      { from = { length - e, -e }, to = { length + e, height + e }, y = "free" } } }
  for _, edge in ipairs { "bottom", "top" } do
    m:absorbing_boundary { body = soil, edge = edge, density = density, cs = cs, cp = cp }
  end
  local curve = {}
  for i = 0, 40 do curve[i + 1] = { i*0.02/40, i < 40 and math.sin(math.pi*i/40)^2 or 0 } end
  for i = 0, n do
    local x, share = i*length/n, (i == 0 or i == n) and 0.5 or 1
    local force = upwards and { 0, 1e3*share*math.cos(k*x) } or { 1e3*share*math.sin(k*x), 0 }
    if math.abs(force[1]) + math.abs(force[2]) > 1e-9 then
      m:point_load { body = soil, at = { x, 0 }, force = force, load_curve = curve }
    end
  end
  local levels = { height/2, height }
  local rows, next_time = {}, 0
  m:run { safety = 0.8, duration = p.duration, until_true = function()
    if m.time < next_time then return false end
    next_time = next_time + p.every
    local row = { m.time }
    for _, y in ipairs(levels) do
      local along, up = 0, 0
      for i = 0, n do
        local x, share = i*length/n, (i == 0 or i == n) and 0.5 or 1
        local px, py = soil:point { x, y }
        along, up = along + (px - x)*math.sin(k*x)*2/n, up + share*(py - y)*math.cos(k*x)*2/n
      end
      row[#row + 1], row[#row + 2] = along, up
    end
    rows[#rows + 1] = row
    return false
  end }
  return rows, levels
end

local function transform(rows, column, omega)
  local re, im = 0, 0
  for i = 2, #rows do
    local dt = rows[i][1] - rows[i - 1][1]
    for _, row in ipairs { rows[i - 1], rows[i] } do
      re = re + 0.5*dt*row[column]*math.cos(omega*row[1])
      im = im - 0.5*dt*row[column]*math.sin(omega*row[1])
    end
  end
  return { re, im }
end

-- Amplitudes of the potentials at the edge: P up, P down, S up, S down.
local function amplitudes(rows, levels, omega)
  local p, q = math.sqrt((omega/cp)^2 - k^2), math.sqrt((omega/cs)^2 - k^2)
  local equations = {}
  for i, level in ipairs(levels) do
    local y = level - height
    local pu, pd, su, sd = turn(-p*y), turn(p*y), turn(-q*y), turn(q*y)
    equations[#equations + 1] = { mul({ -k, 0 }, pu), mul({ -k, 0 }, pd), mul({ 0, -q }, su), mul({ 0, q }, sd),
      transform(rows, 2*i, omega) }
    equations[#equations + 1] = { mul({ 0, -p }, pu), mul({ 0, p }, pd), mul({ -k, 0 }, su), mul({ -k, 0 }, sd),
      transform(rows, 2*i + 1, omega) }
  end
  return solve(equations), p, q
end

-- Share of the energy of a wave that returns, for an incoming P (`is_p`) or S wave.
local function returned(first, second, levels, omega, is_p)
  local a, p, q = amplitudes(first, levels, omega)
  local b = amplitudes(second, levels, omega)
  local det = sub(mul(a[1], b[3]), mul(b[1], a[3]))
  -- Sources with these shares give an incoming wave of one kind and amplitude 1.
  local s = is_p and { div(b[3], det), div({ -a[3][1], -a[3][2] }, det) }
    or { div({ -b[1][1], -b[1][2] }, det), div(a[1], det) }
  local function both(i)
    local x, y = mul(s[1], a[i]), mul(s[2], b[i])
    return square { x[1] + y[1], x[2] + y[2] }
  end
  return is_p and both(2) + q/p*both(4) or both(4) + p/q*both(2)
end

local waves = { { "P", 30, 0.0003 }, { "P", 45, 0.0039 }, { "P", 60, 0.0359 }, { "S", 15, 0.0030 },
  { "S", 30, 0.0359 } }

local function reflection(p)
  local first, levels = pulse(p, true)
  local second = pulse(p, false)
  local out = {}
  for _, w in ipairs(waves) do
    local omega = k*(w[1] == "P" and cp or cs)/math.sin(math.rad(w[2]))
    out[("%s waves at %d degrees"):format(w[1], w[2])] = returned(first, second, levels, omega, w[1] == "P")
  end
  return out
end

local checks = {}
for _, w in ipairs(waves) do
  checks[#checks + 1] = { ("%s waves at %d degrees"):format(w[1], w[2]), unit = "of the energy", exact = w[3],
    within = 0.005 }
end

return {
  title = "Oblique waves on an absorbing boundary",
  source = "Lysmer and Kuhlemeyer (1969), Journal of the Engineering Mechanics Division 95(4)",
  formula = [[\sigma_n = -\rho c_p \dot u_n, \qquad \sigma_s = -\rho c_s \dot u_s]],
  text = "The share of energy that returns from an edge with dashpots, by the angle of the wave from the normal, " ..
    "for a Poisson's ratio of 0.25. It is measured in a strip of elements with rollers at its sides. Two pulses at " ..
    "the base give the matrix of reflection at each frequency.",
  cases = { { name = "oblique_waves", title = "energy that returns", parameters = { { "elements", 30 },
    { "duration", 0.6, "s" }, { "every", 2e-3, "s" } }, checks = checks, run = reflection } },
}
