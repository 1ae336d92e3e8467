#!/usr/bin/python3
"""Notes that limit a result reach the reader of a quiet run, of the results file and of trilith verify.

check_cautions.py PROGRAM FOLDER
"""
import os
import subprocess
import sys

import h5py

MODEL = """local trilith = require "trilith"
local function push(rate, file)
  local m = trilith.model { name = "pushed", thickness = 0.5 }
  m:material { name = "stone", density = 2000 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e8, ks = 5e7, mu = 2, beta = 1e-4 } }
  m:block { name = "ground", width = 4, height = 1, at = { -2, -1 }, material = "stone", support = "fixed" }
  local b = m:block { name = "block", width = 0.5, height = 2, at = { -0.25, 0 }, material = "stone" }
  if file then m:results { file = file } end
  m:consolidate { integrator = "static" }
  local how = rate and { rate = rate } or { control = "arc", arc = 2e-4 }
  how.body, how.at, how.displacement = b, { 0, 1 }, 0.03
  return m:pushover(how).peak_force
end
"""
RUN = MODEL + "push(%s, 'run.h5')\n"
CASES = MODEL + """return { title = "pushes", source = "-", text = "-", cases = {
  { name = "pushed_fast", title = "fast", checks = { { "peak", unit = "N", exact = 1, tolerance = 1e9 } },
    run = function() return { peak = push(1) } end },
  { name = "pushed_by_arc", title = "by arc", checks = { { "peak", unit = "N", exact = 1, tolerance = 1e9 } },
    run = function() return { peak = push() } end } } }
"""


def require(condition, *said):
    if not condition:
        sys.exit(" ".join(str(s) for s in said))


def run(program, folder, *words):
    return subprocess.run([program, *words], cwd=folder, capture_output=True, text=True)


def seal_text(path):
    with h5py.File(path, "r") as file:
        for row in file["seal"][()]:
            if row["check"] in (b"notes", "notes"):
                return row["text"].decode()
    return ""


def main():
    program, folder = os.path.abspath(sys.argv[1]), sys.argv[2]
    os.makedirs(folder, exist_ok=True)
    for rate, is_limited in (("1", True), ("nil", False)):
        with open(os.path.join(folder, "push.lua"), "w") as file:
            file.write(RUN % rate)
        done = run(program, folder, "run", "push.lua", "--quiet")
        require(done.returncode == 0 and done.stdout == "", rate, done)
        lines = [line for line in done.stderr.splitlines() if line.startswith("caution: pushover: the peak of")]
        require(len(lines) == (1 if is_limited else 0) == len(done.stderr.splitlines()), rate, done.stderr)
        text = seal_text(os.path.join(folder, "run.h5"))
        require(("limits a result: pushover: the peak of" in text) == is_limited, rate, text)
    cases = os.path.join(folder, "cases", "statics")
    os.makedirs(cases, exist_ok=True)
    with open(os.path.join(cases, "pushes.lua"), "w") as file:
        file.write(CASES)
    done = run(program, folder, "verify", "--scripts", os.path.dirname(cases))
    cautions = [line for line in done.stdout.splitlines() if "caution: pushover: the peak of" in line]
    require(len(cautions) == 1 and cautions[0].startswith("  pushes: "), done)
    print("cautions reach the reader")


main()
