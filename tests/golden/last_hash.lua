-- Runs a script of the gallery and prints the hash of its first model.
-- usage: SCRIPT=PATH trilith run --quiet --trust last_hash.lua [NAME=VALUE...]
local trilith = require "trilith"
local make, first = trilith.model, nil
function trilith.model(t)
  local m = make(t)
  first = first or m
  return m
end
dofile(os.getenv "SCRIPT")
print("hash " .. first.hash)
