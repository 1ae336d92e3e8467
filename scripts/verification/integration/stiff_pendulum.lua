-- A mass on a bar so stiff that no implicit step resolves its stretch.
local trilith = require "trilith"

return {
  title = "Stiff pendulum",
  source = "Bathe (2007), Computers and Structures 85, for the case; a circular motion is exact",
  formula = [[T = \frac{2\pi L}{v}, \qquad E = \tfrac{1}{2} m v^2]],
  text = "A mass of 10 kg turns at 7.72 m/s on a bar of 3.0443 m and $EA = 10^{10}$ N, without gravity, for 10 s. " ..
    "Average acceleration without control of its step gains energy without bound.",
  cases = { {
    name = "stiff_pendulum", title = "mass on a stiff bar, four turns, default scheme, steps of at most 5 ms",
    checks = { { "time of a turn", unit = "s", exact = 2.47771, tolerance = 0.01 },
      { "least energy", unit = "J", exact = 297.992, tolerance = 0.01 },
      { "largest energy", unit = "J", exact = 297.992, tolerance = 0.01 },
      { "angular momentum", unit = "kg m2/s", exact = 235.020, tolerance = 0.01 } },
    run = function()
      local mass, length, speed = 10, 3.0443, 7.72
      local m = trilith.model { name = "pendulum", gravity = 0 }
      m:material { name = "m", density = 1e-6, E = 1e13 }
      local bar = m:frame { name = "bar", material = "m", floating = true,
        velocity = { 0, speed/2 }, spin = speed/length,
        joints = { hinge = { at = { 0, 0 }, support = { x = "fixed", y = "fixed" } },
          mass = { at = { length, 0 }, mass = mass, inertia = 1e-3 } },
        members = { { from = "hinge", to = "mass", divisions = 1,
          section = trilith.section { area = 1e-3, inertia = 1e-9, depth = 0.03 } } } }
      local least, most, turns, last, before_x, before, momentum = math.huge, 0, 0, 0, length, 0, 0
      m:run { duration = 10, integrator = "implicit", until_true = function()
        local energy = m.energy
        local all = energy.kinetic + energy.strain
        least, most = math.min(least, all), math.max(most, all)
        local x, y = bar:point "mass"
        if before < 0 and y >= 0 and x > 0 then turns, last = turns + 1, m.time - m.dt*y/(y - before) end
        momentum = mass*(before_x*y - before*x)/m.dt
        before_x, before = x, y
        return false
      end }
      return { ["time of a turn"] = last/turns, ["least energy"] = least, ["largest energy"] = most,
        ["angular momentum"] = momentum }
    end,
  } },
}
