#!/usr/bin/env python3
"""The landing page: docs/README.md lists every page of the tour and every guide, links exist, and the first minutes of README.md run.

usage: check_index.py SOURCE
"""
import glob
import os
import re
import subprocess
import sys
import tempfile


def dead_links(page):
    with open(page, encoding="utf8") as f:
        targets = re.findall(r"\]\(([^)\s]+)\)", f.read())
    here = os.path.dirname(page)
    local = [t.split("#")[0] for t in targets if not re.match(r"\w+:", t)]
    return [t for t in local if t and not os.path.exists(os.path.join(here, t))]


def first_minutes_errors(source):
    """At most five commands; the command that changes a number changes one line of its script."""
    with open(os.path.join(source, "README.md"), encoding="utf8") as f:
        found = re.search(r"^## The first five minutes\n.*?^```sh\n(.*?)^```$", f.read(), re.M | re.S)
    if not found:
        return ["README.md has no first five minutes"]
    commands = [line for line in found[1].splitlines() if line and not line.startswith("#")]
    errors = [] if len(commands) <= 5 else ["README.md: more than five commands in the first five minutes"]
    edits = [c for c in commands if c.startswith("sed ")]
    if len(edits) != 1:
        return errors + ["README.md: the first five minutes change not one number"]
    script = re.search(r"scripts/\S+\.lua", edits[0])[0]
    with open(os.path.join(source, script), encoding="utf8") as f:
        before = f.read()
    with tempfile.TemporaryDirectory() as folder:
        os.mkdir(os.path.join(folder, "scripts"))
        copy = os.path.join(folder, script)
        with open(copy, "w", encoding="utf8") as f:
            f.write(before)
        subprocess.run(edits[0], shell=True, cwd=folder, check=True)
        with open(copy, encoding="utf8") as f:
            after = f.read()
    changed = sum(a != b for a, b in zip(before.splitlines(), after.splitlines()))
    return errors + ([] if changed == 1 else [f"README.md: '{edits[0]}' changes {changed} lines, not one"])


def main(source):
    tour, guides = (sorted(glob.glob(os.path.join(source, "docs", part, "*.md"))) for part in ("tour", "guide"))
    pages = [os.path.join(source, "README.md"), os.path.join(source, "docs/README.md")] + tour + guides
    errors = [f"{os.path.relpath(p, source)}: leads to {t}, which is not there" for p in pages for t in dead_links(p)]
    with open(pages[1], encoding="utf8") as f:
        index = f.read()
    errors += [f"docs/README.md does not name {os.path.basename(p)}" for p in tour + guides if os.path.basename(p) not in index]
    tour_text = "".join(open(p, encoding="utf8").read() for p in tour)
    scripts = sorted(os.path.basename(s) for s in glob.glob(os.path.join(source, "scripts/tour/*.lua")))
    errors += [f"no page of the tour runs scripts/tour/{s}" for s in scripts if f"scripts/tour/{s}" not in tour_text]
    errors += first_minutes_errors(source)
    print("".join(line + "\n" for line in errors), end="")
    return 1 if errors or not tour else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
