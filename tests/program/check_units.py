"""The same wall, bearing of a bridge, portal and tower in space in SI, "kN m", "N mm" and "kip ft" give the same results.

usage: check_units.py PROGRAM SCRIPT FOLDER
"""
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
    return readings, out


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


for case in ("wall", "bearing", "portal", "tower"):
    expected, file = run(case, "SI")
    if expected is None:
        continue
    for units in ("kN m", "N mm", "kip ft"):
        compare(case, units, expected, file)

# The door: functions that do not convert are refused, and so are numbers given too early.
REFUSED = {
    'local early = trilith.frictional\nlocal m = trilith.model { units = "N mm" }\n'
    "early { kn = 1, ks = 1, mu = 0.5 }": "does not convert numbers to the units",
    "trilith.linear { stiffness = 1 }\nlocal m = trilith.model { units = \"kN m\" }": "must be given before other numbers",
    'local mm = trilith.units "mm"\nlocal m = trilith.model { units = "kN m" }': "must be given before other numbers",
    'local m = trilith.model { units = "kN m" }\nlocal n = trilith.model {}': "all models of a script have the same units",
    'local m = trilith.model { units = "kN kg" }': "must be a unit of force and a unit of length",
    'local m = trilith.model { units = "kN mile" }': "there is no unit 'mile'",
    'local m = trilith.model { units = "kN m" }\nm:story(function() end)': 'model:story does not convert to units = "kN m"',
    'local m = trilith.model { units = "N mm" }\nm:on({ "impact", above = 2 }, print)': "'above' of on is not converted",
    'local m = trilith.model { units = "kN m" }\nm:material { name = "a", density = -1 }': "density is -1 kN s2/m4",
    'local m = trilith.model { units = "N mm" }\nm:wall { name = "w", length = 1, courses = 1, openings = {} }':
        "openings is not converted",
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

# The console prints values with the units of the models, and tables of the engine keep their messages.
CONSOLE = """
m = trilith.model { units = "N mm" }
m:material { name = "stone", density = 2.4e-9 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 5, ks = 2, mu = 0.6, beta = 1e-4 } }
m:block { name = "ground", width = 4000, height = 1000, at = { -2000, -1000 }, material = "stone", support = "fixed" }
b = m:block { name = "block", width = 500, height = 400, at = { 0, 0 }, material = "stone" }
b
print(m:consolidate { rest = { ratio = 1e-5 } })
m.energy.kinetc
m:run({ duration = 0.01 }).endng
b.uz
print(5*trilith.units "cm")
"""
SHOWN = [r"y +200 mm ", r"mass +0\.48 N s2/mm ", r"vx +0 mm/s ", r"consolidation ended \(rest\) after", "has no 'kinetc'; did you mean",
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
