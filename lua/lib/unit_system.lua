-- Units of a script's models: a system of a unit of force, a unit of length and the second, and its names and factors.
local trilith, core = ...
local si_factor = trilith.units

local system_type = {}
system_type.__index = system_type

local owner = "model"

--- The SI factor of a unit of one of two kinds: exponents of length, time and mass.
local function factor_of(name)
  local l, t, m = core.dimension(name)
  if not l then return nil end
  return si_factor(name), l, t, m
end

--- "kN m" or "kip ft", in either order: a force and a length; an "s" may follow.
function core.read_units(text)
  local example = 'a unit of force and a unit of length, such as "kN m", "N mm" or "kip ft"'
  if type(text) ~= "string" then
    core.fail(("%s: 'units' is %s, must be %s"):format(owner, core.what_is(text), example))
  end
  local system = setmetatable({ text = text, factors = {}, names = {} }, system_type)
  for word in text:gmatch "[^%s,]+" do
    local factor, l, t, m = factor_of(word)
    if not factor then
      core.fail(("%s: 'units' is '%s': there is no unit '%s'; give %s"):format(owner, text, word, example))
    end
    if l == 1 and t == -2 and m == 1 and not system.force then system.force, system.force_name = factor, word
    elseif l == 1 and t == 0 and m == 0 and not system.length then system.length, system.length_name = factor, word
    elseif word ~= "s" then
      core.fail(("%s: 'units' is '%s', must be %s; the time is in s, and the mass follows from them"):format(owner,
        text, example))
    end
  end
  if not system.force or not system.length then
    core.fail(("%s: 'units' is '%s', must be %s"):format(owner, text, example))
  end
  system.mass = system.force/system.length
  return system
end

--- The power of ten that a factor is; nil for another number.
local function power_of_ten(factor)
  for exponent = -12, 12 do
    if factor == tonumber("1e" .. exponent) then return exponent end
  end
end

local function power(base, exponent)
  local result = 1
  for _ = 1, math.abs(exponent) do result = result*base end
  return exponent < 0 and 1/result or result
end

--- The factor of exponents of length and mass, and its exponent if it is a power of ten.
local function factor_for(system, l, m)
  local force, length = power_of_ten(system.force), power_of_ten(system.length)
  if not force or not length then return power(system.length, l)*power(system.mass, m) end
  local exponent = length*l + (force - length)*m
  return tonumber("1e" .. exponent), exponent
end

--- SI value of one unit of this system, for a quantity whose unit in SI is `unit`; nil for an unknown unit. `turning`:
--- the quantity is the rotational one of a law of forces and displacements.
function system_type.factor(system, unit, turning)
  if unit == "" or unit == "1" then return 1 end
  local key = turning and unit .. " turning" or unit
  local known = system.factors[key]
  if known == nil then
    local l, _, m = core.dimension(unit)
    if l and turning then l = m > 0 and 2*m or 0 end
    known = l and { factor_for(system, l, m) } or false
    system.factors[key] = known
  end
  if known then return known[1], known[2] end
end

--- A number times a power of ten. Numbers of at most 15 digits are shifted as decimals, so that 250 mm and 0.25 m, or
--- 1.9e-9 N s2/mm4 and 1900 kg/m3, are the same bits.
local function shifted(value, exponent)
  local text = ("%.15g"):format(value)
  if tonumber(text) ~= value or text:find "[ni]" then
    return exponent < 0 and value/tonumber("1e" .. -exponent) or value*tonumber("1e" .. exponent)
  end
  local digits, own = text:match "^(.-)e(.+)$"
  return tonumber(("%se%d"):format(digits or text, (own and tonumber(own) or 0)//1 + exponent)) + 0.0
end

--- A number converted to SI (direction 1) or from SI (-1) by a factor, which is a power of ten if `exponent` is given.
function core.convert_number(value, factor, exponent, direction)
  if exponent then return shifted(value, direction*exponent) end
  if direction == 1 then return value*factor end
  return value/factor
end

local function product(parts, sign)
  local words = {}
  for _, part in ipairs(parts) do
    local exponent = sign*part[2]
    if exponent > 0 then words[#words + 1] = exponent == 1 and part[1] or part[1] .. exponent end
  end
  return table.concat(words, " ")
end

--- The name of a unit in this system: "kN/m2" for "Pa".
function system_type.name(system, unit)
  local l, t, m = core.dimension(unit)
  if not l or l == 0 and m == 0 then return unit end
  local parts = { { system.force_name, m }, { system.length_name, l - m }, { "s", t + 2*m } }
  local above, below = product(parts, 1), product(parts, -1)
  if above == "" then above = "1" end
  return below == "" and above or above .. "/" .. below
end

-- Units that the engine's texts use, with their SI units, longest first.
local texts = {}
for _, row in ipairs { { "N m/rad" }, { "N s/m" }, { "kg m2" }, { "kg/m3" }, { "kg/m2" }, { "N/m3" }, { "N/m2" },
  { "m/s2" }, { "Pa/m" }, { "J/m2" }, { "m/s" }, { "mm/s", "m/s", 1e-3 }, { "N/m" }, { "kN/m", "N/m", 1e3 }, { "N m" },
  { "kN m", "N m", 1e3 }, { "MPa", "Pa", 1e6 }, { "GPa", "Pa", 1e9 }, { "kPa", "Pa", 1e3 }, { "Pa" }, { "kg" },
  { "kJ", "J", 1e3 }, { "J" }, { "kN", "N", 1e3 }, { "MN", "N", 1e6 }, { "N" }, { "mm", "m", 1e-3 },
  { "cm", "m", 1e-2 }, { "m2" }, { "m3" }, { "m" } } do
  texts[#texts + 1] = { name = row[1], unit = row[2] or row[1], factor = row[3] or 1 }
end
table.sort(texts, function(a, b)
  if #a.name ~= #b.name then return #a.name > #b.name end
  return a.name < b.name
end)

local function unit_at(text, at)
  for _, row in ipairs(texts) do
    if text:sub(at, at + #row.name - 1) == row.name and not text:find("^[%w/]", at + #row.name) then return row end
  end
end

--- Converts each number with an SI unit in a text, such as "0.5 m", to this system, with the same number of digits.
function system_type.message(system, text)
  local out, from = {}, 1
  while true do
    local first, last, number = text:find("(%-?%d[%d.]*e?[+-]?%d*) ", from)
    if not first then break end
    local row = tonumber(number) and (first == 1 or not text:find("^[%w_]", first - 1)) and unit_at(text, last + 1)
    if row then
      local digits = #number:gsub("e.*", ""):gsub("[-.]", ""):gsub("^0+", "")
      local value = tonumber(number)*row.factor/system:factor(row.unit)
      out[#out + 1] = text:sub(from, first - 1) .. ("%." .. math.max(3, math.min(digits, 15)) .. "g"):format(value)
        .. " " .. system:name(row.unit)
      from = last + 1 + #row.name
    else
      out[#out + 1] = text:sub(from, last)
      from = last + 1
    end
  end
  return table.concat(out) .. text:sub(from)
end
