-- trilith.math: values of Lua's math to rounding, without its platform variants; rejected arguments.
local trilith = require "trilith"
local ours = trilith.math
local function near(a, b) assert(math.abs(a - b) <= 4e-16 * math.max(1, math.abs(b)), a .. " is not " .. b) end

for i = -40, 40 do
  local x = i / 7
  for _, name in ipairs { "sin", "cos", "tan", "exp", "atan" } do near(ours[name](x), math[name](x)) end
  near(ours.asin(x / 6), math.asin(x / 6))
  near(ours.acos(x / 6), math.acos(x / 6))
  near(ours.atan(x, -2), math.atan(x, -2))
  near(ours.log(x * x + 1), math.log(x * x + 1))
  near(ours.pow(x * x + 1, 0.7), (x * x + 1) ^ 0.7)
  near(ours.pow(x, 3), x ^ 3)
end
assert(ours.sin(0) == 0 and ours.exp(0) == 1 and ours.pow(2, 10) == 1024 and ours.log(0) == -math.huge)
assert(ours.acos(2) ~= ours.acos(2) and ours.log(-1) ~= ours.log(-1) and ours.tan(math.huge) ~= ours.tan(math.huge))

local function refused(message, f, ...)
  local good, said = pcall(f, ...)
  assert(not good and said:find(message, 1, true), said)
end
refused("trilith.math.sin: takes numbers; argument 1 is the text 'one'", ours.sin, "one")
refused("trilith.math.pow: takes numbers; argument 2 is nil", ours.pow, 2)
refused("trilith.math.atan: takes numbers; argument 2 is a table", ours.atan, 1, {})
refused("trilith.math.log: returns only the natural logarithm", ours.log, 8, 2)
refused("trilith.math has no 'sine'", function() return ours.sine(1) end)
