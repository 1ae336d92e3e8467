#!/usr/bin/python3
"""usage: self_test.py PROGRAM: what counts as a finding, how one is kept, and that no declared call is left out."""
import os
import random
import sys
import tempfile

import programs
import scripts
import shared
import words


def outcome(command):
    with tempfile.TemporaryDirectory() as folder:
        return shared.judge(*shared.run(shared.Job("test", command, {}), folder))


def check(holds, what):
    if not holds:
        sys.exit(f"does not hold: {what}")


def check_judgements():
    for code in (0, 1, 2, 3, 130):
        check(outcome(f"sh -c 'echo refused; exit {code}'") is None, f"code {code} is no finding")
    check(outcome("sh -c 'exit 7'") == "ended with code 7", "a code that is not documented")
    check(outcome("sh -c 'kill -SEGV $$'") == "ended by SIGSEGV", "a signal")
    for said in ("std::bad_alloc", "map::at", "x: trilith/show.lua:3: attempt", "runtime error: overflow"):
        check(outcome(f"echo '{said}'").startswith("says: "), f"'{said}' is from within")
    for name, inner in (("console", True), ("ft", False)):
        said = outcome(f'echo "x.lua:3: attempt to call a number value (upvalue \'{name}\')"')
        check((said is not None) == inner, f"the variable '{name}' is {'' if inner else 'not '}one of the library")
    check(outcome("printf 'stack traceback:\\n\\ttrilith/show.lua:3: in f\\n'") is None, "a line of a traceback is none")
    shared.SECONDS = 0.3
    burn = "import time\nwhile time.process_time() < 0.5: pass"
    check("processor" in (outcome(f"/usr/bin/python3 -c '{burn}'") or ""), "a loop")
    shared.WALL = 1
    check("did not end" in (outcome("sleep 600") or ""), "a wait without an end")


def check_kept():
    with tempfile.TemporaryDirectory() as folder:
        findings = shared.Findings(folder)
        for number in (1, 2):
            findings.add(shared.Job("part", f"cat input {number}", {"input": "content"}), f"took {number} s", "said")
        check(sorted(os.listdir(folder)) == ["part-1"], "one of each kind is kept")
        check(sorted(os.listdir(os.path.join(folder, "part-1"))) == ["finding.txt", "input"], "with what repeats it")


def check_cover(program):
    made = programs.Programs(program, 1)
    check(made.text(3) == programs.Programs(program, 1).text(3), "a seed gives the same programs")
    text = "".join(made.text(number) for number in range(400))
    missed = [call.name for call in made.calls if call.name.split(":")[-1] not in text]
    check(len(made.calls) > 90 and not missed, f"every declared call is in the programs; missed: {missed}")
    verbs = words.verbs_of(program)
    check({"run", "repair", "study", "draw"} <= {verb.name for verb in verbs}, "the verbs are those of the help")
    draw = next(verb for verb in verbs if verb.name == "draw")
    check(draw.positionals == ["RESULT"] and ("--units", "TEXT") in [option[:2] for option in draw.options],
          f"options are those of the help: {draw.positionals}, {draw.options}")
    check(scripts.changed(random.Random(1), "a = 1 + 2") != "a = 1 + 2", "a script is changed")


check_judgements()
check_kept()
check_cover(os.path.abspath(sys.argv[1]))
