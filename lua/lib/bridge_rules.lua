-- Keys of the tables of a bridge in space: kind, unit and range of each. Errors are reported in one line.
local _, core = ...

local function number(unit, rule)
  rule = rule or {}
  rule.kind, rule.unit = "number", unit
  return rule
end
local function above(rule) -- a length above 0
  rule = number("m", rule)
  rule.above = 0
  return rule
end
local function least(rule) -- a length that may be 0
  rule = number("m", rule)
  rule.least = 0
  return rule
end
-- Beyond a skew of 75 degrees the length along the bridge is four times the length across; 30 probably means degrees.
local function skew(preset)
  return number("rad", { preset = preset, least = -75*math.pi/180, most = 75*math.pi/180,
    hint = "30*deg is 30 degrees" })
end
local table_of, law, section = { kind = "table" }, { kind = "direction law" }, { kind = "section" }

local function with(rules, more)
  for key, rule in pairs(more) do rules[key] = rule end
  return rules
end

-- Keys of m:body except name and shape are passed on unchanged.
local body_words = { "material", "groups", "density", "unit_weight", "mass", "weight" }
local body = {}
for _, key in ipairs(body_words) do body[key] = { kind = "any" } end

local function support(rules)
  return with(with({
    name = { kind = "text" }, height = above { needed = true }, skew = skew(), gap = least(), seat = above(),
    breadth = above(), support = { kind = "any" }, ground = { kind = "any" }, foundation = table_of,
      shear_key = table_of,
  }, body), rules)
end

local rules = {
  bridge = {
    supports = { kind = "list", needed = true }, spans = { kind = "list", needed = true },
    x = number("m", { preset = 0 }), soffit_level = number("m", { preset = 0 }), gap = least(), seat = above(),
    skew = skew(0), breadth = above { needed = true }, girders = { kind = "table", needed = true },
    material = { kind = "any" }, abutment = table_of, pier = table_of, span = table_of, ground = { kind = "any" },
  },
  girders = { count = { kind = "count" }, spacing = above(), at = { kind = "list" },
    breadth = above { needed = true } },
  abutment = support { width = above { needed = true }, back_wall_height = least { preset = 0 } },
  pier = support {
    stem_width = above(), stem_breadth = above(), cap_thickness = least { preset = 0 },
      footing_width = least { preset = 0 },
    footing_breadth = above(), footing_thickness = least { preset = 0 }, columns = { kind = "count" },
    column_spacing = above(), column_breadth = above(), section = section, cap_section = section,
    divisions = { kind = "count", preset = 6 }, footing_weight = number("N", { least = 0, preset = 0 }),
  },
  span = with({
    name = { kind = "text" }, length = above { needed = true }, depth = above(), slab = above(), diaphragm = table_of,
    weight_per_length = number("N/m", { above = 0 }), left = { kind = "any" }, right = { kind = "any" },
    section = section, divisions = { kind = "count", preset = 8 },
  }, body),
  diaphragm = { thickness = above(), depth = above(), count = { kind = "count", preset = 2 }, section = section },
  shear_key = { gap = least(), height = above(), breadth = above(), law = law, limit = above() },
  foundation = {
    soil = number("Pa", { above = 0 }), poisson = number("", { preset = 0.35, least = 0, most = 0.49 }),
    beta = number("s", { preset = 0, least = 0 }), along = law, across = law, horizontal = law, axial = law,
    turning_along = law, turning_across = law, turning_axial = law, limit = { kind = "any" },
      becomes = { kind = "any" },
  },
  ground = { thickness = above { preset = 1 }, margin = least { preset = 1 }, material = { kind = "any" } },
  motions = {
    x = { kind = "any" }, y = { kind = "any" }, z = { kind = "any" }, velocity = number("m/s", { above = 0 }),
    delay = { kind = "list" },
  },
}

local sorted = {} -- keys of each kind in a fixed order
for kind, of_kind in pairs(rules) do
  sorted[kind] = {}
  for key in pairs(of_kind) do table.insert(sorted[kind], key) end
  table.sort(sorted[kind])
end

local function shown(text)
  text = tostring(text):gsub("%c", "?")
  return #text > 60 and text:sub(1, 57) .. "..." or text
end

local what_is = core.what_is

local function fail(owner, text, ...) core.fail(("%s: " .. text):format(owner, ...)) end

local function check_number(owner, key, rule, value)
  local unit = rule.unit and rule.unit ~= "" and " " .. rule.unit or ""
  local function refuse(text, bound)
    fail(owner, "'%s' is %.6g%s, must %s %.4g%s%s", key, value, unit, text, bound, bound ~= 0 and unit or "",
      rule.hint and "; " .. rule.hint or "")
  end
  if type(value) ~= "number" or value ~= value or math.abs(value) == math.huge then
    fail(owner, "'%s' is %s, must be a finite number%s", key, what_is(value), unit ~= "" and " in" .. unit or "")
  end
  if math.abs(value) > 1e12 then refuse("be within -1e12 and", 1e12) end
  if rule.above and value <= rule.above then refuse("be above", rule.above) end
  if rule.least and value < rule.least then refuse("not be below", rule.least) end
  if rule.most and value > rule.most then refuse("not be above", rule.most) end
end

local checks = {
  number = check_number,
  count = function(owner, key, _, value)
    if math.type(value) ~= "integer" or value < 1 or value > 1000 then
      fail(owner, "'%s' is %s, must be a whole number from 1 to 1000", key, what_is(value))
    end
  end,
  text = function(owner, key, _, value)
    if type(value) ~= "string" or value == "" or value:find "%c" then
      fail(owner, "'%s' is %s, must be a text, without control characters", key, what_is(value))
    end
  end,
  list = function(owner, key, _, value)
    if type(value) ~= "table" or #value == 0 then
      fail(owner, "'%s' is %s, must be a list", key, type(value) == "table" and "an empty table" or what_is(value))
    end
  end,
  table = function(owner, key, _, value)
    if type(value) ~= "table" then fail(owner, "'%s' is %s, must be a table", key, what_is(value)) end
  end,
  any = function() end,
}
for _, kind in ipairs { "direction law", "section" } do
  checks[kind] = function(owner, key, _, value)
    if type(value) ~= "userdata" or core.kind_of(value) ~= kind then
      fail(owner, "'%s' is %s, must be a %s", key, what_is(value), kind)
    end
  end
end

local function check_known(kind, owner, given)
  if type(given) ~= "table" then fail(owner, "is %s, must be a table", what_is(given)) end
  local unknown
  for key in pairs(given) do
    if not rules[kind][key] and (not unknown or tostring(key) < unknown) then unknown = tostring(key) end
  end
  if unknown then fail(owner, "unknown key '%s'%s", shown(unknown), core.hint(unknown, sorted[kind])) end
end

--- The values of a row of this kind: for each key the first of the tables, which may be nil, that contains it.
local function read(kind, owner, ...)
  local tables, values = {}, {}
  for i = 1, select("#", ...) do
    local given = select(i, ...)
    if given ~= nil then
      check_known(kind, owner, given)
      tables[#tables + 1] = given
    end
  end
  for _, key in ipairs(sorted[kind]) do
    local rule, value = rules[kind][key], nil
    for _, given in ipairs(tables) do
      if value == nil then value = given[key] end
    end
    if value == nil then value = rule.preset else checks[rule.kind](owner, key, rule, value) end
    if value == nil and rule.needed then
      fail(owner, "'%s' is missing; give a %s%s", key, rule.kind, rule.unit and " in " .. rule.unit or "")
    end
    values[key] = value
  end
  return values
end

core.bridge_rules = { read = read, fail = fail, what_is = what_is, body_words = body_words, declared = rules }
