-- Parameters arrive in SI, from their defaults or from the command line, which this test is run with.
local trilith = require "trilith"
local g, ft = trilith.units "g ft"
local p = trilith.params {
  pga = { 0.8, unit = "g", "peak acceleration" },
  other = { 0.5, unit = "g", "in another unit" },
  gap = { 2, unit = "ft", "left as it is" },
  sign = 1,
  mode = { "a", choices = { "a", "b" }, "one of two" },
  long = { false, "a flag" },
}
assert(p.pga == 0.6 * g)
assert(math.abs(p.other - 3) < 1e-12)
assert(p.gap == 2 * ft)
assert(p.sign == -1)
assert(p.mode == "b")
assert(p.long == true)
local good, message = pcall(trilith.params, {})
assert(not good and message:find "called a second time")
