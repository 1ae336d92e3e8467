#!/usr/bin/python3
"""usage: fuzz.py PROGRAM LIBRARY SECONDS FOLDER [SEED]

Text under libFuzzer, random Lua programs and damaged results files, each for a third of the time. LIBRARY is the
engine's archive, for what the readers of text stand on. Findings are kept in FOLDER, each with what was seen; code 1
where there are any. One seed gives the same programs and files every time.
"""
import concurrent.futures
import os
import random
import shutil
import subprocess
import sys
import tempfile
import time

import damage
import programs
import shared

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
# Compiled with sanitizers; the rest comes from the library.
SOURCES = ["tests/fuzz/readers.cpp", "engine/base/error.cpp", "engine/base/nearest.cpp", "engine/base/units.cpp",
           "engine/build/gmsh.cpp", "engine/load/motion.cpp", "engine/load/motion_check.cpp",
           "engine/load/motion_csv.cpp", "engine/load/motion_peer.cpp", "engine/load/motion_read.cpp",
           "engine/load/motion_samples.cpp", "engine/load/text_lines.cpp", "engine/run/study_figures.cpp",
           "engine/shape/mesh.cpp"]
MESH = """$MeshFormat
4.1 0 8
$EndMeshFormat
$Nodes
1 4 1 4
2 1 0 4
1
2
3
4
0 0 0
1 0 0
1 1 0
0 1 0
$EndNodes
$Elements
2 3 1 3
2 1 3 1
1 1 2 3 4
2 1 2 2
2 1 2 3
3 1 3 4
$EndElements
"""
RECORD = """# title: made up
# units: g
# dt: 0.02 s
# npts: 4
0.00,0.0
0.02,0.1
0.04,-0.1
0.06,0.0
"""
PEER = "PEER\nmade up\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 4, DT= .0200 SEC\n 0.0 .1E-00 -.1 0\n"
TEXTS = {"record": [RECORD, PEER], "mesh": [MESH], "quantity": ["m/s2,0.6g", "m,3 ft", "s,1e-3", "1,0.4"],
         "unit": ["kip/ft", "N s/m", "m/s2", "kg m^2"], "figures": ["drift\tm\tnumber\t0.5\nend\t\ttext\trest\n"]}


def build(library, folder):
    """The readers as one program; only what has changed is compiled."""
    flags = ["-std=c++20", "-O1", "-g1", "-DFMT_SHARED", "-DNDEBUG", "-ffp-contract=off", "-fno-math-errno",
             "-fsanitize=fuzzer,address,undefined", "-fno-sanitize-recover=undefined", "-Iengine"]
    flags += subprocess.run(["pkg-config", "--cflags", "eigen3", "hdf5-serial"], capture_output=True, text=True,
                            check=True).stdout.replace("-I/", "-isystem/").split()
    libraries = ["hdf5-serial", "cairo", "zlib", "fmt"]
    link = subprocess.run(["pkg-config", "--libs", *libraries], capture_output=True, text=True, check=True)
    compiler = (["ccache"] if shutil.which("ccache") else []) + ["clang++"]
    objects = [os.path.join(folder, source.replace("/", "_") + ".o") for source in SOURCES]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        done = list(pool.map(lambda pair: subprocess.run([*compiler, *flags, "-c", pair[0], "-o", pair[1]], cwd=ROOT,
                                                         check=False).returncode, zip(SOURCES, objects)))
    program = os.path.join(folder, "readers")
    linking = ["clang++", "-fsanitize=fuzzer,address,undefined", *objects, library, *link.stdout.split(), "-o", program]
    if any(done) or subprocess.run(linking, check=False).returncode:
        sys.exit("the readers do not compile")
    return program


def fuzz_texts(program, seconds, seed, out, findings):
    total, each = 0, max(1, int(seconds / len(TEXTS)))
    for reader, texts in TEXTS.items():
        corpus = os.path.join(out, "corpus", reader)
        os.makedirs(corpus, exist_ok=True)
        for number, text in enumerate(texts):
            with open(os.path.join(corpus, f"seed{number}"), "w", encoding="utf8") as file:
                file.write(text)
        command = [program, corpus, f"-max_total_time={each}", f"-seed={seed}", "-timeout=10", "-rss_limit_mb=2048",
                   "-max_len=2000", "-print_final_stats=1", "-verbosity=0", f"-artifact_prefix={out}/{reader}-"]
        done = subprocess.run(command, env={**os.environ, "TRILITH_READER": reader}, capture_output=True, text=True,
                              errors="replace", check=False)
        count = [int(line.split()[-1]) for line in done.stderr.splitlines() if "number_of_executed_units" in line]
        total += count[0] if count else 0
        if done.returncode != 0:
            made = [line.split()[-1] for line in done.stderr.splitlines() if "Test unit written to" in line]
            path = made[0] if made else os.path.join(corpus, "seed0")
            told = next((line for line in done.stderr.splitlines() if "ERROR" in line or "runtime error" in line),
                        "ended badly")
            findings.add("text-" + reader, told, path, command, done.stderr[-4000:])
    return total


def in_parallel(seconds, one):
    """one(number) for 0, 1, ... until the time is over; how many were done."""
    until, count = time.monotonic() + seconds, 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        running = set()
        while time.monotonic() < until or running:
            while time.monotonic() < until and len(running) < os.cpu_count():
                running.add(pool.submit(one, count))
                count += 1
            done, running = concurrent.futures.wait(running, return_when=concurrent.futures.FIRST_COMPLETED)
            for future in done:
                future.result()
    return count


def fuzz_programs(program, seconds, seed, out, findings):
    known = programs.declarations(program)

    def one(number):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "model.lua")
            programs.write(path, seed * 1000003 + number, known)
            command = programs.command_of(program, path, random.Random(number))
            what, text = shared.trouble(command, folder)
            if what:
                findings.add("program", what, path, command, text)
    return in_parallel(seconds, one)


def make_results(program, folder):
    """A finished file and one that was left unfinished."""
    script = os.path.join(folder, "base.lua")
    with open(script, "w", encoding="utf8") as file:
        file.write(programs.HEAD + 'local p = trilith.params { left = { false, "left unfinished" } }\n'
                   'a.model:results { file = "base.h5", frames = 0.01, velocities = true }\n'
                   "a.model:run { duration = 0.1 }\n"
                   "if p.left then os.exit(1) end\n")
    subprocess.run([program, "run", "-q", script], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    os.rename(os.path.join(folder, "base.h5"), os.path.join(folder, "finished.h5"))
    subprocess.run([program, "run", "-q", script, "left=true"], cwd=folder, check=False, stdout=subprocess.DEVNULL,
                   stderr=subprocess.DEVNULL)
    return [os.path.join(folder, "finished.h5"), os.path.join(folder, "base.h5.part")]


def fuzz_results(program, seconds, seed, out, findings):
    with tempfile.TemporaryDirectory() as bases:
        files = make_results(program, bases)

        def one(number):
            with tempfile.TemporaryDirectory() as folder:
                path = os.path.join(folder, "run.h5")
                damage.damage(seed * 1000003 + number, files[number % 3 == 0], path)
                for verb in damage.verbs(number):
                    command = damage.command_of(program, verb, path)
                    what, text = shared.trouble(command, folder)
                    if what:
                        findings.add("results-" + verb[0], what, path, command, text)
        return in_parallel(seconds, one)


def main(program, library, seconds, out, seed="1"):
    program, out, seconds, seed = os.path.abspath(program), os.path.abspath(out), float(seconds), int(seed)
    os.makedirs(os.path.join(out, "build"), exist_ok=True)
    findings = shared.Findings(out)
    readers = build(os.path.abspath(library), os.path.join(out, "build"))
    for what, go, subject in (("texts read", fuzz_texts, readers), ("Lua programs run", fuzz_programs, program),
                              ("damaged results files shown to repair and three more verbs each", fuzz_results, program)):
        begun = time.monotonic()
        count = go(subject, seconds / 3, seed, out, findings)
        print(f"{count} {what} in {time.monotonic() - begun:.0f} s", flush=True)
    kinds = len(findings.known)
    print(f"seed {seed}: " + (f"{kinds} kinds of findings, in {out}" if kinds else "no finding"))
    return 1 if kinds else 0


if __name__ == "__main__":
    if not 5 <= len(sys.argv) <= 6:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
