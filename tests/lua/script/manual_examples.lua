-- The example of each declaration in lua/manual runs unchanged on a model of a block on fixed ground.
local trilith = require "trilith"

local function new_model(name)
  local m = trilith.model { name = name }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.6, beta = 2e-4 } }
  m:block { name = "ground", width = 4, height = 1, at = { -2, -1 }, material = "stone", support = "fixed" }
  m:block { name = "block", width = 0.5, height = 1, at = { -0.25, 0 }, material = "stone" }
  return m
end

local run, scratch = 0, os.tmpname()  -- files in out/ go to the folder for temporary files
local function run_example(name, text)
  text = text:gsub('"out/', '"' .. scratch)
  local m = new_model(name)
  local there = setmetatable({ m = m, trilith = trilith, print = function() end }, { __index = _G })
  local good, message = pcall(assert(load(text, "=the example of " .. name, "t", there)))
  local is_stock = not good and message:find "only the program can begin one"  -- a study, in the stock interpreter
  assert(good or is_stock, message)
  m:close()
  run = run + 1
end

for file in io.popen("ls ../../lua/manual/*.lua"):lines() do
  local page = dofile(file)
  for _, row in ipairs(page) do
    if row.example then run_example(row[1], row.example) end
  end
  for name, text in pairs(page.examples or {}) do run_example(name, text) end
end
os.execute(("rm -rf %s*"):format(scratch))
assert(run >= 160, ("only %d examples ran"):format(run))
