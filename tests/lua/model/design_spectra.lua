-- Design spectra against values of the codes' tables and formulas, worked out by hand.
local trilith = require "trilith"
local g = 9.80665

local function near(a, b, share)
  assert(math.abs(a - b) <= (share or 1e-12)*math.max(1, math.abs(b)), ("%.15g is not %.15g"):format(a, b))
end
local function refused(text, options)
  local ok, message = pcall(trilith.spectrum, options)
  assert(not ok, "this was not refused: " .. text)
  assert(tostring(message):find(text, 1, true), ("said '%s' instead of '%s'"):format(message, text))
end

-- EN 1998-1, figures 3.2 and 3.3: the plateau Se/ag is 2.5 S for 5 % damping.
local plateaus = { { A = 2.5, B = 3, C = 2.875, D = 3.375, E = 3.5 }, { A = 2.5, B = 3.375, C = 3.75, D = 4.5, E = 4 } }
local corners = { { A = { 0.15, 0.4, 2 }, B = { 0.15, 0.5, 2 }, C = { 0.2, 0.6, 2 }, D = { 0.2, 0.8, 2 },
    E = { 0.15, 0.5, 2 } },
  { A = { 0.05, 0.25, 1.2 }, B = { 0.05, 0.25, 1.2 }, C = { 0.1, 0.25, 1.2 }, D = { 0.1, 0.3, 1.2 },
    E = { 0.05, 0.25, 1.2 } } }
for kind, row in ipairs(plateaus) do
  for ground, plateau in pairs(row) do
    local s = trilith.spectrum { code = "eurocode8", type = kind, ground = ground, ag = 2 }
    local TB, TC, TD = table.unpack(corners[kind][ground])
    near(s.at(0), 2*plateau/2.5)
    near(s.at(TB/2), 2*plateau*(1 + 1/2.5)/2)
    for _, T in ipairs { TB, (TB + TC)/2, TC } do near(s.at(T), 2*plateau) end
    near(s.at((TC + TD)/2), 2*plateau*TC/((TC + TD)/2))
    near(s.at(TD), 2*plateau*TC/TD)
    near(s.at(2*TD), 2*plateau*TC/TD/4)
    for i = 2, #s do assert(s[i][1] > s[i - 1][1]) end
    for _, p in ipairs(s) do near(p[2], s.at(p[1])) end
  end
end
local damped = trilith.spectrum { code = "eurocode8", ground = "A", ag = 1, damping_ratio = 0.1 }
near(damped.at(0.3), 2.5*math.sqrt(10/15))
near(damped.at(0), 1)
near(trilith.spectrum { code = "eurocode8", ground = "A", ag = 1, damping_ratio = 0.5 }.at(0.3), 2.5*0.55)

-- ASCE 7-16 with Ss = 1.5, S1 = 0.6 in site class D: Fa = 1, Fv = 1.7, SDS = 1, SD1 = 0.68.
local a = trilith.spectrum { code = "asce7", Ss = 1.5, S1 = 0.6, ground = "D" }
near(a.SDS, 1) near(a.SD1, 0.68)
near(a.at(0), 0.4*g) near(a.at(0.136), g) near(a.at(0.68), g) near(a.at(2), 0.34*g) near(a.at(16), 0.68*8/256*g)
-- Between two columns of the site tables: Ss = 0.6 in class D, Fa = 1.4 - 0.2*0.4 = 1.32; S1 = 0.15 in C, Fv = 1.5.
near(trilith.spectrum { code = "asce7", Ss = 0.6, S1 = 0.15, ground = "D" }.SDS, 2/3*1.32*0.6)
near(trilith.spectrum { code = "asce7", Ss = 0.6, S1 = 0.15, ground = "C" }.SD1, 2/3*1.5*0.15)
near(trilith.spectrum { code = "asce7", Ss = 0.1, S1 = 0.04, ground = "D" }.SDS, 2/3*1.6*0.1)
near(trilith.spectrum { code = "asce7", Ss = 2, S1 = 0.9, ground = "C" }.SD1, 2/3*1.4*0.9)
near(trilith.spectrum { code = "asce7", SDS = 0.8, SD1 = 0.4, TL = 4 }.at(0.5), 0.8*g)

-- NTC 2018, ag = 0.25 g, F0 = 2.4, TC* = 0.35 s. Ground C: SS = 1.7 - 0.6*2.4*0.25 = 1.34, CC = 1.05*0.35^-0.33.
local c = trilith.spectrum { code = "ntc2018", ground = "C", ag = 0.25*g, F0 = 2.4, TC_star = 0.35 }
near(c.S, 1.34) near(c.TC, 1.05*0.35^0.67) near(c.TB, c.TC/3) near(c.TD, 2.6)
near(c.at(0.4), 0.25*g*1.34*2.4) near(c.at(0), 0.25*g*1.34) near(c.at(1), 0.25*g*1.34*2.4*c.TC)
-- Ground B reaches its upper limit at small ag, ground D its lower one at large ag; topography multiplies.
near(trilith.spectrum { code = "ntc2018", ground = "B", ag = 0.05*g, F0 = 2.5, TC_star = 0.3 }.S, 1.2)
near(trilith.spectrum { code = "ntc2018", ground = "D", ag = 0.45*g, F0 = 2.4, TC_star = 0.3 }.S, 0.9)
near(trilith.spectrum { code = "ntc2018", ground = "A", ag = 1, F0 = 2.5, TC_star = 0.3, topography = 1.2 }.at(0.2), 3)

-- A record matched to a spectrum: the mean of the logarithm of the ratio is 0.
local target = trilith.spectrum { code = "eurocode8", ground = "C", ag = 2.5, periods = { 0.3, 0.6, 1.2 } }
local matched = trilith.motion "elcentro_1940_rest_ns.csv":match { spectrum = target }
local sum = 0
for _, p in ipairs(target) do sum = sum + math.log(p[2]/matched:sa(p[1])) end
assert(#target == 3 and math.abs(sum) < 1e-6, sum)
trilith.motion "elcentro_1940_rest_ns.csv":match { spectrum = trilith.spectrum { code = "asce7", SDS = 1, SD1 = 0.6 },
  from = 0.1, to = 2 }

refused("there is no 'eurocode' for the key 'code'; did you mean 'eurocode8'?", { code = "eurocode" })
refused("'code' is missing, must be one of", {})
refused("there is no 'F' for the key 'ground'; known: A, B, C, D, E", { code = "eurocode8", ground = "F", ag = 1 })
refused("'ag' is missing, must be a number above 0 m/s2", { code = "eurocode8", ground = "A" })
refused("'type' is 3", { code = "eurocode8", ground = "A", ag = 1, type = 3 })
refused("unknown key 'Ss'", { code = "eurocode8", ground = "A", ag = 1, Ss = 1 })
refused("site class E needs a site response analysis", { code = "asce7", Ss = 1, S1 = 0.4, ground = "E" })
refused("give either SDS and SD1, or Ss", { code = "asce7", SDS = 1, SD1 = 0.4, Ss = 1 })
refused("are shares of g, must be at most 5", { code = "asce7", SDS = 9.81, SD1 = 6 })
refused("'periods' is 1", { code = "eurocode8", ground = "A", ag = 1, periods = 1 })
assert(not pcall(target.at, -1) and not pcall(target.at, "x"))
