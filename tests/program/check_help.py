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


def ask(*words, **more):
    return subprocess.run([program, *words], capture_output=True, text=True, check=False, **more)


for words in (["manual", "trilith.frictional"], ["help", "trilith.frictional"], ["manual", "frictional"]):
    said = ask(*words)
    check(said.returncode == 0 and said.stdout.startswith("trilith.frictional{...}"), f"{words}: {said.stdout}")
    check("normal stiffness" in said.stdout and "example:" in said.stdout, said.stdout)
check(ask("help").stdout == ask("--help").stdout != "", "help is not --help")
check(ask("help", "draw").stdout == ask("draw", "--help").stdout != "", "help draw is not draw --help")
for words in (["help", "frictoinal"], ["manual", "trilith.frictoinal"]):
    said = ask(*words)
    check(said.returncode == 1 and "did you mean" in said.stderr and not said.stdout, f"{words}: {said.stderr}")

# The name of each entry of the reference, as the console takes it: none has an empty page.
names = set()
for page in ask("manual", "--pages").stdout.split():
    text = ask("manual", page, "--markdown").stdout
    names.update(re.findall(r"^### `([a-z][\w.:]*)[({]", text, re.M))
check(len(names) > 150, f"{len(names)} names")
lines = "".join(f'print "@{name}" help "{name}"\n' for name in sorted(names))
said = ask(input=lines)
pages = re.split(r"^@(.*)\n", said.stdout, flags=re.M)[1:]
check(len(pages) == 2 * len(names), f"{len(pages) // 2} pages of {len(names)}: {said.stderr}")
for name, text in zip(pages[::2], pages[1::2]):
    check(len(text.strip()) > 20 and name.split(":")[-1].split(".")[-1] in text, f"the page of {name} is '{text}'")
print(f"{len(names)} pages")
