#!/usr/bin/python3
"""Power cuts: records the writes of a run, and restores the files that a power cut between two writes would leave.

usage: power_cut.py PROGRAM FOLDER [CUTS [SEED]]

CUTS: number of cuts, or "all" for one after each write and three more with lost writes. A disk keeps the data that
were forced to it (fsync) and the order of names; any other write before the cut may be lost. Every file must open or be
refused in one line, and a run that can be resumed must have the rows of a run without a cut. Needs strace.
"""
import importlib.machinery
import importlib.util
import os
import random
import re
import shutil
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
CALLS = "openat,write,pwrite64,ftruncate,rename,unlink,unlinkat,mkdir,rmdir,fsync,fdatasync,fcntl,dup"
LINE = re.compile(r"^(\d+) +(\w+)\((.*)\) += (-?\d+)(?:<(.*)>)?")
SKIPPED = 77


def rows_module():
    """`difference` of the test of restarts: all rows of two results files."""
    loader = importlib.machinery.SourceFileLoader("check_resume", os.path.join(HERE, "..", "restart", "check_resume"))
    spec = importlib.util.spec_from_loader("check_resume", loader)
    module = importlib.util.module_from_spec(spec)
    loader.exec_module(module)
    return module


def text_of(escaped):
    return bytes.fromhex(escaped.replace("\\x", ""))


def whole_lines(path):
    """Lines of strace; the two lines of an interrupted call are joined."""
    begun = {}
    with open(path, encoding="ascii") as log:
        for line in log:
            process = line.split(" ", 1)[0]
            if line.endswith("<unfinished ...>\n"):
                begun[process] = line[:-len("<unfinished ...>\n")]
            elif " resumed>" in line:
                yield begun.pop(process) + line.split(" resumed>", 1)[1]
            else:
                yield line


class Recorded:
    """The writes below a folder. `names`: (index, old name or None, new name or None, inode). `data`: for each inode
    (index, offset, bytes), (index, length, None) for a truncation, (index, None, None) for an fsync. `forced_names`:
    indices of the fsyncs of folders."""

    def __init__(self, log, folder):
        self.folder, self.count = folder, 0
        self.names, self.data, self.forced_names = [], [], [0]
        self.now, self.open, self.folders = {}, {}, set()
        for line in whole_lines(log):
            found = LINE.match(line)
            if found and int(found[4]) >= 0:
                self.take(found[2], found[3], int(found[4]), found[5])

    def inside(self, path):
        path = os.path.normpath(os.path.join(self.folder, path))
        return os.path.relpath(path, self.folder) if path.startswith(self.folder + "/") else None

    def take(self, call, given, result, opened):
        strings = [text_of(s) for s in re.findall(r'"((?:\\x[0-9a-f]{2})*)"', given)]
        number = re.match(r"\d+", given)
        if call == "openat":
            self.opened(self.inside(strings[0].decode()), given, result)
        elif call in ("rename", "unlink", "unlinkat", "rmdir", "mkdir"):
            self.renamed(call, [self.inside(s.decode()) for s in strings])
        elif number and int(number[0]) in self.open and call in ("fcntl", "dup"):
            if call == "dup" or "F_DUPFD" in given:
                self.open[result] = self.open[int(number[0])]
        elif number and int(number[0]) in self.open:
            self.written(call, given, self.open[int(number[0])], strings, result)

    def opened(self, name, given, descriptor):
        self.open.pop(descriptor, None)
        if name is None or name.endswith(".lua"):
            return
        if "O_DIRECTORY" in given or name in self.folders:
            self.open[descriptor] = [None, 0]
        elif "O_RDWR" in given or "O_WRONLY" in given:
            if name not in self.now:
                self.data.append([])
                self.now[name] = len(self.data) - 1
                self.add_name(None, name, self.now[name])
            self.open[descriptor] = [self.now[name], 0]

    def add_name(self, old, new, inode):
        self.names.append((self.count, old, new, inode))
        self.count += 1

    def renamed(self, call, names):
        if not names or names[0] is None:
            return
        if call == "mkdir":
            self.folders.add(names[0])
        elif call == "rename" and names[0] in self.now:
            self.now[names[1]] = self.now.pop(names[0])
            self.add_name(names[0], names[1], self.now[names[1]])
        elif names[0] in self.now:
            self.add_name(names[0], None, self.now.pop(names[0]))

    def written(self, call, given, place, strings, result):
        inode, offset = place
        if call in ("fsync", "fdatasync"):
            if inode is None:
                self.forced_names.append(self.count)
            else:
                self.data[inode].append((self.count, None, None))
            return
        if inode is None:
            return
        if call == "ftruncate":
            self.data[inode].append((self.count, int(given.rsplit(",", 1)[1]), None))
        else:
            at = int(given.rsplit(",", 1)[1]) if call == "pwrite64" else offset
            self.data[inode].append((self.count, at, strings[0][:result]))
            place[1] = at + result
        self.count += 1

    def content(self, inode, cut, lost):
        """Bytes of a file at a cut; `lost(index)` decides for each write that was not forced."""
        operations = [o for o in self.data[inode] if o[0] < cut or (o[1] is None and o[0] <= cut)]
        safe = max((i for i, o in enumerate(operations) if o[1] is None), default=-1)
        bytes_now = bytearray()
        for i, (_, at, data) in enumerate(operations):
            if at is None or (i > safe and lost()):
                continue
            if data is None:
                bytes_now = bytes_now[:at] + bytes(max(0, at - len(bytes_now)))
            else:
                bytes_now += bytes(max(0, at - len(bytes_now)))
                bytes_now[at:at + len(data)] = data
        return bytes(bytes_now)

    def make(self, target, cut, draw):
        """The files at a cut. With `draw`, writes and names that were not forced are lost by chance."""
        shutil.rmtree(target, ignore_errors=True)
        os.makedirs(target)
        last = cut
        if draw:
            last = draw.randint(max(f for f in self.forced_names if f <= cut), cut)
        names = {}
        for index, old, new, inode in self.names:
            if index >= last:
                break
            names.pop(old, None)
            if new is not None:
                names[new] = inode
        share = draw.random() if draw else 0
        for name, inode in names.items():
            path = os.path.join(target, name)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, "wb") as file:
                file.write(self.content(inode, cut, (lambda: draw.random() < share) if draw else (lambda: False)))


class Cuts:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder
        self.rows = rows_module()
        self.script = os.path.join(HERE, "..", "restart", "two_stages.lua")
        self.resumed = self.refused = self.failed = 0

    def record(self):
        run = os.path.join(self.folder, "run")
        os.makedirs(run)
        shutil.copy(self.script, run)
        log = os.path.join(self.folder, "log")
        command = ["strace", "-f", "-qq", "-xx", "-s", "100000000", "-e", "trace=" + CALLS, "-o", log, self.program, "run",
                   "two_stages.lua", "out=run.h5", "blocks=6", "duration=1", "--checkpoint=0.05", "--quiet", "--threads=1"]
        done = subprocess.run(command, cwd=run, capture_output=True, text=True)
        if done.returncode != 0:
            print("skipped: strace cannot follow the program here:", done.stderr[:200])
            sys.exit(SKIPPED)
        os.rename(os.path.join(run, "run.h5"), os.path.join(self.folder, "reference.h5"))
        self.recorded = Recorded(log, run)
        return self.recorded.count

    def run_at(self, cut, *words):
        done = subprocess.run([self.program, *words], cwd=os.path.join(self.folder, "run"), capture_output=True, text=True,
                              timeout=300)
        lines = done.stderr.strip().splitlines()
        if done.returncode == 0 or (done.returncode == 1 and len(lines) == 1):
            return done
        self.report(cut, f"{' '.join(words)} ended with {done.returncode}: {done.stderr[:600]}")
        return None

    def report(self, cut, text):
        self.failed += 1
        kept = os.path.join(self.folder, f"failed{self.failed}")
        shutil.copytree(os.path.join(self.folder, "cut"), kept, dirs_exist_ok=True)
        print(f"cut {cut}: {text}; files in {kept}", flush=True)

    def attempt(self, cut, draw, resumes):
        run = os.path.join(self.folder, "run")
        self.recorded.make(run, cut, draw)
        shutil.copytree(run, os.path.join(self.folder, "cut"), dirs_exist_ok=False)
        shutil.copy(self.script, run)
        for name in ("run.h5", "run.h5.part"):
            if os.path.exists(os.path.join(run, name)):
                self.run_at(cut, "info", name)
        if resumes:
            done = self.run_at(cut, "resume", "run.h5", "--quiet")
            if done and done.returncode == 0:
                self.resumed += 1
                why = self.rows.difference(os.path.join(self.folder, "reference.h5"), os.path.join(run, "run.h5"))
                if why:
                    self.report(cut, "the resumed run has other rows: " + why)
            elif done:
                self.refused += 1
                if not re.search("no checkpoint|is finished", done.stderr):
                    self.report(cut, "resume prints: " + done.stderr)
        shutil.rmtree(os.path.join(self.folder, "cut"))


def main(program, folder, cuts="20", seed="1"):
    folder = os.path.abspath(folder)
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    if shutil.which("strace") is None:
        print("skipped: there is no strace")
        return SKIPPED
    tried = Cuts(os.path.abspath(program), folder)
    count, draw = tried.record(), random.Random(int(seed))
    if cuts == "all":
        plan = [(cut, mode) for cut in range(count + 1) for mode in range(4)]
    else:
        plan = [(draw.randint(0, count), i % 2) for i in range(int(cuts))]
    for cut, mode in plan:
        tried.attempt(cut, draw if mode else None, cuts != "all" or cut % 8 == 0)
    print(f"{len(plan)} cuts of {count} writes: {tried.resumed} runs were resumed, {tried.refused} refused, {tried.failed} failed")
    return 1 if tried.failed else 0


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
