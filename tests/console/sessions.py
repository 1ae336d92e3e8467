"""Runs the sessions of a file: every function whose name begins with `session_`, each in a folder of its own."""
import os
import shutil
import subprocess
import sys

from session import Failed, Session

FALL = """local trilith = require "trilith"
local m = trilith.model { name = "fall", still_time = 0.1 }
m:material { name = "stone", density = 2400 }
m:contact { between = { "stone", "stone" }, law = trilith.frictional { kn = 6e9, ks = 3e9, mu = 0.6, beta = 2e-4 } }
m:block { name = "base", width = 2, height = 0.2, at = { -1, -0.2 }, material = "stone", support = "fixed" }
local block = m:block { name = "block", width = 0.5, height = 0.3, at = { -0.25, 0.2 }, material = "stone",
                        groups = "upper", floating = true }
"""


class Place:
    """A folder for one session, with the files that it needs."""

    def __init__(self, program, folder):
        self.program, self.folder, self.sessions = program, folder, []
        shutil.rmtree(folder, ignore_errors=True)
        os.makedirs(folder)
        self.write("fall.lua", FALL)
        self.write("run.lua", FALL + "local report = m:run { duration = 1 }\nprint('the script goes on', report.ending)\n")
        self.write("long.lua", FALL + "m:run { duration = 1e4 }\nprint 'the script goes on'\n")

    def write(self, name, text):
        with open(os.path.join(self.folder, name), "w") as f:
            f.write(text)

    def has(self, name):
        return os.path.exists(os.path.join(self.folder, name))

    def console(self, *words, **options):
        s = Session(self.program, *words, folder=self.folder, **options)
        self.sessions.append(s)
        s.expect(r"^> $" if words[:1] != ("-i",) or options.pop("at_top", True) else ".")
        return s

    def start(self, *words, **options):
        s = Session(self.program, *words, folder=self.folder, **options)
        self.sessions.append(s)
        return s

    def pipe(self, text, *words):
        """Code, output, errors of a session whose input is a pipe."""
        run = subprocess.run([self.program, *words], input=text, capture_output=True, text=True, cwd=self.folder,
                             timeout=60, env=dict(os.environ, HOME=self.folder))
        return run.returncode, run.stdout, run.stderr


def check(condition, what):
    if not condition:
        raise Failed(what)


def run_all(functions):
    program, folder = sys.argv[1], sys.argv[2]
    only = sys.argv[3:]
    failed = count = 0
    for name, function in functions.items():
        if not name.startswith("session_") or (only and name not in only):
            continue
        count += 1
        place = Place(program, os.path.join(folder, name))
        try:
            function(place)
        except Failed as failure:
            failed += 1
            print(f"{name}: {failure}\n")
        finally:
            for s in place.sessions:
                s.close()
    print(f"{count} sessions, {failed} failed")
    sys.exit(1 if failed or not count else 0)
