-- Undamped blocks bounce by their default steps. A contact that closes within a step loses energy, one that opens gains
-- it, each up to accuracy/2 of the impact. The sign varies with the borders of the steps. So the errors must not add up
-- to a gain, and their size must follow `accuracy`.
local trilith = require "trilith"
local g, bounces = 9.80665, 8

--- Gains of energy per bounce, as shares of the energy of the fall by `fall`, of a block that begins to bounce.
local function gains(dim, fall, accuracy, list)
  local m = trilith.model { name = "bounces", dim = dim }
  m:material { name = "stone", density = 2000 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e8, ks = 5e7, mu = 0.5 } }
  local b
  if dim == 2 then
    m:block { name = "floor", width = 4, height = 0.5, at = { -2, -0.5 }, material = "stone", support = "fixed" }
    b = m:block { name = "b", width = 0.5, height = 0.4, at = { -0.25, fall }, material = "stone", floating = true }
  else
    m:block { name = "floor", size = { 4, 4, 0.5 }, at = { -2, -2, -0.5 }, material = "stone", support = "fixed" }
    b = m:block { name = "b", size = { 0.5, 0.5, 0.4 }, at = { -0.25, -0.25, fall }, material = "stone",
      floating = true }
  end
  local energy, before, missed, count = b.mass*g*fall, -1, 0, 0
  m:on_step(function()
    local speed = dim == 2 and b.vy or b.vz
    if before > 0 and speed <= 0 and count < bounces then
      count = count + 1
      list[#list + 1] = m.energy.residual/energy - missed
      missed = m.energy.residual/energy
    end
    before = speed
  end)
  m:run { duration = 2*(bounces + 1)*math.sqrt(2*fall/g), accuracy = accuracy, integrator = "explicit" }
  assert(count == bounces, count)
  m:close()
end

for _, dim in ipairs { 2, 3 } do
  for _, accuracy in ipairs { 0.02, 2e-3 } do
    local list, sum, squares, most = {}, 0, 0, 0
    for fall = 0.1, 0.39, 0.02 do gains(dim, fall, accuracy ~= 0.02 and accuracy or nil, list) end
    for _, gain in ipairs(list) do
      sum, squares, most = sum + gain, squares + gain^2, math.max(most, math.abs(gain))
    end
    local mean, rms = sum/#list, math.sqrt(squares/#list)
    local what = ("%dD, accuracy %g: mean gain %.3g, root mean square %.3g, largest %.3g"):format(dim, accuracy, mean,
      rms, most)
    assert(#list == 15*bounces, #list)
    assert(mean < accuracy/40 and mean > -accuracy/10, what)
    assert(rms < accuracy/4 and rms > accuracy/200, what)
    assert(most < 0.6*accuracy, what)
  end
end
