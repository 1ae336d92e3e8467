#!/usr/bin/python3
"""trilith movie: length, size and formats of films, posters, and its error messages.
usage: check_movie.py PROGRAM FOLDER. Without ffmpeg, only the messages are checked."""
import json
import os
import shutil
import struct
import subprocess
import sys
from pathlib import Path

program, folder = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)

MODEL = """
local trilith = require "trilith"
local m = trilith.model { name = "falling block"DIM }
m:material { name = "stone", density = 2400 }
m:contact { between = { "stone", "stone" }, law = trilith.frictional { kn = 6e8, ks = 3e8, mu = 0.6, beta = 2e-4 } }
m:block { name = "base", BASE, material = "stone", support = "fixed" }
m:block { name = "block", BLOCK, material = "stone", floating = true }
m:results { file = "NAME.h5", frames = 0.05 }
m:run { duration = 0.5 }
"""

BLOCKS = {
    False: {"BASE": "width = 2, height = 0.2, at = { -1, -0.2 }",
            "BLOCK": "width = 0.5, height = 0.3, at = { -0.25, 0.2 }"},
    True: {"BASE": "size = { 2, 1, 0.2 }, at = { -1, -0.5, -0.2 }",
           "BLOCK": "size = { 0.5, 0.5, 0.3 }, at = { -0.25, -0.25, 0.2 }"},
}


def check(holds, text):
    if not holds:
        sys.exit(f"wrong: {text}")


def run_program(*words, **more):
    return subprocess.run([str(program), *words], cwd=folder, capture_output=True, text=True, check=False, **more)


def record(name, space):
    text = MODEL
    for key, value in {"NAME": name, "DIM": ", dim = 3" if space else "", **BLOCKS[space]}.items():
        text = text.replace(key, value)
    (folder / f"{name}.lua").write_text(text)
    ran = run_program("run", f"{name}.lua", "--quiet")
    check(ran.returncode == 0, ran.stderr)


def probe(name):
    """Columns, rows and number of pictures of a film."""
    out = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_streams", "-of", "json", name], cwd=folder,
                         capture_output=True, text=True, check=True).stdout
    stream = json.loads(out)["streams"][0]
    return stream["width"], stream["height"], int(stream["nb_read_frames"])


def refused(words, part, code=1, **more):
    result = run_program("movie", *words, **more)
    check(result.returncode == code and part in result.stderr, f"{words}: {result.returncode} {result.stderr}")


record("plane", False)
record("space", True)

refused(["plane.h5", "-o", "film.avi"], "must be .mp4, .webm or .gif")
refused(["nowhere.h5", "-o", "film.mp4"], "there is no such file")
refused(["plane.h5", "--size", "1281x720"], "even numbers from 160 to 4096")
refused(["plane.h5", "--from", "0.4", "--to", "0.2"], "--to must be above --from")
refused(["plane.h5", "--slow", "1e9"], "lower --fps or --slow")
refused(["plane.h5", "--slow", "0"], "not a number above 0", code=2)
refused(["plane.h5", "--from", "seat.lost"], "neither a time nor an event")
refused(["plane.h5", "-o", "film.mp4"], "install it with 'sudo apt install ffmpeg'",
        env={**os.environ, "PATH": "/nowhere"})
check(not list(folder.glob("*.mp4")) and not list(folder.glob(".*")), "a refused film has left a file")

if not shutil.which("ffmpeg") or not shutil.which("ffprobe"):
    print("skipped: there is no ffmpeg here; the messages are right")
    sys.exit(0)

# 0.5 s at 10 pictures per second, slowed by 4: a picture each 0.025 s from 0 to 0.5 s, both included.
made = run_program("movie", "plane.h5", "-o", "films/plane.mp4", "--fps", "10", "--slow", "4", "--size", "640x360",
           "--poster", "start,end")
check(made.returncode == 0, made.stderr)
check(made.stdout.splitlines() == ["films/plane_1.png", "films/plane_2.png", "films/plane.mp4"], made.stdout)
check(probe("films/plane.mp4") == (640, 360, 21), probe("films/plane.mp4"))
for i in (1, 2):
    data = (folder / f"films/plane_{i}.png").read_bytes()
    width, height = struct.unpack(">II", data[16:24])
    check(data.startswith(b"\x89PNG") and abs(width / height - 640 / 360) < 0.01, "poster of another shape")
check((folder / "films/plane_1.png").read_bytes() != (folder / "films/plane_2.png").read_bytes(), "nothing moved")

for name, ending in (("plane", "gif"), ("space", "webm")):
    made = run_program("movie", f"{name}.h5", "-o", f"{name}.{ending}", "--fps", "10", "--size", "320x240",
               *(["--view", "235,18"] if name == "space" else []))
    check(made.returncode == 0, made.stderr)
    check(probe(f"{name}.{ending}") == (320, 240, 6), probe(f"{name}.{ending}"))

# The picture above the caption stays where it is: the base has the same pixels in the first and in the last picture.
pixels = [subprocess.run(["ffmpeg", "-v", "error", "-i", "films/plane.mp4", "-vf", f"select=eq(n\\,{n})", "-frames:v", "1",
                          "-f", "rawvideo", "-pix_fmt", "gray", "-"], cwd=folder, capture_output=True, check=True).stdout
          for n in (0, 20)]
rows = [[i for i in range(360) if min(p[640 * i + 100:640 * i + 110]) < 200] for p in pixels]
check(rows[0] and abs(rows[0][0] - rows[1][0]) <= 1, f"the ground moves in the film: {rows[0][:2]} {rows[1][:2]}")
again = run_program("movie", "plane.h5", "-o", "again.mp4", "--fps", "10", "--slow", "4", "--size", "640x360")
check(again.returncode == 0 and (folder / "again.mp4").read_bytes() == (folder / "films/plane.mp4").read_bytes(),
      "the same film has other bytes")
check(not list(folder.glob("**/.*")), "an unfinished film was left")
print("films have their length and size")
