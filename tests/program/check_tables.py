#!/usr/bin/python3
"""The tables of `trilith export --to csv` and `--to xlsx`, and the Python module trilith_results, against the results file.
usage: check_tables.py PROGRAM FOLDER_OF_THE_MODULE FOLDER"""
import csv
import re
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path
from xml.etree import ElementTree

import h5py
import numpy as np

program, module, folder = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve(), Path(sys.argv[3])
sys.path.insert(0, str(module))
sys.dont_write_bytecode = True
import trilith_results as tr  # noqa: E402  pylint: disable=wrong-import-position

shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)

MODEL = """
local trilith = require "trilith"
local p = trilith.params { height = { 0.2, unit = "m", "of the fall, \\"free\\", in metres" } }
local m = trilith.model { name = "falling" DIM }
m:material { name = "stone", density = 2400 }
m:contact { between = { "stone", "stone" }, law = trilith.frictional { kn = 6e8, ks = 3e8, mu = 0.6, beta = 2e-4 } }
m:block { name = "base", BASE, material = "stone", support = "fixed" }
m:block { name = "block", BLOCK, material = "stone", floating = true }
m:results { file = "NAME.h5", frames = 0.05, histories = 0.01, energy = 0.05 }
m:history { name = "uy, of \\"block\\"", body = "block", what = "UP" }
m:run { duration = 0.6 }
"""

PLANE = {"BASE": "width = 2, height = 0.2, at = { -1, -0.2 }", "UP": "uy",
         "BLOCK": "width = 0.5, height = 0.3, at = { -0.25, p.height }"}


def check(holds, text):
    if not holds:
        sys.exit(f"wrong: {text}")


def run_program(*words):
    return subprocess.run([str(program), *words], cwd=folder, capture_output=True, text=True, check=False)


def rows_of(path):
    with open(folder / path, newline="", encoding="utf8") as file:
        return list(csv.reader(file))


def sheets_of(path):
    """Rows of each sheet of a workbook, by its name: texts and numbers; an empty cell is ""."""
    sheets = {}
    with zipfile.ZipFile(folder / path) as book:
        check(book.testzip() is None, f"{path} is damaged")
        names = [e.get("name") for e in ElementTree.fromstring(book.read("xl/workbook.xml")).iter() if e.tag.endswith("}sheet")]
        for number, name in enumerate(names, 1):
            rows = []
            for row in ElementTree.fromstring(book.read(f"xl/worksheets/sheet{number}.xml")).iter():
                if not row.tag.endswith("}row"):
                    continue
                cells = {}
                for cell in row:
                    column = 0
                    for letter in re.match("[A-Z]+", cell.get("r"))[0]:
                        column = 26 * column + ord(letter) - 64
                    text = "".join(cell.itertext())
                    cells[column - 1] = text if cell.get("t") else float(text)
                rows.append([cells.get(k, "") for k in range(max(cells) + 1)] if cells else [])
            sheets[name] = rows
    return sheets


def agrees(cell, text):
    """Workbooks have sixteen significant digits, tables as text have all of them."""
    if isinstance(cell, float):
        return abs(cell - float(text)) <= 1e-15 * abs(cell)
    return cell == text


def check_workbook(name, tables, *at):
    """A sheet for each table has the cells of the csv file."""
    made = run_program("export", f"{name}.h5", "--to", "xlsx", *at)
    check(made.returncode == 0 and made.stdout == f"{name}.xlsx\n", made.stderr)
    sheets = sheets_of(f"{name}.xlsx")
    check(list(sheets) == tables, sheets.keys())
    for table, sheet in sheets.items():
        expected = rows_of(f"{name}_csv/{table}.csv")
        check(len(sheet) == len(expected), f"{table}: {len(sheet)} rows for {len(expected)}")
        for own, row in zip(sheet, expected):
            own += [""] * (len(row) - len(own))
            check(len(own) == len(row) and all(map(agrees, own, row)), (table, own, row))
    check(isinstance(sheets["histories"][1][0], float) and isinstance(sheets["bodies"][1][1], str), "cells have the wrong type")


def script(name, **parts):
    text = MODEL
    for key, value in {"NAME": name, "DIM": "", **PLANE, **parts}.items():
        text = text.replace(key, value)
    (folder / f"{name}.lua").write_text(text)


script("plane")
script("space", DIM=", dim = 3", BASE="size = { 2, 1, 0.2 }, at = { -1, -0.5, -0.2 }", UP="uz",
       BLOCK="size = { 0.5, 0.5, 0.3 }, at = { -0.25, -0.25, p.height }")
for name in ("plane", "space"):
    check(run_program("run", f"{name}.lua", "--quiet").returncode == 0, f"{name} does not run")

# Before it touches, the block has fallen by g t^2/2.
fallen = -9.80665 * 0.1**2 / 2  # an explicit fall is ahead of it by g t dt/2
for name, axes in (("plane", "xy"), ("space", "xyz")):
    result = run_program("export", f"{name}.h5", "--to", "csv", "--at", "0,0.1,end")
    check(result.returncode == 0, result.stderr)
    tables = ["histories", "energy", "events", "stages", "bodies", "bearings", "members", "modes", "notes",
              "parameters"]
    check(result.stdout.splitlines() == [f"{name}_csv/{t}.csv" for t in tables], result.stdout)
    check_workbook(name, tables, "--at", "0,0.1,end")
    file = h5py.File(folder / f"{name}.h5")
    histories = rows_of(f"{name}_csv/histories.csv")
    check(histories[0] == ["time [s]", 'uy, of "block" [m]'], histories[0])
    check([float(r[0]) for r in histories[1:]] == list(file["histories/time"]), "times differ")
    check([float(r[1]) for r in histories[1:]] == list(file['histories/uy, of "block"']), "numbers are not exact")
    energy = rows_of(f"{name}_csv/energy.csv")
    check(energy[0][-1] == "residual [J]" and len(energy) == 1 + len(file["energy/time"]), energy[0])
    events = rows_of(f"{name}_csv/events.csv")
    check([r[4] for r in events[1:]] == [t.decode() for t in file["events"]["type"]], "events differ")
    bodies = rows_of(f"{name}_csv/bodies.csv")
    check(len(bodies) == 1 + 3 * 2 and [r[1] for r in bodies[1:3]] == ["base", "block"], bodies)
    at = dict(zip(bodies[0], bodies[4]))
    vertical = axes[-1]
    check(at["body"] == "block" and at["time [s]"] == "0.1", at)
    check(abs(float(at[f"u{vertical} [m]"]) - fallen) < 2e-4, at)
    check(abs(float(at[f"{vertical} [m]"]) - (0.35 + fallen)) < 2e-4, at)
    check(abs(float(at["mass [kg]"]) - 2400 * 0.15 * (0.5 if name == "space" else 1)) < 1e-9, at)
    check(rows_of(f"{name}_csv/parameters.csv")[1][4] == 'of the fall, "free", in metres', "quotes are lost")

    run = tr.open(folder / f"{name}.h5")
    check(run.finished and run.verdict == "" and run.dim == len(axes) and run.title == "falling", repr(run))
    check(list(run.histories.columns) == ['uy, of "block"'] and run.histories.attrs["units"]["time"] == "s", "columns")
    check(np.array_equal(run.histories['uy, of "block"'], file['histories/uy, of "block"']), "histories differ")
    check(list(run.events.type) == [r[4] for r in events[1:]] and run.stages.name[0] == "run", "tables differ")
    now = run.bodies_at(0.1).loc["block"]
    check(abs(now["u" + vertical] - fallen) < 2e-4 and abs(run.bodies_at(0.1).attrs["time"] - 0.1) < 1e-3, now)
    corners = run.vertices(0.1)["block"]
    check(abs(corners[:, -1].min() - (0.2 + fallen)) < 2e-4 and abs(corners[:, -1].max() - (0.5 + fallen)) < 2e-4, corners)
    contacts = run.contacts_at()
    force = contacts[["fx", "fy", "fz"][:run.dim]].sum()
    check(set(contacts.body_a) | set(contacts.body_b) <= {"base", "block"}, contacts)
    check(run.parameters.loc["height", "value"] == "0.2" and "trilith.model" in run.script, "the script is lost")
    check("<table" in run._repr_html_() and "falling" in run._repr_html_(), "no page in a notebook")
    run.close()

one = run_program("export", "plane.h5", "--to", "csv", "--table", "stages")
check(one.stdout.splitlines()[0] == "name,kind,begin [s],end [s],why" and one.returncode == 0, one.stdout)
check(run_program("export", "plane.h5", "--to", "csv", "--table", "events", "-o", "e.csv").stdout == "e.csv\n", "one file")
for words, part in ((["--at", "9"], "outside the frames"), (["--frames", "0:1"], "csv takes moments")):
    result = run_program("export", "plane.h5", "--to", "csv", *words)
    check(result.returncode == 1 and part in result.stderr, result.stderr)
(folder / "blocked.xlsx").mkdir()
for words, part in ((["-o", "a.xls"], "must end in .xlsx"), (["--frames", "0:1"], "xlsx takes moments"),
                    (["-o", "blocked.xlsx"], "'blocked.xlsx' cannot be written")):
    result = run_program("export", "plane.h5", "--to", "xlsx", *words)
    check(result.returncode == 1 and part in result.stderr, result.stderr)
check(not list(folder.glob("*.part")), "an unfinished workbook remains")
one = run_program("export", "plane.h5", "--to", "xlsx", "--table", "energy", "-o", "energy.xlsx")
check(one.returncode == 0 and list(sheets_of("energy.xlsx")) == ["energy"], one.stderr)

# From Python: parameters in, run, results out.
import os  # noqa: E402  pylint: disable=wrong-import-position,wrong-import-order
os.chdir(folder)
high = tr.run("plane.lua", program=str(program), height="0.4 m")
check(high.parameters.loc["height", "value"] != "0.2", high.parameters)
# An explicit fall is ahead of the exact one by g t dt/2, with steps dt of at most 0.5 ms.
check(abs(high.bodies_at(0.2).loc["block"].uy + 9.80665 * 0.2**2 / 2) < 9.80665 * 0.2 * 5e-4 / 2, high.bodies_at(0.2))
try:
    tr.run("plane.lua", program=str(program), heigth=1)
    check(False, "a wrong parameter was taken")
except tr.TrilithError as error:
    check("heigth" in str(error), error)
for path in (program, folder / "nowhere.h5"):
    try:
        tr.open(path)
        check(False, f"{path} was opened")
    except (tr.TrilithError, FileNotFoundError):
        pass
try:
    import matplotlib
    matplotlib.use("Agg")
except ImportError:
    print("skipped: there is no matplotlib; the tables are right")
    sys.exit(0)
ax = tr.open("plane.h5").plot()
check(ax.get_xlabel() == "time [s]" and "[m]" in ax.get_ylabel(), ax.get_ylabel())
ax = tr.open("plane.h5").draw(0.1)
check("t = 0.10 s" in ax.get_title() and len(ax.collections[0].get_paths()) == 2, ax.get_title())
print("tables have the numbers of the file")
