"""Random command lines: verbs and options from the program's help, and closed standard streams."""
import os
import random
import re
import subprocess

import declared
import shared

ODD = ["", "-", "--", "nan", "-1", "0", "1e309", "1e308", "99999999999999999999", "0x10", "x", "a=b", "=", "a=", "=1", ",", ",,",
       "1,2,", "..", "1..", "1..0", "*", "'\\''", "%s", "\\x1b[2J", "\u00e4\u20ac", "x" * 5000, "/dev/null", "/", ".", "/dev/full",
       "missing/out.svg", "out", "run.h5", "end", "start", "seat.lost", "1,1,1,1", "0,0,1e308,1", "nan,0,1,1", "-3,0,5,4"]
VALUES = {"NUMBER": ["1", "2", "3"], "N": ["1", "2"], "T": ["0", "end", "start", "0,0.02,end"], "FACTOR": ["1", "1e3"],
          "FILE": ["out.svg", "out.pdf", "out.png", "out.h5", "out.html"], "RESULT": ["run.h5", "other.h5"], "DIR": [".", "folder"],
          "NAME": ["run", "top"], "UNITS": ["si", "us", "kN m", "N mm"], "GROUP": ["pile"], "HISTORY": ["top", "energy", "x", "y"], "SPEED": ["0.5"],
          "SIZE": ["512MB", "1 GiB", "0", "-1", "1 m"], "SECONDS": ["0.5", "100", "0", "-1"], "PGA": ["0.3"],
          "PARAMETER": ["a", "b"], "X0": ["-1,-1,1,1"], "NAME=VALUE": ["a=1", "a=0.5 m", "b=two", "c=3"],
          "NAME=VALUES": ["a=1,2", "a=1..3", "a=0.1..0.5:3", "b=one,two", "zeta=0.1..0.5", "a=1..1000000000", "a=nan", "a=1..2:1e9",
                          "a=1..2:0", "a=-1e308..1e308:3", "a=,", "=1", "a=1..2:-1", "a=2..1", "copy=1..2"]}
FILES = {"RESULT": ["run.h5", "other.h5", "study.h5", "case.lua", "missing.h5", "."], "FILE": ["record.csv", "run.h5", "nothing"],
         "SCRIPT": ["case.lua", "study.lua", "case.lua", "missing.lua", ".", "run.h5"]}
STREAMS = ["", "", "", "", ">&-", ">&-", "2>&-", "<&-", ">&- 2>&-", "<&- >&- 2>&-", ">/dev/full", "2>/dev/full", "<&- >&-",
           "</dev/zero >/dev/null"]
CASE = """\
local trilith = require "trilith"
local p = trilith.params { a = { 1, unit = "m", "a length" }, b = { "one", choices = { "one", "two" }, "a word" } }
local m = trilith.model { name = "case" }
m:material { name = "stone", density = 2400 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e8, ks = 5e7, mu = 0.5, beta = 1e-3 } }
m:block { name = "base", width = 6, height = 0.5, at = { -3, -0.5 }, material = "stone", support = "fixed" }
local low = m:block { name = "low", width = 1, height = 0.5, at = { -0.5, 0.1 }, material = "stone", groups = "pile",
  floating = true }
m:history { name = "top", body = low, what = "y" }
m:results { file = "run.h5", frames = 0.01 }
m:on_step(function() if m.steps > 300 then m:stop() end end)
m:run { duration = 0.05 }
return { x = { p.a, unit = "m" }, y = low.y, word = p.b }
"""
RECORD = "# title: made up\n# units: g\n# dt: 0.02 s\n# npts: 4\n0.00,0.0\n0.02,0.1\n0.04,-0.1\n0.06,0.0\n"
# Arguments of trilith.study, by key.
STUDY = {"file": ['"study.h5"'], "script": ['"case.lua"', '"missing.lua"', '"study.lua"'],
         "case": ["function(c) return { x = c.a or 1 } end", "function() return {} end", "function() error {} end",
                  "function(c) return { x = 0/0, y = 'a', [1] = 2 } end", "function() return { x = { 1, unit = 'm' } } end",
                  "function() return { x = print } end", "function() os.exit(3) end", "function() return 1, 2 end"],
         "parameters": ["{ a = { 1, 2 } }", "{ a = { 1, 2, unit = 'm' }, b = { 'one', 'two' } }", "{ a = {} }", "{ a = 1 }",
                        "{ [1] = { 1 } }", "{ a = { 0/0 } }", "{ a = { {} } }", "{ ['a b'] = { 1, 1 } }", "{}"],
         "cases": ["{ { a = 1 }, { a = 2 } }", "{ { a = 1 }, { b = 'two' } }", "{ {}, {} }", "{ 1 }", "{}"],
         "samples": ["{ a = { mean = 1, deviation = 0.1 } }", "{ a = { from = 1, to = 2 } }", "{ a = { 1, 2 } }", "{ a = 1 }"],
         "count": ["3", "0", "-1", "2^31", "1.5"], "seed": ["1", "-1", "2^63"], "jobs": ["1", "2", "0", "2^31"],
         "histories": ["{ top = 'last' }", "{ ['top'] = { 'max', 'min' } }", "{ 'top' }", "{ zz = 'last' }", "{ top = 'x' }"]}


class Verb:
    """A verb with its options (flag, type of its value or "") and positionals, from its help."""

    def __init__(self, program, name):
        output = subprocess.run([program, name, "--help"], capture_output=True, text=True, check=True).stdout
        self.name = name
        self.options = [(m[1], m[2].split(":")[0].split(",")[0].split("=")[0] if "NAME=" not in m[2] else m[2],
                         re.search(r"\{(.*)\}", m[2]))
                        for m in re.finditer(r"^  (?:-\w,)?(--?[\w-]+)(?:,-\w)? ?(\S*)", output, re.M)]
        self.positionals = re.findall(r"^  [a-z]+ (\S+)(?: REQUIRED)?(?: \.\.\.)? ", output.split("Options:")[0], re.M)


def verbs_of(program):
    output = subprocess.run([program, "--help"], capture_output=True, text=True, check=True).stdout
    return [Verb(program, name) for name in re.findall(r"^  ([a-z]+) {2,}", output.split("Subcommands:")[1], re.M)]


def command(program, words):
    """The shell command of a line; `live`, which serves a page until it is interrupted, is interrupted after 2 s."""
    interrupted = "timeout --preserve-status -s INT 2 " if quoted("live") in words else ""
    return f"{interrupted}{program} {words}"


def quoted(word):
    return "'" + word.replace("'", "'\\''") + "'"


def line(draw, verb, file=None, odd=0.15):
    """The words of a command; `file` is the first positional."""
    words = [verb.name]
    for place, wanted in enumerate(verb.positionals):
        if place == 0 and file:
            words.append(file)
        elif place == 0 or draw.random() < 0.4:
            words.append(draw.choice(ODD if draw.random() < odd else FILES.get(wanted) or VALUES.get(wanted, ODD)))
    for flag, takes, choices in draw.sample(verb.options, min(len(verb.options), draw.choice([0, 1, 1, 2, 3, 5]))):
        if flag == "--help" and draw.random() < 0.9:
            continue
        sane = VALUES.get(takes, ["1", "2"])
        if choices or "|" in takes:
            sane = choices[1].split(",") if choices else takes.split("|")
        words.append(flag)
        if takes or draw.random() < 0.02:
            words.append(draw.choice(ODD if draw.random() < odd else sane))
    if verb.name == "verify" and "--list" not in words:
        words.append("--list")  # the cases themselves take minutes
    if verb.name == "repair" and "--output" not in words:
        words += ["--output", "copy.h5"]
    if draw.random() < odd / 2:
        words.insert(draw.randrange(len(words) + 1), draw.choice(ODD))
    return " ".join(quoted(word) for word in words)


def study_text(draw, keys):
    """A script of a study, from the keys that are declared."""
    given = {"file": '"study.h5"'}
    for name, *_ in keys:
        if name in ("case", "parameters") or draw.random() < 0.25:
            given[name] = draw.choice(STUDY.get(name, declared.WILD))
    if draw.random() < 0.4:
        given[draw.choice([row[0] for row in keys])] = draw.choice(declared.WILD)
    if draw.random() < 0.7:
        given.pop(draw.choice(["case", "script", "parameters"]), None)
    body = ", ".join(f"{name} = {text}" for name, text in given.items() if "a.m" not in text and "b." not in text)
    return ('local trilith = require "trilith"\nlocal a, b = { model = 1 }, {}\nlocal fuzz = {}\n'
            f"local given = trilith.study {{ {body} }}\nfor _, row in ipairs(given.rows) do print(row.status, row.x) end\n")


def fuzz(program, until, seed, findings):
    verbs = verbs_of(program)
    keys = next(call.keys for call in declared.declarations(program)[0] if call.name == declared.STUDY)
    path = os.path.abspath(program)
    scripted = [verb for verb in verbs if verb.name in ("run", "study")]

    def work(number):
        draw = random.Random(f"{seed} words {number}")
        files = {"case.lua": CASE, "record.csv": RECORD, "study.lua": study_text(draw, keys)}
        verb = draw.choice(scripted) if draw.random() < 0.6 else draw.choice(verbs)
        # The results of a run are read, even if it failed.
        first = line(draw, verb, draw.choice([None, "study.lua", "case.lua"]) if verb in scripted else None)
        shell_line = f"{command(path, first)} {draw.choice(STREAMS)}"
        if verb.name == "run" and draw.random() < 0.5:
            shell_line = f"{path} run case.lua {draw.choice(STREAMS)} && {path} info run.h5"
        elif "RESULT" in verb.positionals and draw.random() < 0.8:
            shell_line = f"{path} run -q case.lua && {command(path, line(draw, verb, None))} {draw.choice(STREAMS)}"
        shared.attempt(shared.Job("words", shell_line, files), findings)
    return f"{len(shared.in_parallel(until, work))} command lines"
