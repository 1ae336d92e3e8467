-- Natural frequencies of rigid blocks on joints, of shear frames and of hanging chains.
local trilith = require "trilith"

local function checks(list, tolerance)
  local rows = {}
  for i, f in ipairs(list) do rows[i] = { "mode " .. i, unit = "Hz", exact = f, tolerance = tolerance } end
  return rows
end
local function named(modes, count)
  local found = {}
  for i = 1, count do found["mode " .. i] = modes[i].frequency end
  return found
end

-- Blocks on each other in space; joints act over the whole face, and weight is so small that it does nothing else.
local function pile(sizes, height_of_ground)
  local m = trilith.model { name = "pile", dim = 3, gravity = 1e-3 }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 4e8, mu = 0.6, beta = 1e-5 } }
  m:block { name = "ground", size = { 4, 4, 1 }, at = { -2, -2, -1 }, material = "stone", support = "fixed" }
  local z = height_of_ground or 0
  for i, size in ipairs(sizes) do
    m:block { name = "block " .. i, size = size, at = { -size[1]/2, -size[2]/2, z }, material = "stone" }
    z = z + size[3]
  end
  m:consolidate { integrator = "static" }
  return m
end

local cases = {
  {
    name = "block_on_joint", title = "a block of 0.4 m x 0.4 m x 1.2 m on its joint",
    parameters = { { "kn", 1e9, "Pa/m" }, { "ks", 4e8, "Pa/m" } },
    checks = checks({ 15.0450, 15.0450, 59.3135, 93.7829, 116.919, 116.919 }, 0.0005),
    run = function() return named(pile { { 0.4, 0.4, 1.2 } }:modes { count = 6 }, 6) end,
  },
  {
    name = "two_cubes", title = "two cubes of 0.5 m on each other",
    parameters = { { "kn", 1e9, "Pa/m" }, { "ks", 4e8, "Pa/m" } },
    checks = checks({ 22.1055, 22.1055, 56.790, 89.793, 96.3095, 96.3095, 148.678, 186.093, 186.093, 224.931, 224.931,
      235.081 }, 0.0005),
    run = function() return named(pile { { 0.5, 0.5, 0.5 }, { 0.5, 0.5, 0.5 } }:modes { count = 12 }, 12) end,
  },
}

local function held_floor(m, name, x, y, mass)
  return m:block { name = name, width = 1, height = 0.2, at = { x, y }, mass = mass, material = "steel",
    support = { y = "fixed", rotation = "fixed" }, floating = true }
end
cases[#cases + 1] = {
  name = "shear_frame", title = "three storeys of 1 t and 1 MN/m",
  checks = checks({ 2.23986, 6.27595, 9.06901 }, 1e-4),
  run = function()
    local m = trilith.model { name = "shear frame", gravity = 0 }
    m:material { name = "steel", density = 7850 }
    m:contact { between = { "*", "*" }, law = "none" }
    m:block { name = "floor 0", width = 1, height = 0.2, at = { 0, 0 }, material = "steel", support = "fixed" }
    for i = 1, 3 do
      held_floor(m, "floor " .. i, 0, i, 1000)
      m:bearing { name = "storey " .. i, between = { "floor " .. i - 1, "floor " .. i }, from = { 0.5, i - 0.9 },
        to = { 0.5, i + 0.1 }, along = trilith.linear { stiffness = 1e6 }, angle = 0 }
    end
    return named(m:modes { count = 3 }, 3)
  end,
}

-- A floor of 6 m x 4 m on columns at its corners, the right pair stiffer across.
cases[#cases + 1] = {
  name = "eccentric_floor", title = "floor of 20 t on four columns, stiffer across on one side",
  parameters = { { "kx", 1e6, "N/m" }, { "ky left", 1e6, "N/m" }, { "ky right", 2e6, "N/m" } },
  checks = checks({ 2.25079, 2.57587, 4.62851 }, 1e-4),
  run = function()
    local m = trilith.model { name = "floor", dim = 3, gravity = 0 }
    m:material { name = "concrete", density = 2400 }
    m:contact { between = { "*", "*" }, law = "none" }
    m:block { name = "ground", size = { 6, 4, 1 }, at = { -3, -2, -1 }, material = "concrete", support = "fixed" }
    m:block { name = "floor", size = { 6, 4, 0.2 }, at = { -3, -2, 0 }, mass = 2e4, material = "concrete",
      inertia = 2e4*(6^2 + 4^2)/12, support = { z = "fixed", rotation_x = "fixed", rotation_y = "fixed" },
      floating = true }
    for i, at in ipairs { { -3, -2, 1e6 }, { -3, 2, 1e6 }, { 3, -2, 2e6 }, { 3, 2, 2e6 } } do
      m:bearing { name = "column " .. i, between = { "ground", "floor" }, at = { at[1], at[2], 0 },
        along = trilith.linear { stiffness = 1e6 }, across = trilith.linear { stiffness = at[3] } }
    end
    return named(m:modes { count = 3 }, 3)
  end,
}

-- A lattice of masses that move along x alone; springs join neighbours, and the outer masses and walls.
local counts, springs = { 3, 2, 2 }, { 1e6, 2e6, 3e6 }
local function lattice_modes()
  local list = {}
  for i = 1, counts[1] do
    for j = 1, counts[2] do
      for k = 1, counts[3] do
        local sum = 0
        for axis, n in ipairs { i, j, k } do
          sum = sum + springs[axis]*math.sin(math.pi*n/(2*(counts[axis] + 1)))^2
        end
        list[#list + 1] = math.sqrt(4/10*sum)/(2*math.pi)
      end
    end
  end
  table.sort(list)
  return list
end
cases[#cases + 1] = {
  name = "lattice", title = "lattice of 3 x 2 x 2 masses of 10 kg between walls",
  parameters = { { "springs along x", springs[1], "N/m" }, { "along y", springs[2], "N/m" },
    { "along z", springs[3], "N/m" } },
  checks = checks(lattice_modes(), 1e-4),
  run = function()
    local m = trilith.model { name = "lattice", dim = 3, gravity = 0 }
    m:material { name = "steel", density = 7850 }
    m:contact { between = { "*", "*" }, law = "none" }
    local function name(at) return ("mass %d %d %d"):format(at[1], at[2], at[3]) end
    local function is_wall(at)
      for axis = 1, 3 do
        if at[axis] == 0 or at[axis] == counts[axis] + 1 then return true end
      end
      return false
    end
    local function add(at)
      m:block { name = name(at), size = { 0.2, 0.2, 0.2 }, anchor = "centre", at = at, mass = 10, material = "steel",
        support = is_wall(at) and "fixed" or { y = "fixed", z = "fixed", rotation_x = "fixed", rotation_y = "fixed",
          rotation_z = "fixed" }, floating = true }
    end
    local made = {}
    local function made_once(at)
      if not made[name(at)] then
        made[name(at)] = true
        add(at)
      end
    end
    for i = 1, counts[1] do
      for j = 1, counts[2] do
        for k = 1, counts[3] do
          for axis = 1, 3 do
            for _, way in ipairs { -1, 1 } do
              local here, there = { i, j, k }, { i, j, k }
              there[axis] = there[axis] + way
              made_once(here)
              made_once(there)
              if way == 1 or is_wall(there) then
                m:bearing { name = ("spring %d %d %d %d %d"):format(i, j, k, axis, way),
                  between = { name(here), name(there) }, at = here, arm = 2,
                  along = trilith.linear { stiffness = springs[axis] } }
              end
            end
          end
        end
      end
    end
    return named(m:modes { count = 12 }, 12)
  end,
}

-- Rods that hang on each other: pinned frames, with the stiffness of their tension.
for _, row in ipairs { { 2, 1, { 0.42648, 1.14392 } }, { 4, 0.5, { 0.42453, 1.02373, 1.79717, 2.95906 } } } do
  cases[#cases + 1] = {
    name = ("hanging_rods_%.0f"):format(row[1]), title = "rods that hang on each other",
    parameters = { { "rods", row[1] }, { "length", row[2], "m" } },
    checks = checks(row[3], 0.001),
    run = function(p)
      local m = trilith.model { name = "rods" }
      m:material { name = "steel", density = 7850 }
      m:contact { between = { "*", "*" }, law = "none" }
      m:block { name = "ceiling", width = 1, height = 0.1, at = { -0.5, 0 }, material = "steel", support = "fixed" }
      local above, stiff = "ceiling", trilith.linear { stiffness = 1e10 }
      for i = 1, p.rods do
        local name = "rod " .. i
        local mass = 10*p.length
        m:block { name = name, width = 0.01, height = p.length, at = { -0.005, -i*p.length }, mass = mass,
          inertia = mass*p.length^2/12, material = "steel", floating = true }
        m:bearing { name = "pin " .. i, between = { above, name }, at = { 0, -(i - 1)*p.length }, along = stiff,
          axial = stiff }
        above = name
      end
      m:consolidate { integrator = "static" }
      return named(m:modes { count = p.rods }, p.rods)
    end,
  }
end

return {
  title = "Natural frequencies of rigid blocks",
  source = "Derived: equations of motion of rigid blocks on joints whose stress is linear over the face; " ..
    "Rayleigh (1894), The Theory of Sound, for chains",
  formula = [[\omega^4 - \omega^2\left(\frac{k_x}{m} + \frac{k_r + k_x h_c^2}{I}\right) + \frac{k_x k_r}{m I} = 0,
\qquad k_x = k_s A, \quad k_r = \frac{k_n D B^3}{12}]],
  text = "Sway and rocking of a block of width $B$, depth $D$ and height $2 h_c$ on one joint; " ..
    "shear frames have $\\omega_i = 2\\sqrt{k/m}\\,\\sin((2i - 1)\\pi/14)$.",
  cases = cases,
}
