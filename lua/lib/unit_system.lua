-- Units of a script's models: a system of a unit of force, a unit of length and the second, and its names and factors.
local _, core = ...

local system_type = {}
system_type.__index = system_type

--- "kN m" or "kip ft", in either order: a force and a length; an "s" may follow.
function core.read_units(text)
  local system = setmetatable({ text = text, factors = {} }, system_type)
  system.force, system.force_name, system.length, system.length_name = core.take_units(text)
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

--- The name of a unit in this system: "kN/m2" for "Pa".
function system_type.name(_, unit) return core.unit_name(unit) end

--- Converts each number with an SI unit in a text, such as "0.5 m", to this system, with the same number of digits.
--- `value`, in an SI unit, is the exact number that the text gives rounded.
function system_type.message(_, text, value, unit) return core.unit_message(text, value, unit) end
