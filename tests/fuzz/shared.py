"""Runs the program with limits, tells findings from refusals, and keeps them."""
import os
import re
import resource
import shutil
import signal
import subprocess

SECONDS = 30                       # wall clock for one process; more is a hang
MEMORY = 4 << 30                   # bytes of address space
DOCUMENTED = {0, 1, 2, 3}          # exit codes of the program, but for signals
# What no message to a user should hold: the insides of C++, of the Lua library that is compiled in, or of sanitizers.
# Lines of tracebacks begin with a tab, and may name the library.
INTERNAL = re.compile(r"std::|vector::|basic_string|bad_alloc|map::at|bad optional|bad_|::_M_|stoi|stod|Assertion"
                      r"|runtime error|Sanitizer|terminate called|core dumped|^(?!\t).*trilith/\w+\.lua:\d+:", re.M)


def limits():
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    if not os.environ.get("TRILITH_FUZZ_SANITIZED"):  # the address sanitizer claims far more than it uses
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


def trouble(command, folder, input_text=None):
    """What is wrong with how `command` ended, or None; and what it said."""
    with open(os.path.join(folder, "said.txt"), "wb+") as said:
        process = subprocess.Popen(command, cwd=folder, stdout=said, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
                                   preexec_fn=limits, start_new_session=True)
        try:
            code = process.wait(SECONDS)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
            code = None
        said.seek(0)
        text = said.read(200000).decode("utf8", "replace")
    if code is None:
        return f"did not end within {SECONDS} s", text
    if code < 0:
        return f"ended by {signal.Signals(-code).name}", text
    if code not in DOCUMENTED:
        return f"ended with code {code}", text
    found = INTERNAL.search(text)
    if found:
        line = next(line for line in text.splitlines() if INTERNAL.search(line))
        return f"says: {line[:300]}", text
    return None, text


class Findings:
    """One of each kind is kept; the others are counted."""

    def __init__(self, folder):
        self.folder, self.known = folder, {}
        os.makedirs(folder, exist_ok=True)

    def add(self, part, what, path, command, text):
        # Numbers and names of files differ from one finding to the next of its kind.
        kind = (part, re.sub(r"'[^']*'|[-+]?[0-9.]+(e[-+]?[0-9]+)?", "#", what))
        self.known[kind] = self.known.get(kind, 0) + 1
        if self.known[kind] > 1:
            return
        name = f"{part}-{len(self.known)}{os.path.splitext(path)[1]}"
        kept = os.path.join(self.folder, name)
        shutil.copy(path, kept)
        with open(kept + ".txt", "w", encoding="utf8") as note:
            note.write(f"{what}\n{' '.join(command)}\n{text}\n")
        print(f"finding: {part}: {what}\n  {kept}", flush=True)
