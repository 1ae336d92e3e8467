-- Wrong input: each case is one line of script and the expected one-line message with its line number.
local trilith = require "trilith"
local given = dofile "wrong_input.lua"

local huge, nan = math.huge, 0 / 0
local stone, spring, square = given.stone, given.spring, given.square
local new, built, with_block, late = given.new, given.built, given.with_block, given.late
local quake = trilith.motion "elcentro_1940_rest_ns.csv"

local function meshed()
  local w = trilith.model { name = "meshed" }
  w:material { name = "soft", density = 2000, E = 1e9, nu = 0.2 }
  w:block { name = "mesh", width = 1, height = 1, material = "soft", body = { mesh = { 2, 2 } }, floating = true }
  return w
end
local function bonded()
  local w = new()
  w:contact { between = { "stone", "stone" }, name = "mortar", law = trilith.cohesive { kn = 1e9, ks = 5e8, mu = 0.5,
    cohesion = 1e5, tension = 5e4, energy_tension = 20, energy_shear = 50 } }
  w:run { duration = 1e-4 }
  return w
end

local m, b = new(), built()
given.check {
  { function() new():block { name = "b", width = 1, height = 1, material = "stone", support = { r = "fixed" } } end,
    "block 'b': support: 'r' is written in full: rotation = \"fixed\"" },
  { function() new():block { name = "b", size = { 1, 1, 1 }, material = "stone" } end,
    "block 'b': 'size' is for blocks in space, in models with dim = 3; in the plane give width and height" },
  -- bearings, seats and changes without effect or with harmful effect
  { function() with_block("up", 0):bearing { name = "b", between = { "base", "up" }, at = { 0.5, 0 },
      along = trilith.friction { mu = 0.3, stiffness = 1e6 } } end,
    "bearing 'b': friction slides under the compression of the axial law, which is missing, so it never transfers a "
      .. "force; give axial a law that carries compression, such as trilith.linear{...}" },
  { function() with_block("up", 0):bearing { name = "b", between = { "base", "up" }, at = { 0.5, 0 },
      axial = trilith.pendulum { radius = 1, mu = 0.3, stiffness = 1e6 } } end,
    "bearing 'b': pendulum slides under the compression of the axial law, which is itself a sliding law, so it never "
      .. "transfers a force; give axial a law that carries compression, such as trilith.linear{...}" },
  { function() b:change { bearing = "B1", along = trilith.friction { mu = 0.3, stiffness = 1e6 } } end,
    "change: bearing 'B1': friction slides under the compression of the axial law, which is missing, so it never "
      .. "transfers a force; give axial a law that carries compression, such as trilith.linear{...}" },
  { function() with_block("up", 0):seat { name = "s", body = "up", support = "base", at_end = { 0.8, 0 },
      edge = { 0.5, 0 }, inward = { -1, 0 } } end,
    "seat 's': 'at_end' lies 0.3 m beyond the edge, so the seat is lost at the start; 'inward' points from the edge "
      .. "over the seat: reverse it, or leave it out" },
  { function() with_block("up", 0):seat { name = "s", body = "up", support = "base", at_end = { 0.5, 1 },
      edge = { 0.5, 0 } } end,
    "seat 's': 'at_end' is over the edge, so 'inward' does not follow from them; give inward, from the edge over the "
      .. "seat" },
  { function() bonded():change { law = "mortar", tension = 1e6, cohesion = 1e6 } end,
    "change: cohesive: energy_tension is 20 J/m2, must be above tension^2/(2 kn) = 500, the energy that the joint "
      .. "stores at its strength; give more energy, or a stiffer joint, or use the bonded law" },
  -- input without effect
  { function() b:fix("block", "") end,
    "fix: directions are the text '', which names no direction; give some of x, y and r, as in \"xy\", or leave them "
      .. "out for "
      .. "all" },
  { function() late():run { to = 1, duration = 1 } end,
    "run: both 'to' and 'duration' are given; keep one: the time at which it ends, or how long it lasts" },
  { function() late():point_load { name = "p", body = "block", at = { 50, 5 }, force = { 0, 1 } } end,
    "load 'p' on 'block': its point (50, 5) is 49 m away from body 'block', which is 1.41 m large; give a point in it "
      .. "or near it, in m" },
  { function() late():point_load { body = "block", at = "tip", force = { 0, 1 } } end,
    "point_load: 'at' is 'tip', must be {x, y}, the name of a joint or one of centroid, top, bottom, left, right, "
      .. "top left, top right, bottom left, bottom right" },
  { function() trilith.cable { stiffness = 1, side = 0.5 } end, "cable: 'side' is 0.5, must be 1 or -1" },
  { function() trilith.cable { stiffness = 1, side = 0 } end, "cable: 'side' is 0, must be 1 or -1" },
  { function() trilith.gap { stiffness = 1, opening = 0, side = 0.5 } end,
    "gap: 'side' is 0.5, must be 1, -1, or 0 for both" },
  { function() trilith.gap { stiffness = 1, opening = 0, pull = 0.5 } end, "gap: 'pull' is 0.5, must be 0 or 1" },
  { function() trilith.bonded { kn = 1, ks = 1, mu = 1, cohesion = 1, tension = 1, loss_by_point = 0.5 } end,
    "bonded: 'loss_by_point' is 0.5, must be 0 or 1" },
  { function() trilith.cohesive { kn = 1, ks = 1, mu = 1, cohesion = 1, tension = 1, energy_tension = 9,
      energy_shear = 9, dilation = 0.2 } end,
    "cohesive: 'dilation' is given without 'dilation_slip', so that the joint does not dilate; give both, the opening "
      .. "per slip and the slip up to which it opens" },
  { function() bonded():change { law = "mortar", dilation_slip = 0.01 } end,
    "change: 'dilation_slip' is given without 'dilation', so that the joint does not dilate; give both, the opening "
      .. "per slip and the slip up to which it opens" },
  { function() with_block("up", 0):bearing { name = "b", between = { "base", "up" }, at = { 0.5, 0 }, along = spring,
      limit = {} } end,
    "bearing 'b': limit: no direction is named; give the displacement of one, as in limit = { along = 0.1 }" },
  { function() trilith.lead_rubber { strength = 1, post_stiffness = 10, stiffness = 50, ratio = 3 } end,
    "lead_rubber: both 'stiffness' and 'ratio' are given; keep one: K1, or K1 over post_stiffness" },
  { function() trilith.end_hinge { sagging = 1e5, softening = 0.1 } end,
    "end_hinge: softening is 0.1 rad, but without a capping rotation it never softens; give capping, the plastic "
      .. "rotation from which it does, or leave softening out" },
  { function() trilith.end_hinge { sagging = 1e5, residual = 0.2 } end,
    "end_hinge: residual is 0.2, but the moment never decreases to it; give capping and softening, or wear, or "
      .. "leave residual out" },
  { function() late():release { push = "q" } end, "release: there is no push 'q'; there are none" },
  { function() meshed():free("mesh", "r") end,
    "free: body 'mesh' is made of elements, whose nodes have no rotation to free; free x and y" },
  { function() meshed():fix("mesh", "r") end,
    "fix: body 'mesh' is made of elements, whose nodes have no rotation to hold; fix x and y, or hold some of its nodes"
  },
  -- units and parameters
  { function() return trilith.units "ft inhc" end, "there is no unit 'inhc'; did you mean 'inch'?" },
  { function() return trilith.units "in" end,
    "there is no unit 'in'; did you mean 'inch'? Other units of this kind: m, mm, cm, km, ft, yd" },
  { function() return trilith.units "lb" end, "there is no unit 'lb'; write lbf for a force, lbm for a mass" },
  { function() return trilith.units(3) end, 'units: takes one text, as in units "ft inch kip"; this is 3' },
  { function() return trilith.modle {} end, "trilith has no 'modle'; did you mean 'model'?" },
  -- model
  { function() trilith.model { gravty = 9.81 } end, "model: unknown key 'gravty'; did you mean 'gravity'?" },
  { function() trilith.model { name = "x", thickness = 0 } end, "model 'x': 'thickness' is 0 m, must be above 0" },
  { function() trilith.model { gravity = "down" } end,
    "model: 'gravity' is the text 'down', must be a number (downwards) or {x, y}, in m/s2" },
  { function() trilith.model { gravity = -9.81 } end,
    "model: 'gravity' is -9.81, must be not below 0: a number acts downwards; for other directions give a vector" },
  { function() trilith.model "x" end, "model: takes one table, as in model{ ... }; this is the text 'x'" },
  -- materials and laws
  { function() m:material { density = 2000 } end, "material: 'name' is missing; give a text" },
  { function() m:material { name = "a", density = -1 } end,
    "material 'a': density is -1 kg/m3, must be finite and above 0" },
  { function() trilith.motion { acceleration = { 0, nan, 0 }, dt = 0.1 } end,
    "motion 'samples of the script': acceleration of sample 2 is nan, must be a finite number" },
  { function() trilith.motion { acceleration = { 0, 1, 0 }, dt = 0.1 }:match { spectrum = { { 1, nan } } } end,
    "spectrum: acceleration of the target is nan m/s2, must be finite and above 0" },
  { function() trilith.rayleigh { ratios = { 0.05, nan }, frequencies = { 1, 2 } } end,
    "rayleigh: 'ratios[2]' is nan, must be a number above 0" },
  { function() m:material { name = "a", density = nan } end,
    "material 'a': 'density' is nan, must be a finite number in kg/m3" },
  { function() m:material { name = "a", density = 150 * trilith.units "pcf" } end,
    "material 'a': 'density' is 23563.1 kg/m3, more than any metal's; a weight by volume (pcf, kcf, N/m3) "
      .. "is given as unit_weight" },
  { function() m:material { name = "stone", density = 1 } end,
    "material 'stone' exists already; give each its own name" },
  { function() m:material { name = "a" } end, "material 'a': give either density (kg/m3) or unit_weight (N/m3)" },
  { function() trilith.frictional { kn = 1e9, mu = 0.5 } end, "frictional: 'ks' is missing; give a number in Pa/m" },
  { function() trilith.frictional { kn = 0, ks = 1, mu = 0.5 } end, "frictional: 'kn' is 0 Pa/m, must be above 0" },
  { function() trilith.frictional { kn = 1, ks = 1, mu = "x" } end,
    "frictional: 'mu' is the text 'x', must be a number" },
  { function() trilith.bonded { kn = 1, ks = 1, mu = 1, cohesion = 1, tensoin = 1 } end,
    "bonded: unknown key 'tensoin'; did you mean 'tension'?" },
  { function() trilith.linear {} end, "linear: 'stiffness' is missing; give a number in N/m" },
  { function() trilith.elastic_plastic { stiffness = 1, yield = 1, hardening = 1 } end,
    "elastic_plastic: 'hardening' is 1, must be not below 0 and at most 0.99" },
  { function() trilith.table { points = { { 0, 0 }, { 0, 1 } } } end,
    "table: displacement of point 2 is 0 m, must be above the displacement of point 1 (0 m)" },
  { function() trilith.table { points = { { 0, 0 }, { 1 } } } end,
    "table: point 2 of 'points' is {1}, must be {x, y}, two finite numbers" },
  { function() return stone.nk end, "this law has no 'nk'; did you mean 'kn'?" },
  { function() m:contact { between = { "stone" }, law = stone } end,
    "contact: 'between' holds 1 names, must hold two" },
  { function() m:contact { between = { "stone", "stome" }, law = stone } end,
    "contact: there is no material, group or body 'stome'; did you mean 'stone'?" },
  { function() m:contact { between = { "stone", "*" }, law = "rough" } end,
    "contact of 'stone' and '*': there is no law 'rough'; known: frictional 1, none" },
  { function() m:contact { between = { "stone", "*" }, law = spring } end,
    "contact: 'law' is a direction law, must be a contact law, the name of one, or \"none\"" },
  -- bodies
  { function() m:body { name = "a", outline = square, material = "stone", heigth = 2 } end,
    "body 'a': unknown key 'heigth'; did you mean 'weight'?" },
  { function() m:body { name = "a", outline = square, 3 } end,
    "body 'a': 3 is given without a key; write key = value" },
  { function() m:body { name = "a", material = "stone" } end,
    "body 'a': 'outline' is missing; give a list of points {{x, y}, ...}" },
  { function() m:body { name = "a", outline = { { 0, 0 }, { 1, nan }, { 1, 1 } }, material = "stone" } end,
    "body 'a': point 2 of 'outline' is {1, nan}, must be {x, y}, two finite numbers" },
  { function() m:body { name = "a", outline = { { 0, 0 }, { 1, 1 } }, material = "stone" } end,
    "body 'a': outline has 2 different points, needs at least 3" },
  { function() m:body { name = "a", outline = { { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 } }, material = "stone" } end,
    "body 'a': outline crosses or touches itself at (0.5, 0.5): the edge from point 1 (0, 0) to point 2 "
      .. "(1, 1) meets the edge from point 3 (1, 0) to point 4 (0, 1); give the points in order around the "
      .. "outline" },
  { function() m:body { name = "a", outline = square, material = "stome" } end,
    "body 'a': there is no material 'stome'; did you mean 'stone'?" },
  { function() m:body { name = "a", outline = square } end,
    "body 'a': give a density, mass or weight, or a material that has a density" },
  { function() m:body { name = "a", outline = square, mass = 0 } end,
    "body 'a': mass is 0 kg, must be finite and above 0" },
  { function() m:body { name = "a", outline = square, mass = -3 } end,
    "body 'a': mass is -3 kg, must be finite and above 0" },
  { function() m:body { name = "a", outline = square, mass = huge } end,
    "body 'a': 'mass' is inf, must be a finite number in kg" },
  { function() m:body { name = "a", outline = square, mass = 1, weight = 1 } end,
    "body 'a': more than one of density, mass and weight is given; keep one" },
  { function() m:body { name = "a", outline = square, mass = 1, support = "fixd" } end,
    "body 'a': 'support' is 'fixd', must be \"fixed\" or \"free\"" },
  { function() m:body { name = "a", outline = square, mass = 1, support = { z = "fixed" } } end,
    "body 'a': support: unknown key 'z'; known: x, y, rotation" },
  { function() m:body { name = "base", outline = square, mass = 1 } end,
    "body 'base' exists already; give each its own name" },
  { function() m:body { outline = square, mass = 1 } end, "body: 'name' is missing; give a text" },
  { function() m:body "bse" end, "body: there is no body 'bse'; did you mean 'base'?" },
  { function() m.body { name = "a" } end, "argument 1 is a table, must be a model; call methods with ':'" },
  { function() m:pier { name = "P", station = 0, height = 3 } end,
    "pier 'P': 'stem_width' is missing; give a number in m, or seat and gap" },
  { function() m:pier { name = "P", station = 0, height = -3, stem_width = 1, material = "stone" } end,
    "pier 'P': height is -3 m, must be finite and above 0" },
  { function() m:arch { voussoirs = 2.5 } end, "arch: 'voussoirs' is 2.5, must be a whole number" },
  { function() m:abutment { side = "top", x = 0, height = 1, width = 1 } end,
    "abutment 'abutment': 'side' is 'top', must be one of left, right" },
  { function() m:arch { material = "stone", fixed = "abutment" } end,
    "arch: fixed names 'abutment', but there is no such group or part; did you mean 'abutments'?" },
  { function() m:arch { span = 4, material = "stone" } end, "arch: span and rise are given together; give both or "
    .. "neither" },
  { function() m:arch { span = 4, rise = 1, radius = 3 } end,
    "arch: span and rise define the same shape as radius, half_angle and offset; keep one of the two" },
  { function() m:rubble { outline = { { 0, 0 }, { 1, 0 }, { 1, 1 } }, stones = 0, material = "stone" } end,
    "rubble: stones is 0, must be a whole number from 1 to 10000" },
  { function() m:wall { name = "w", length = 2, courses = 3, by_group = { slab = { weight = 1 } } } end,
    "wall 'w': by_group names 'slab', but there is no such group or part; known: units, storey 1, course 1, w, "
      .. "course 2, course 3" },
  { function() m:wall { length = 2, courses = 3, by_group = { units = { wieght = 1 } } } end,
    "wall: by_group: units: unknown key 'wieght'; did you mean 'weight'?" },
  { function() m:wall { length = 2, courses = 3, bond = "english cross" } end,
    { "wall: there is no bond 'english cross'; .*running.*" } },
  { function() m:wall { length = 2, courses = 3, openings = { { x = 1, width = 0.5, hight = 1 } } } end,
    "wall: opening 1: unknown key 'hight'; did you mean 'height'?" },
  { function() m:wall { length = 2, courses = 3, openings = { { x = 1, width = 1, height = 1, storey = "top" } } } end,
    "wall: opening 1: 'storey' is the text 'top', must be a whole number or a list of whole numbers" },
  { function() m:wall { length = 2, storeys = "two" } end,
    "wall: 'storeys' is the text 'two', must be a whole number" },
  { function() m:add {} end, "add: the list of parts is empty; give a list, as from trilith.build" },
  { function() return m.bodys end, "model 'wrong' has no 'bodys'; did you mean 'body'?" },
  { function() m.time = 3 end, "'time' of model 'wrong' can be read, not set" },
  { function() return b:body("block").hight end,
    "body 'block' has no 'hight'; known: area, bearings, fibres, forces, groups, hinges, inertia, kind, mass, "
      .. "material, name, outline, plastic, point, present, reaction_x, reaction_y, reactions, removed_at, resting, "
      .. "rotation, seats, speed, spin, sxx, sxy, syy, ux, uy, vx, vy, x, y" },
  { function() return m:bodies { grup = "x" } end, "bodies: unknown key 'grup'; did you mean 'group'?" },
  -- bearings and seats
  { function() m:bearing { name = "B", between = { "base", "nobody" }, at = { 0, 0 } } end,
    "bearing 'B': there is no body 'nobody'; known: base" },
  { function() m:bearing { name = "B", between = { "base", "base" }, at = { 0, 0 } } end,
    "bearing 'B': connects body 'base' with itself; name two bodies" },
  { function() m:bearing { name = "B", between = { "base", "base" } } end,
    "bearing 'B': its place is missing; give at = {x, y}, or from = {x, y} and to = {x, y}" },
  { function() m:bearing { name = "B", between = { "base", "base" }, at = { 0, 0 }, along = stone } end,
    "bearing 'B': 'along' is a contact law, must be a direction law" },
  { function() m:bearing { name = "B", between = { "base", "base" }, at = { 0, 0 }, limit = { allong = 1 } } end,
    "bearing 'B': limit: unknown key 'allong'; did you mean 'along'?" },
  { function() return b.bearings.B2 end, "there is no bearing 'B2'; did you mean 'B1'?" },
  { function() built():bearing { name = "B", between = { "base", "block" }, at = { 0, 0 } } end,
    "bearing 'B': has no law, so it transfers no force; give along, axial or turning a law such as "
      .. "trilith.linear{...}" },
  { function() built():bearing { name = "B", between = { "base", "block" }, at = { 0, 0 }, along = spring,
      becomes = "frictional 1" } end,
    "bearing 'B': becomes 'frictional 1' at its limit, but has none; give limit = { along = }, axial or turning" },
  { function() built():bearing { name = "B", between = { "base", "block" }, at = { 0, 0 }, along = spring,
      limit = { along = 1 }, becomes = "frictional 1", becomes_from = "here" } end,
    "bearing 'B': becomes_from is \"here\", but no bearing is its successor; name one under becomes" },
  { function() m:bearing { name = "B", between = { "base", "base" }, at = { 0, 0 }, becomes_from = "there" } end,
    "bearing 'B': 'becomes_from' is 'there', must be one of start, here" },
  { function() m:bearing { name = "B", between = { "base", "base" }, at = { 0, 0 }, becomes_from = 3 } end,
    "bearing 'B': 'becomes_from' is 3, must be \"start\", \"here\", or a table as in { along = \"here\" }" },
  { function() m:bearing { name = "B", between = { "base", "base" }, at = { 0, 0 }, becomes_from = { allong = "here" } }
    end, "bearing 'B': becomes_from: unknown key 'allong'; did you mean 'along'?" },
  { function() built():bearing { name = "B", between = { "base", "block" }, at = { 0.5, 3 }, along = spring } end,
    "bearing 'B': its point (0.5, 3) is 2 m away from body 'block', which is 1.41 m large; give a point in it or near "
      .. "it, in m; or give arm = 2 for a rigid arm of that length" },
  { function() m:seat { name = "s", body = "base", support = "base", edge = { 0, 0 } } end,
    "seat 's': 'at_end' is missing; give {x, y}" },
  { function() built():seat { name = "s", body = "block", support = "base", at_end = { 0, 0 }, edge = { 7, 0 } } end,
    "seat 's': its point (7, 0) is 5 m away from body 'base', which is 4.12 m large; give a point in it or near it, "
      .. "in m" },
  -- motions
  { function() trilith.motion "elcentro_1940_rest_sn.csv" end,
    { "motion: there is no file 'elcentro_1940_rest_sn.csv' in .*; did you mean 'elcentro_1940_rest_ns.csv'%?" } },
  { function() trilith.motion { acceleration = { 0, 1, "x" }, dt = 0.01 } end,
    "motion: sample 3 of 'acceleration' is the text 'x', must be a number in m/s2" },
  { function() trilith.motion { acceleration = { 0, 1, 0 } } end, "motion: 'dt' is missing; give a number in s" },
  { function() trilith.motion { acceleration = { 0, 1, 0 }, dt = 0.1, velocity = 1 } end,
    "motion: 'acceleration' cannot be given with 'velocity': velocity is a steady motion instead of samples, which "
      .. "begin "
      .. "with v0" },
  { function() trilith.motion { velocity = 1, duration = 1, v0 = 1 } end,
    "motion: 'v0' cannot be given with 'velocity': it is for records; a steady motion takes only velocity and "
      .. "duration" },
  { function() trilith.motion { file = "a.csv", acceleration = { 0, 1 }, dt = 1 } end,
    "motion: 'acceleration' cannot be given with 'file': keep one, the file or the samples" },
  { function() trilith.motion { acceleration = { 0, 1, 0 }, dt = 0.1, duration = 1 } end,
    "motion: 'duration' cannot be given with 'acceleration': samples last as long as their number times dt" },
  { function() trilith.motion {} end,
    "motion: 'acceleration' is missing; give a list of numbers in m/s2, or a file, or a velocity and a duration" },
  { function() quake:scale { pga = 1, factor = 2 } end,
    "scale: give either pga (in m/s2), factor, or sa (in m/s2) with its period" },
  { function() quake:scale(2) end, "scale: takes one table, as in scale{ ... }; this is 2" },
  { function() quake:time_scale "x" end, "time_scale: takes one finite number; this is the text 'x'" },
  -- numbers in their given units
  { function() new():material { name = "u", unit_weight = -3 } end,
    "material 'u': 'unit_weight' is -3 N/m3, must be above 0 and not above 225553 N/m3, any metal's; stone has some "
      .. "25000" },
  { function() m:block { name = "u", width = 1, height = 1, unit_weight = 1e300 } end,
    "block 'u': 'unit_weight' is 1e+300 N/m3, must be above 0 and not above 225553 N/m3, any metal's; stone has some "
      .. "25000" },
  -- input without meaning
  { function() trilith.end_hinge { sagging = 1e5, axial = {} } end,
    "end_hinge: 'axial' has no points; give { { normal force, share of the moment left }, ... }" },
  { function() built():beam { name = "s", from = { 0, 5 }, to = { 0, 8 }, material = "stone", stations = -1,
      section = trilith.rectangle_section { width = 1, depth = 1 } } end,
    "beam 's': 'stations' is for fibre sections, but this section has no fibres; leave it out" },
  { function() built():run { duration = 1, alpha = "x" } end,
    "run: 'alpha' is for integrator = \"implicit\", but this stage is explicit; leave it out" },
  { function() built():run { duration = 1, integrator = "implicit", alpha = -0.1, spectral_radius = 0.8 } end,
    "run: both 'alpha' and 'spectral_radius' are given; keep one: each sets the numerical damping" },
  { function() trilith.model { threads = 0 } end, "model: 'threads' is 0, must be 1 to 64" },
  { function() trilith.model { threads = 65 } end, "model: 'threads' is 65, must be 1 to 64" },
  { function() trilith.model { threads = 1.5 } end, "model: 'threads' is 1.5, must be a whole number" },
  { function() built():run { duration = 1, accuracy = 1e300 } end,
    "run: 'accuracy' is 1e+300, must be from 0 to 1, a share of energies" },
  { function() built():run { duration = 1, accuracy = 1e-300 } end,
    "run: 'accuracy' is 1e-300, must be 0 for any error, or at least 1e-09; less needs too many steps" },
  { function() built():consolidate { tolerance = -1 } end,
    "consolidate: 'tolerance' is for integrator = \"static\", but this stage is explicit; leave it out" },
  { function() built():pushover { body = "block", rate = 1, displacement = 1, storey = 0 } end,
    "pushover: 'storey' is 0, must be at least 1" },
}

-- A message lists only the first of very many names.
do
  local many = trilith.model { name = "many" }
  many:material { name = "stone", density = 2000 }
  for i = 1, 151 do many:block { name = "b" .. i, width = 1, height = 1, at = { 2*i, 0 }, material = "stone" } end
  local good, message = pcall(many.body, many, "nobody here")
  assert(not good and message:find("known: b1, b2, .*b9, b10, and 141 more$"), message)
end

-- Accepted input without effect gets a note.
do
  local w = new()
  w:block { name = "up", width = 1, height = 1, material = "stone", support = { rotation = "fixed" }, spin = 1 }
  w:bearing { name = "y", between = { "base", "up" }, at = { 0.5, 0 }, along = spring, waiting = true }
  w:point_load { name = "p", body = "base", force = { 1, 0 } }
  w:tilt { rate = 0 }
  local notes = w.notes
  assert(#notes == 4, #notes)
  assert(notes[1] == "body 'up': it is given a spin, but is held in that direction and does not move; free that "
    .. "direction or leave it out", notes[1])
  assert(notes[2] == "bearing 'y' waits, but it is the successor of no bearing, so it never acts; name it in `becomes` "
    .. "of another one, or leave out waiting", notes[2])
  assert(notes[3]:find("^load 'p': body 'base' is held or driven in all directions"), notes[3])
  assert(notes[4] == "tilt: rate is 0 rad/s, and gravity is not rotating: nothing changes", notes[4])
  w:tilt { rate = 0.1 }
  w:run { duration = 0.1 }
  w:tilt { rate = 0 } -- stops it
  w:run { duration = 0.1 }
  assert(#w.notes == 4 and math.abs(w.tilted - 0.01) < 1e-12, w.tilted)
  w:tilt { rate = -0.1, by = 0.03 }
  w:run { duration = 0.4 }
  assert(math.abs(w.tilted + 0.02) < 1e-12 and math.abs(math.atan(w.gravity[1], -w.gravity[2]) - w.tilted) < 1e-12)
  assert(tostring(stone):find("mu=0.5,", 1, true), tostring(stone))
end
