-- Runs one case of an experiment alone, with a results file for pictures:
--   trilith run --trust shared/run_one.lua file=dry_granite_walls case=granite_ws100 out=/tmp/ws100.h5
local trilith = require "trilith"
local p = trilith.params { file = { "dry_granite_walls", "name of the script, without .lua" },
  case = { "", "name of the case; empty: all" }, out = { "", "results file" }, coarse = { false },
  over = { "", "keys of the series that are replaced, as a Lua table" } }

package.path = "./?.lua;" .. package.path
local declared = assert(loadfile(p.file .. ".lua"))({ coarse = p.coarse,
  over = load("return {" .. p.over .. "}")(), file = p.out ~= "" and p.out or nil })

local function text(value)
  if type(value) ~= "number" then return tostring(value) end
  return ("%.5g"):format(value)
end

for _, case in ipairs(declared.cases) do
  if p.case == "" or p.case == case.name then
    local parameters = {}
    for _, row in ipairs(case.parameters or {}) do parameters[row[1]] = row[2] end
    local begun = os.clock()
    local found = case.run(parameters)
    if type(found) ~= "table" then found = { [case.checks[1][1]] = found } end
    print(("%s (%.1f s)"):format(case.name, os.clock() - begun))
    for _, check in ipairs(case.checks) do
      local band = check.between and text(check.between[1]) .. " to " .. text(check.between[2]) or ""
      local measured = type(check.measured) == "table" and table.concat(check.measured, ", ") or check.measured
      print(("  %-28s measured %-12s model %-16s band %s"):format(check[1], tostring(measured),
        text(found[check[1]]), band))
    end
    for _, line in ipairs(found.notes or {}) do print("  " .. line) end
  end
end
