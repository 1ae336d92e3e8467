#!/usr/bin/python3
"""usage: self_test.py PROGRAM: kinds of findings, their storage, and a check that no declared call is left out."""
import os
import random
import sys
import tempfile

import declared
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
        check(outcome(f"sh -c 'echo refused; exit {code}'") is None, f"code {code} is not a finding")
    check(outcome("sh -c 'exit 7'") == "ended with code 7", "a code that is not documented")
    check(outcome("sh -c 'kill -SEGV $$'") == "ended by SIGSEGV", "a signal")
    for output in ("std::bad_alloc", "map::at", "x: trilith/show.lua:3: attempt", "runtime error: overflow"):
        check(outcome(f"echo '{output}'").startswith("prints: "), f"'{output}' is from within")
    for name, inner in (("console", True), ("ft", False)):
        output = outcome(f'echo "x.lua:3: attempt to call a number value (upvalue \'{name}\')"')
        check((output is not None) == inner, f"the variable '{name}' is {'' if inner else 'not '}one of the library")
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
            findings.add(shared.Job("part", f"cat input {number}", {"input": "content"}), f"took {number} s", "output")
        check(sorted(os.listdir(folder)) == ["part-1"], "one of each kind is kept")
        check(sorted(os.listdir(os.path.join(folder, "part-1"))) == ["finding.txt", "input"], "with what repeats it")


def check_cover(program):
    made = programs.Programs(program, 1)
    check(made.text(3) == programs.Programs(program, 1).text(3), "a seed gives the same programs")
    text = "".join(made.text(number) for number in range(400))
    rows = [row for call in made.calls for row in call.keys + call.arguments]
    strange = {row[1] for row in rows if not any(kind in declared.SANE for kind in declared.kinds_of(row[1]))}
    check(not strange, f"every declared kind has sound values; none have {sorted(strange)}")
    check({call.name.split(":")[0] for call in made.calls if ":" in call.name} <= set(programs.SUBJECTS),
          "every kind of subject has a handle")
    check_space(made)
    missed = [call.name for call in made.calls if call.name.split(":")[-1] not in text]
    check(len(made.calls) > 90 and not missed, f"every declared call is in the programs; missed: {missed}")
    verbs = words.verbs_of(program)
    check({"run", "repair", "study", "draw"} <= {verb.name for verb in verbs}, "the verbs are those of the help")
    draw = next(verb for verb in verbs if verb.name == "draw")
    check(draw.positionals == ["RESULT"] and ("--units", "UNITS") in [option[:2] for option in draw.options],
          f"options are those of the help: {draw.positionals}, {draw.options}")
    check(scripts.changed(random.Random(1), "a = 1 + 2") != "a = 1 + 2", "a script is changed")


def check_space(made):
    """Programs in space have models and calls of their own, and valid calls succeed."""
    check("dim = 3" not in made.head(2, 2) and 'fuzz.make("a", 3)' in made.head(3, 3), "there are models in space")
    dims = [made.dimensions(number) for number in range(24)]
    check({2, 3} == {dim for dim, _ in dims} and any(a != b for a, b in dims), "programs are of the plane, of space, and mixed")
    check(any(call.name.startswith("space:") for call in made.calls_in(3)), "calls of space are among them")
    check(not any(call.name.startswith("space:") for call in made.calls_in(2)), "and not among those of the plane")
    lines = ["a.model:run { duration = 0.01 }"]
    wanted = {"space:block": 'name = "n", size = { 1, 1, 1 }, at = { 2, 2, 3 }, material = "stone", floating = true',
              "space:sphere": 'name = "o", radius = 0.1, at = { 2, -2, 0.1 }, material = "stone", floating = true'}
    for name, keys in wanted.items():
        check(any(call.name == name for call in made.calls), f"{name} is declared")
        lines.append(f"a.model:{name.split(':')[1]} {{ {keys} }}")
    for dim, some in ((2, lines[:1]), (3, lines)):
        text = "".join(f"try({i}, function() return {line} end)\n" for i, line in enumerate(some))
        job = made.job(text, dim=dim, other=5 - dim)
        with tempfile.TemporaryDirectory() as folder:
            job.lay_out(folder)
            output = shared.run(job, folder)[2]
        good = sum(f"good {i}" in output for i in range(len(some)))
        check(good == len(some), f"sound calls of a model of {dim} dimensions go well: {output}")


check_judgements()
check_kept()
check_cover(os.path.abspath(sys.argv[1]))
