-- The files of the verification manual: read, checked, and each convergence study written out as the cases it is.
local V = ...

local function fail(file, text) error(("%s: %s"):format(file, text), 0) end

local file_keys = { title = "string", source = "string", formula = "string", text = "string", cases = "table",
  assumptions = "table", moves = "table" }
local case_keys = { name = "string", title = "string", parameters = "table", checks = "table", run = "function",
  plot = "function", slow = "boolean", convergence = "table", known = "string" }
local check_keys = { [1] = "string", unit = "string", exact = true, tolerance = true, within = "number",
  between = "table", measured = true, one_of = "table" }
local study_keys = { parameter = "string", unit = "string", values = "table", order = "number", tolerance = "number",
  exact = "number", quantity = "string", quantity_unit = "string" }

local function keys_checked(file, where, t, allowed)
  for key, value in pairs(t) do
    local wanted = allowed[key]
    if not wanted then fail(file, ("%s has the unknown key '%s'"):format(where, key)) end
    if wanted ~= true and type(value) ~= wanted then
      fail(file, ("'%s' of %s is a %s, must be a %s"):format(key, where, type(value), wanted))
    end
  end
end

local function check_checked(file, case, check)
  local where = ("a check of '%s'"):format(case.name)
  keys_checked(file, where, check, check_keys)
  if not check[1] then fail(file, where .. " has no name") end
  if check.between == nil and check.exact == nil and not check.one_of then
    fail(file, where .. " has no exact value")
  end
  if type(check.exact) == "number" and not check.tolerance and not check.within then
    fail(file, where .. " has neither 'tolerance' nor 'within'")
  end
  if type(check.tolerance) == "number" then check.tolerance = { -check.tolerance, check.tolerance } end
end

-- A move is a result of the model with one assumption changed, kept from a run of it.
local function move_checked(file, move)
  local where = ("the move '%s'"):format(tostring(move[2]))
  for i, name in ipairs { "check", "assumption", "from", "to" } do
    if type(move[i]) ~= "string" then fail(file, ("%s: '%s', entry %d, must be a text"):format(where, name, i)) end
  end
  for i, name in ipairs { "value before", "value after" } do
    if type(move[i + 4]) ~= "number" then
      fail(file, ("%s: '%s', entry %d, must be a number"):format(where, name, i + 4))
    end
  end
end

-- A study is a case whose checks are one value for each value of its parameter, and the order of the error.
local function write_out(file, case)
  local study = case.convergence
  if not study then return end
  keys_checked(file, ("the convergence of '%s'"):format(case.name), study, study_keys)
  case.checks = {}
  for i, value in ipairs(study.values) do
    case.checks[i] = { ("%s at %s %s"):format(study.quantity, study.parameter, V.number(value)),
      unit = study.quantity_unit, exact = study.exact, within = math.huge }
  end
  local order = study.tolerance
  case.checks[#case.checks + 1] = { "order of the error", exact = study.order, tolerance = order }
end

function V.number(value)
  if type(value) ~= "number" then return tostring(value) end
  if value == math.floor(value) and math.abs(value) < 1e6 then return ("%d"):format(value) end
  return (("%.5g"):format(value):gsub("e%+?(-?)0*", "e%1"))
end

--- The parameters of a case as a table by name.
function V.parameters(case)
  local p = {}
  for _, row in ipairs(case.parameters or {}) do p[row[1]] = row[2] end
  return p
end

--- Reads a file; it only declares, nothing runs.
function V.read(path)
  local chunk, message = loadfile(path, "t")
  if not chunk then error(message, 0) end
  local declared = chunk(V.experiments and { coarse = V.quick } or nil)
  if type(declared) ~= "table" then fail(path, "returns no table of cases") end
  keys_checked(path, "the file", declared, file_keys)
  for _, key in ipairs { "title", "source", "cases" } do
    if not declared[key] then fail(path, ("has no '%s'"):format(key)) end
  end
  for _, move in ipairs(declared.moves or {}) do move_checked(path, move) end
  declared.path = path
  declared.subject, declared.name = path:match "([^/]+)/([^/]+)%.lua$"
  for _, case in ipairs(declared.cases) do
    if not case.name then fail(path, "a case has no name") end
    keys_checked(path, ("'%s'"):format(case.name), case, case_keys)
    write_out(path, case)
    if not case.run or not case.checks then fail(path, ("'%s' has no 'run' or no 'checks'"):format(case.name)) end
    for _, check in ipairs(case.checks) do check_checked(path, case, check) end
    case.file = declared
  end
  return declared
end
