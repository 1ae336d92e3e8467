#!/usr/bin/python3
"""The scripts of docs/examples: each one is listed with a picture and prints figures within the bounds of a
hand calculation.
usage: check_examples.py PROGRAM SOURCE FOLDER"""
import re
import shutil
import subprocess
import sys
from pathlib import Path

program, source, folder = (Path(each).resolve() for each in sys.argv[1:4])
shutil.rmtree(folder, ignore_errors=True)
shutil.copytree(source / "scripts" / "examples", folder)
g = 9.80665


def check(holds, text):
    if not holds:
        sys.exit(f"wrong: {text}")


def figures(pattern, text):
    found = re.search(pattern, text)
    check(found, f"no '{pattern}' in: {text}")
    return [float(each) for each in found.groups()]


def run(name):
    result = subprocess.run([program, "run", "-q", f"{name}.lua"], cwd=folder, capture_output=True, text=True, check=False)
    check(result.returncode == 0, f"{name}: {result.stderr}{result.stdout}")
    return result.stdout


def listed():
    """Each script has a row with a picture on the page, and no row names a script that is not there."""
    page = (source / "docs/examples/README.md").read_text(encoding="utf8")
    rows = dict(re.findall(r"\]\((\w+\.png)\)\]\(\.\./\.\./scripts/examples/(\w+)\.lua\)", page))
    check({name + ".lua" for name in rows.values()} == {p.name for p in folder.glob("*.lua")}, rows)
    for picture in rows:
        check((source / "docs/examples" / picture).is_file(), picture)


def dry_wall():
    text = run("dry_wall_pushover")
    weight, peak = figures(r"weight ([\d.]+) kN, peak ([\d.]+) kN", text)
    # The wall of 4 m by 2.4 m with a window and a slab: sliding on the base bounds the push.
    area = 4 * 2.4 - 0.8 * 0.8 + 4 * 0.3
    check(abs(weight - 2200 * g * 0.5 * area / 1e3) < 0.01 * weight, text)
    check(0.3 * weight < peak < 0.6 * weight, text)


def pendulum_bridge():
    text = run("pendulum_bridge")
    period, = figures(r"dishes: ([\d.]+) s", text)
    check(abs(period - 2.84) < 0.01, text)
    largest, end, hold = figures(r"dish ([\d.]+) mm, at the end (-?[\d.]+) mm; friction holds up to ([\d.]+) mm", text)
    # The pulse displaces the ground by A T^2/(2 pi), and the deck by less relative to it.
    check(50 < largest < 2 * 3 * 0.8**2 / 6.283 * 1e3 and abs(end) <= hold + 1, text)


def house_corner():
    broken, apart, joints = figures(r"(\d+) bonds broke, (\d+) of (\d+) joints", run("house_corner"))
    check(0 < apart <= broken <= joints, (broken, apart, joints))


def drums():
    text = run("drums")
    moved, risen = figures(r"moved by ([\d.]+) mm and risen by (-?[\d.]+) mm", text)
    check("the column stands" in text and moved < 600 and abs(risen) < 100, text)  # less than the diameter of a drum


def concrete_portal():
    peak, moment, limit = figures(r"peak ([\d.]+) kN at \d+ mm; four hinges of ([\d.]+) kN m give ([\d.]+) kN", run("concrete_portal"))
    # Bars of 8 cm2 at each face and 420 MPa, lever arm about 0.25 m: 84 kN m, and the moment of the normal force.
    check(84 < moment < 84 + 100 * 0.35 / 2 + 20, moment)
    # Bars harden and the right column is pressed more, so the peak lies above the mechanism.
    check(limit < peak < 1.2 * limit, (peak, limit))


def arch_fragility():
    counts = [int(each) for each in re.findall(r"g: (\d) of 6 collapse", run("arch_fragility"))]
    check(len(counts) == 5 and counts == sorted(counts) and counts[0] < 6 and counts[-1] == 6, counts)


def obj_and_stl():
    text = run("obj_and_stl")
    # The upright is a frustum; the boulder a regular icosahedron of 0.35 m circumradius: V = 2.5362 r^3.
    bottom, top = 1.0 * 1.0, 0.84 * 0.84
    frustum = 3 / 3 * (bottom + top + (bottom * top) ** 0.5)
    upright, = figures(r"stone.left: ([\d.]+) m3", text)
    boulder, = figures(r"boulder: ([\d.]+) m3", text)
    check(abs(upright - frustum) < 0.01 and abs(boulder - 2.5362 * 0.35**3) < 2e-4, text)


def console():
    lines = re.findall(r"^--     > (.*)$", (folder / "console.lua").read_text(encoding="utf8"), re.M)
    check(len(lines) == 4, lines)
    result = subprocess.run([program, "-i", "-q", "console.lua"], cwd=folder, input="\n".join(lines) + "\n", capture_output=True,
                            text=True, check=False)
    check(result.returncode == 0 and not result.stderr, result.stderr)
    # The block slides: a = g (sin - mu cos) along a slope of 1 : 2 with mu = 0.3, for 0.5 s.
    speed, share = figures(r"share = ([\d.]+), speed = ([\d.]+)", result.stdout)[::-1]
    wanted = 0.5 * g * (1 - 0.3 * 2) / 5**0.5 * 2 / 5**0.5
    check(abs(speed - wanted) < 2e-3 and abs(share - speed / 9.81) < 1e-9, result.stdout)


listed()
for each in (dry_wall, pendulum_bridge, house_corner, drums, concrete_portal, arch_fragility, obj_and_stl, console):
    each()
