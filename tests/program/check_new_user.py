#!/usr/bin/python3
"""The first output that a new user reads. It has kinds of stages in `info`, words in events.csv, and the mark of an event in a
picture. Further cases are events of sliders, tables in the console, and the drift of records.
usage: check_new_user.py PROGRAM FOLDER"""
import csv
import math
import re
import shutil
import subprocess
import sys
from pathlib import Path

program, folder = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)

WALL = """
local trilith = require "trilith"
local m = trilith.model { name = "pillar", dim = 2 }
m:material { name = "stone", density = 2000 }
m:contact { between = { "*", "*" }, law = trilith.bonded { kn = 1e9, ks = 5e8, mu = 0.6, beta = 1e-4, tension = 2e4, cohesion = 3e4 } }
local base = m:block { name = "base", width = 4, height = 0.5, at = { -2, -0.5 }, material = "stone", support = "fixed" }
local stone = m:block { name = "stone", width = 0.5, height = 1, at = { -0.25, 0 }, material = "stone" }
m:results { file = "wall.h5", frames = 0.02, histories = 0.02 }
m:consolidate { duration = 5 }
m:pushover { name = "push", body = stone, at = { 0, 1 }, displacement = 0.1 }
m:run { name = "damped", duration = 0.1, local_damping = 0.3 }
"""

PATH = """
local trilith = require "trilith"
local m = trilith.model { name = "cantilever" }
m:material { name = "steel", density = 7850, E = 2.1e11, nu = 0.3 }
local post = m:beam { name = "post", from = { 0, 0 }, to = { 0, 3 }, material = "steel", from_support = "fixed",
  section = trilith.rectangle_section { width = 0.1, depth = 0.2 } }
m:results { file = "path.h5" }
m:consolidate { integrator = "static" }
m:pushover { body = post, at = { 0, 3 }, control = "arc", displacement = 0.1 }
"""

SLIDER = """
local trilith = require "trilith"
local p = trilith.params { integrator = { "explicit", "of the consolidation" } }
local m = trilith.model { name = "slider" }
m:material { name = "stone", density = 2400 }
m:contact { between = { "*", "*" }, law = "none" }
m:block { name = "base", width = 4, height = 0.5, at = { -2, -0.5 }, material = "stone", support = "fixed" }
local block = m:block { name = "block", width = 1, height = 1, at = { -0.5, 0 }, material = "stone" }
for i, x in ipairs { -0.4, 0.4 } do
  m:bearing { name = "slider" .. i, between = { "base", "block" }, at = { x, 0 },
    axial = trilith.linear { stiffness = 1e8, damping = 1e5 }, along = trilith.friction { mu = 0.1, stiffness = 1e6 } }
end
local events = {}
m:on("bearing.yielded", function(e) events[#events + 1] = ("%.3g"):format(e.value) print(e.text) end)
m:consolidate { integrator = p.integrator }
print(("yielded under weight: %d"):format(#events))
m:pushover { body = block, displacement = 0.02, rate = 0.02 }
print(("yielded in all: %d at %s m"):format(#events, table.concat(events, " and ")))
"""


def check(holds, text):
    if not holds:
        sys.exit(f"wrong: {text}")


def trilith(*arguments, code=0, text=None):
    result = subprocess.run([program, *arguments], cwd=folder, input=text, capture_output=True, text=True, check=False)
    check(result.returncode == code, f"{arguments}: code {result.returncode}, {result.stderr}{result.stdout}")
    return result.stdout + result.stderr


def run_script(name, source, *arguments):
    (folder / f"{name}.lua").write_text(source)
    return trilith("run", f"{name}.lua", *arguments)


def kinds_of_stages():
    run_script("wall", WALL)
    stages = trilith("info", "wall.h5")
    for row in ("consolidation (consolidation)", "push (pushover)", "damped (dynamic)"):
        check(row in stages, f"no '{row}' in {stages}")
    run_script("path", PATH)
    check("pushover (pushover)" in trilith("info", "path.h5"), "a load path is not a pushover")


def words_of_events():
    trilith("export", "wall.h5", "--to", "csv", "--table", "events", "-o", "events.csv")
    with open(folder / "events.csv", newline="", encoding="utf8") as file:
        rows = list(csv.DictReader(file))
    broken = [row for row in rows if row["type"] == "bond.broken"]
    check(broken and all(row["mode"] in ("tension", "shear") for row in broken), broken)
    check(all(f"in {row['mode']}" in row["text"] for row in broken), broken)
    check(all(row["figure_2"] != "mode" for row in rows), "events.csv has codes of modes")
    check(all(row["mode"] == "" for row in rows if row["type"].startswith(("contact.", "stage."))), rows)
    return float(broken[0]["time [s]"])


def mark_of_event(time):
    trilith("draw", "wall.h5", "--at", "bond.broken", "-o", "event.svg")
    trilith("draw", "wall.h5", "--at", f"{time:.9g}", "-o", "time.svg")
    marked, plain = ((folder / name).read_text(encoding="utf8") for name in ("event.svg", "time.svg"))
    strokes = [set(re.findall(r'stroke="([^"]+)"|stroke:\s*([^;"]+)', text)) for text in (marked, plain)]
    check(len(strokes[0] - strokes[1]) == 1, f"the ring has no colour of its own: {strokes}")
    check(len(marked) > len(plain) + 2000, "no ring of 48 sides")


def slider_under_weight():
    for integrator in ("explicit", "static"):
        text = run_script("slider", SLIDER, f"integrator={integrator}")
        check("yielded under weight: 0" in text, text)
        found = re.search(r"yielded in all: (\d+) at (.*) m", text)
        # N = rho g / 2 of 1 m2 on each slider; it slides at mu N / k.
        yields = 0.1 * 2400 * 9.80665 / 2 / 1e6
        check(found and found[1] == "2", text)
        check(all(0.9 * yields < float(each) < 1.5 * yields for each in found[2].split(" and ")), f"{yields}: {text}")


def tables_in_console():
    text = trilith(text="t = { 1, 2, side = 'left' }\nprint(t)\nprint('a', 2, nil, { x = {} })\nprint\nprint(setmetatable({}, "
                   "{ __tostring = function() return 'own' end }))\n")
    check("{ 1, 2, side = \"left\" }" in text and "a\t2\tnil\t{ x = {} }" in text and "own" in text and "table: 0x" not in text, text)


def accelerations(end_share):
    """At 100 samples/s: 1 s up, 1 s down to about a share of the peak velocity, 6 s at that speed."""
    return [0.0] + [1.0] * 100 + [-(1 - end_share)] * 100 + [0.0] * 600


def integrated(rows, step=0.01):
    """Peak velocity, velocity and displacement at the end, of accelerations that are linear between samples."""
    v = u = peak = 0
    for a, b in zip(rows, rows[1:]):
        u += v * step + (2 * a + b) * step**2 / 6
        v += 0.5 * (a + b) * step
        peak = max(peak, abs(v))
    return peak, v, u


def drift_of_records():
    for name, share in (("drifts", 0.03), ("rests", 0)):
        (folder / f"{name}.txt").write_text("\n".join(f"{a:.6f}" for a in accelerations(share)) + "\n")
    plain = ("--no-picture", "--unit", "m/s2", "--dt", "0.01")
    text = trilith("motion", "drifts.txt", *plain)
    found = re.search(r"usable +yes; the ground still moves at ([\d.]+) mm/s at the end \(([\d.]+) % of PGV\), ([\d.]+) m from its start", text)
    check(found, text)
    speed, share, offset = (float(each) for each in found.groups())
    peak, v, u = integrated(accelerations(0.03))
    # As printed, with two or three figures.
    check(math.isclose(speed, 1e3 * v, rel_tol=5e-3) and math.isclose(share, 100 * v / peak, rel_tol=0.02), (text, v, peak))
    check(math.isclose(offset, u, rel_tol=5e-3), (text, u))
    check(re.search(r"usable +yes\n", trilith("motion", "rests.txt", *plain)), "a record at rest drifts")
    for name, told in (("drifts", True), ("rests", False)):
        text = run_script("shake", WALL[:WALL.index("m:consolidate")] + f'm:shake {{ body = "base", duration = 0.1, x = trilith.motion '
                          f'{{ file = "{name}.txt", unit = "m/s2", dt = 0.01 }} }}\n')
        check(("the ground still moves at" in text) == told, f"{name}: {text}")


def component_of_titles():
    for title, component in (("EL CENTRO, 5/19/40, ARRAY #9, 180 (USGS STATION 117)", "180"), ("SITE, N90E", "N90E"),
                             ("VALLEY, NEAR THE HILLS, CA", None)):
        (folder / "title.at2").write_text(f"PEER\n{title}\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 5, DT= .01 SEC\n0 .1 0 -.1 0\n")
        text = trilith("motion", "title.at2", "-o", "title.svg")
        found = re.search(r"^component +(.*)$", text, re.M)
        check((found[1] if found else None) == component, text)


kinds_of_stages()
mark_of_event(words_of_events())
slider_under_weight()
tables_in_console()
drift_of_records()
component_of_titles()
