#!/usr/bin/python3
"""usage: fuzz.py PROGRAM LIBRARY SECONDS FOLDER [SEED [PART...]]

Random inputs for all parts or for the named ones: texts, programs, scripts, results, restarts, words, console. LIBRARY
is the engine's archive. The readers of text are linked with it; they are compiled while the other parts run.
Findings are kept in FOLDER, each in its own folder with the command that repeats it; the exit code is then 1.
One seed gives the same inputs every time.
"""
import concurrent.futures
import os
import sys
import time

import console
import programs
import restarts
import results
import scripts
import shared
import texts
import words

# Parts and their shares of the run time.
SHARES = {"programs": 0.35, "scripts": 0.1, "results": 0.15, "restarts": 0.05, "words": 0.1, "console": 0.1, "texts": 0.15}


def main(program, library, seconds, out, seed="1", *wanted):
    program, out, seed = os.path.abspath(program), os.path.abspath(out), int(seed)
    end = time.monotonic() + float(seconds)
    shares = {part: share for part, share in SHARES.items() if part in wanted or not wanted}
    if not set(wanted) <= set(SHARES):
        sys.exit(f"parts are {', '.join(SHARES)}")
    if shared.SANITIZED:
        shares.pop("texts", None)  # their sanitizers are of another compiler
    os.makedirs(os.path.join(out, "build"), exist_ok=True)
    findings = shared.Findings(out)
    pool = concurrent.futures.ThreadPoolExecutor(1)
    readers = pool.submit(texts.build, os.path.abspath(library), os.path.join(out, "build")) if "texts" in shares else None
    made = programs.Programs(program, seed)
    if shares.keys() & {"programs", "console"}:
        print("{} of {} declared calls went well at least once".format(*made.learn(end, findings)), flush=True)
    runs = {"texts": lambda until: texts.fuzz(readers.result(), program, until, seed, out, findings),
            "programs": lambda until: programs.fuzz(made, until, findings),
            "scripts": lambda until: scripts.fuzz(program, until, seed, findings),
            "results": lambda until: results.fuzz(program, until, seed, findings),
            "restarts": lambda until: restarts.fuzz(program, until, seed, findings),
            "words": lambda until: words.fuzz(program, until, seed, findings),
            "console": lambda until: console.fuzz(program, until, seed, findings, made)}
    begun, total, passed = time.monotonic(), sum(shares.values()), 0
    for part, share in shares.items():
        passed += share
        print(f"{runs[part](begun + (end - begun) * passed / total)}, after {time.monotonic() - begun:.0f} s", flush=True)
    kinds = len(findings.known)
    print(f"seed {seed}: " + (f"{kinds} kinds of findings, in {out}" if kinds else "no finding"))
    return 1 if kinds else 0


if __name__ == "__main__":
    if len(sys.argv) < 5:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
