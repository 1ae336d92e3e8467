-- Pages of the verification manual: Markdown for each subject, made from the cases and their results.
local V = ...

local function plot_of(case)
  if case.plotted then return case.plotted end
  local study = case.convergence
  if not study or not case.values then return nil end
  local x, y, line = {}, {}, {}
  for i, value in ipairs(study.values) do
    x[i], y[i] = value, math.abs(case.values[i]/study.exact - 1)
  end
  for i, value in ipairs(study.values) do line[i] = y[#x]*(value/x[#x])^(x[1] > x[#x] and study.order
    or -study.order) end
  return { title = case.title or case.file.title, scale = "logarithmic", x_label = study.parameter,
    x_unit = study.unit or "", y_label = "error", y_unit = "",
    { name = "computed", kind = "points", x = x, y = y },
    { name = ("order %s"):format(V.number(study.order)), kind = "dashed", x = x, y = line } }
end

local function parameters_text(case)
  local texts = {}
  for i, row in ipairs(case.parameters or {}) do
    texts[i] = ("%s = %s%s"):format(row[1], V.number(row[2]), row[3] and " " .. row[3] or "")
  end
  return #texts > 0 and " (" .. table.concat(texts, ", ") .. ")" or ""
end

-- A text in lines of at most 118 letters.
local function wrapped(text)
  local lines, line = {}, nil
  for word in text:gmatch "%S+" do
    if line and #line + 1 + #word > 118 then
      lines[#lines + 1], line = line, nil
    end
    line = line and line .. " " .. word or word
  end
  lines[#lines + 1] = line
  return table.concat(lines, "\n")
end

local function escaped(text) return (text:gsub("|", "\\|")) end

-- The table of assumptions of an experiment: name, value, source.
local function add_assumptions(add, declared)
  if not declared.assumptions then return end
  add "Assumptions, the same for all specimens:" add ""
  add "| assumption | value | source |"
  add "|---|---|---|"
  for _, row in ipairs(declared.assumptions) do
    add(("| %s | %s | %s |"):format(escaped(row[1]), escaped(row[2]), escaped(row[3])))
  end
  add ""
end

-- The table of moves of an experiment: model over measured before and after the change of one assumption.
local function add_moves(add, declared)
  if not declared.moves then return end
  add "" add "Assumptions that move a result. Each row changes one assumption and keeps the others:" add ""
  add "| result, model over measured | assumption | from | to | ratio from | ratio to |"
  add "|---|---|---|---|---|---|"
  for _, row in ipairs(declared.moves) do
    add(("| %s | %s | %s | %s | %.2f | %.2f |"):format(escaped(row[1]), escaped(row[2]), escaped(row[3]),
      escaped(row[4]), row[5], row[6]))
  end
end

-- A picture of the mechanism, which is drawn apart from the cases, where the folder has one.
local function add_picture(add, declared)
  local folder = V.pages or V.compare
  local name = ("plots/%s-%s.png"):format(declared.subject, declared.name)
  local file = folder and io.open(("%s/%s"):format(folder, name))
  if not file then return end
  file:close()
  add "" add(("![Mechanism: %s](%s)"):format(declared.title, name))
end

-- A section of a page: its lines, and for lines of a table the row that they show.
local function add_file(page, file, folder)
  local declared = file.declared
  local function add(line, row) page[#page + 1] = { line, row } end
  add "" add("## " .. declared.title) add ""
  if declared.text then
    add(wrapped(declared.text)) add ""
  end
  if declared.formula then
    add "$$" add((declared.formula:gsub("^%s+", ""):gsub("%s+$", ""))) add "$$" add ""
  end
  local script = ("scripts/%s%s/%s.lua"):format(V.experiments and "" or "verification/", declared.subject,
    declared.name)
  add(wrapped(("Source: %s."):format(declared.source))) add ""
  add(("Script: [%s](../../%s). To run it: `trilith verify %s%s/%s`."):format(script, script,
    V.experiments and "--experiments " or "", declared.subject, declared.name)) add ""
  add_assumptions(add, declared)
  local heads = V.heads
  add(("| %s | quantity | %s | %s | %s | %s | |"):format(heads.name, heads.exact, heads.value, heads.error,
    heads.tolerance))
  add "|---|---|---|---|---|---|---|"
  for _, case in ipairs(file.cases) do
    for i, row in ipairs(case.rows) do
      local name = i == 1 and ("%s%s"):format(case.title or "`" .. case.name .. "`", parameters_text(case)) or ""
      add(("| %s | %s | %s | %s | %s | %s | %s |"):format(escaped(name), row.quantity, row.exact, row.value, row.error,
        row.tolerance, escaped(row.result)), row)
    end
  end
  add_moves(add, declared)
  for _, case in ipairs(file.cases) do
    if case.plot or case.convergence then
      local name = ("plots/%s-%s.svg"):format(declared.subject, case.name)
      add "" add(("![%s](%s)"):format(case.title or declared.title, name))
      local plot = folder and plot_of(case)
      if plot then V.chart(plot, folder .. "/" .. name) end
    end
  end
  add_picture(add, declared)
end

local function page_of(subject, folder)
  local page = { { ("# Verification: %s"):format(subject.name:gsub("_", " ")) }, { "" },
    { V.experiments and "This page compares models with measured structures. A value outside its band is shown with " ..
      "the reason." or "This page shows closed-form cases, their exact values and the computed ones." },
    { ("`trilith verify%s` makes it from the scripts; [Verification](../verification.md) explains the table.")
      :format(V.experiments and " --experiments" or "") } }
  for _, file in ipairs(subject.files) do add_file(page, file, folder) end
  return page
end

local function path_of(folder, subject) return ("%s/%s.md"):format(folder, subject.name) end

--- Writes the page of each subject, and its plots, into the folder of --pages.
function V.write_pages(subjects)
  for _, subject in ipairs(subjects) do
    local lines = {}
    for i, line in ipairs(page_of(subject, V.pages)) do lines[i] = line[1] end
    local path = path_of(V.pages, subject)
    local file = assert(io.open(path, "w"))
    file:write(table.concat(lines, "\n"), "\n")
    file:close()
    print(path)
  end
end

local function cells(line)
  local found = {}
  for cell in line:gsub("\\|", "\0"):gmatch "|([^|]*)" do found[#found + 1] = cell end
  return found
end

-- Whether a line of a table shows the row: all but the computed value is the same, and the value moved by little.
local function shows(kept, line, row)
  if kept == line then return true end
  local old, new = cells(kept), cells(line)
  if #old ~= #new or not row.check then return false end
  for i = 1, #new do
    if i ~= 4 and i ~= 5 and old[i] ~= new[i] then return false end
  end
  local was, is = tonumber(old[4]:match "%S+"), tonumber(new[4]:match "%S+")
  return was and is and math.abs(was - is) <= V.play(row.check)
end

local function difference(subject)
  local path = path_of(V.compare, subject)
  local file = io.open(path)
  if not file then return path .. " does not exist" end
  local kept = {}
  for line in file:lines() do kept[#kept + 1] = line end
  file:close()
  local wanted = {}
  for _, line in ipairs(page_of(subject)) do
    for part in (line[1] .. "\n"):gmatch "([^\n]*)\n" do wanted[#wanted + 1] = { part, line[2] } end
  end
  for i = 1, math.max(#kept, #wanted) do
    local new = wanted[i]
    if not new or not kept[i] or not (kept[i] == new[1] or new[2] and shows(kept[i], new[1], new[2])) then
      return ("%s:%d says '%s', must say '%s'"):format(path, i, kept[i] or "", new and new[1] or "")
    end
  end
  return nil
end

--- Whether the pages in the folder of --compare agree with these subjects; prints the differences.
function V.compare_pages(subjects)
  local same = true
  for _, subject in ipairs(subjects) do
    local text = difference(subject)
    if text then
      same = false
      print(text .. "; to write the page: trilith verify --pages")
    end
  end
  if same then print "the pages agree with the cases" end
  return same
end
