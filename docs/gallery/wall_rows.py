#!/usr/bin/env python3
"""Rows of the wall's tables, from results of scripts/wall.lua: share of bonds lost and of joints apart by storey over time,
times at which bonds were lost, and dissipated energies.

usage: docs/gallery/wall_rows.py RESULT..."""
import sys

import h5py
import numpy as np

APART = 0.0127  # half an inch [m]
TIMES = (0.5, 1, 1.5, 2, 3, 4, 6, 10, 20, 30)  # s into the shake


def storeys(h):
    """Shares by storey at each time: (time, [lost 1, 2, 3], [apart 1, 2, 3])."""
    joints, frames = h["model/joints"][:], h["frames"]
    time, begin = frames["time"][:], h["stages"][-1]["begin"]
    bonded = joints["bonded"] > 0
    for t in TIMES:
        if begin + t > time[-1] + 0.05:
            return
        k = int(np.argmin(abs(time - begin - t)))
        lost, far = frames["joint_damage"][k], np.maximum(frames["joint_opening"][k], abs(frames["joint_slip"][k]))
        rows = [joints["storey"] == s for s in (1, 2, 3)]
        yield t, [lost[r & bonded].mean() for r in rows], [(far[r] > APART).mean() for r in rows]


def failures(h):
    """First, a tenth, half and nine tenths of all bonds lost [s into the shake]."""
    begin = h["stages"][-1]["begin"]
    times = sorted(e["time"] - begin for e in h["events"][:] if e["type"] == b"bond.broken" and e["time"] >= begin)
    return [times[int(q * (len(times) - 1))] for q in (0, 0.1, 0.5, 0.9)] if times else []


def ledger(h):
    energy = h["energy"]
    last = {name: float(energy[name][-1]) for name in energy}
    terms = [(v, n) for n, v in last.items() if n not in ("time", "residual", "support", "load", "gravity")]
    return ", ".join(f"{n} {v / 1e3:.2f}" for v, n in sorted(terms, reverse=True) if v >= 5)


def main():
    for path in sys.argv[1:]:
        with h5py.File(path) as h:
            print(f"{path}: first, 10 %, half, 90 % of the lost bonds at "
                  + ", ".join(f"{t:.2f}" for t in failures(h)) + f" s; [kJ] {ledger(h)}")
            for t, lost, apart in storeys(h):
                print(f"| {t:g} | " + " | ".join(f"{100 * v:.0f} %" for v in lost + apart) + " |")


if __name__ == "__main__":
    main()
