#!/usr/bin/python3
"""Office work on a façade: the commands of docs/guide/office.md, at most ten, as they are on the page. They read a drawing, match
records to a design spectrum, run pushover and time history, and write pictures, a report, tables and a film.
usage: check_office.py PROGRAM PAGE FOLDER"""
import csv
import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

import h5py

program, page, folder = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).read_text(encoding="utf8"), Path(sys.argv[3])
shutil.rmtree(folder, ignore_errors=True)
(folder / "bin").mkdir(parents=True)
os.symlink(program, folder / "bin" / "trilith")
environment = {**os.environ, "PATH": f"{folder.resolve() / 'bin'}:{os.environ['PATH']}"}


def check(holds, text):
    if not holds:
        sys.exit(f"wrong: {text}")


def run_commands():
    """Runs the first block of the page. Returns its folder, the number of commands and the printed text."""
    here, printed = folder, ""
    commands = re.search(r"```sh\n(.*?)```", page, re.S).group(1).splitlines()
    check(len(commands) <= 10, f"{len(commands)} commands")
    for command in commands:
        if command.startswith("cd "):
            here = here / command[3:]
            continue
        if "movie" in command and not has_encoder:
            print("skipped: ffmpeg is not installed, so there is no film")
            continue
        result = subprocess.run(["sh", "-c", command], cwd=here, env=environment, capture_output=True, text=True, check=False)
        check(result.returncode == 0, f"{command}: {result.stderr}{result.stdout}")
        printed += result.stdout
    return here / "out", len(commands), printed


def figures(pattern, text):
    found = re.search(pattern, text)
    check(found, f"no '{pattern}' in: {text}")
    return [float(each) for each in found.groups()]


has_encoder = shutil.which("ffmpeg") is not None
begun = time.monotonic()
out, count, printed = run_commands()
seconds = time.monotonic() - begun

# A dry wall slides on its base at the latest, at 0.6 of its weight.
capacity, weight = figures(r"capacity ([\d.]+) kN, weight ([\d.]+) kN", printed)
check(0.2 * weight < capacity < 0.6 * weight, printed)
target, ultimate = figures(r"target displacement ([\d.]+) mm, ultimate ([\d.]+) mm", printed)
check(0 < target < ultimate, printed)

with open(out / "facade_1_csv" / "histories.csv", newline="", encoding="utf8") as file:
    rows = list(csv.reader(file))
check(rows[0] == ["time [s]", "top [m]"] and len(rows) > 300, rows[0])
tops = [abs(float(row[1])) for row in rows[1:]]
check(1e-3 < max(tops) < 1, f"the top moves by {max(tops)} m")

with h5py.File(out / "records.h5") as file:
    cases = file["cases"][()]
    check(len(cases) == 3 and set(cases["status"]) == {b"finished"}, cases)
    # Each record has a factor of its own, and all have the same target.
    check(len(set(cases["pga"])) == 3 and max(cases["pga"]) < 3 * min(cases["pga"]), cases)
    # The run by itself is the same computation as its case in the study.
    check(figures(r"the top has moved by ([\d.]+) mm", printed)[0] == round(1e3 * cases["top"][0], 1), cases["top"])

for name in ("capacity.png", "facade.png", "facade_1.report.html") + (("facade.mp4",) if has_encoder else ()):
    check((out / name).is_file() and (out / name).stat().st_size > 5000, f"there is no {name}: {sorted(os.listdir(out))}")
print(f"{count} commands, {seconds:.0f} s")
