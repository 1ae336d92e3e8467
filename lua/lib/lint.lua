-- m:lint(): what of a model is likely not meant, each with the next thing to try.
local _, core = ...
local model_methods = core.members "model"

local checks = {}

function checks.laws(model, add)
  for _, law in ipairs(core.contact_laws(model)) do
    local kind, name = tostring(law):match "^(%w+)", law.name
    if law.beta == 0 then
      add(("law '%s' has no damping (beta = 0): what strikes it bounces for ever; give beta = 2*zeta/omega")
        :format(name))
    end
    if kind ~= "frictional" and law.mu > 0 and law.tension > law.cohesion / law.mu then
      add(("law '%s': tension %g Pa is above cohesion/mu = %g Pa, so shear fails first in pure tension; is that meant?")
        :format(name, law.tension, law.cohesion / law.mu))
    end
    if law.ks > law.kn then
      add(("law '%s': ks is above kn; a joint is mostly softer in shear, ks = 0.4 to 0.5 kn"):format(name))
    end
  end
end

function checks.bodies(model, add)
  local lightest, heaviest
  for body in model:bodies {} do
    local outline, size = body.outline, math.sqrt(body.area)
    for i = 1, #outline do
      local a, b = outline[i], outline[i % #outline + 1]
      local edge = math.sqrt((a[1] - b[1])^2 + (a[2] - b[2])^2)
      if edge < 1e-3*size then
        add(("body '%s' has an edge of %.3g m, %.1g of its size; leave that corner out"):format(body.name, edge,
          edge/size))
        break
      end
    end
    if not lightest or body.mass < lightest.mass then lightest = body end
    if not heaviest or body.mass > heaviest.mass then heaviest = body end
  end
  if lightest and lightest.mass < 1e-4*heaviest.mass then
    add(("body '%s' (%.3g kg) has %.1g of the mass of '%s'; it makes all steps short, see explain_dt()"):format(
      lightest.name, lightest.mass, lightest.mass/heaviest.mass, heaviest.name))
  end
end

function checks.sinking(model, add)
  local softest
  for _, law in ipairs(core.contact_laws(model)) do
    if not softest or law.kn < softest.kn then softest = law end
  end
  if not softest then
    add "there is no contact law, so nothing touches anything; see m:contact{between = {\"*\", \"*\"}, law = ...}"
    return
  end
  for body in model:bodies {} do
    local width, height = math.sqrt(body.area), math.sqrt(body.area)
    local sinks = body.mass*9.81/(softest.kn*width*model.thickness)
    if sinks > 1e-3*height then
      add(("body '%s' sinks by about %.2g m into law '%s' under its own weight; raise kn"):format(body.name, sinks,
        softest.name))
      return
    end
  end
end

function checks.bearings(model, add)
  for _, bearing in ipairs(model.bearings) do
    if not bearing.limited then
      add(("bearing '%s' has no limit, so it never fails; is that meant?"):format(bearing.name))
    end
  end
end

function checks.rest(model, add)
  if model.time > 0 then return end
  local worst = model.worst
  if worst.ratio and worst.ratio > 0.05 then
    add(("body '%s' does not rest as it stands (%.2g of the largest force is unbalanced); begin with m:consolidate()")
      :format(worst.body.name, worst.ratio))
  end
end

function checks.recording(model, add)
  if model.time == 0 and not core.records(model) then
    add "nothing is recorded; see m:results{file = \"out.h5\"} and m:history{...}"
  end
end

--- m:lint(): a list of findings, and the same in words.
function model_methods.lint(model)
  local found = {}
  for _, name in ipairs { "laws", "bodies", "sinking", "bearings", "rest", "recording" } do
    checks[name](model, function(text) found[#found + 1] = text end)
  end
  found.text = #found == 0 and "nothing found" or "- " .. table.concat(found, "\n- ")
  return setmetatable(found, core.findings)
end
