"""Seeded faults: `./dev mutants` builds a copy of the sources in which each fault of faults.txt can be switched on by
TRILITH_FAULT=NUMBER, and runs the tests of its module against each fault. A fault that no test notices survives.

usage: mutants.py FOLDER [--build-only] [--run-only] [--module NAME,...] [--only NUMBER,...] [--jobs N]
"""
import argparse
import concurrent.futures
import os
import re
import subprocess
import sys
import time
from pathlib import Path

import faults

SWITCH = """// Written by tests/mutants/mutants.py: true if the environment variable TRILITH_FAULT has this number.
#pragma once
#include <cstdlib>
inline const int trilith_active_fault = [] {
  const char* const number = std::getenv("TRILITH_FAULT");
  return number == nullptr ? 0 : std::atoi(number);
}();
inline bool trilith_fault(int number) { return trilith_active_fault == number; }
"""
# A build for minutes: little optimisation, one copy of each kernel, no warnings.
FLAGS = '-w -include {} -DTRILITH_ONE_WIDTH "-Dtarget_clones(...)=unused"'
SLACK, LEAST_LIMIT = 5, 60  # a test that takes this many times as long as without a fault, and this many seconds, hangs


def write_if_changed(path, content):
    if path.is_file() and path.read_bytes() == content:
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content)


def copy_sources(listed, source):
    """The files of the repository with all faults, each switched off."""
    by_file = {}
    for fault in listed.faults:
        by_file.setdefault(fault.file, []).append(fault)
    names = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=faults.ROOT,
                           check=True, capture_output=True, text=True).stdout.split("\0")
    names = [name for name in names if name and (faults.ROOT / name).is_file()]
    for name in names:
        content = (faults.ROOT / name).read_bytes()
        if name in by_file:
            text = content.decode()
            for fault in by_file[name]:
                text = text.replace(fault.text, fault.switched())
            content = text.encode()
        write_if_changed(source / name, content)
        (source / name).chmod((faults.ROOT / name).stat().st_mode)
    known = set(names)
    for path in [p for p in source.rglob("*") if p.is_file() and str(p.relative_to(source)) not in known]:
        path.unlink()  # of an earlier state


def build(listed, folder):
    source, switch = folder / "source", folder / "trilith_fault.hpp"
    copy_sources(listed, source)
    write_if_changed(switch, SWITCH.encode())
    subprocess.run(["cmake", "-S", str(source), "-B", str(folder / "build"), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                    "-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_CXX_FLAGS=" + FLAGS.format(switch),
                    "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG"], check=True, stdout=subprocess.DEVNULL)
    subprocess.run([os.environ.get("NINJA", "ninja"), "-C", str(folder / "build"), "-j", os.environ.get("JOBS", str(os.cpu_count())),
                    "trilith_tests", "trilith_program"], check=True)


def doctest_failure(text):
    """Name of the case that failed first."""
    name = ""
    for line in text.splitlines():
        if line.startswith("TEST CASE:"):
            name = line[10:].strip()
        elif "ERROR:" in line and name:
            return name
    return name or text.strip().splitlines()[-1] if text.strip() else "it ended at once"


class Command:
    """One test of a module: the command to run, and the name of the failed case."""

    def __init__(self, folder, kind, words):
        tests = folder / "build" / "tests"
        self.kind, self.limit = kind, None
        if kind == "doctest":
            patterns = ",".join(f"*/tests/{word}*" for word in words)
            self.command = [str(tests / "trilith_tests"), f"-sf={patterns}", "-tse=long", "-aa=1", "-nc=true"]
            self.folder, self.name = folder / "build", "doctest"
        elif kind == "lua":
            self.command = [str(folder / "build/lua/trilith"), "run", words[0], "--quiet", "--trust"]
            self.folder, self.name = folder / "source/tests/lua", "lua " + words[0]
        else:
            self.command = ["ctest", "--test-dir", str(folder / "build"), "-R", words[0], "--no-tests=error", "--output-on-failure"]
            self.folder, self.name = folder, "ctest " + words[0].strip("^").replace(".", " ")

    def run(self, fault):
        """'' if it passes, otherwise the test that noticed the fault; and the seconds."""
        environment = {**os.environ, "TRILITH_FAULT": str(fault)}
        began = time.monotonic()
        try:
            done = subprocess.run(self.command, cwd=self.folder, env=environment, capture_output=True, text=True, errors="replace",
                                  timeout=self.limit)
        except subprocess.TimeoutExpired:
            return f"{self.name} (hangs)", time.monotonic() - began
        seconds = time.monotonic() - began
        # Runs of some scripts are not reliable by intent: they end with code 3 after their last assertion.
        if done.returncode == 0 or (done.returncode == 3 and "every assertion holds" in done.stdout):
            return "", seconds
        return self.name if self.kind != "doctest" else doctest_failure(done.stdout + done.stderr), seconds


def commands_of(listed, folder, modules):
    out = {}
    for module in modules:
        out[module] = []
        for kind, words in listed.tests[module]:
            each = [[word] for word in words] if kind == "lua" else [words]
            out[module] += [Command(folder, kind, some) for some in each]
    return out


def require_sound(commands, pool):
    """Without a fault all tests pass; sets the time limits."""
    every = [command for of in commands.values() for command in of]
    errors = []
    for command, (failed, seconds) in zip(every, pool.map(lambda c: c.run(0), every)):
        command.limit = max(LEAST_LIMIT, SLACK * seconds)
        if failed:
            errors.append(f"fails without any fault: {failed} ({' '.join(command.command)})")
    if errors:
        sys.exit("\n".join(errors))


def catch(fault, commands):
    spent = 0
    for command in commands:
        failed, seconds = command.run(fault.number)
        spent += seconds
        if failed:
            return failed, spent
    return "", spent


def report(fault, caught, seconds):
    """Prints the row of a fault; true if a test is missing."""
    head = f"{fault.number:4} {fault.module:12}"
    if caught:
        stale = " BUT the list says why no test can notice it; remove that" if fault.reason else ""
        print(f"{head} caught in {seconds:5.1f} s by: {caught}{stale}", flush=True)
        return bool(stale)
    print(f"{head} survives {seconds:5.1f} s: {fault.file}: {fault.original} -> {fault.faulty}"
          + (f" (reason: {fault.reason})" if fault.reason else ""), flush=True)
    return not fault.reason


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--build-only", action="store_true")
    parser.add_argument("--run-only", action="store_true")
    parser.add_argument("--module", default="")
    parser.add_argument("--only", default="")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    asked = parser.parse_args()
    listed = faults.read_list()
    if errors := faults.problems(listed):
        sys.exit("\n".join(errors))
    folder = asked.folder.resolve()
    if not asked.run_only:
        build(listed, folder)
    if asked.build_only:
        return
    only, modules = set(filter(None, asked.only.split(","))), set(filter(None, asked.module.split(",")))
    some = [f for f in listed.faults if (not only or str(f.number) in only) and (not modules or f.module in modules)]
    commands = commands_of(listed, folder, sorted({f.module for f in some}))
    with concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:
        require_sound(commands, pool)
        results = pool.map(lambda f: catch(f, commands[f.module]), some)
        bad = [report(fault, *result) for fault, result in zip(some, results)]
    survivors = sum(bad)
    print(f"{len(some)} faults: {survivors} to mend" if survivors else f"{len(some)} faults: all caught, or with a reason")
    sys.exit(1 if survivors else 0)


if __name__ == "__main__":
    main()
