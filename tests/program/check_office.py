#!/usr/bin/python3
"""The work flow of the README of the starting model `facade`, in at most ten commands. It reads a drawing, matches records
to a design spectrum, runs pushover and time history, and writes a plot, a report, tables and a film.
usage: check_office.py PROGRAM FOLDER"""
import csv
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import h5py

program, folder = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
shutil.rmtree(folder, ignore_errors=True)
(folder / "bin").mkdir(parents=True)
os.symlink(program, folder / "bin" / "trilith")
environment = {**os.environ, "PATH": f"{folder.resolve() / 'bin'}:{os.environ['PATH']}"}


def check(holds, text):
    if not holds:
        sys.exit(f"wrong: {text}")


def run_program(command, where):
    return subprocess.run(["sh", "-c", command], cwd=where, env=environment, capture_output=True, text=True, check=False)


made = run_program("trilith new facade", folder)
check(made.returncode == 0, made.stderr)
here = folder / "facade"
commands = re.search(r"```sh\n(.*?)```", (here / "README.md").read_text(), re.S).group(1).splitlines()
check(len(commands) < 10, f"{len(commands)} commands")
has_encoder = shutil.which("ffmpeg") is not None
for command in commands:
    command = command.split("  #")[0].strip()
    if "movie" in command and not has_encoder:
        continue
    # The records are cut to 0.3 s, as the test is about the commands.
    short = " duration=0.3s" if "record=" in command and "--over" not in command else ""
    if "--over" in command:
        short = " duration=0.3s"
    result = run_program(command + short, here)
    check(result.returncode == 0, f"{command}: {result.stderr}{result.stdout}")

with open(here / "out" / "facade_0_csv" / "histories.csv", newline="", encoding="utf8") as file:
    rows = list(csv.reader(file))
check(rows[0][1:] == ["top [m]", "force [N]", "displacement [m]"] and len(rows) > 50, rows[0])
check(max(float(r[2] or 0) for r in rows[1:]) > 5e4, "the push has no force")
with h5py.File(here / "out" / "records.h5") as file:
    cases = file["cases"][()]
    check(len(cases) == 3 and set(cases["status"]) == {b"finished"}, cases)
    # The records of one component and of its reverse are matched by the same factor.
    check(abs(cases["pga"][0] - cases["pga"][2]) < 1e-9 and cases["pga"][0] != cases["pga"][1], cases)
for name in ("capacity.svg", "facade_0.report.html") + (("collapse.mp4", "collapse.png") if has_encoder else ()):
    check(list(here.glob(f"**/{name}")), f"there is no {name}: {sorted(p.name for p in here.glob('**/*'))}")
print(f"{len(commands) + 1} commands")
