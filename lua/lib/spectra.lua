-- trilith.spectrum{...}: elastic design spectra by code name, as targets of motion:match and as demand of
-- trilith.bilinear.
local trilith, core = ...

local owner = "spectrum"
local gravity = 9.80665
local ground_names = { "A", "B", "C", "D", "E" }

-- EN 1998-1:2004, tables 3.2 (type 1) and 3.3 (type 2): S, TB, TC, TD [s].
local eurocode8 = {
  { A = { 1, 0.15, 0.4, 2 }, B = { 1.2, 0.15, 0.5, 2 }, C = { 1.15, 0.2, 0.6, 2 }, D = { 1.35, 0.2, 0.8, 2 },
    E = { 1.4, 0.15, 0.5, 2 } },
  { A = { 1, 0.05, 0.25, 1.2 }, B = { 1.35, 0.05, 0.25, 1.2 }, C = { 1.5, 0.1, 0.25, 1.2 },
    D = { 1.8, 0.1, 0.3, 1.2 }, E = { 1.6, 0.05, 0.25, 1.2 } },
}
-- NTC 2018, tables 3.2.IV: soil factor SS = a - b F0 ag/g within limits, and CC = c TC*^e.
local ntc = {
  A = { 1, 0, 1, 1, 1, 0 }, B = { 1.4, 0.4, 1, 1.2, 1.1, -0.2 }, C = { 1.7, 0.6, 1, 1.5, 1.05, -0.33 },
  D = { 2.4, 1.5, 0.9, 1.8, 1.25, -0.5 }, E = { 2, 1.1, 1, 1.6, 1.15, -0.4 },
}
-- ASCE 7-16, tables 11.4-1 and 11.4-2: Fa at Ss = 0.25, 0.5, ... 1.5, and Fv at S1 = 0.1, 0.2, ... 0.6.
local asce_fa = {
  A = { 0.8, 0.8, 0.8, 0.8, 0.8, 0.8 }, B = { 0.9, 0.9, 0.9, 0.9, 0.9, 0.9 }, C = { 1.3, 1.3, 1.2, 1.2, 1.2, 1.2 },
  D = { 1.6, 1.4, 1.2, 1.1, 1, 1 },
}
local asce_fv = {
  A = { 0.8, 0.8, 0.8, 0.8, 0.8, 0.8 }, B = { 0.8, 0.8, 0.8, 0.8, 0.8, 0.8 }, C = { 1.5, 1.5, 1.5, 1.5, 1.5, 1.4 },
  D = { 2.4, 2.2, 2, 1.9, 1.8, 1.7 },
}

--- Damping correction of EN 1998-1 (3.6) and NTC 2018 (3.2.4).
local function eta(ratio) return math.max(0.55, math.sqrt(10/(5 + 100*ratio))) end

local function number(options, key, unit, preset)
  local value = options[key]
  if value == nil and preset then return preset end
  return core.positive(owner, key, value, unit)
end

--- Acceleration at a period: plateau `top`, value `zero` at 0 s, corners TB, TC, TD [s].
local function four_branches(zero, top, TB, TC, TD)
  return function(T)
    if T < TB then return zero + (top - zero)*T/TB end
    if T <= TC then return top end
    if T <= TD then return top*TC/T end
    return top*TC*TD/T^2
  end
end

local codes = {}

function codes.eurocode8(options)
  core.check_keys(owner, options, { "code", "type", "ground", "ag", "damping_ratio", "periods" })
  local kind = options.type or 1
  if kind ~= 1 and kind ~= 2 then
    core.fail(("%s: 'type' is %s, must be 1 (surface-wave magnitude above 5.5) or 2"):format(owner,
      core.what_is(kind)))
  end
  local S, TB, TC, TD = table.unpack(eurocode8[kind][core.one_of(owner, "ground", options.ground, ground_names)])
  local ag, damping = number(options, "ag", " m/s2"), number(options, "damping_ratio", "", 0.05)
  return four_branches(ag*S, ag*S*2.5*eta(damping), TB, TC, TD), { S = S, TB = TB, TC = TC, TD = TD }
end

function codes.ntc2018(options)
  core.check_keys(owner, options, { "code", "ground", "ag", "F0", "TC_star", "topography", "damping_ratio", "periods" })
  local a, b, low, high, c, e = table.unpack(ntc[core.one_of(owner, "ground", options.ground, ground_names)])
  local ag, F0 = number(options, "ag", " m/s2"), number(options, "F0", "")
  local star, slope = number(options, "TC_star", " s"), number(options, "topography", "", 1)
  local soil = math.min(high, math.max(low, a - b*F0*ag/gravity))
  local TC = star*c*trilith.math.exp(e*trilith.math.log(star))
  local S, damping = soil*slope, number(options, "damping_ratio", "", 0.05)
  local TD = 4*ag/gravity + 1.6
  return four_branches(ag*S, ag*S*eta(damping)*F0, TC/3, TC, TD), { S = S, TB = TC/3, TC = TC, TD = TD }
end

--- Linear interpolation in a row of a site table; beyond its ends the end values.
local function site_factor(row, value, first, step)
  local at = math.min(#row, math.max(1, (value - first)/step + 1))
  local left = math.min(#row - 1, math.floor(at))
  return row[left] + (row[left + 1] - row[left])*(at - left)
end

--- SDS and SD1 as shares of g, given or from Ss, S1 and the site class.
local function design_values(options)
  if options.SDS or options.SD1 then
    for _, key in ipairs { "Ss", "S1", "ground" } do
      if options[key] then core.fail(("%s: give either SDS and SD1, or Ss, S1 and ground"):format(owner)) end
    end
    return number(options, "SDS", " g"), number(options, "SD1", " g")
  end
  local Ss, S1 = number(options, "Ss", " g"), number(options, "S1", " g")
  if options.ground == "E" or options.ground == "F" then
    core.fail(("%s: site class %s needs a site response analysis in parts of ASCE 7-16; give SDS and SD1"):format(owner,
      options.ground))
  end
  local ground = core.one_of(owner, "ground", options.ground, { "A", "B", "C", "D" })
  return 2/3*site_factor(asce_fa[ground], Ss, 0.25, 0.25)*Ss, 2/3*site_factor(asce_fv[ground], S1, 0.1, 0.1)*S1
end

function codes.asce7(options)
  core.check_keys(owner, options, { "code", "Ss", "S1", "ground", "SDS", "SD1", "TL", "periods" })
  local SDS, SD1 = design_values(options)
  local TS, TL = SD1/SDS, number(options, "TL", " s", 8)
  if TS >= TL then
    core.fail(("%s: SD1/SDS = %g s must be below TL = %g s; accelerations are shares of g"):format(owner, TS, TL))
  end
  if math.max(SDS, SD1) > 5 then
    core.fail(("%s: SDS = %g and SD1 = %g are shares of g, must be at most 5"):format(owner, SDS, SD1))
  end
  local shape = four_branches(0.4*SDS*gravity, SDS*gravity, 0.2*TS, TS, TL)
  return shape, { SDS = SDS, SD1 = SD1, TB = 0.2*TS, TC = TS, TD = TL }
end

local code_names = { "eurocode8", "asce7", "ntc2018" }

--- Periods of the points: the corners, and 60 others in a geometric series from 0.02 s to 4 s.
local function usual_periods(about)
  local periods, first, last, count = {}, 0.02, 4, 60
  local ratio = trilith.math.log(last/first)/(count - 1)
  for i = 0, count - 1 do periods[#periods + 1] = first*trilith.math.exp(ratio*i) end
  for _, corner in ipairs { about.TB, about.TC, about.TD } do
    if corner > first and corner < last then periods[#periods + 1] = corner end
  end
  table.sort(periods)
  return periods
end

local function given_periods(list)
  if type(list) ~= "table" or #list == 0 then
    core.fail(("%s: 'periods' is %s, must be a list of periods in s"):format(owner, core.what_is(list)))
  end
  for i, period in ipairs(list) do core.positive(owner, ("periods[%d]"):format(i), period, " s") end
  return list
end

function trilith.spectrum(options)
  local all = { "code", "type", "ground", "ag", "F0", "TC_star", "topography", "Ss", "S1", "SDS", "SD1", "TL",
    "damping_ratio", "periods" }
  core.check_keys(owner, options, all)
  local shape, about = codes[core.one_of(owner, "code", options.code, code_names)](options)
  local points = {}
  for i, T in ipairs(options.periods and given_periods(options.periods) or usual_periods(about)) do
    points[i] = { T, shape(T) }
  end
  about.code = options.code
  --- Acceleration [m/s2] at a period [s].
  function about.at(period)
    if type(period) ~= "number" or not (period >= 0 and period < math.huge) then
      core.fail(("%s: the period is %s, must be a number from 0 s"):format(owner, core.what_is(period)))
    end
    return shape(period)
  end
  return setmetatable(points, { __index = about })
end
