"""Damaged instants of a run, opened by the console: every reader of checkpoints. Most get a new digest, because the check
of the digest would refuse all of them."""
import os
import random
import struct
import subprocess
import tempfile

import shared

HERE = os.path.dirname(os.path.abspath(__file__))
SCRIPTS = ["instant.lua", "instant_3d.lua"]
WORDS = [0, 1, 2, 7, 255, 2**31, 2**32 - 1, 2**40, 2**63 - 1, 2**64 - 1, 0x7FF8000000000000, 0x7FF0000000000000]
MASK = 2**64 - 1


def digest(data):
    """base/hash.hpp, eight bytes at a time."""
    value = 0xCBF29CE484222325
    whole = len(data) // 8 * 8
    rest = data[whole:]
    for word in (*struct.unpack(f"<{whole // 8}Q", data[:whole]), *rest, len(rest)):
        value = (value ^ word) * 0x100000001B3 & MASK
        value ^= value >> 29
    return value


def with_digest(data):
    return data + struct.pack("<Q", digest(data))


def make_bases(program, folder):
    bases = {}
    for script in SCRIPTS:
        with open(os.path.join(HERE, script), "rb") as file:
            text = file.read()
        with open(os.path.join(folder, script), "wb") as file:
            file.write(text)
        subprocess.run([program, "-i", script], cwd=folder, input=b'save "base.state"\n', stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL, timeout=120, check=False)
        with open(os.path.join(folder, "base.state"), "rb") as file:
            bases[script] = file.read()
        os.remove(os.path.join(folder, "base.state"))
        if with_digest(bases[script][:-8]) != bases[script]:
            raise SystemExit("the digest of restart files has changed: adapt tests/fuzz/restarts.py")
    return bases


def damaged(draw, base):
    data = bytearray(base[:-8])
    for _ in range(draw.choice([1, 1, 2, 5, 30])):
        way, at = draw.random(), draw.randrange(24, len(data))
        if way < 0.4:
            data[at] = draw.choice([data[at] ^ (1 << draw.randrange(8)), draw.randrange(256), 0, 255])
        elif way < 0.8:
            data[at:at + 8] = struct.pack("<Q", draw.choice(WORDS))
        elif way < 0.9:
            del data[at:at + draw.choice([1, 8, 100, 10**6])]
        else:
            data[at:at] = bytes(draw.choice([1, 8, 100]))
    return with_digest(bytes(data)) if draw.random() < 0.95 else bytes(data) + base[-8:]


def fuzz(program, until, seed, findings):
    path = os.path.abspath(program)
    with tempfile.TemporaryDirectory(prefix="fuzz") as folder:
        bases = make_bases(path, folder)

        def work(number):
            draw = random.Random(f"{seed} restarts {number}")
            script = draw.choice(SCRIPTS)
            files = {"damaged.state": damaged(draw, bases[script]), "commands": b"print(m)\nrun(0.01)\n"}
            shared.attempt(shared.Job("restarts", f"{path} -i --from damaged.state < commands", files), findings)
        return f"{len(shared.in_parallel(until, work))} damaged instants, opened and continued"
