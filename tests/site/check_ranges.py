#!/usr/bin/env python3
"""Each key of the reference whose unit does not depend on the size of a structure has a plausible range ("usually ..."), or a
reason not to have one.
usage: check_ranges.py SOURCE"""
import re
import sys
from pathlib import Path

# Quantities of these units grow with the structure or the run: their size alone says nothing about the unit that was meant.
# Bodies are checked by their least side and their density, sections by their area.
OF_SIZE = {"m", "m2", "m4", "1/m", "N", "N m", "N/m", "N s/m", "N m/rad", "kg", "kg m2", "s", "Hz", "1/s", "m/s", "rad", "rad/s",
           "or list m"}

# Further keys without a range, with the reason.
EXCEPTIONS = {
    ("hardening", "Pa"): "any value from 0 to the modulus is usual",
    ("stress", "Pa"): "a load",
    ("unit_modulus", "Pa"): "checked against the measured modulus of the wall",
    ("unit_weight", "N/m3"): "the density that follows from it is checked",
    ("gravity", "m/s2"): "other values are given on purpose, such as those of a centrifuge",
    ("ag", "m/s2"): "a weak site has the value that a strong site has in g",
    ("pga", "m/s2"): "motion:scale has a note of its own for values in g",
    ("sa", "m/s2"): "small at long periods",
    ("conductance", "W/(m2 K)"): "joints differ by more than a factor of 1000",
    ("conductivity", "W/(m K)"): "materials differ by more than a factor of 1000",
    ("exchange", "W/(m2 K)"): "still air and water differ by more than a factor of 1000",
    ("expansion", "1/K"): "materials differ by more than a factor of 1000",
    ("heat_capacity", "J/(kg K)"): "m:heat has no notes",
    ("bond", "N/m2"): "m:bolt has no notes",
    ("bond_strength", "Pa"): "m:bolt has no notes",
    ("dowel", "N/m2"): "m:bolt has no notes",
    ("bulk_modulus", "Pa"): "m:seepage has no notes",
    ("stiffness", "Pa/m"): "m:seepage has no notes",
    ("viscosity", "Pa s"): "m:seepage has no notes",
    ("reference", "degC"): "any temperature is usual",
    ("temperature", "degC"): "any temperature is usual",
}

# Keys of size that laws declare, with values that a wrong unit puts beyond all structures.
NEEDED = {("sagging", "N m"), ("hogging", "N m"), ("across", "N m"), ("tension", "N"), ("compression", "N"), ("strength", "N"),
          ("yield", "N"), ("reference_load", "N"), ("speed", "m/s"), ("rate", "s/m"), ("softening", "rad"), ("wear", "rad"),
          ("capping", "rad"), ("dilation_slip", "m"), ("radius", "m"), ("kn", "Pa/m"), ("E", "Pa")}


def declared(source):
    """{(key, unit): ranges}"""
    found = {}
    for page in sorted(Path(source, "docs/reference").glob("*.md")):
        head = []
        for line in page.read_text(encoding="utf8").splitlines():
            cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
            if line.startswith("| key |"):
                head = cells
            row = re.match(r"\| `(\w+)` \|", line)
            if not row or "unit" not in head or "range" not in head or len(cells) != len(head):
                continue
            fields = dict(zip(head, cells))
            if fields["type"] in ("number", "integer") and fields["unit"] not in ("", "1"):
                found.setdefault((row[1], fields["unit"]), []).append(fields["range"])
    return found


def main(source):
    keys, wrong = declared(source), []
    ranged = {key for key, ranges in keys.items() if any("usually" in each for each in ranges)}
    if len(keys) < 150:
        wrong.append(f"only {len(keys)} keys with a unit are read from the reference")
    for key in sorted(keys):
        if key not in ranged and key[1] not in OF_SIZE and key not in EXCEPTIONS:
            wrong.append(f"{key[0]} [{key[1]}] has no plausible range: give it one in engine/model/plausible_ranges.cpp, or a reason here")
    wrong += [f"{key[0]} [{key[1]}] has lost its plausible range" for key in sorted(NEEDED - ranged)]
    wrong += [f"{key[0]} [{key[1]}] is an exception without need" for key in sorted(EXCEPTIONS) if key in ranged or key not in keys]
    print("".join(line + "\n" for line in wrong), end="")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
