#!/usr/bin/env python3
"""Rows of the bridge's table of variants. Runs scripts/bridge.lua with the parameters of each line of bridge_variants.txt
and prints failed bearings, lost seats, the time of rest and the residual. Times are seconds from the start of the record.

usage: docs/gallery/bridge_rows.py PROGRAM [LINE...]   LINE: 'gap=1 mu=0.1'; without lines, all lines of the file."""
import pathlib
import subprocess
import sys
import tempfile

import h5py

LEAD_IN = 1.02  # time from the start of the shake to the record's own [s]
HERE = pathlib.Path(__file__).parent
WORDS = {b"bearing.failed": "fails", b"seat.lost": "unseats"}


def row(line, results, output):
    with h5py.File(results) as h:
        shake = h["stages"][-1]
        start = shake["begin"] + LEAD_IN
        chain = [(e["time"] - start, e["bearing_name"].decode() or e["text"].decode().split("(")[1].split(")")[0],
                  WORDS[e["type"]]) for e in h["events"][:] if e["type"] in WORDS]
    chain_text = "; ".join(f"{name} {word} {t:.1f}" for t, name, word in chain) or "no bearing fails, no seat is lost"
    residual = output.split("error of the energy balance is ")[1].split(" of ")[0]
    rest = f"{shake['end'] - start:.1f}" if shake["ended"] and b"rest" in shake["why"] else "not at rest"
    return f"| {line} | {chain_text} | {rest} | {residual} |"


def main():
    program, lines = sys.argv[1], sys.argv[2:] or (HERE / "bridge_variants.txt").read_text().splitlines()
    for line in lines:
        with tempfile.TemporaryDirectory() as folder:
            results = f"{folder}/bridge.h5"
            parameters = [] if line == "defaults" else line.split()
            done = subprocess.run([program, "run", HERE.parent.parent / "scripts/bridge.lua", *parameters,
                                   f"out={results}"], check=True, capture_output=True, text=True)
            print(row(line, results, done.stdout + done.stderr), flush=True)


if __name__ == "__main__":
    main()
