"""Damaged results files of several kinds, read by `repair` and by the other verbs."""
import glob
import os
import random
import subprocess
import tempfile

import damage
import shared
import words

HERE = os.path.dirname(os.path.abspath(__file__))
KINDS = ["all", "unfinished", "rigid", "wall", "diverged", "still"]


def make_bases(program, folder):
    """One small file of each kind, and the table of a study."""
    script = os.path.join(HERE, "bases.lua")
    with open(os.path.join(folder, "study.lua"), "w", encoding="utf8") as file:
        file.write('require "trilith".study { file = "study.h5", parameters = { a = { 1, 2 }, b = { "one", "two" } },\n'
                   '  case = function(c) return { x = { c.a, unit = "m" }, word = c.b } end }\n')
    for given in [[script, f"kind={kind}"] for kind in KINDS] + [["study.lua"]]:
        subprocess.run([program, "run", "-q", *given], cwd=folder, check=False, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)
    with open(os.path.join(folder, "study.lua"), "rb") as file:
        study = file.read()
    bases = sorted(glob.glob(os.path.join(folder, "*.h5")) + glob.glob(os.path.join(folder, "*.part")))
    if len(bases) < len(KINDS) + 1:
        raise SystemExit("the results files to damage are not all there: " + ", ".join(map(os.path.basename, bases)))
    return bases, study


def fuzz(program, until, seed, findings):
    path = os.path.abspath(program)
    verbs = [verb for verb in words.verbs_of(program) if verb.positionals[:1] == ["RESULT"]]
    repair = next(verb for verb in verbs if verb.name == "repair")
    with tempfile.TemporaryDirectory(prefix="fuzz") as folder:
        bases, study = make_bases(path, folder)

        def work(number):
            draw = random.Random(f"{seed} results {number}")
            base = draw.choice(bases)
            whole = os.path.join(folder, f"whole{number}.tmp")
            content = damage.damaged(f"{seed} damage {number}", base, whole)
            os.remove(whole)
            files = {"run.h5": content}
            if os.path.basename(base) == "study.h5":  # which a study goes on from, too
                files = {"study.h5": content, "study.lua": study}
                lines = ["study study.lua -j 1", "plot study.h5 --over a -o out.svg", "plot study.h5", "info study.h5"]
            else:
                with open(draw.choice(bases), "rb") as file:
                    files["other.h5"] = file.read()
                lines = [words.line(draw, repair, "run.h5", 0)]
                lines += [words.line(draw, draw.choice(verbs), "run.h5", 0.02) for _ in range(3)]
            for line in lines:
                shared.attempt(shared.Job("results", words.command(path, line), files), findings)
        return f"{len(shared.in_parallel(until, work))} damaged results files, each shown to repair and three more verbs"
