#!/usr/bin/python3
"""trilith help and trilith manual print the page of each command, function and field.
usage: check_help.py PROGRAM"""
import re
import subprocess
import sys

program = sys.argv[1]


def check(holds, text):
    if not holds:
        sys.exit(f"wrong: {text}")


def run_program(*words, **more):
    return subprocess.run([program, *words], capture_output=True, text=True, check=False, **more)


for words in (["manual", "trilith.frictional"], ["help", "trilith.frictional"], ["manual", "frictional"]):
    result = run_program(*words)
    check(result.returncode == 0 and result.stdout.startswith("trilith.frictional{...}"), f"{words}: {result.stdout}")
    check("normal stiffness" in result.stdout and "example:" in result.stdout, result.stdout)
check(run_program("help").stdout == run_program("--help").stdout != "", "help is not --help")
check(run_program("help", "draw").stdout == run_program("draw", "--help").stdout != "", "help draw is not draw --help")
for words in (["help", "frictoinal"], ["manual", "trilith.frictoinal"]):
    result = run_program(*words)
    check(result.returncode == 1 and "did you mean" in result.stderr and not result.stdout, f"{words}: {result.stderr}")

# The name of each entry of the reference, as the console takes it: none has an empty page.
names = set()
for page in run_program("manual", "--pages").stdout.split():
    text = run_program("manual", page, "--markdown").stdout
    names.update(re.findall(r"^### `([a-z][\w.:]*)[({]", text, re.M))
check(len(names) > 150, f"{len(names)} names")
lines = "".join(f'print "@{name}" help "{name}"\n' for name in sorted(names))
result = run_program(input=lines)
pages = re.split(r"^@(.*)\n", result.stdout, flags=re.M)[1:]
check(len(pages) == 2 * len(names), f"{len(pages) // 2} pages of {len(names)}: {result.stderr}")
for name, text in zip(pages[::2], pages[1::2]):
    check(len(text.strip()) > 20 and name.split(":")[-1].split(".")[-1] in text, f"the page of {name} is '{text}'")
print(f"{len(names)} pages")
