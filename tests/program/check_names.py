#!/usr/bin/python3
"""Names in a script that mean something in HTML, XML, VTK, a shell or a terminal stay names everywhere.

usage: check_names.py PROGRAM FOLDER
"""
import glob
import html.parser
import os
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree

program, folder = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
failed = []

BAD = "</script><script>alert(1)</script><img src=x onerror=alert(2)>\"'`&amp;]]>--><!--\\${x}../../x"
CONTROLS = {"escape": "\\27[2J", "line break": "\\n", "carriage return": "\\r", "zero": "\\0", "bell": "\\7", "delete": "\\127",
            "next line of Latin 1": "\\u{85}"}

MODEL = '''
local trilith = require "trilith"
local bad = %s
local m = trilith.model { name = bad .. "model" }
m:material { name = bad .. "stone", density = 2400 }
m:contact { between = { bad .. "stone", "*" }, name = bad .. "law",
  law = trilith.frictional { kn = 6e8, ks = 3e8, mu = 0.5, beta = 2e-4 } }
m:block { name = bad .. "base", width = 4, height = 0.2, at = { -2, -0.2 }, material = bad .. "stone", support = "fixed",
  groups = { bad .. "group" } }
local b = m:block { name = bad .. "b", width = 0.5, height = 0.25, at = { 0, 0.1 }, material = bad .. "stone",
  floating = true }
m:bearing { name = bad .. "spring", between = { bad .. "base", bad .. "b" }, at = { 0.25, 0 }, arm = 1,
  along = trilith.linear { stiffness = 1e4 } }
m:results { file = "run.h5", frames = 0.05, histories = 0.01, energy = 0.05 }
m:history { name = bad:gsub("/", "") .. "history", body = b, what = "y" }
m:run { duration = 0.5, name = bad .. "stage" }
'''


def expect(what, good, text=""):
    if not good:
        failed.append(what)
        print(f"{what}: {text[:500]!r}")


def run(*words):
    return subprocess.run([program, *words], cwd=folder, capture_output=True, timeout=120)


def clean(what, done, code=0):
    output = done.stdout + done.stderr
    expect(f"{what} ends with {code}", done.returncode == code, output.decode(errors="replace"))
    found = re.search(rb"[\x00-\x08\x0b-\x1f\x7f]|\xc2[\x80-\x9f]", output)
    expect(f"{what} prints no control character", not found, output[max(0, found.start() - 60):].decode(errors="replace")
           if found else "")
    return output.decode(errors="replace")


class Page(html.parser.HTMLParser):
    """Finds elements that a name has added to a page: elements with handlers, an image `x`, and scripts."""

    def __init__(self):
        super().__init__()
        self.found, self.script = [], False

    def handle_starttag(self, tag, attributes):
        self.script = tag == "script"
        if any(key.startswith("on") and "alert" in (value or "") for key, value in attributes) or ("src", "x") in attributes:
            self.found.append(self.get_starttag_text())

    def handle_endtag(self, tag):
        self.script = False

    def handle_data(self, data):
        if self.script and data.strip().startswith("alert("):
            self.found.append(data[:80])


def check_page(name, shown):
    with open(os.path.join(folder, name), encoding="utf-8") as file:
        text = file.read()
    page = Page()
    page.feed(text)
    expect(f"{name} has no element that is a name", not page.found, str(page.found))
    expect(f"{name} shows the name", shown in text, text[:100])


def check_xml(pattern):
    files = sorted(glob.glob(os.path.join(folder, pattern), recursive=True))
    expect(f"there is a file {pattern}", files)
    for path in files:
        with open(path, "rb") as file:
            data = file.read()
        data = data.split(b"<AppendedData")[0] + b"</VTKFile>" if b"<AppendedData" in data else data
        try:
            root = xml.etree.ElementTree.fromstring(data)
        except xml.etree.ElementTree.ParseError as error:
            expect(f"{os.path.basename(path)} is XML", False, str(error))
            continue
        tags = {element.tag.split("}")[-1] for element in root.iter()}
        expect(f"{os.path.basename(path)} has no element of a name", not tags & {"script", "img"}, str(tags))


def outputs(literal, history, shown):
    with open(os.path.join(folder, "names.lua"), "w", encoding="utf-8") as file:
        file.write((MODEL % literal).replace('bad:gsub("/", "")', history))
    clean("run", run("run", "names.lua"))
    clean("info", run("info", "run.h5"))
    for verb, name in (("view", "view.html"), ("report", "report.html")):
        clean(verb, run(verb, "run.h5", "-o", name))
        check_page(name, shown)
    clean("draw", run("draw", "run.h5", "-o", "drawing.svg"))
    clean("plot", run("plot", "run.h5", "-o", "plot.svg"))
    clean("export", run("export", "run.h5", "-o", "vtk"))
    check_xml("*.svg")
    check_xml("vtk/**/*.[pv][vt]?")
    outside = [name for name in os.listdir(os.path.dirname(folder)) if name == "x" or "alert" in name]
    expect("no file outside the folder", not outside, str(outside))


def refusals():
    for name, text in CONTROLS.items():
        with open(os.path.join(folder, "control.lua"), "w", encoding="utf-8") as file:
            file.write(MODEL % f'"a{text}b"')
        output = clean(f"a name with {name}", run("run", "control.lua", "--quiet"), 1)
        expect(f"a name with {name} is refused with its place", output.startswith("control.lua:4: ") and output.count("\n") == 1, output)


def files():
    """Names of files and arguments in messages."""
    name = "a\x1b[2J<b>\n.lua"
    with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
        file.write('error "no"')
    clean("a script whose name has control characters", run("run", name), 1)
    clean("a script that does not exist", run("run", "none" + name), 1)
    clean("results that do not exist", run("info", "none" + name), 1)
    clean("a parameter with control characters", run("run", "names.lua", "x\x1b[2J=1\x1b]0;t\x07"), 1)
    clean("an option with control characters", run("run", "--x\x1b[2J"), 2)
    clean("an unknown case", run("verify", "x\x1b[2J"), 1)


shutil.rmtree(folder, ignore_errors=True)
os.makedirs(folder)
outputs("[==[" + BAD + "]==]", 'bad:gsub("/", "")', "onerror")
outputs('"cut \\xff UTF-8 "', '"h"', "UTF-8 ")  # histories take whole UTF-8 alone
refusals()
files()
print("names: all as they should be" if not failed else f"{len(failed)} wrong")
sys.exit(1 if failed else 0)
