-- Compares a computed value with the exact one, and formats both.
local V = ...

local function spaced(text, unit) return unit and text .. " " .. unit or text end

-- Measured values as a list of numbers; none where it is a text.
local function measured_numbers(check)
  if type(check.measured) == "number" then return { check.measured } end
  return type(check.measured) == "table" and check.measured or {}
end

local function measured_text(check)
  local numbers = measured_numbers(check)
  if #numbers == 0 then return check.measured end
  if #numbers > 2 then
    return spaced(("%s to %s"):format(V.number(math.min(table.unpack(numbers))),
      V.number(math.max(table.unpack(numbers)))), check.unit)
  end
  local texts = {}
  for i, value in ipairs(numbers) do texts[i] = V.number(value) end
  return spaced(table.concat(texts, ", "), check.unit)
end

-- Computed value over the mean of the measured ones.
local function ratio_text(check, value)
  local numbers, sum = measured_numbers(check), 0
  if #numbers == 0 or type(value) ~= "number" then return "" end
  for _, number in ipairs(numbers) do sum = sum + number end
  if sum == 0 then return "" end
  return ("%.2f"):format(value*#numbers/sum)
end

--- "0.3243 s", "stands", "0.1756 to 0.2271"; of an experiment the measured values
function V.exact_text(check)
  if check.measured then return measured_text(check) end
  if check.between then
    return spaced(V.number(check.between[1]) .. " to " .. V.number(check.between[2]), check.unit)
  end
  return spaced(V.number(check.exact), type(check.exact) == "number" and check.unit or nil)
end

function V.value_text(check, value)
  if value ~= value then return "no number" end
  return spaced(V.number(value), type(value) == "number" and check.unit or nil)
end

local function percent(share) return V.number(tonumber(("%.3g"):format(100*share))) end

--- "1 %", "-4 % to 0 %", "0.1 deg"
function V.tolerance_text(check)
  if check.measured and check.between then
    return V.number(check.between[1]) .. " to " .. V.number(check.between[2])
  end
  if check.one_of then return table.concat(check.one_of, " or ") end
  if check.between then return "within" end
  if type(check.exact) ~= "number" then return "equal" end
  if check.within == math.huge then return "" end
  if check.within then return spaced(V.number(check.within), check.unit) end
  local low, high = check.tolerance[1], check.tolerance[2]
  if low == -high then return percent(high) .. " %" end
  return percent(low) .. " % to " .. percent(high) .. " %"
end

local function is_number(value) return type(value) == "number" and value == value and math.abs(value) < math.huge end

--- The error as a text, and whether the value passes.
function V.judge(check, value)
  if check.one_of then
    for _, allowed in ipairs(check.one_of) do
      if value == allowed then return "", true end
    end
    return "", false
  end
  local ratio = check.measured and ratio_text(check, value) or ""
  if check.between then return ratio, is_number(value) and value >= check.between[1] and value <= check.between[2] end
  if type(check.exact) ~= "number" then return "", value == check.exact end
  if not is_number(value) then return "", false end
  local off = value - check.exact
  if check.tolerance then
    local share = off/math.abs(check.exact)
    return ("%+.2g %%"):format(math.abs(share) < 1e-10 and 0 or 100*share), share >= check.tolerance[1]
      and share <= check.tolerance[2]
  end
  if check.within == math.huge then return ("%+.3g %%"):format(100*off/math.abs(check.exact)), true end
  return spaced(("%+.2g"):format(off), check.unit), math.abs(off) <= check.within
end

--- Allowed difference of a value from the value on a page: a tenth of the tolerance, or a digit.
function V.play(check)
  if check.between and check.measured then return 0.05*(check.between[2] - check.between[1]) end
  if type(check.exact) ~= "number" then return 0 end
  local allowed = check.tolerance and math.max(-check.tolerance[1], check.tolerance[2])*math.abs(check.exact)
    or check.within < math.huge and check.within or 0.01*math.abs(check.exact)
  return 0.1*allowed + 1e-4*math.abs(check.exact)
end

--- Slope of log(error) over log(value) by the last two values of a study.
local function order_of(study, results)
  local n = #study.values
  local function at(i) return math.abs(results[i] - study.exact), study.values[i] end
  local e1, v1 = at(n - 1)
  local e2, v2 = at(n)
  local slope = math.log(e2/e1)/math.log(v2/v1)
  return math.abs(slope)
end

--- Runs a case; the values in the order of its checks.
function V.values(case)
  local p, values = V.parameters(case), {}
  local study = case.convergence
  if study then
    for i, value in ipairs(study.values) do
      p[study.parameter] = value
      values[i] = case.run(p)
    end
    values[#values + 1] = order_of(study, values)
    return values
  end
  local found = case.run(p)
  for i, check in ipairs(case.checks) do
    local value = type(found) == "table" and found[check[1]]
    if type(found) ~= "table" and i == 1 then value = found end
    if value == nil or type(found) == "table" and found[check[1]] == nil then
      error(("'%s' gives no '%s'"):format(case.name, check[1]), 0)
    end
    values[i] = value
  end
  return values
end
