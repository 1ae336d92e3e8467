-- Checks that a number is within a share of its expected value; with TRILITH_SHOW in the environment it is printed.
local show = os.getenv "TRILITH_SHOW"

return function(what, value, expected, share)
  if show then print(("%-60s %.6g for %.6g"):format(what, value, expected)) end
  assert(math.abs(value - expected) <= share*math.abs(expected), ("%s: %g for %g"):format(what, value, expected))
end
