#!/usr/bin/env python3
"""Runs the commands of a page of docs/tour and compares their output and pictures with the page.

usage: check_page.py PROGRAM SOURCE WORK PAGE [--keep]

The page's ```sh blocks are run line by line in the folder WORK, where `trilith` is PROGRAM and scripts/ is the folder of SOURCE. Every
line of its ```text blocks must be printed, in this order. Its ```lua block must be the script that the commands name. Each
picture is drawn again into WORK and must have the lines of the picture in SOURCE. --keep copies the new pictures to SOURCE.
"""
import os
import re
import shutil
import subprocess
import sys

MOST_LINES = 40        # of a script
MOST_BYTES = 150_000   # of a picture
FAR = 3.0              # by which a point of a picture may be off [points]


def blocks(text, kind):
    return re.findall(rf"^```{kind}\n(.*?)^```$", text, re.M | re.S)


def path_numbers(svg):
    """The numbers of all lines that are drawn; glyphs are defined apart and depend on the fonts of the machine."""
    drawn = re.sub(r"<defs>.*?</defs>", "", svg, flags=re.S)
    return [[float(x) for x in re.findall(r"-?\d+\.?\d*", d)] for d in re.findall(r'<path[^>]* d="([^"]*)"', drawn)]


def picture_error(made, kept):
    if not os.path.exists(made):
        return "was not made"
    if os.path.getsize(made) > MOST_BYTES:
        return f"has {os.path.getsize(made)} bytes, more than {MOST_BYTES}"
    if not os.path.exists(kept):
        return "is not in the repository"
    new, old = (path_numbers(open(name, encoding="utf8").read()) for name in (made, kept))
    if not new or [len(p) for p in new] != [len(p) for p in old]:
        return f"has other lines than the one in the repository: {len(new)} against {len(old)}"
    off = max((abs(a - b) for p, q in zip(new, old) for a, b in zip(p, q)), default=0)
    return f"is off by {off:.1f} points" if off > FAR else None


def run(command, work, program):
    env = dict(os.environ, PATH=os.path.dirname(program) + os.pathsep + os.environ["PATH"])
    done = subprocess.run(command, shell=True, cwd=work, env=env, text=True, capture_output=True)
    print(f"$ {command}\n{done.stdout}{done.stderr}", end="")
    return done.returncode, done.stdout + done.stderr


def main(program, source, work, page, keep=False):
    errors = []
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(os.path.join(work, "docs/tour"))
    os.symlink(os.path.join(source, "scripts"), os.path.join(work, "scripts"))
    with open(os.path.join(source, "docs/tour", page), encoding="utf8") as f:
        text = f.read()
    commands = [line for block in blocks(text, "sh") for line in block.splitlines() if line and not line.startswith("#")]
    os.makedirs(os.path.join(work, "out"))

    printed = ""
    for command in commands:
        code, output = run(command, work, os.path.abspath(program))
        printed += output
        if code:
            errors.append(f"'{command}' ended with code {code}")
    lines = iter(printed.splitlines())
    for expected in [line for block in blocks(text, "text") for line in block.splitlines()]:
        if expected not in lines:
            errors.append(f"not printed, or not in its place: {expected}")
            break

    names = sorted(set(re.findall(r"scripts/tour/\S+\.lua", "\n".join(commands))))
    scripts = [open(os.path.join(source, name), encoding="utf8").read() for name in names]
    if blocks(text, "lua") != scripts:
        errors.append(f"the Lua on the page is not {' '.join(names) or 'any script of the tour'}")
    errors += [f"a script has more than {MOST_LINES} lines" for s in scripts if s.count("\n") > MOST_LINES]

    pictures = re.findall(r"-o (docs/tour/\S+\.svg)", "\n".join(commands))
    if not pictures or [os.path.basename(p) for p in pictures] != re.findall(r"!\[[^]]+\]\((\S+)\)", text):
        errors.append("the pictures that the commands make are not those that the page shows")
    for picture in pictures:
        made, kept = os.path.join(work, picture), os.path.join(source, picture)
        if keep:
            shutil.copyfile(made, kept)
        what = picture_error(made, kept)
        if what:
            errors.append(f"{picture} {what}")
    if not blocks(text, "text"):
        errors.append("the page says no number to expect")
    print("".join(f"{page}: {line}\n" for line in errors), end="")
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:5], keep="--keep" in sys.argv[5:]))
