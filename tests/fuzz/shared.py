"""A job is a command with the files it needs. Runs it with limits, separates findings from error messages, and keeps findings."""
import concurrent.futures
import glob
import os
import re
import resource
import shutil
import signal
import subprocess
import tempfile
import time

SECONDS = 10        # of processor time for one command, all of which ask for little; more is a hang
WALL = 60           # of wall clock, after which it is killed: machines may be busy
SANITIZED = bool(os.environ.get("TRILITH_FUZZ_SANITIZED"))  # the program has sanitizers: it is slow and claims much
MEMORY = 4 << 30    # bytes of address space
MOST_OUTPUT = 200000       # largest number of checked output bytes of a command
# Exit codes of the program: success, wrong input, wrong usage, unsound verdict, interrupted.
DOCUMENTED = {0, 1, 2, 3, 130}
# Freed memory is filled with this value, so that a later read fails at once.
FREED = "ASAN_OPTIONS=detect_leaks=0" if SANITIZED else "MALLOC_PERTURB_=165"
# Patterns that no message to a user may contain: internals of C++, of the HDF5 library, of the compiled-in Lua files,
# of Lua's own assertions, or of sanitizers. Exceptions: lines of tracebacks, which begin with a tab, may name Lua
# files, and a script may call a value of its own that is not a function.
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def locals_of(folders):
    """Names of the local variables of the Lua files in `folders`."""
    names = set()
    for folder in folders:
        for path in sorted(glob.glob(os.path.join(ROOT, folder, "*.lua"))):
            with open(path, encoding="utf-8") as file:
                for line in re.findall(r"^local (?:function )?([\w, ]+)", file.read(), re.M):
                    names.update(re.findall(r"\w+", line))
    return names


WITHIN = "|".join(sorted(locals_of(["lua/lib", "lua/console"]) - locals_of(["scripts"])))
INTERNAL = re.compile(r"std::|vector::|basic_string|bad_alloc|map::at|bad optional|bad_|::_M_|stoi|stod|Assertion"
                      r"|runtime error|Sanitizer|terminate called|core dumped|HDF5-DIAG|Can't allocate"
                      r"|^(?!\t).*trilith/\w+\.lua:\d+: (?!cannot resume)"
                      r"|attempt to \w+ a \w+ value \(upvalue '(?:" + WITHIN + r")'"
                      r"|bad argument #\d to '\?'|^(?!printed\t).*\d{60}", re.M)


class Job:
    """`command` is a line for the shell, run in a folder that holds `files` (name to bytes)."""

    def __init__(self, part, command, files):
        self.part, self.command, self.files = part, f"{FREED} {command}", files

    def lay_out(self, folder):
        os.makedirs(folder, exist_ok=True)
        for name, content in self.files.items():
            with open(os.path.join(folder, name), "wb") as file:
                file.write(content if isinstance(content, bytes) else content.encode())


def set_limits():
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_FSIZE, (1 << 30, 1 << 30))
    if not SANITIZED:
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


def run(job, folder):
    """How the job ended in `folder`: code (None where it was killed), seconds of processor time, its output."""
    output_path = os.path.join(folder, "output.txt")
    with open(output_path, "wb") as output:
        process = subprocess.Popen(["/bin/sh", "-c", job.command], cwd=folder, stdout=output, stderr=subprocess.STDOUT,
                                   stdin=subprocess.DEVNULL, preexec_fn=set_limits,
                                   start_new_session=True)
    killed, until = False, time.monotonic() + WALL
    while True:
        pid, status, used = os.wait4(process.pid, os.WNOHANG)
        if pid:
            break
        if time.monotonic() > until:
            killed, until = True, float("inf")
            os.killpg(process.pid, signal.SIGKILL)
        time.sleep(0.002)
    process.returncode = os.waitstatus_to_exitcode(status)
    with open(output_path, "rb") as output:
        text = output.read(MOST_OUTPUT).decode("utf8", "replace")
    return None if killed else process.returncode, used.ru_utime + used.ru_stime, text


def judge(code, seconds, text):
    """The kind of finding for the end of a command, or None. The shell gives 128 + n for a signal n."""
    if code is None:
        return f"did not end within {WALL} s"
    number = -code if code < 0 else code - 128
    if number > 0 and code not in DOCUMENTED:
        return f"ended by {signal.Signals(number).name}" if number in set(signal.Signals) else f"ended with code {code}"
    if code not in DOCUMENTED:
        return f"ended with code {code}"
    found = INTERNAL.search(text)
    if found:
        return "prints: " + next(line for line in text.splitlines() if INTERNAL.search(line))[:300]
    if seconds > SECONDS * (5 if SANITIZED else 1):
        return f"took {seconds:.0f} s of processor time"
    return None


def frame(job, folder):
    """Place of a crash: the first function on the stack, if a debugger is installed and the crash repeats."""
    if not shutil.which("gdb") or SANITIZED:
        return ""
    debugged = re.sub(r"(?<=\s)(/\S+/trilith) (.*)", r"gdb -q -batch -ex 'run \2' -ex bt \1", job.command)
    job.lay_out(folder)
    text = run(Job(job.part, debugged.removeprefix(FREED + " "), job.files), folder)[2]
    found = re.search(r"in (trilith::(?:\(anonymous namespace\)|[^(])*)", text)
    return f" in {found[1]}" if found else ""


class Findings:
    """One finding of each kind is kept, in its own folder with the files that repeat it; others are counted."""

    def __init__(self, folder):
        self.folder, self.known = folder, {}
        os.makedirs(folder, exist_ok=True)

    def add(self, job, what, text):
        # Numbers and names differ between findings of the same kind.
        kind = (job.part, re.sub(r"'[^']*'|[-+]?[0-9.]+(e[-+]?[0-9]+)?", "#", what))
        self.known[kind] = self.known.get(kind, 0) + 1
        if self.known[kind] > 1:
            return
        kept = os.path.join(self.folder, f"{job.part}-{len(self.known)}")
        shutil.rmtree(kept, ignore_errors=True)
        job.lay_out(kept)
        with open(os.path.join(kept, "finding.txt"), "w", encoding="utf8") as note:
            note.write(f"{what}\n{job.command}\n\n{text}\n")
        print(f"finding: {job.part}: {what}\n  cd {kept} && {job.command}", flush=True)


def attempt(job, findings):
    """Runs the job in a temporary folder, keeps its findings; returns the output of the job."""
    with tempfile.TemporaryDirectory(prefix="fuzz") as folder:
        job.lay_out(folder)
        code, seconds, text = run(job, folder)
        what = judge(code, seconds, text)
        if what and what.startswith("ended by"):
            what += frame(job, folder)
    if what:
        findings.add(job, what, text)
    return text


def in_parallel(until, work, limit=None):
    """work(0), work(1), ... until the time `until` of the monotonic clock, or until `limit` are done; their results."""
    given, number, running = {}, 0, {}
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        while True:
            while (len(running) < os.cpu_count() and (limit is None or number < limit)
                   and time.monotonic() < until):
                running[pool.submit(work, number)] = number
                number += 1
            if not running:
                return [given[n] for n in sorted(given)]
            done, _ = concurrent.futures.wait(running, return_when=concurrent.futures.FIRST_COMPLETED)
            for future in done:
                given[running.pop(future)] = future.result()
