-- trilith verify: chooses the cases, lets a process run each file of them, and prints the results.
local V = ...

local most_reason = 300 -- letters of a message

-- In the process that runs a file: a line of Lua for each case that is done.

local function printed(value)
  if type(value) ~= "number" then return ("%q"):format(value) end
  if value ~= value then return "0/0" end
  if math.abs(value) == math.huge then return value > 0 and "1/0" or "-1/0" end
  return ("%.17g"):format(value)
end

local function plot_text(plot)
  local parts = {}
  for key, value in pairs(plot) do
    if type(key) == "string" then parts[#parts + 1] = ("%s=%q"):format(key, value) end
  end
  for _, series in ipairs(plot) do
    local function list(values)
      local texts = {}
      for i, v in ipairs(values) do texts[i] = ("%.7g"):format(v) end
      return table.concat(texts, ",")
    end
    parts[#parts + 1] = ("{name=%q,kind=%q,x={%s},y={%s}}"):format(series.name or "", series.kind or "line",
      list(series.x), list(series.y))
  end
  return table.concat(parts, ",")
end

local function run_case(case, with_plot)
  local begun = os.time()
  local cpu = os.clock()
  local good, values = pcall(V.values, case)
  if not good then
    io.write(("failed{%q,%q}\n"):format(case.name, (tostring(values):gsub("[^\n]*/", "", 1):match "[^\n]*"):sub(1,
      most_reason)))
    io.flush()
    return
  end
  local texts = {}
  for i, value in ipairs(values) do texts[i] = printed(value) end
  local seconds = math.max(os.clock() - cpu, os.time() - begun - 1)
  io.write(("done{%q,seconds=%.2f,%s}\n"):format(case.name, seconds, table.concat(texts, ",")))
  if with_plot and case.plot then
    io.write(("plot{%q,%s}\n"):format(case.name, plot_text(case.plot(V.parameters(case)))))
  end
  io.flush()
end

local function run_file()
  local wanted, with_plot = {}, false
  for _, name in ipairs(V.names) do
    if name == "+plots" then with_plot = true else wanted[name] = true end
  end
  for _, case in ipairs(V.read(V.file).cases) do
    if wanted[case.name] then run_case(case, with_plot) end
  end
  return 0
end

if V.file then return run_file() end

-- In the process that starts the others.

local function pattern_of(name) return "^" .. name:gsub("[%^%$%(%)%%%.%[%]%+%-%?]", "%%%0"):gsub("%*", ".*") .. "$" end

local function file_name(file) return file.subject .. "/" .. file.name end

-- The subject, file and case name of a case that match `pattern`.
local function matches_of(case, pattern)
  local found = {}
  if case.file.subject:find(pattern) then found[#found + 1] = "the subject " .. case.file.subject end
  if case.file.name:find(pattern) or file_name(case.file):find(pattern) then
    found[#found + 1] = "the file " .. file_name(case.file)
  end
  if case.name:find(pattern) then found[#found + 1] = ("the case %s of %s"):format(case.name, file_name(case.file)) end
  return found
end

local function all_cases()
  local cases, by_name = {}, {}
  for _, path in ipairs(V.files) do
    for _, case in ipairs(V.read(path).cases) do
      if by_name[case.name] then
        error(("%s: there is a case '%s' in %s too"):format(path, case.name, by_name[case.name].file.path), 0)
      end
      by_name[case.name] = case
      cases[#cases + 1] = case
    end
  end
  return cases
end

-- A name without * must fit exactly one subject, file or case.
local function require_one(name, found)
  if #found < 2 or name:find("*", 1, true) then return end
  error(("verify: '%s' is %s; write SUBJECT/FILE for a file, or SUBJECT/* or '%s*' for all of them")
    :format(name, table.concat(found, " and "), name), 0)
end

local function wanted_by_name(cases)
  local wanted = {}
  for _, name in ipairs(V.names) do
    local pattern, found = pattern_of(name), {}
    for _, case in ipairs(cases) do
      for _, match in ipairs(matches_of(case, pattern)) do
        wanted[case] = true
        if not found[match] then found[match], found[#found + 1] = true, match end
      end
    end
    if #found == 0 then
      error(("verify: there is no subject, file or case '%s'; see trilith verify --list"):format(name), 0)
    end
    require_one(name, found)
  end
  return wanted
end

local function chosen(cases)
  local wanted, list = wanted_by_name(cases), {}
  for _, case in ipairs(cases) do
    if (#V.names == 0 or wanted[case]) and not (V.quick and case.slow) then list[#list + 1] = case end
  end
  return list
end

local function show_list(cases)
  local subject
  for _, case in ipairs(cases) do
    if case.file.subject ~= subject then
      subject = case.file.subject
      print(subject)
    end
    print(("  %-28s %-24s %s%s"):format(case.name, case.file.name, case.title or case.file.title,
      case.slow and " (slow)" or ""))
  end
  print(("%d cases"):format(#cases))
end

-- Files of a subject, in order. `left`: number of processes of a subject that have not ended.
local function grouped(cases)
  local files, subjects, by_file, by_subject = {}, {}, {}, {}
  for _, case in ipairs(cases) do
    local declared = case.file
    local file = by_file[declared.path]
    if not file then
      file = { path = declared.path, declared = declared, cases = {} }
      by_file[declared.path] = file
      files[#files + 1] = file
      local subject = by_subject[declared.subject]
      if not subject then
        subject = { name = declared.subject, files = {}, left = 0 }
        by_subject[declared.subject] = subject
        subjects[#subjects + 1] = subject
      end
      subject.files[#subject.files + 1] = file
      file.subject = subject
    end
    file.cases[#file.cases + 1] = case
  end
  return files, subjects
end

-- The rows of a case: one for each check, or one with the reason why there are none.
local function rows_of(case)
  local rows = {}
  if case.reason then
    return { { name = case.name, quantity = "", exact = "", value = "", error = "", tolerance = "",
      result = "FAILS: " .. case.reason } }, false
  end
  local good = true
  for i, check in ipairs(case.checks) do
    local error_text, passes = V.judge(check, case.values[i])
    good = good and passes
    rows[i] = { name = i == 1 and case.name or "", quantity = check[1], exact = V.exact_text(check),
      value = V.value_text(check, case.values[i]), error = error_text, tolerance = V.tolerance_text(check),
      result = passes and "pass" or "FAILS" .. (case.known and ": " .. case.known or ""), check = check }
  end
  return rows, good
end

local columns = { "name", "quantity", "exact", "value", "error", "tolerance", "result" }
local heads = { name = "case", quantity = "quantity", exact = "exact", value = "computed", error = "error",
  tolerance = "tolerance", result = "" }
if V.experiments then
  heads.name, heads.exact, heads.value, heads.error, heads.tolerance = "specimen", "measured", "model", "ratio", "band"
end
V.heads = heads

local function print_subject(subject, tally)
  local rows = { heads }
  for _, file in ipairs(subject.files) do
    for _, case in ipairs(file.cases) do
      local of_case, good = rows_of(case)
      case.rows = of_case
      tally.cases = tally.cases + 1
      if not good then tally.failed[#tally.failed + 1] = case.name end
      for _, row in ipairs(of_case) do rows[#rows + 1] = row end
    end
  end
  tally.checks = tally.checks + #rows - 1
  local widths = {}
  for _, row in ipairs(rows) do
    for _, column in ipairs(columns) do
      widths[column] = math.max(widths[column] or 0, utf8.len(row[column]) or #row[column])
    end
  end
  print(subject.name)
  for _, row in ipairs(rows) do
    local line = "  "
    for _, column in ipairs(columns) do
      local text = row[column]
      line = line .. text .. (" "):rep(widths[column] - (utf8.len(text) or #text) + 2)
    end
    print((line:gsub("%s+$", "")))
  end
  for _, line in ipairs(subject.cautions or {}) do print(line) end
  print ""
end

-- Notes that limit a result, one line each, below the rows of the subject.
local function take_cautions(part, errors)
  local subject = part.file.subject
  subject.cautions = subject.cautions or {}
  for line in errors:gmatch "[^\n]+" do
    if line:find("caution: ", 1, true) == 1 then
      local where = part.file.path:match "([^/]+)%.lua$"
      table.insert(subject.cautions, ("  %s: %s"):format(where, line))
    end
  end
end

local function taken(text, part, trouble, errors)
  take_cautions(part, errors)
  local by_name = {}
  for _, case in ipairs(part.cases) do by_name[case.name] = case end
  local environment = {
    done = function(t)
      local case = by_name[table.remove(t, 1)]
      case.values, case.seconds = t, t.seconds
    end,
    failed = function(t) by_name[t[1]].reason = t[2] end,
    plot = function(t) by_name[table.remove(t, 1)].plotted = t end,
  }
  for line in text:gmatch "[^\n]+" do
    local chunk = load(line, "=output", "t", environment)
    if chunk then pcall(chunk) end
  end
  local first = errors:match "[^\n]+"
  local why = trouble ~= "" and trouble .. (first and ": " .. first or "") or "the process printed no result for it"
  for _, case in ipairs(part.cases) do
    if not case.values and not case.reason then case.reason = why:sub(1, most_reason) end
  end
end

-- One process for each file, and one for each of its slow cases, which begin first.
local function parts_of(files)
  local slow, others = {}, {}
  for _, file in ipairs(files) do
    local rest = { file = file, cases = {} }
    for _, case in ipairs(file.cases) do
      if case.slow then
        slow[#slow + 1] = { file = file, cases = { case } }
      else
        rest.cases[#rest.cases + 1] = case
      end
    end
    if #rest.cases > 0 then others[#others + 1] = rest end
  end
  for _, part in ipairs(others) do slow[#slow + 1] = part end
  for _, part in ipairs(slow) do part.file.subject.left = part.file.subject.left + 1 end
  return slow
end

local function run_all(files, subjects)
  local parts, orders, tally = parts_of(files), {}, { cases = 0, checks = 0, failed = {} }
  for i, part in ipairs(parts) do
    orders[i] = { "verify", "--file", part.file.path }
    for _, case in ipairs(part.cases) do table.insert(orders[i], case.name) end
    if V.pages then table.insert(orders[i], "+plots") end
    if V.experiments then table.insert(orders[i], "--experiments") end
    if V.quick then table.insert(orders[i], "--quick") end
  end
  local next_subject, finished = 1, 0
  V.status(("0 of %d files"):format(#parts))
  local whole = V.processes(orders, V.jobs, function(i, output, errors, trouble)
    taken(output, parts[i], trouble, errors)
    finished = finished + 1
    parts[i].file.subject.left = parts[i].file.subject.left - 1
    V.status()
    while subjects[next_subject] and subjects[next_subject].left == 0 do
      print_subject(subjects[next_subject], tally)
      next_subject = next_subject + 1
    end
    io.flush()
    if finished < #parts then V.status(("%d of %d files"):format(finished, #parts)) end
  end, V.output)
  V.status()
  return tally, whole
end

local function main()
  local cases = chosen(all_cases())
  if V.list then
    show_list(cases)
    return 0
  end
  local begun = os.time()
  local files, subjects = grouped(cases)
  local tally, whole = run_all(files, subjects)
  if not whole then return 130 end
  print(("%d checks of %d cases, %d failed%s; %d s"):format(tally.checks, tally.cases, #tally.failed,
    #tally.failed > 0 and " (" .. table.concat(tally.failed, ", ") .. ")" or "", os.time() - begun))
  if V.pages then V.write_pages(subjects) end
  local same = not V.compare or V.compare_pages(subjects)
  return #tally.failed == 0 and same and 0 or 3
end

return main()
