#!/usr/bin/python3
"""Each starting model of `trilith new` runs, has the results that its README lists, and overwrites nothing.
usage: check_templates.py PROGRAM FOLDER"""
import re
import shutil
import subprocess
import sys
from pathlib import Path

import h5py

program, folder = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)

# Parameters for a short run, and a line that must appear.
KINDS = {
    "wall": (["duration=0.2s"], r"\d+ bonds broken; the top slab has moved by \d+\.\d mm"),
    "bridge": (["duration=0.5s"], r"S3: its dowel is intact; 0\.\d\d m of the right seat are left"),
    "arch": ([], r"the arch weighs 88\.7 kN and carries 7\d\.\d kN"),
    "facade": ([], r"capacity 1?\d\d\.\d kN, weight 197\.1 kN"),
    "frame": ([], r"peak force (99|100)\.\d kN; the plastic limit is 4 Mp / height = 100\.0 kN"),
    "house3d": (["duration=0.02s"], r"\d+ bodies; \d+ bonds broke"),
}


def run_program(*words, cwd=folder):
    return subprocess.run([str(program), *words], cwd=cwd, capture_output=True, text=True, check=False)


def check(holds, text):
    if not holds:
        sys.exit(f"wrong: {text}")


listed = run_program("new")
check(listed.returncode == 0, listed.stderr)
for kind in KINDS:
    check(re.search(rf"^  {kind} +\S", listed.stdout, re.M), f"the list has no {kind}: {listed.stdout}")
check(len(listed.stdout.splitlines()) == len(KINDS) + 1, f"the list has other entries: {listed.stdout}")

for kind, (words, line) in KINDS.items():
    made = run_program("new", kind, f"my {kind}")
    check(made.returncode == 0, made.stderr)
    here = folder / f"my {kind}"
    drawings = ["facade.dxf"] if kind == "facade" else []
    check(sorted(p.name for p in here.iterdir()) == ["README.md", *drawings, "model.lua"], f"{kind}: other files")
    again = run_program("new", kind, f"my {kind}")
    check(again.returncode == 1 and "exists already" in again.stderr, f"{kind}: overwritten: {again.stderr}")
    ran = run_program("run", "model.lua", "--quiet", *words, cwd=here)
    check(ran.returncode == 0, f"{kind}: {ran.stderr}{ran.stdout}")
    check(re.search(line, ran.stdout), f"{kind}: '{line}' is not in: {ran.stdout}")
    check("note:" not in ran.stderr, f"{kind}: a starting model runs without notes: {ran.stderr}")
    readme = (here / "README.md").read_text()
    with h5py.File(here / "out" / (f"{kind}_0.h5" if kind == "facade" else f"{kind}.h5")) as file:
        check(file.attrs["finished"] == 1, f"{kind}: unfinished")
        for name in file["histories"]:
            check(name == "time" or f"`{name}`" in readme, f"{kind}: the README has no history {name}")
    for quoted in re.findall(r"^\| `([^`.]+)", readme, re.M):
        check(quoted.strip(" .") in ran.stdout or quoted.startswith("error of"), f"{kind}: no '{quoted}' in {ran.stdout}")

unknown = run_program("new", "brige")
check(unknown.returncode == 1 and "did you mean 'bridge'?" in unknown.stderr, unknown.stderr)
print(f"{len(KINDS)} starting models run")
