"""A console session under a pseudo-terminal: typed input, and the text on the screen."""
import fcntl
import os
import pty
import re
import select
import signal
import struct
import subprocess
import sys
import termios
import time

ESCAPES = re.compile(r"\x1b\[[0-9;?]*[A-Za-z]|\x1b[()][A-Z0-9]|[\x07\r]|.\x08")


class Failed(Exception):
    pass


class Session:
    """`text` is the whole output without escapes; `expect` searches the output after the last match."""

    def __init__(self, program, *words, folder=".", environment=None, columns=100):
        self.text, self.seen, self.typed = "", 0, []
        main, side = pty.openpty()
        fcntl.ioctl(side, termios.TIOCSWINSZ, struct.pack("HHHH", 40, columns, 0, 0))
        own = dict(os.environ, TERM="xterm", LC_ALL="C.UTF-8", TRILITH_HISTORY="", HOME=folder)
        own.update(environment or {})
        self.process = subprocess.Popen(
            [program, *words], stdin=side, stdout=side, stderr=side, cwd=folder, env=own, close_fds=True,
            preexec_fn=lambda: (os.setsid(), fcntl.ioctl(0, termios.TIOCSCTTY, 0)))
        os.close(side)
        self.terminal = main

    def type(self, text):
        self.typed.append(text)
        os.write(self.terminal, text.encode())

    def line(self, text):
        self.type(text + "\r")

    def interrupt(self):
        self.type("\x03")

    def _take(self, seconds):
        ready, _, _ = select.select([self.terminal], [], [], seconds)
        if not ready:
            return False
        try:
            data = os.read(self.terminal, 65536)
        except OSError:
            return False
        self.text += ESCAPES.sub("", data.decode("utf8", "replace"))
        return bool(data)

    def expect(self, pattern, seconds=60):
        """Waits for a regular expression; returns the match."""
        end = time.monotonic() + seconds
        while True:
            match = re.compile(pattern, re.S | re.M).search(self.text, self.seen)
            if match:
                self.seen = match.end()
                return match
            left = end - time.monotonic()
            if left <= 0 or (not self._take(left) and self.process.poll() is not None):
                raise Failed(f"no {pattern!r} after {self.typed[-1:]}; the screen:\n{self.text[-2500:]}")

    def query(self, text, pattern, seconds=60):
        """Types a line, waits for an answer and for the next prompt."""
        self.line(text)
        match = self.expect(pattern, seconds)
        self.prompted()
        return match

    def prompted(self, seconds=3):
        """Waits until the screen ends with a prompt. Lines after which a run continues show none, which is accepted.
        The terminal is not ready for a key such as Ctrl-D before the prompt."""
        end = time.monotonic() + seconds
        while not self.text.endswith("> ") and self.process.poll() is None and time.monotonic() < end:
            self._take(0.05)

    def ends(self, code=0, seconds=60):
        end = time.monotonic() + seconds
        while self.process.poll() is None and time.monotonic() < end:
            self._take(0.05)
        while self._take(0.05):
            pass
        if self.process.poll() is None:
            self.process.kill()
            raise Failed(f"it did not end; the screen:\n{self.text[-2500:]}")
        if self.process.returncode != code:
            raise Failed(f"it ended with {self.process.returncode}, not {code}; the screen:\n{self.text[-2500:]}")

    def close(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGKILL)
            self.process.wait()
        os.close(self.terminal)


def show(program, *words):
    """For people: types the lines of stdin, each after a moment, and prints the screen."""
    s = Session(program, *words)
    for line in sys.stdin.read().split("\n"):
        time.sleep(0.4)
        while s._take(0.05):
            pass
        s.type(line.replace("^C", "\x03").replace("^I", "\t").replace("^D", "\x04") + ("" if line.endswith(("^I", "^C", "^D")) else "\r"))
    time.sleep(0.5)
    while s._take(0.2):
        pass
    s.close()
    print(s.text)


if __name__ == "__main__":
    show(*sys.argv[1:])
