#!/usr/bin/python3
"""Temperatures and water in joints in results files, tables, VTK, pictures and reports, against the script's numbers.
usage: check_fields.py PROGRAM FOLDER"""
import csv
import re
import shutil
import subprocess
import sys
from pathlib import Path

import h5py
import numpy as np

program, folder = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)

MODEL = """
local trilith = require "trilith"
local m = trilith.model { name = "fields" }
m:material { name = "concrete", density = 2400, E = 2e10, nu = 0.2 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e11, ks = 1e11, mu = 0.75 } }
m:block { name = "rock", width = 12, height = 2, at = { -2, -2 }, material = "concrete", support = "fixed" }
m:block { name = "dam", width = 8, height = 4, at = { 0, 0 }, material = "concrete", body = { mesh = { 8, 4 } } }
m:block { name = "cold", width = 1, height = 1, at = { 7, 4 }, material = "concrete" }
m:results { file = "plane.h5", frames = 0.1, histories = 0.01 }
m:consolidate { integrator = "static" }
m:heat { body = "dam", conductivity = 2, heat_capacity = 900, temperature = 12 }
m:heat_exchange { name = "sun", body = "dam", side = "top", temperature = 30 }
m:seepage { name = "joint", upper = "dam", lower = "rock", aperture = 3e-4, divisions = 16, from = "heel", to = "toe" }
m:seepage { name = "fissure", length = 2, aperture = 2e-4, divisions = 4, from = "heel", to = "end" }
m:seepage_head { node = "heel", head = 8 }
m:seepage_head { node = "toe", head = 0 }
m:history { name = "warm", body = "dam", what = "temperature" }
m:history { name = "at the top", body = "dam", what = "temperature", point = { 4, 4 } }
m:history { name = "pressure", seepage = "joint", what = "pressure", at = 0 }
m:history { name = "head", seepage = "joint", what = "head", at = 8 }
m:history { name = "inflow", seepage = "joint", what = "inflow" }
m:process { name = "summer", duration = 3*3600, step = 1800 }
local s = m:seepage_state "joint"
print(m:temperature "dam", m:temperature("dam", { 4, 4 }), s.pressure[1], s.head[16], s.inflow)
local function fails(text, keys)
  keys.name = "wrong"
  local ok, said = pcall(m.history, m, keys)
  assert(not ok and tostring(said):find(text, 1, true), tostring(said))
end
fails("give the distance from its first end, from 0 to 8 m", { seepage = "joint", what = "pressure" })
fails("must be from 0 to 8 m", { seepage = "joint", what = "pressure", at = 9 })
fails("leave out at", { seepage = "joint", what = "volume", at = 1 })
fails("not a reading of a joint", { seepage = "joint", what = "pressures", at = 1 })
fails("there is no joint 'joints'", { seepage = "joints", what = "volume" })
fails("for a point of a body give of = function()", { body = "dam", what = "ux", at = 1 })
fails("give seepage, the name of the joint", { what = "time", at = 1 })
fails("is of a body's temperature", { body = "dam", what = "ux", point = { 1, 1 } })
"""

SPACE = """
local trilith = require "trilith"
local m = trilith.model { name = "space", dim = 3 }
m:material { name = "concrete", density = 2400, E = 2e10, nu = 0.2 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e11, ks = 1e11, mu = 0.75 } }
m:block { name = "rock", size = { 4, 4, 1 }, at = { -1, -1, -1 }, material = "concrete", support = "fixed" }
m:block { name = "slab", size = { 2, 2, 1 }, at = { 0, 0, 0 }, material = "concrete", body = { mesh = { 4, 4, 2 } } }
m:block { name = "stone", size = { 1, 1, 0.5 }, at = { 0.5, 0.5, 1 }, material = "concrete" }
m:heat { body = "slab", conductivity = 2, heat_capacity = 900, temperature = 10 }
m:heat { body = "stone", conductivity = 2, heat_capacity = 900, temperature = -5 }
m:heat_exchange { body = "slab", side = "left", temperature = 40 }
m:results { file = "space.h5", frames = 0.5, histories = 0.1 }
m:history { name = "slab", body = "slab", what = "temperature", point = { 0, 1, 0.5 } }
m:process { duration = 6*3600, step = 1800 }
print(m:temperature("slab", { 0, 1, 0.5 }))
"""


def check(holds, text):
    if not holds:
        sys.exit(f"wrong: {text}")


def run_program(*words):
    done = subprocess.run([str(program), *words], cwd=folder, capture_output=True, text=True, check=False)
    check(done.returncode == 0, f"{' '.join(words)}: {done.stdout}{done.stderr}")
    return done.stdout


def fails(text, *words):
    done = subprocess.run([str(program), *words], cwd=folder, capture_output=True, text=True, check=False)
    check(done.returncode != 0 and text in done.stdout + done.stderr, f"{' '.join(words)}: {done.stdout}{done.stderr}")


def run_script(name, text):
    (folder / f"{name}.lua").write_text(text)
    return [float(v) for v in run_program("run", f"{name}.lua", "--quiet").split()]


def near(a, b, share=1e-9):
    check(abs(a - b) <= share * abs(b), f"{a} is not {b}")


mean, top, pressure, head, inflow = run_script("plane", MODEL)
with h5py.File(folder / "plane.h5") as file:
    frames, stages = file["frames"], file["stages"][()]
    check(frames["node_temperature"].attrs["units"] in (b"degC", "degC"), "unit of temperatures")
    node = frames["node_temperature"][()]
    bodies = file["model/bodies"][()]
    mass = file["model/node_mass"][()]
    row = {b["name"].decode(): b for b in bodies}
    first, count = int(row["dam"]["first_node"]), int(row["dam"]["node_count"])
    dam = slice(first, first + count)
    # Mean by mass of the nodes; no temperature before the declaration, and none in the other body.
    near(float(np.average(node[-1, dam], weights=mass[dam])), mean)
    near(float(node[-1, dam].max()), 30)
    check((node[0] == -273.15).all() and (node[-1, row["cold"]["first_node"]] == -273.15), "nodes without temperature")
    cells = frames["water_cell"][()][-1]
    check(cells.shape == (20, 4) and not cells[16:].any(), "fissures have no place")
    near(cells[0, 0] + 1, 1, 1e-4)
    near(cells[15, 2], 8, 1e-4)
    near(float(frames["water_pressure"][()][-1, 0]), pressure)
    near(float(frames["water_fill"][()][-1].min()), 1, 1e-6)
    check(0 < frames["water_aperture"][()][-1, 0] < 3.01e-4, "aperture")
    last = {name: float(file[f"histories/{name}"][-1]) for name in ("warm", "at the top", "pressure", "head", "inflow")}
    units = {name: file[f"histories/{name}"].attrs["units"] for name in last}
    check([u if isinstance(u, str) else u.decode() for u in units.values()] == ["degC", "degC", "Pa", "m", "m3/s"],
          f"units {units}")
for value, wanted in zip(last.values(), (mean, top, pressure, head, inflow)):
    near(value, wanted)

run_program("export", "plane.h5", "--to", "csv")
table = next(folder.rglob("*histor*.csv"))
with open(table, newline="", encoding="utf8") as file:
    rows = list(csv.reader(file))
check(any("at the top" in cell for cell in rows[0]) and any("pressure" in cell for cell in rows[0]), rows[0])
run_program("export", "plane.h5", "--to", "vtk")
check(any(b'Name="node_temperature"' in path.read_bytes() for path in folder.rglob("*.vtu")), "VTK")

run_program("draw", "plane.h5", "--at", "end", "--colour", "temperature", "-o", "heat.svg")
run_program("draw", "plane.h5", "--at", "end", "--colour", "water", "-o", "water.svg")
run_program("draw", "plane.h5", "--at", "end", "--colour", "temperature", "-o", "heat.png")
run_program("draw", "plane.h5", "--at", "end", "--colour", "water", "-o", "water.png")
run_program("plot", "plane.h5", "pressure", "-o", "pressure.svg")


def fills(name):
    return len(set(re.findall(r"rgb\([^)]*\)", (folder / name).read_text())))


# More elements of different temperatures than colours of the legend's 40 steps and the marks.
check(fills("heat.svg") > fills("water.svg") - 40, "colours of temperature")
fails("has no temperatures at this time", "draw", "plane.h5", "--at", "start", "--colour", "temperature", "-o", "x.svg")
fails("cannot be drawn with magnified displacements", "draw", "plane.h5", "--at", "end", "--colour", "water", "--magnify",
      "10", "-o", "x.svg")

space = run_script("space", SPACE)
with h5py.File(folder / "space.h5") as file:
    near(float(file["histories/slab"][-1]), space[0])
    near(space[0], 40)
    check(file["frames/node_temperature"][()][-1].min() == -273.15, "the rock has no temperature")
run_program("draw", "space.h5", "--at", "end", "--colour", "temperature", "-o", "space.png")
run_program("draw", "space.h5", "--at", "end", "--colour", "temperature", "--cut", "y=1", "-o", "cut.png")
fails("has no water in joints", "draw", "space.h5", "--at", "end", "--colour", "water", "-o", "x.svg")
report = run_program("report", "plane.h5", "-o", "report.html")
page = (folder / "report.html").read_text()
for text in ("at the top", "Temperatures at the end.", "Pressure of the water in joints at the end."):
    check(text in page, f"the report lacks '{text}'")
