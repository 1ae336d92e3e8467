"""The readers of text, of checkpoints and of results under libFuzzer, with the address and undefined-behaviour sanitizers."""
import os
import shutil
import struct
import subprocess
import time

import results
import shared

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
# Compiled with sanitizers; the rest comes from the library.
SOURCES = ["tests/fuzz/readers.cpp", "engine/base/error.cpp", "engine/base/nearest.cpp", "engine/base/units.cpp",
           "engine/element/solid/space_mesh.cpp", "engine/build/space/gmsh.cpp", "engine/build/space/obj.cpp", "engine/build/space/solid_file.cpp",
           "engine/build/space/stl.cpp", "engine/load/motion.cpp", "engine/load/motion_check.cpp", "engine/load/motion_columns.cpp",
           "engine/load/motion_csv.cpp", "engine/load/motion_formats.cpp", "engine/load/motion_peer.cpp",
           "engine/load/motion_plain.cpp", "engine/load/motion_read.cpp", "engine/load/motion_samples.cpp", "engine/load/text_lines.cpp", "engine/run/study/study_figures.cpp",
           "engine/geometry/plane/mesh.cpp", "engine/model/io/checkpoint.cpp", "tests/fuzz/damaged_results.cpp",
           *(f"engine/results/reading/{name}.cpp" for name in ("event_table", "header_reading", "reader", "row_checks",
                                                               "set_reading", "table_columns"))]
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
ESM = "EVENT_NAME: A\nSAMPLING_INTERVAL_S: 0.005\nNDATA: 3\nUNITS: cm/s^2\n0.0\n1.5\n-2.0\n"
KNET = """Origin Time       2011/03/11 14:46:00
Sampling Freq(Hz) 100Hz
Duration Time(s)  0
Scale Factor      3920(gal)/6182761
Memo.
  100   -20  3000 -2000
"""
CUBE = "".join(f"v {x} {y} {z}\n" for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)))
QUADS = [(1, 4, 3, 2), (5, 6, 7, 8), (1, 2, 6, 5), (2, 3, 7, 6), (3, 4, 8, 7), (4, 1, 5, 8)]
OBJ = "o a\n" + CUBE + "".join("f {} {} {} {}\n".format(*quad) for quad in QUADS)
TETRA = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
SIDES = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]
STL = "solid a\n" + "".join("facet normal 0 0 0\nouter loop\n" + "".join("vertex {} {} {}\n".format(*TETRA[i]) for i in side)
                           + "endloop\nendfacet\n" for side in SIDES) + "endsolid a\n"
BINARY_STL = (b" " * 80 + struct.pack("<I", 4) + b"".join(struct.pack("<3f", 0, 0, 0) + b"".join(struct.pack("<3f", *TETRA[i])
              for i in side) + b"\0\0" for side in SIDES)).decode("latin1")
SPACE_MESH = """$MeshFormat
4.1 0 8
$EndMeshFormat
$Nodes
1 4 1 4
3 1 0 4
1
2
3
4
0 0 0
1 0 0
0 1 0
0 0 1
$EndNodes
$Elements
1 1 1 1
3 1 4 1
1 1 2 3 4
$EndElements
"""
COLUMNS = ["m/s2 0.02 2 - -\nt,ns,ew\n0.00,0,0\n0.02,.1,.2\n0.04,-.1,0\n", "g - - - ,\n0,00;0,1\n0,02;-0,1\n0,04;0\n",
           "g 0.01 rows 1 .\nhead\n0 .1 .2\n-.1 0\n", "gal 0.005 - - -\n0.00 1\n0.01 2\n0.01 -3\n0.02 0\n"]
TEXTS = {"record": [RECORD, PEER, ESM, KNET], "columns": COLUMNS, "space_mesh": [SPACE_MESH],
         "obj": ["\x00" + OBJ, "\x02" + OBJ.replace("f 5 6", "f 5 \\\n6")], "stl": ["\x01" + STL, "\x00" + BINARY_STL], "mesh": [MESH], "quantity": ["m/s2,0.6g", "m,3 ft", "s,1e-3", "1,0.4"],
         "unit": ["kip/ft", "N s/m", "m/s2", "kg m^2"], "figures": ["drift\tm\tnumber\t0.5\nend\t\ttext\trest\n"],
         "checkpoint": ["\x10" + "\x00" * 8, "\x80" + "\x01" * 8 + "\xff\x7f" + "\x00" * 7],
         "results": [chr(base) + chr(thing) + chr(kind) + "\x00\x07" + "\x01" * 8
                     for base, thing, kind in ((0, 9, 0), (1, 20, 3), (2, 30, 5), (3, 7, 6), (4, 12, 7), (5, 255, 4))]}


def build(library, folder):
    """The readers as one program; only changed files are compiled."""
    flags = ["-std=c++20", "-O1", "-g1", "-DFMT_SHARED", "-DNDEBUG", "-ffp-contract=off", "-fno-math-errno",
             "-fsanitize=fuzzer,address,undefined", "-fno-sanitize-recover=undefined", "-Iengine"]
    flags += subprocess.run(["pkg-config", "--cflags", "eigen3", "hdf5-serial"], capture_output=True, text=True,
                            check=True).stdout.replace("-I/", "-isystem/").split()
    libraries = ["hdf5-serial", "cairo", "zlib", "fmt"]
    link = subprocess.run(["pkg-config", "--libs", *libraries], capture_output=True, text=True, check=True)
    compiler = (["ccache"] if shutil.which("ccache") else []) + ["clang++"]
    objects = [os.path.join(folder, source.replace("/", "_") + ".o") for source in SOURCES]
    done = [subprocess.run([*compiler, *flags, "-c", source, "-o", made], cwd=ROOT, check=False).returncode
            for source, made in zip(SOURCES, objects)]
    program = os.path.join(folder, "readers")
    # Sources of the library are compiled in groups, so some definitions occur twice, and the first one counts.
    linking = ["clang++", "-fsanitize=fuzzer,address,undefined", "-Wl,--allow-multiple-definition", *objects, library,
               *link.stdout.split(), "-o", program]
    if any(done) or subprocess.run(linking, check=False).returncode:
        raise RuntimeError("the readers do not compile")
    return program


def fuzz(program, trilith, until, seed, out, findings):
    """Each reader for its share of the time; `trilith` writes the results files that are damaged."""
    folder = os.path.join(out, "bases")  # kept for the commands that repeat findings
    os.makedirs(folder, exist_ok=True)
    # Part files have much reserved space, which would cost most of the time.
    bases = [path for path in results.make_bases(trilith, folder)[0] if path.endswith(".h5") and "study" not in path]
    program, counts, left = f"TRILITH_BASES={':'.join(bases)} {program}", {}, len(TEXTS)
    for reader, texts in TEXTS.items():
        corpus = os.path.join(out, "corpus", reader)
        os.makedirs(corpus, exist_ok=True)
        for number, text in enumerate(texts):
            with open(os.path.join(corpus, f"seed{number}"), "wb") as file:
                file.write(text.encode("latin1"))
        each = max(1, round((until - time.monotonic()) / left))
        left -= 1
        options = "-timeout=10 -rss_limit_mb=2048 -max_len=2000 -print_final_stats=1 -verbosity=0"
        command = f"TRILITH_READER={reader} {program} {corpus} -max_total_time={each} -seed={seed} {options}"
        done = subprocess.run(f"{command} -artifact_prefix={out}/{reader}-", shell=True, capture_output=True, text=True,
                              errors="replace", check=False)
        counts[reader] = sum(int(line.split()[-1]) for line in done.stderr.splitlines() if "number_of_executed_units" in line)
        if done.returncode != 0:
            made = [line.split()[-1] for line in done.stderr.splitlines() if "Test unit written to" in line]
            error_line = next((line for line in done.stderr.splitlines() if "ERROR" in line or "runtime error" in line),
                        "ended badly")
            content = b""
            if made:
                with open(made[0], "rb") as file:
                    content = file.read()
            job = shared.Job("text", f"TRILITH_READER={reader} {program} input", {"input": content})
            findings.add(job, f"{reader}: {error_line}", done.stderr[-4000:])
    each = ", ".join(f"{reader} {count}" for reader, count in counts.items())
    return f"{sum(counts.values())} texts and checkpoints ({each})"
