#!/usr/bin/python3
"""Ways out of the sandbox of a script: each must be refused with one line that gives the reason, and change no file.

usage: check_room.py PROGRAM FOLDER
"""
import os
import shutil
import subprocess
import sys
import time

program, top = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
failed = []

MODEL = '''
local m = trilith.model { name = "fall" }
m:material { name = "stone", density = 2400 }
m:contact { between = { "stone", "stone" }, law = trilith.frictional { kn = 6e9, ks = 3e9, mu = 0.6, beta = 2e-4 } }
m:block { name = "base", width = 2, height = 0.2, at = { -1, -0.2 }, material = "stone", support = "fixed" }
m:block { name = "block", width = 0.5, height = 0.3, at = { -0.25, 0 }, material = "stone" }
'''

# Name, script, part of the message. OUT is a folder next to the script's folder, with a file `secret`.
WAYS = [
    ("a pipe", 'io.popen("touch OUT/hit"):close()', "io.popen is refused: it starts programs"),
    ("a command", 'os.execute "touch OUT/hit"', "os.execute is refused: it starts programs"),
    ("an absolute path to write", 'io.open("OUT/hit", "w"):close()', "a script may write files only below"),
    ("an absolute path to read", 'print(io.open("OUT/secret"):read "a")', "a script may read files only below"),
    ("append", 'io.open("OUT/secret", "a"):close()', "only below"),
    ("update", 'io.open("OUT/secret", "r+"):close()', "a script may write files only below"),
    ("a mode with a zero byte", 'io.open("OUT/secret", "r\\0w"):close()', "only below"),
    ("dots", 'io.open("../outside/hit", "w"):close()', "only below"),
    ("dots behind a folder that is not there", 'io.open("none/../../outside/hit", "w"):close()', "is refused"),
    ("a zero byte in a path", 'io.open("../outside/hit\\0.csv", "w"):close()', "holds a zero byte"),
    ("a link to a folder", 'print(io.open("link/secret"):read "a")', "only below"),
    ("a link to nothing", 'io.open("dangling", "w"):close()', "does not exist"),
    ("a second name of a file", 'io.open("second", "w"):close()', "second name elsewhere"),
    ("a hidden file", 'io.open(".bashrc", "w"):close()', "begin with a dot"),
    ("a file in a hidden folder", 'print(io.open(".git/config"):read "a")', "begin with a dot"),
    ("another script", 'io.open("helper.lua", "w"):close()', "files that programs run"),
    ("a program", 'io.open("tool", "w"):close()', "it is a program"),
    ("a fifo", 'for line in io.lines "fifo" do print(line) end', "it is not a regular file"),
    ("lines", 'for line in io.lines "OUT/secret" do print(line) end', "io.lines"),
    ("input", 'io.input "OUT/secret" print(io.read "a")', "io.input"),
    ("output", 'io.output "OUT/hit" io.write "x"', "io.output"),
    ("remove", 'os.remove "kept.csv"', "only files that it has made"),
    ("remove outside", 'os.remove "OUT/secret"', "os.remove"),
    ("rename", 'io.open("new.csv", "w"):close() os.rename("new.csv", "OUT/hit")', "os.rename"),
    ("rename over a file",
     'io.open("new.csv", "w"):close() os.rename("new.csv", "kept.csv")', "only files that it has"),
    ("a name for a temporary file", 'print(os.tmpname())', "os.tmpname is refused"),
    ("the surroundings", 'print(os.getenv "HOME")', "begin with TRILITH_"),
    ("the locale", 'os.setlocale "de_DE"', "os.setlocale is refused"),
    ("dofile", 'dofile "OUT/code.lua"', "dofile"),
    ("loadfile", 'loadfile("OUT/code.lua")()', "loadfile"),
    ("require by a path", 'require "../outside/code"', "require"),
    ("require by package.path", 'package.path = "OUT/?.lua" require "code"', "require"),
    ("package.loadlib", 'package.loadlib("libc.so.6", "system")', "package.loadlib is refused"),
    ("package.cpath", 'print(package.cpath)', "package.cpath is refused"),
    ("package.searchers", 'package.searchers[3]("code")', "package.searchers is refused"),
    ("package.searchpath", 'print(package.searchpath("code", "OUT/?.lua"))', "package.searchpath is refused"),
    ("bytecode", 'assert(load("\\27Lua", "x", "b"))', "attempt to load a binary chunk"),
    ("string.dump", 'string.dump(print)', "string.dump is refused"),
    ("upvalues", 'print(debug.getupvalue(io.open, 1))', "debug.getupvalue is refused"),
    ("the registry", 'print(debug.getregistry())', "debug.getregistry is refused"),
    ("a hook", 'debug.sethook(print, "l")', "debug.sethook is refused"),
    ("locals of a caller, in a message handler",
     'xpcall(error, function() io.stderr:write(select(2, pcall(debug.getlocal, 2, 1))) end) error "end"',
     "debug.getlocal is refused"),
    ("functions of frames", 'assert(debug.getinfo(1).func, "no function is given")', "no function is given"),
    ("the metatable of files", 'getmetatable(io.stdout).__index.write = print', "string value|attempt to index"),
    ("the metatable of texts", 'getmetatable("").__index = print', "attempt to"),
    ("the metatable of globals", 'setmetatable(_G, {})', "metatable is locked"),
    ("the metatable of the module", 'setmetatable(trilith, {})', "metatable is locked"),
    ("the metatable of a model", MODEL + 'getmetatable(m).__index = print', "attempt to"),
    ("the metatable of a report",
     MODEL + 'local r = m:run { duration = 0.01 } getmetatable(r).__index = print', "attempt to"),
    ("a finalizer", 'setmetatable({}, { __gc = print })', "'__gc' is refused"),
    ("the collector", 'collectgarbage "stop"', "collectgarbage"),
    ("a method of texts that deceives",
     'string.find = function() return nil end string.sub = function() return "r" end '
     'string.gsub = string.sub io.open("OUT/hit", "w"):close()', "only below"),
    ("globals that deceive",
     'type = function() return "userdata" end pairs = function() return next, {} end next = pairs '
     'io.output "OUT/hit"', "only below"),
    ("tables of the library", 'package.loaded.io.popen "touch OUT/hit"', "io.popen is refused"),
    ("another coroutine", 'assert(coroutine.resume(coroutine.create(function() os.execute "x" end)))', "os.execute"),
    ("preloaded modules", 'package.preload.x = io.popen require "x"', "io.popen is refused"),
    ("results outside", MODEL + 'm:results { file = "OUT/hit" } m:run { duration = 0.01 }', "results"),
    ("results that are a start file", MODEL + 'm:results { file = ".bashrc" } m:run { duration = 0.01 }', "results"),
    ("results by a link", MODEL + 'm:results { file = "link/run.h5" } m:run { duration = 0.01 }', "results"),
    ("a study outside",
     'trilith.study { file = "OUT/hit", parameters = { n = { 1 } }, case = function() end }', "study"),
    ("a study of a foreign script",
     'trilith.study { file = "s.h5", parameters = { n = { 1 } }, script = "OUT/code.lua" }', "study: script"),
    ("a parameter that is an option",
     'trilith.study { file = "s.h5", parameters = { ["--trust"] = { "true" } }, script = "way.lua" }', "is not a parameter name"),
    ("a loop without an end", 'while true do end', "way.lua:2: the script has run for more than 0.3 s"),
    ("a loop that catches all",
     'while true do pcall(function() while true do end end) end', "has run for more than 0.3 s"),
    ("a loop of short calls", 'while true do trilith.math.sin(1) end', "way.lua:2: the script has run for more than 0.3 s"),
    ("a loop of short calls in a handler", """local m = trilith.model {}
m:material { name = "stone", density = 2400 }
m:block { name = "base", width = 1, height = 1, at = { 0, 0 }, material = "stone", support = "fixed" }
m:on_step(function() while true do trilith.math.sin(1) end end)
m:run { duration = 0.1 }""", "has run for more than 0.3 s"),
    ("a loop in a coroutine", 'coroutine.wrap(function() while true do end end)()', "has run for more than 0.3 s"),
    ("a loop in a handler", MODEL + 'm:on_step(function() while true do end end) m:run { duration = 0.01 }',
     "has run for more than 0.3 s"),
    ("a table without an end",
     'local t = {} for i = 1, 1e9 do t[i] = { i } end', "way.lua:2: the script needs more than 100 MB of memory"),
    ("a text without an end", 'local t = ("x"):rep(1e9)', "the script needs more than 100 MB of memory"),
]

GOOD = MODEL + '''
local helper = require "helper"
assert(helper.two == 2 and dofile("helper.lua").two == 2 and loadfile("helper.lua")().two == 2)
local sum = 0
for line in io.lines "table.txt" do sum = sum + tonumber(line) end
assert(sum == 6 and assert(io.open("table.txt")):read "n" == 1)
assert(io.open("none.txt") == nil and getmetatable("x") == "locked")
m:results { file = "out/run.h5" }
m:run { duration = 0.02 }
local file = assert(io.open("out/curve.csv", "w"))
file:write("t,x\\n0,", m.time, "\\n")
file:close()
local old = assert(io.open("out/curve.csv", "a")) old:close()
local passing <close> = assert(io.open("out/passing.csv", "w"))
assert(os.rename("out/passing.csv", "out/passed.csv") and os.remove "out/passed.csv")
local class = { __index = { twice = function(self) return 2 * self[1] end } }
assert(setmetatable({ 4 }, class):twice() == 8 and getmetatable(setmetatable({}, class)) == class)
assert(setmetatable(setmetatable({}, class), nil) ~= nil and collectgarbage "count" > 0)
assert(load("return 1 + 1")() == 2 and debug.getinfo(1, "l").currentline > 1 and debug.traceback "x")
assert(os.getenv "TRILITH_NO_SUCH" == nil and os.time() > 0)
print "all is well"
'''

TRUSTED = '''
assert(io.popen("echo yes"):read "l" == "yes")
assert(os.getenv "HOME" and debug.getregistry() and io.open("OUT/secret"):read "l" == "a secret")
local name = os.tmpname() os.remove(name)
print "trusted"
'''


def prepare():
    shutil.rmtree(top, ignore_errors=True)
    room, outside = os.path.join(top, "room"), os.path.join(top, "outside")
    os.makedirs(os.path.join(room, ".git"))
    os.makedirs(outside)
    for path, text in ((outside + "/secret", "a secret\n"), (outside + "/code.lua", "io.stderr:write 'ran'\n"),
                       (outside + "/twin", "a twin\n"), (room + "/.git/config", "a secret\n"),
                       (room + "/helper.lua", "return { two = 2 }\n"), (room + "/kept.csv", "kept\n"),
                       (room + "/table.txt", "1\n2\n3\n"), (room + "/tool", "#!/bin/sh\n")):
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
    os.chmod(room + "/tool", 0o755)
    os.symlink(outside, room + "/link")
    os.symlink(outside + "/hit", room + "/dangling")
    os.link(outside + "/twin", room + "/second")
    os.mkfifo(room + "/fifo")
    return room, outside


def contents():
    return {folder: sorted(names) for folder, _, names in os.walk(top)}


def run(text, *options):
    with open(os.path.join(room, "way.lua"), "w", encoding="utf-8") as file:
        file.write('local trilith = require "trilith"\n' + text.replace("OUT", outside) + "\n")
    return subprocess.run([program, "run", "--quiet", *options, "way.lua"], cwd=room, capture_output=True, text=True,
                          timeout=60, check=False)


def way_out(name, text, message):
    before = contents()
    seconds = "0.3" if "has run for" in message else "100"
    done = run(text, "--script-seconds=" + seconds, "--script-memory=100MB")
    output = done.stdout + done.stderr
    known = any(part in output for part in message.split("|"))
    if done.returncode == 0 or not known or "secret\n" in output or "ran" == output[:3]:
        failed.append(f"{name}: code {done.returncode}, not '{message}':\n{output}")
    after = contents()
    if after[outside] != before[outside] or open(outside + "/twin", encoding="utf-8").read() != "a twin\n":
        failed.append(f"{name}: it has left {after[outside]}")
    if open(room + "/kept.csv", encoding="utf-8").read() != "kept\n":
        failed.append(f"{name}: it has written over a file")
    if os.path.exists(room + "/new.csv"):
        os.remove(room + "/new.csv")


room, outside = prepare()
begun = time.time()
for way in WAYS:
    way_out(*way)
for kind, script, options, expected in (("a well-behaved script", GOOD, (), "all is well"),
                                        ("a trusted script", TRUSTED, ("--trust",), "trusted")):
    done = run(script, *options)
    if done.returncode != 0 or expected not in done.stdout:
        failed.append(f"{kind}: code {done.returncode}:\n{done.stdout}{done.stderr}")

# Cases of a study inherit the room, its limits and --trust.
STUDY = """local study = trilith.study { file = "study/s.h5", parameters = { n = { 1 } }, BEFORE
  case = function() CODE return { answer = 5 } end }
print(study.rows[1].status, study.rows[1].message)
"""
for before in ("", "before = function() return 1 end,"):
    for code, options, expected in (('io.popen("echo 5"):close()', (), "io.popen is refused"),
                                    ('io.popen("echo 5"):close()', ("--trust",), "finished"),
                                    ("while true do end", ("--script-seconds=0.3",), "has run for more than 0.3 s"),
                                    ("local t = ('x'):rep(1e9)", ("--script-memory=100MB",), "more than 100 MB"),
                                    ('io.open("curve.csv", "w"):close()', (), "finished")):
        shutil.rmtree(room + "/study", ignore_errors=True)
        os.makedirs(room + "/study")
        done = run(STUDY.replace("BEFORE", before).replace("CODE", code), *options)
        if expected not in done.stdout:
            failed.append(f"a case of a study, {code} with {options} {before}: {done.returncode}:\n"
                          f"{done.stdout}{done.stderr}")
with open(room + "/case.lua", "w", encoding="utf-8") as file:
    file.write('local p = require "trilith".params { n = { 1, "a number" } } return { twice = 2 * p.n }')
for options in ((), ("--trust",)):
    done = run('local s = trilith.study { file = "o.h5", parameters = { n = { 3, 4 } }, script = "case.lua" } '
               'print(s.rows[1].twice, s.rows[2].twice)', *options)
    if done.stdout.split() != ["6.0", "8.0"]:
        failed.append(f"a study of another script with {options}:\n{done.stdout}{done.stderr}")
os.makedirs(room + "/linked.cases", exist_ok=True)
os.symlink(outside, room + "/linked.cases/n=1")
way_out("a link in the folder of a study's cases",
        STUDY.replace("study/s.h5", "linked.h5").replace("BEFORE", "").replace("CODE", ""), "study: ")

for text in failed:
    print(text)
print(f"{len(WAYS)} ways out, {len(failed)} faults, {time.time() - begun:.1f} s")
sys.exit(1 if failed else 0)
