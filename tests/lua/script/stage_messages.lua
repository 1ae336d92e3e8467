-- Wrong input of stages, handlers, histories and sets, and errors found only when the model is built: each case is one
-- line of script and the expected one-line message with its line number.
local trilith = require "trilith"
local given = dofile "wrong_input.lua"

local stone, square, new, built, with_block, late = given.stone, given.square, given.new, given.built, given.with_block,
  given.late
local quake = trilith.motion "elcentro_1940_rest_ns.csv"

local function closed()
  local w = new()
  w:close()
  return w
end
local function with_contact(a, b)
  local w = with_block("up", 0)
  w:contact { between = { a, b }, law = stone }
  return w
end
local function with_results()
  local w = new()
  w:results { file = "first.h5" }
  return w
end

local m, b = new(), built()
local nobody = b:bodies { name = "nobody" }
given.check {
  -- mass scaling
  { function() late():run { duration = 1, mass_scaling = 2 } end,
    "run: 'mass_scaling' is 2, must be a table { step = , most = , bodies = }" },
  { function() late():run { duration = 1, mass_scaling = { most = 2 } } end,
    "run: mass_scaling: 'step' is missing; give a number in s" },
  { function() late():run { duration = 1, mass_scaling = { step = 1e-5, steps = 1 } } end,
    "run: mass_scaling: unknown key 'steps'; did you mean 'step'?" },
  { function() late():run { duration = 1, mass_scaling = { step = 0 } } end,
    "stage 'run': mass_scaling: step is 0 s, must be finite and above 0" },
  { function() late():run { duration = 1, dt = 1e-6, mass_scaling = { step = 1e-5 } } end,
    "stage 'run': dt is 1e-06 s and mass_scaling has a step of 1e-05 s; leave dt out; mass_scaling sets the step"
  },
  { function() late():run { duration = 1, integrator = "implicit", mass_scaling = { step = 1e-5 } } end,
    "stage 'run': mass_scaling is for explicit steps; implicit steps do not need it; keep one" },
  { function() late():consolidate { integrator = "static", mass_scaling = { step = 1e-5 } } end,
    "consolidate: mass_scaling is for explicit steps; integrator = \"static\" has none" },
  -- stages
  { function() m:run {} end, "run: 'duration' is missing; give a number in s" },
  { function() m:run { duration = -1 } end, "stage 'run': duration is -1 s, must be finite and above 0" },
  { function() m:run { duration = 1, dt = 1 } end,
    "stage 'run': dt is 1 s, the longest stable step is 0.1 s at t = 0 s; leave dt out, or: no stiffness governs; "
      .. "steps are limited to 0.1 s, and by motions, loads and bearings" },
  { function() b:shake { body = "bass", x = quake } end,
    "shake: body: there is no body or group 'bass'; did you mean 'base'?" },
  { function() b:shake { body = "base" } end, "shake: no motion is given; give x, y or rotation = trilith.motion ..." },
  { function() b:shake { body = "base", x = trilith.motion { acceleration = { 0, 0, 0 }, dt = 1 } } end,
    "shake: 'x': motion 'samples of the script' is zero everywhere; check the file and its column" },
  { function() b:shake { body = "base", x = trilith.motion { acceleration = { 0, 1, 0 }, dt = 1 } } end,
    "shake: 'x': motion 'samples of the script' drifts: 1 m in 2 s, end velocity 100 cm/s (100 % of "
      .. "PGV), mean of the last quarter 83.3 cm/s (83.3 %). Correct its baseline, as by motion:baseline(1), start it "
      .. "from the velocity of its source (zero mean velocity needs -50 cm/s), or use a version of the record that "
      .. "begins and ends at rest. To allow the drift, give trilith.motion the key allow_drift = true" },
  { function() b:fix("block", "xz") end,
    "fix: directions are the text 'xz', must be a text of x, y and r, as in \"xy\"" },
  { function() b:shake { body = "base", motions = { { body = "base", x = trilith.ramp { by = 1, duration = 1 } } } }
    end,
    "shake: 'body' cannot be given with 'motions'; give it in each row" },
  { function() b:history { name = "of two", of = function() return 1 end, what = "ux" } end,
    "history 'of two': 'what' cannot be given with 'of', whose function gives the number; keep one" },
  { function() new():consolidate { rest = { ratio = 0 } } end,
    "stage 'consolidation': unbalanced ratio at rest is 0, must be finite and above 0" },
  { function() b:fix(7) end, "fix: 7 is not a body; give a body, a set, a name, or a list of these" },
  { function() b:fix(m:body "base") end, "fix: body 'base' belongs to another model" },
  { function() b:fix(nobody) end,
    "fix: the set of bodies is empty, so the call has no effect; check the filters of its m:bodies{...}" },
  { function() b:free(nobody) end,
    "free: the set of bodies is empty, so the call has no effect; check the filters of its m:bodies{...}" },
  { function() b:free "block" end,
    "free: body 'block' is free already in x, y, rotation, so there is nothing to release" },
  { function() b:free({ "block", "other" }, "y") end,
    "free: the 2 bodies are free already in y, so there is nothing to release" },
  { function() b:release { body = nobody } end,
    "release: body: the set of bodies is empty, so the call has no effect; check the filters of its m:bodies{...}" },
  { function() b:release { body = "block" } end,
    "release: body 'block' is free already in x, y, rotation, so there is nothing to release" },
  { function() b:release { body = { "block", "other" }, y = true } end,
    "release: the 2 bodies are free already in y, so there is nothing to release" },
  { function() b:point_load { body = nobody, force = { 1, 0 } } end,
    "point_load: body: the set of bodies is empty, so the call has no effect; check the filters of its m:bodies{...}" },
  { function() b:pressure { body = nobody, face = "top", value = 1 } end,
    "pressure: body: the set of bodies is empty, so the call has no effect; check the filters of its m:bodies{...}" },
  { function() b:drive { body = nobody, x = quake } end,
    "drive: body: the set of bodies is empty, so the call has no effect; check the filters of its m:bodies{...}" },
  { function() b:shake { body = nobody, x = quake } end,
    "shake: body: the set of bodies is empty, so the call has no effect; check the filters of its m:bodies{...}" },
  { function() b:stop() end, "stop: no stage runs; call it from a handler or a story while one does" },
  { function() return b.energy.kin end,
    "the energy balance has no 'kin'; did you mean 'kinetic'? Its terms are kinetic, gravity, contact_elastic, "
      .. "bearing_elastic, strain, contact_damping, contact_friction, contact_fracture, bearing_damping, "
      .. "bearing_inner, bearing_failure, plastic, element_damping, mass_damping, rest_damping, support, load, "
      .. "left_bounds, numerical, added, removed, water, heat, residual" },
  -- handlers and histories
  { function() m:on("bearing.faild", print) end,
    "on: there is no event 'bearing.faild'; did you mean 'bearing.failed'?" },
  { function() m:on("impact") end, "on: needs a function; this is nil" },
  { function() m:every(0, print) end, "every: the interval is 0, must be a number of seconds above 0" },
  { function() m:on_step "x" end, "on_step: needs a function; this is a string" },
  { function() m:wait "impact" end, "wait: only within a story, see m:story(function() ... end)" },
  { function() m:wait { "impact", wihtin = 3 } end, "wait: unknown key 'wihtin'; did you mean 'within'?" },
  { function() m:history { name = "h", body = "base", what = "z" } end,
    "history 'h': 'what' is 'z', which is not a reading of a body; known: x, y, rotation, vx, vy, spin, ux, uy, "
      .. "speed, mass, "
      .. "inertia, area, sxx, syy, sxy, reaction_x, reaction_y, plastic" },
  { function() m:history { name = "h", what = "sped" } end,
    "history 'h': 'what' is 'sped', which is not a reading of the model (for others give body, bearing, seat, "
      .. "storey or seepage); did "
      .. "you mean 'speed'?" },
  { function() m:history { name = "h", what = "" } end,
    "history 'h': 'what' is '', which is not a reading of the model (for others give body, bearing, seat, "
      .. "storey or seepage); "
      .. "known: "
      .. "time, dt, steps, thickness, tilted, speed, ratio, residual, base_shear, top_drift, damage, largest_opening, "
      .. "largest_slip, push_force, push_displacement" },
  { function() m:history { name = "h", of = 3 } end, "history 'h': 'of' is 3, must be a function" },
  { function() m:results { frames = 1 } end, "results: 'file' is missing; give a text" },
  { function() m:results { file = "x.h5", frames = 0 } end, "results: 'frames' is 0 s, must be above 0" },
  { function() with_results():results { file = "second.h5" } end,
    "results: already set, to 'first.h5'; a model has one file, so give everything in one call" },
  -- errors found when the model is built
  { function() with_contact("stone", "qq"):run { duration = 1 } end,
    "contact of 'stone' and 'qq': there is no material, group or body 'qq'; known: *, stone" },
  { function() with_contact("uup", "stone"):run { duration = 1 } end,
    "contact of 'uup' and 'stone': there is no material, group or body 'uup'; did you mean 'up'?" },
  { function() trilith.model({}):run { duration = 1 } end, "model: there is no body; add at least one" },
  { function() with_block("in", -0.5):run { duration = 1 } end,
    "bodies 'base' and 'in' overlap by 0.5 m at the start (0.35 of the smaller one's size, at most 1e-06 "
      .. "is allowed); move one of them, or raise overlap_allowed" },
  { function() with_block("up", 5):run { duration = 1 } end,
    "body 'up' has no support: no contact or bearing connects it to a fixed or driven body; place it on another "
      .. "body, give a contact law for its material, or give floating = true" },
  { function() late():body { name = "late", outline = square, mass = 1 } end,
    "body 'late' has no support: no contact or bearing connects it to a fixed or driven body; place it on another "
      .. "body, give a contact law for its material, or give floating = true" },
  { function() return closed().time end, "the model is closed" },
  -- sets without a body, counts out of range, control characters
  { function() built():pushover { body = built():bodies { name = "none" }, at = "top", rate = 1, displacement = 1 } end,
    "pushover: body: set of 0 bodies belongs to another model" },
  { function() b:pushover { body = b:bodies { name = "none" }, at = "top", rate = 1, displacement = 1 } end,
    "pushover: 'body' is an empty set; check the filters of its m:bodies{...}" },
  { function() b:pushover { body = b:bodies { name = "none" }, rate = 1, displacement = 1 } end,
    "pushover: 'body' is an empty set; check the filters of its m:bodies{...}" },
  { function() b:history { name = "h", storey = 2^31, what = "drift" } end,
    "history 'h': 'storey' is 2147483648, must be within -1e9 and 1e9" },
  { function() b:history { name = "h", storey = math.mininteger, what = "drift" } end,
    "history 'h': 'storey' is -9.223372036854776e+18, must be within -1e9 and 1e9" },
  { function() b:history { name = "h", storey = 0, what = "drift" } end,
    "history 'h': there is no storey 0; there are 0" },
  { function() m:every(1e-300, print) end, "every: the interval is 1e-300 s, must be at least 1e-09 s" },
  { function() new():block { name = "\27[31mred", width = 1, height = 1, material = "stone" } end,
    "block '\\27[31mred': 'name' '\\27[31mred' holds the control character \\27; leave it out" },
  { function() new():block { name = "k\0one", width = 1, height = 1, material = "stone" } end,
    "block 'k\\0one': 'name' 'k\\0one' holds the control character \\0; leave it out" },
  { function() new():material { name = "a\nb", density = 1 } end,
    "material 'a\\10b': 'name' 'a\\10b' holds the control character \\10; leave it out" },
  { function() new():block { name = "a", groups = { "\127" }, width = 1, height = 1, material = "stone" } end,
    "block 'a': 'groups' '\\127' holds the control character \\127; leave it out" },
  { function() trilith.model { name = "\u{9B}31m" } end,
    "model '\\194\\15531m': 'name' '\\194\\15531m' holds the control character \\194\\155; leave it out" },
  { function() b:body "block\0" end,
    "body: there is no body 'block\\0'; did you mean 'block'?" },
  { function() trilith.params { ["a\27"] = 1 } end,
    "parameter 'a\\27' holds the control character \\27; leave it out" },
}

-- A handler's request that is rejected at the step border is reported with the handler's line, and once.
do
  local w, done = late(), false
  w:every(1e-3, function()
    if not done then w:remove "block" w:remove "block" end
    done = true
  end)
  local good, message = pcall(w.run, w, { duration = 0.01 })
  assert(not good and message:find("^script/stage_messages.lua:%d+: remove: body 'block' was removed at"), message)
end
