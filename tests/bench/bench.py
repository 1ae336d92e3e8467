#!/usr/bin/python3
"""Runs the cases of the benchmarks and prints the cost of a step of each, by part; docs/benchmarks.md explains the output.

bench.py PROGRAM [--against OTHER] [--cases REGEX] [--long] [--threads N[,N...]] [--times N] [--instructions] [--parts]

One line for each case and number of threads: the median of `--times` runs, its spread, and the speed-up by
several threads. With --against, runs of both programs alternate, and the ratio of each two is printed with its spread:
below 1 PROGRAM is faster. The load by other processes meanwhile is printed too; such figures are less reliable.
"""
import argparse
import os
import re
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

UNIT = {"s": 1.0, "ms": 1e-3, "µs": 1e-6, "ns": 1e-9}
WALL, PILE, SPACE = "tests/bench/wall.lua", "tests/bench/pile.lua", "tests/bench/wall3d.lua"
SPACE_PILE, TOWER, SPHERES = "tests/bench/pile3d.lua", "tests/bench/tower3d.lua", "tests/bench/spheres3d.lua"


class Case:
    """A script and its parameters. `before`: parameters of a shorter run, which is subtracted if only the later part
    counts. `motion`: duration of the model's motion, where steps differ in length [s]. `whole`: duration of the run
    of which this is a part [s]. `prints_figures`: its figures are the lines that it prints."""

    def __init__(self, name, script, words, long=False, before=None, brief="", motion=None, prints_figures=False, whole=None):
        self.name, self.script, self.words, self.long, self.before = name, script, words, long, before
        self.motion, self.prints_figures, self.whole = motion, prints_figures, whole
        self.brief = brief or words  # for counting instructions


def wall(units, courses, columns, body, seconds, long=False):
    size = f"courses={courses} columns={columns} body={body}"
    return Case(f"wall of {units}, {body}", WALL, f"{size} seconds={seconds}", long, brief=f"{size} seconds=0.02")


def bridge_of_beams(integrator):
    """The strong part of the shaking, in which bearings and piers yield and decks pound."""
    words = f"integrator={integrator} out=out/bench_frames.h5 duration="
    return Case(f"bridge of beams, {integrator}", "scripts/bridge_frames.lua", words + "5", before=words + "1", motion=4,
                brief=words + "0.1")


CHUTE = "count=20000 least=0.0045 most=0.006 settle=0.1 out=out/bench_chute.h5 "

CASES = [
    wall(444, 24, 18, "rigid", 1.0), wall(444, 24, 18, "quad", 0.4), wall(444, 24, 18, "mesh", 0.1),
    wall(1752, 48, 36, "rigid", 0.5), wall(1752, 48, 36, "quad", 0.2), wall(1752, 48, 36, "mesh", 0.05),
    wall(28000, 192, 145, "rigid", 0.05, True), wall(28000, 192, 145, "quad", 0.03, True),
    wall(28000, 192, 145, "mesh", 0.01, True),
    Case("wall of 444, mesh, masses scaled", WALL, "body=mesh scaled=7.5e-5 safety=0.8 seconds=0.25", motion=0.3,
         brief="body=mesh scaled=7.5e-5 safety=0.8 seconds=0.02"),
    Case("pile of 5000 boxes", PILE, "seconds=1.5"),
    Case("pile of 5000 boxes, safety 0.8", PILE, "safety=0.8 seconds=1.5"),
    Case("pile of 50000 boxes", PILE, "boxes=50000 across=316 seconds=1.5", True),
    Case("bridge of the gallery", "scripts/bridge.lua", "out=out/bench_bridge", True),
    Case("gallery wall, first shaking", "scripts/wall.lua", "duration=1 out=out/bench_wall.h5"),
    Case("gallery wall, meshed", "scripts/wall.lua", "body=mesh duration=0.1 out=out/bench_wall.h5"),
    Case("gallery wall after its collapse", "scripts/wall.lua", "duration=9 out=out/bench_wall.h5", True,
         before="duration=8 out=out/bench_wall.h5"),
    Case("wall of 444 in space", SPACE, "courses=24 seconds=0.1"),
    Case("wall of 1752 in space", SPACE, "courses=48 columns=36 seconds=0.05"),
    Case("pile of 5000 boxes in space", SPACE_PILE, "seconds=1.5", True, brief="boxes=300 across=6 seconds=0.3"),
    Case("pile of 50000 boxes in space", SPACE_PILE, "boxes=50000 across=58 seconds=1.5", True,
         brief="boxes=300 across=6 seconds=0.3"),
    Case("chute of 20000 grains", "scripts/chute.lua", CHUTE + "flow=0.1", True, before=CHUTE + "flow=0.02",
         motion=0.08,
         brief="count=200 settle=0.1 flow=0.1 out=out/bench_chute.h5"),
    Case("tower of 11520 blocks, shaken", TOWER, "seconds=0.15", True, before="seconds=0.05", motion=0.1, whole=15,
         brief="courses=12 side=3 seconds=0.1"),
    Case("50000 spheres settle", SPHERES, "seconds=0.4", True, before="seconds=0.2", motion=0.2,
         brief="spheres=2000 across=12 seconds=0.1"),
    bridge_of_beams("explicit"), bridge_of_beams("implicit"),
    Case("frame of 2000 beams, implicit", "tests/bench/frame.lua", "steps=40", before="steps=20"),
    Case("gallery wall set down by statics", "tests/bench/statics.lua", "", prints_figures=True),
]


class Cost:
    """Cost of a run: steps, seconds by part, peak memory [kB]; touching pairs at its end and bodies, if the script
    prints them."""

    def __init__(self, text="", peak=0):
        self.steps, self.seconds, self.parts, self.pairs, self.hash = 0, 0.0, {}, None, None
        self.peak, self.bodies = peak, None
        if head := re.search(r"^profile of (\d+) steps in ([\d.]+) (\S+),", text, re.M):
            self.steps, self.seconds = int(head[1]), float(head[2]) * UNIT[head[3]]
        for part, number, unit in re.findall(r"^  (\S.*?) +[\d.]+ % +([\d.]+) (s|ms|µs|ns) ", text, re.M):
            self.parts[part] = self.parts.get(part, 0) + float(number) * UNIT[unit]
        if pairs := re.search(r"(\d+) contacts", text):
            self.pairs = int(pairs[1])
        if bodies := re.search(r"(\d+) (?:bodies|boxes|grains)", text):
            self.bodies = int(bodies[1])
        if digest := re.search(r"hash ([0-9a-f]+)", text):
            self.hash = digest[1]

    def less(self, other):
        self.steps -= other.steps
        self.seconds -= other.seconds
        for part, seconds in other.parts.items():
            self.parts[part] = self.parts.get(part, 0) - seconds
        return self

    def step(self):
        return self.seconds / max(1, self.steps)


def busy():
    """Processor time of the machine since its start, all processors together [s]."""
    with open("/proc/stat", encoding="ascii") as f:
        numbers = [int(n) for n in f.readline().split()[1:]]
    return (sum(numbers) - numbers[3] - numbers[4]) / os.sysconf("SC_CLK_TCK")


def own():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def order(program, case, words, threads):
    return [program, "run", case.script, *words.split(), "--profile", "--threads", str(threads)]


def watched(command):
    """A finished run: its exit code, its output, and the most memory that it held [kB]."""
    with tempfile.TemporaryFile("w+") as output_file:
        child = subprocess.Popen(command, stdout=output_file, stderr=subprocess.STDOUT)
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        output_file.seek(0)
        return child.returncode, output_file.read(), usage.ru_maxrss


def run(program, case, threads):
    """One run, and the share of the machine that other processes used during it."""
    begun, worked, ours = time.monotonic(), busy(), own()
    costs = []
    for words in filter(None, (case.words, case.before)):
        command = order(program, case, words, threads)
        code, text, peak = watched(command)
        costs.append(Cost(text, peak))
        if code != 0 or costs[-1].steps == 0:
            sys.exit(f"bench: {' '.join(command)} ended with {code}:\n{text}")
    others = max(0.0, busy() - worked - (own() - ours)) / (time.monotonic() - begun) / os.cpu_count()
    return (costs[0].less(costs[1]) if case.before else costs[0]), others


def run_calmly(program, case, threads, calm, tries=5):
    """As run(), repeated while other processes use more than `calm` of the machine."""
    found = min((run(program, case, threads) for _ in range(1)), key=lambda r: r[1])
    while found[1] > calm and tries > 1:
        time.sleep(2)
        found, tries = min(found, run(program, case, threads), key=lambda r: r[1]), tries - 1
    return found


def print_lines(program, case):
    done = subprocess.run([program, "run", case.script, *case.words.split(), "--quiet"], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"bench: {' '.join(done.args)} ended with {done.returncode}:\n{done.stdout}{done.stderr}")
    print(case.name)
    for line in done.stdout.splitlines():
        print(f"    {line}", flush=True)


def spread(values):
    return f"{statistics.median(values):.3g} ({min(values):.3g} to {max(values):.3g})"


def print_cost(case, threads, runs, alone):
    costs = [cost for cost, _ in runs]
    steps = [1e6 * cost.step() for cost in costs]
    line = f"{case.name:32} {threads} thread{'s' if threads > 1 else ' '} {spread(steps)} us a step"
    if costs[0].pairs:
        line += f", {1e3 * statistics.median(steps) / costs[0].pairs:.1f} ns a touching pair ({costs[0].pairs})"
    if alone and threads > 1:
        line += f", {statistics.median(alone) / statistics.median(steps):.2f} times as fast as one"
    if case.motion:
        seconds = statistics.median(cost.seconds for cost in costs)
        line += f", {costs[0].steps} steps, {seconds / case.motion:.3g} s for a second of motion"
        if case.whole:
            line += f", {seconds / case.motion * case.whole / 3600:.2g} h for {case.whole} s"
    if costs[0].bodies:
        line += f", {max(cost.peak for cost in costs) / costs[0].bodies:.1f} kB a body at most ({costs[0].bodies})"
    others = max(share for _, share in runs)
    print(line + (f"; others took {100 * others:.0f} % of the machine" if others > 0.05 else ""), flush=True)
    return steps


def print_parts(costs):
    cost = sorted(costs, key=Cost.step)[len(costs) // 2]
    for part, seconds in sorted(cost.parts.items(), key=lambda p: -p[1]):
        if seconds > 0.005 * cost.seconds:
            per_pair = f"{1e9 * seconds / cost.steps / cost.pairs:8.2f} ns a pair" if cost.pairs else ""
            print(f"    {part:32} {100 * seconds / cost.seconds:5.1f} % {1e6 * seconds / cost.steps:10.2f} us {per_pair}")


def counted(program, case, words):
    """Instructions of a whole run, by perf where the machine counts them, otherwise by callgrind; and its steps."""
    what = order(program, case, words, 1)
    if shutil.which("perf"):
        done = subprocess.run(["perf", "stat", "-x", ",", "-e", "instructions:u", *what], capture_output=True, text=True,
                              check=False)
        if found := re.search(r"^(\d+),[^\n]*instructions", done.stderr, re.M):
            return int(found[1]), Cost(done.stdout + done.stderr).steps
    if shutil.which("valgrind"):
        done = subprocess.run(["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", *what],
                              capture_output=True, text=True, check=False)
        if found := re.search(r"Collected : (\d+)", done.stderr):
            return int(found[1]), Cost(done.stdout + done.stderr).steps
    return None, 0


# The searches that keep fast and thin bodies from passing through each other: before a step, and after it.
SWEEPS = ("trilith::tunnelling_limit(*", "trilith::report_deep_penetration(*")


def counted_in(program, case, words, functions):
    """Instructions of a whole run within these functions and all that they call, by callgrind; None without it."""
    if not shutil.which("valgrind"):
        return None
    inside = [f"--toggle-collect={name}" for name in functions]
    done = subprocess.run(["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", *inside,
                           *order(program, case, words, 1)], capture_output=True, text=True, check=False)
    found = re.search(r"Collected : (\d+)", done.stderr)
    return int(found[1]) if found else None


def print_sweep(program, case, few, many, longer):
    """Share of the instructions between two runs that the searches against tunnelling take."""
    brief, whole = (counted_in(program, case, words, SWEEPS) for words in (case.brief, longer))
    if brief is not None and whole is not None:
        print(f"    search against tunnelling: {100 * (whole - brief) / (many - few):.1f} % of them")


def print_instructions(program, case):
    """Instructions of a step: the difference to a run of twice the length, divided by the additional steps. Then the
    share of the searches against tunnelling in them."""
    longer = re.sub(r"(seconds|duration)=([\d.]+)", lambda m: f"{m[1]}={2 * float(m[2]):g}", case.brief)
    (few, steps), (many, more) = counted(program, case, case.brief), counted(program, case, longer)
    if few is None or many is None or more <= steps:
        return print("    instructions: neither perf nor valgrind counts them here")
    print(f"    {(many - few) / (more - steps) / 1e3:.1f} thousand instructions a step")
    return print_sweep(program, case, few, many, longer)


def compare(program, other, case, threads, args):
    ratios = []
    for _ in range(args.times):
        ours, _ = run_calmly(program, case, threads, args.calm)
        theirs, _ = run_calmly(other, case, threads, args.calm)
        ratios.append(ours.step() / theirs.step())
    same = "the same bits" if ours.hash == theirs.hash and ours.hash else "other bits" if ours.hash else ""
    print(f"{case.name:32} {threads} thread{'s' if threads > 1 else ' '} ratio {spread(ratios)}  {same}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--against", metavar="PROGRAM", help="another one, run in turn with it")
    parser.add_argument("--cases", default="", metavar="REGEX", help="only those whose name this finds")
    parser.add_argument("--long", action="store_true", help="those that take minutes too")
    parser.add_argument("--threads", default="1,2", metavar="N,...")
    parser.add_argument("--times", type=int, default=3, metavar="N", help="runs of each")
    parser.add_argument("--calm", type=float, default=1, metavar="SHARE",
                        help="a run is made again, up to five times, where others took more of the machine")
    parser.add_argument("--instructions", action="store_true", help="count them too")
    parser.add_argument("--parts", action="store_true", help="what each part of a step takes")
    args = parser.parse_args()
    os.makedirs("out", exist_ok=True)
    counts = [int(n) for n in args.threads.split(",")]
    for case in CASES:
        if not re.search(args.cases, case.name) or (case.long and not args.long):
            continue
        if case.prints_figures:
            print_lines(args.program, case)
            continue
        if args.against:
            for threads in counts:
                compare(args.program, args.against, case, threads, args)
            continue
        # In turn, so that a change of the machine affects all alike.
        runs = {threads: [] for threads in counts}
        for _ in range(args.times):
            for threads in counts:
                runs[threads].append(run_calmly(args.program, case, threads, args.calm))
        hashes = {cost.hash for all_of in runs.values() for cost, _ in all_of}
        if len(hashes) > 1:
            sys.exit(f"bench: {case.name}: the bits depend on the threads: {hashes}")
        alone = None
        for threads in counts:
            steps = print_cost(case, threads, runs[threads], alone)
            alone = steps if threads == 1 else alone
            if args.parts:
                print_parts([cost for cost, _ in runs[threads]])
        if args.instructions:
            print_instructions(args.program, case)


if __name__ == "__main__":
    main()
