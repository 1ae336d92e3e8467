"""The same models, with calls of all functions that convert, give the same results in SI, "kN m", "N mm" and "kip ft".

usage: check_units.py PROGRAM SCRIPT FOLDER
"""
import base64
import csv
import gzip
import json
import os
import re
import subprocess
import sys

import h5py
import numpy

program, script, folder = (os.path.abspath(a) for a in sys.argv[1:4])
os.makedirs(folder, exist_ok=True)
failed = []

# Powers of ten are exact, so the numbers in the engine are the same bits. A foot and a kip are not: the inputs differ in
# the last digits, and the oscillations of the wall amplify this.
TOLERANCE = {"kN m": 1e-12, "N mm": 1e-12, "kip ft": 1e-5}


def run(case, units):
    out = os.path.join(folder, f"{case}_{units.replace(' ', '_')}.h5")
    command = [program, "run", "--quiet", script, f"case={case}", f"units={units}", f"out={out}"]
    done = subprocess.run(command, capture_output=True, text=True, cwd=folder)
    if done.returncode != 0:
        failed.append(f"{case} in {units}: code {done.returncode}\n{done.stdout}{done.stderr}")
        return None, None
    readings = {}
    for line in done.stdout.splitlines():
        name, value = line.split()
        readings[name] = float(value)
    branch = out.replace(".h5", ".branch2.h5")  # of a run that has gone back
    return readings, out if os.path.exists(out) else branch


def numbers(path):
    """All tables of numbers of a results file by name."""
    found = {}

    def add(name, item):
        if not isinstance(item, h5py.Dataset):
            return
        if item.dtype.kind == "f":
            found[name] = item[()]
        for field in item.dtype.names or ():
            if item.dtype[field].kind == "f":
                found[f"{name}.{field}"] = item[field]

    with h5py.File(path, "r") as file:
        file.visititems(add)
    return found


def differ(a, b):
    """Largest difference over the largest value of a table."""
    a, b = numpy.nan_to_num(numpy.asarray(a)), numpy.nan_to_num(numpy.asarray(b))
    if a.shape != b.shape:
        return float("inf")
    size = float(numpy.max(numpy.abs(a), initial=0))
    return float(numpy.max(numpy.abs(a - b), initial=0)) / size if size > 0 else float(numpy.max(numpy.abs(b), initial=0))


def compare(case, units, expected, file):
    tolerance = TOLERANCE[units]
    readings, other = run(case, units)
    if readings is None:
        return
    for name, value in expected.items():
        # Kinetic energy and speed at rest are rounding errors themselves.
        if abs(readings[name] - value) > tolerance * abs(value) + (1e-9 if units == "kip ft" else 0):
            failed.append(f"{case} in {units}: {name} is {readings[name]!r}, in SI {value!r}")
    if units == "kip ft":
        return
    first, second = numbers(file), numbers(other)
    if len(first) < 10 or first.keys() != second.keys():
        failed.append(f"{case} in {units}: the results files have other tables: {first.keys() ^ second.keys()}")
    for name in first:
        if re.search("wall_clock|seconds|cost|profile", name) or name not in second:
            continue
        if not differ(first[name], second[name]) <= tolerance:
            failed.append(f"{case} in {units}: {name} differs by {differ(first[name], second[name]):g}")


for case in ("wall", "bearing", "portal", "tower", "fields", "calls", "spans", "skew", "waves", "builders"):
    expected, file = run(case, "SI")
    if expected is None:
        continue
    for units in ("kN m", "N mm", "kip ft"):
        compare(case, units, expected, file)

# Results are shown in the units of the model, or in others; the file stays in SI.
def shown(*arguments):
    done = subprocess.run([program, *arguments], capture_output=True, text=True, cwd=folder)
    if done.returncode != 0:
        failed.append(f"trilith {' '.join(arguments)}: code {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def expect(what, text, present=(), absent=()):
    for pattern in present:
        if not re.search(pattern, text):
            failed.append(f"{what}: '{pattern}' is missing:\n{text[:2000]}")
    for pattern in absent:
        if re.search(pattern, text):
            failed.append(f"{what}: '{pattern}' must not be there: {re.search(pattern, text).group(0)}")


def column(table, name):
    head, *rows = list(csv.reader(table.splitlines()))
    if name not in head:
        failed.append(f"no column '{name}' in {head}")
        return numpy.zeros(0)
    return numpy.array([float(row[head.index(name)]) for row in rows])


def check_outputs(file, metric):
    """`file`: a portal in N mm; `metric`: the same in SI."""
    with h5py.File(file, "r") as data:
        if data["provenance"].attrs["units"].decode() != "N mm":
            failed.append("the results file does not keep the units of the script")
    own, si = shown("export", file, "--to", "csv", "--table", "members"), shown("export", file, "--to", "csv", "--table", "members",
                                                                              "--units", "SI")
    if si != shown("export", metric, "--to", "csv", "--table", "members"):
        failed.append("a table in SI differs from that of a model in SI")
    for name, unit, factor in (("along", "mm", 1e3), ("x", "mm", 1e3), ("moment", "N mm", 1e3), ("normal", "N", 1)):
        there = [head for head in own.splitlines()[0].split(",") if head.startswith(name) and head.endswith(f"[{unit}]")]
        if not there:
            failed.append(f"export: no column '{name} [{unit}]' in {own.splitlines()[0]}")
            continue
        plain = there[0].replace(f"[{unit}]", "[N m]" if unit == "N mm" else "[m]" if unit == "mm" else "[N]")
        a, b = column(own, there[0]), column(si, plain)
        if len(a) == 0 or not numpy.allclose(a, factor * b, rtol=1e-14, atol=0):
            failed.append(f"export: '{name}' in {unit} is not {factor} times SI")
    expect("info", shown("info", file), [r"mass +[\d.]+ t", r"energy", r" N mm\n"], [r" J\n", r" kg\b"])
    expect("info in kip ft", shown("info", file, "--units", "kip ft"), [r" kip ft\n"], [r" J\n"])
    expect("events", shown("info", file, "--events"), [r"yielded under [\d.e+]+ N mm"], [r"kN m"])
    page = os.path.join(folder, "units.report.html")
    shown("report", file, "-o", page)
    with open(page, encoding="utf-8") as text:
        body = re.sub(r"(?s)<svg.*?</svg>|<details.*?</details>|<pre.*?</pre>", "", text.read())
    expect("report", body, [r"N·mm", r"1/mm", r"Units of the model throughout: N, mm"], [r"\d k?N·m\b", r"\d kN\b", r"\d Pa\b", r"\d J\b"])
    view = os.path.join(folder, "units.html")
    shown("view", file, "-o", view)
    with open(view, encoding="utf-8") as text:
        packed = max(re.findall(r"[A-Za-z0-9+/=]{2000,}", text.read()), key=len)
    raw = gzip.decompress(base64.b64decode(packed))
    head = json.loads(raw[12:12 + int.from_bytes(raw[8:12], "little")])
    if head.get("units", {}).get("N m") != [0.001, "N·mm"] or head["units"].get("m") != [0.001, "mm"]:
        failed.append(f"the page has the units {head.get('units')}")
    expect("events of the page", json.dumps(head["events"], ensure_ascii=False), [r"N mm"], [r"kN m"])
    for verb in (["draw", file, "--diagram", "moment", "-o", "units.svg"], ["plot", file, "energy", "-o", "units.plot.svg"]):
        shown(*verb)
        shown(*verb, "--units", "kip ft")
    wrong = subprocess.run([program, "info", file, "--units", "kN mile"], capture_output=True, text=True, cwd=folder)
    expect("a wrong unit", wrong.stderr, [r"--units: 'units' is 'kN mile': there is no unit 'mile'"])


def check_terminal():
    """Lines of a run that is not quiet."""
    for units, there, not_there in (("N mm", r"yielded under [\d.e+]+ N mm", r"kN m"), ("SI", r"yielded under [\d.]+ kN m", r"N mm")):
        done = subprocess.run([program, "run", script, "case=portal", f"units={units}", "out=terminal.h5"], capture_output=True,
                              text=True, cwd=folder)
        expect(f"the terminal in {units}", done.stdout, [there], [not_there])


if not failed:
    check_outputs(os.path.join(folder, "portal_N_mm.h5"), os.path.join(folder, "portal_SI.h5"))
    check_terminal()

# A report lists the strains in use of a law with a fracture energy, and no energy of 0.
LAW = """
local trilith = require "trilith"
local m = trilith.model { name = "post", units = "N mm" }
m:material { name = "concrete", density = 2.5e-9, E = 3e4, nu = 0.2 }
m:beam { name = "post", from = { 0, 0 }, to = { 0, 3000 }, material = "concrete", divisions = 6, from_support = "fixed",
  section = trilith.fibre_section { shape = trilith.rectangle_section { width = 300, depth = 300 },
    law = trilith.kent_park { strength = 30, crush_energy = 25 } } }
m:results { file = "post.h5" }
m:consolidate { integrator = "static" }
"""
with open(os.path.join(folder, "post.lua"), "w", encoding="utf-8") as text:
    text.write(LAW)
shown("run", "--quiet", "post.lua")
shown("report", "post.h5", "-o", "post.html")
with open(os.path.join(folder, "post.html"), encoding="utf-8") as text:
    # 0.002 + 2 G/(1.2 f h) - 0.8 f/E with E = 2 f/0.002
    expect("the law of a report", text.read(), [r"kent_park\{strength=30 N/mm2[^}]*ultimate=0\.00397778"], [r"crush_energy=0"])

# A path by arc length has its energies at each point.
with h5py.File(os.path.join(folder, "portal_SI.h5"), "r") as data:
    plastic, residual = data["energy/plastic"][()], data["energy/residual"][()]
    if len(plastic) < 10 or len(set(plastic)) < 10 or numpy.max(numpy.abs(residual)) > 1e-4 * plastic[-1]:
        failed.append(f"energies of a path: {len(plastic)} rows, plastic {plastic}, residual {residual}")

# The door: functions that do not convert are refused, and so are numbers given too early.
REFUSED = {
    'local early = trilith.frictional\nlocal m = trilith.model { units = "N mm" }\n'
    "early { kn = 1, ks = 1, mu = 0.5 }": "does not convert numbers to the units",
    "trilith.linear { stiffness = 1 }\nlocal m = trilith.model { units = \"kN m\" }": "must be given before other numbers",
    'local mm = trilith.units "mm"\nlocal m = trilith.model { units = "kN m" }': "must be given before other numbers",
    'local m = trilith.model { units = "kN m" }\nlocal n = trilith.model {}': "all models of a script have the same units",
    'local m = trilith.model { units = "kN kg" }': "must be a unit of force and a unit of length",
    'local m = trilith.model { units = "kN mile" }': "there is no unit 'mile'",
    'trilith.params { pga = { 0.4, unit = "g" } }\nlocal m = trilith.model { units = "kN m" }': "parameters with a unit",
    'local m = trilith.model { units = "N mm" }\nm:body { name = "a", mesh = { file = "square.msh", scale = 0 } }':
        "'scale' is 0, must be above 0",
    'local m = trilith.model { units = "N mm" }\nm:calibrate { frequency = 1, vary = "a.kn", between = { 2, 1 } }':
        "there is no stiffness 'a.kn'",
    'local m = trilith.model { units = "N mm" }\nm:on({ "no.event", above = 2 }, print)': "'above' of on is not converted",
    'local m = trilith.model { units = "kN m" }\nm:material { name = "a", density = -1 }': "density is -1 kN s2/m4",
    'local m = trilith.model { units = "N mm" }\nm:wall { name = "w", length = 1, courses = 1, openings = { { x = 1 } } }':
        "'width' is missing; give a number in mm",
}
for text, message in REFUSED.items():
    path = os.path.join(folder, "refused.lua")
    with open(path, "w", encoding="utf-8") as file:
        file.write('local trilith = require "trilith"\n' + text + "\n")
    done = subprocess.run([program, "run", "--quiet", path], capture_output=True, text=True, cwd=folder)
    if done.returncode == 0 or message not in done.stderr + done.stdout:
        failed.append(f"{text}\nmust be refused with '{message}', gave code {done.returncode}:\n{done.stdout}{done.stderr}")
    if "refused.lua:" not in done.stderr + done.stdout:
        failed.append(f"{text}\nthe message has no place:\n{done.stderr}")

# A study after the first model: parameters with a unit, figures of the script and of histories are in its units. A mesh
# file has the unit of length of the models.
STUDY = """
local trilith = require "trilith"
local units = %r
local one = units == "N mm" and 1e3 or 1                 -- a metre
local function made(name)
  return trilith.model { name = name, units = units ~= "SI" and units or nil, gravity = 0 }
end
made "first"
local file = io.open("square.msh", "w")
file:write("$MeshFormat\\n2.2 0 8\\n$EndMeshFormat\\n$Nodes\\n4\\n")
for i, p in ipairs { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } } do file:write(i, " ", p[1]*one, " ", p[2]*one, " 0\\n") end
file:write("$EndNodes\\n$Elements\\n1\\n1 3 2 1 1 1 2 3 4\\n$EndElements\\n")
file:close()
local study = trilith.study { file = "units_study.h5", parameters = { speed = { 0.5, 1, unit = "m/s" } },
  histories = { moved = "largest" }, jobs = 1,
  case = function(p)
    local m = made "case"
    m:material { name = "stone", density = one == 1 and 2000 or 2e-9 }
    local body = m:body { name = "square", material = "stone", mesh = { file = "square.msh" }, body = "rigid",
      velocity = { p.speed, 0 }, floating = true }
    m:results { file = "case.h5" }
    m:history { name = "moved", body = body, what = "ux" }
    m:run { duration = 0.1 }
    return { came = body.ux, mass = { body.mass, unit = "kg" } }
  end }
for _, row in ipairs(study.rows) do
  print(row.speed, row.came/one, row["moved largest"]/one, row.mass*(one == 1 and 1 or 1e3))
end
"""
rows = []
for units in ("SI", "N mm"):
    where = os.path.join(folder, "study " + units)
    os.makedirs(where, exist_ok=True)
    with open(os.path.join(where, "study.lua"), "w", encoding="utf-8") as file:
        file.write(STUDY % units)
    done = subprocess.run([program, "study", "--trust", "study.lua"], capture_output=True, text=True, cwd=where)
    found = [[float(x) for x in line.split()] for line in done.stdout.splitlines() if re.match(r"[\d.]+\s+[\d.]+\s", line)]
    if done.returncode != 0 or len(found) != 2:
        failed.append(f"the study in {units}: code {done.returncode}\n{done.stdout}{done.stderr}")
    rows.append(found)
if not numpy.allclose(rows[0], [[0.5, 0.05, 0.05, 2000], [1, 0.1, 0.1, 2000]], rtol=1e-9) or \
        not numpy.allclose(rows[0], rows[1], rtol=1e-12):
    failed.append(f"the rows of a study are {rows[0]} in SI and {rows[1]} in N mm")

# The console prints values with the units of the models, and tables of the engine keep their messages.
CONSOLE = """
m = trilith.model { units = "N mm" }
m:material { name = "stone", density = 2.4e-9 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 5, ks = 2, mu = 0.6, beta = 1e-4 } }
m:block { name = "ground", width = 4000, height = 1000, at = { -2000, -1000 }, material = "stone", support = "fixed" }
b = m:block { name = "block", width = 500, height = 400, at = { 0, 0 }, material = "stone" }
b
print(m:consolidate { rest = { ratio = 1e-5 } })
print(m.verdict)
m.energy.kinetc
m:run({ duration = 0.01 }).endng
b.uz
print(5*trilith.units "cm")
"""
SHOWN = [r"y +200 mm ", r"mass +0\.48 t ", r"vx +0 mm/s ", r"consolidation ended \(rest\) after", "^the run is valid$", "has no 'kinetc'; did you mean",
         "report has no 'endng'; did you mean", "body 'block' has no 'uz'", r"^50\.0$"]
done = subprocess.run([program], input=CONSOLE, capture_output=True, text=True, cwd=folder)
shown = done.stdout + done.stderr
for pattern in SHOWN:
    if not re.search(pattern, shown, re.M):
        failed.append(f"the console does not print '{pattern}':\n{shown}")
if re.search("traceback|does not convert", shown):
    failed.append(f"the console prints an error of the library:\n{shown}")

print("\n".join(failed))
sys.exit(1 if failed else 0)
