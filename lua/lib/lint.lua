-- m:lint(): probable errors of a model, each with advice.
local _, core = ...
local model_methods = core.members "model"

local checks = {}

local most_faults = 10 -- reported one by one
local least_damping, usual_damping = 0.01, 0.1 -- shares of critical damping

--- Errors that prevent building the model. True if there are none.
function checks.faults(model, add)
  local faults = core.faults(model)
  for i = 1, math.min(#faults, most_faults) do add(faults[i]) end
  if #faults > most_faults then
    add(("and %d more errors that prevent building the model"):format(#faults - most_faults))
  end
  return #faults == 0
end

function checks.doubts(model, add)
  for _, text in ipairs(core.doubts(model)) do add(text) end
end

-- For a model with errors the contacts are unknown.
function checks.damping(model, add, whole)
  local damped = whole and core.damping(model, least_damping) or {}
  for _, law in ipairs(core.contact_laws(model)) do
    local d = damped[law.name]
    local better = d and
      ("beta = %.2g s gives %g %% of critical"):format(2*usual_damping/d.frequency, 100*usual_damping)
    if law.beta == 0 then
      add(("law '%s' has no damping (beta = 0): bodies that strike it bounce for ever; %s")
        :format(law.name, better or "give beta = 2*zeta/omega"))
    elseif d and d.less > 0 then
      add(("law '%s' damps %d of %d contacts by less than %g %% of critical ('%s' and '%s' by %.2g %%, with "
        .. "beta = %g s and omega = %.3g rad/s): bodies on them may rattle and drift; %s"):format(law.name, d.less,
        d.all, 100*least_damping, d.a.name, d.b.name, 100*d.share, law.beta, d.frequency, better))
    end
  end
end

--- A number of a law, or nil if laws of its kind have no such number.
local function number_of(law, key)
  local known, value = pcall(function() return law[key] end)
  return known and value or nil
end

function checks.laws(model, add)
  for _, law in ipairs(core.contact_laws(model)) do
    local name, tension = law.name, number_of(law, "tension")
    if tension and law.mu > 0 and tension > law.cohesion / law.mu then
      add(("law '%s': tension %g Pa is above cohesion/mu = %g Pa, so shear fails first in pure tension; is that "
        .. "intended?")
        :format(name, tension, law.cohesion / law.mu))
    end
    if law.ks > law.kn then
      add(("law '%s': ks is above kn; a joint is mostly softer in shear, ks = 0.4 to 0.5 kn"):format(name))
    end
  end
end

function checks.edges(model, add)
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
  end
end

function checks.solids(model, add)
  local faults = core.solid_faults(model)
  for i = 1, math.min(#faults, most_faults) do add(faults[i]) end
  if #faults > most_faults then add(("and %d more like it"):format(#faults - most_faults)) end
end

function checks.masses(model, add)
  local lightest, heaviest
  for body in model:bodies {} do
    if not lightest or body.mass < lightest.mass then lightest = body end
    if not heaviest or body.mass > heaviest.mass then heaviest = body end
  end
  if lightest and lightest.mass < 1e-4*heaviest.mass then
    add(("body '%s' (%.3g kg) has %.1g of the mass of '%s'; it makes all steps short, see explain_dt()"):format(
      lightest.name, lightest.mass, lightest.mass/heaviest.mass, heaviest.name))
  end
end

--- Magnitude of the present gravity [m/s2]; for a model without gravity, the standard one.
local function weight_of(model)
  local square = 0
  for _, part in ipairs(model.gravity) do square = square + part*part end
  return square > 0 and math.sqrt(square) or 9.80665
end

function checks.sinking(model, add)
  local softest
  for _, law in ipairs(core.contact_laws(model)) do
    if not softest or law.kn < softest.kn then softest = law end
  end
  if not softest then
    add "there is no contact law, so no bodies touch; see m:contact{between = {\"*\", \"*\"}, law = ...}"
    return
  end
  for body in model:bodies {} do
    local width, height = math.sqrt(body.area), math.sqrt(body.area)
    local sinks = body.mass*weight_of(model)/(softest.kn*width*model.thickness)
    if sinks > 1e-3*height then
      add(("body '%s' sinks by about %.2g m under its own weight (law '%s'); raise kn"):format(body.name, sinks,
        softest.name))
      return
    end
  end
end

-- Elastic slip before sliding is mu p/ks. If sliding reverses often, residual slip converges slowly with that; it
-- should be small compared with the relevant slip.
local usual_slip, slip_share = 0.1, 1e-3 -- [m], and its share

function checks.slipping(model, add, slip)
  local most = slip_share*(slip or usual_slip)
  local heaviest, pressure = nil, 0
  for body in model:bodies {} do
    local p = body.mass*weight_of(model)/(math.sqrt(body.area)*model.thickness)
    if p > pressure and not core.is_held(body) then heaviest, pressure = body, p end
  end
  for _, law in ipairs(core.contact_laws(model)) do
    local gives = law.mu*pressure/law.ks
    if gives > most then
      add(("law '%s' deforms by %.2g m before it slides ('%s' under its own weight), more than %g of a slip of %g m: "
        .. "residual slip after cyclic sliding will be inaccurate; give ks = %.1g Pa/m, or the expected slip, "
        .. "m:lint{ slip = }")
        :format(law.name, gives, heaviest.name, slip_share, slip or usual_slip, law.mu*pressure/most))
    end
  end
end

function checks.bearings(model, add)
  for _, bearing in ipairs(model.bearings) do
    if not bearing.limited then
      add(("bearing '%s' has no limit, so it never fails; is that intended?"):format(bearing.name))
    end
  end
end

function checks.rest(model, add)
  if model.time > 0 then return end
  local worst = model.worst
  if worst.ratio and worst.ratio > 0.05 then
    add(("body '%s' is not in equilibrium at the start (%.2g of the largest force is unbalanced); begin with "
      .. "m:consolidate()")
      :format(worst.body.name, worst.ratio))
  end
end

function checks.recording(model, add)
  if model.time == 0 and not core.records(model) then
    add "nothing is recorded; see m:results{file = \"out.h5\"} and m:history{...}"
  end
end

local of_any = { "doubts", "laws", "damping" }
-- Outlines, areas and unbalanced bodies are checked for plane models only.
local of_whole = { [2] = { "edges", "masses", "sinking", "slipping", "bearings", "rest", "recording" },
  [3] = { "solids", "masses", "bearings", "recording" } }

--- The expected slip [m] from m:lint{ slip = }; nil if not given.
local function expected_slip(options)
  if options == nil then return nil end
  if type(options) ~= "table" then core.fail "lint: takes a table, as in m:lint{ slip = 0.02 }" end
  for key in pairs(options) do
    if key ~= "slip" then core.fail(("lint: unknown key '%s'; known: slip"):format(tostring(key))) end
  end
  local slip = options.slip
  if slip ~= nil and not (type(slip) == "number" and slip > 0) then
    core.fail(("lint: 'slip' is %s, must be a number in m, above 0"):format(core.what_is(slip)))
  end
  return slip
end

--- m:lint{ slip = }: a list of findings, and the same in words. Errors that prevent building the model are findings
--- too.
function model_methods.lint(model, options)
  local slip = expected_slip(options)
  local found = {}
  local function add(text) found[#found + 1] = text end
  local whole = checks.faults(model, add)
  for _, name in ipairs(of_any) do checks[name](model, add, whole) end
  if whole then
    for _, name in ipairs(of_whole[model.dim]) do checks[name](model, add, slip) end
  end
  found.text = #found == 0 and "nothing found" or "- " .. table.concat(found, "\n- ")
  return setmetatable(found, core.findings)
end
