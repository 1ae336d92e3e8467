"""Scripts and runs: names that remain after a script, Ctrl-C, pauses, errors."""
import subprocess

from sessions import FALL, check, run_all

# The status line. A Ctrl-C typed before it, directly after the line that starts a run, is still a key of the editor.
RUNNING = r"run +t [0-9.]+ s +step"


def session_script_runs_and_its_locals_stay(place):
    s = place.console("-i", "run.lua")
    check("the script goes on" in s.text, "the script did not run")
    s.query("m", r"model 'fall': 2 bodies")
    s.query("report.ending", r"^time$")
    s.query("block.y < 0.2", r"^true$")


def session_ctrl_c_pauses_a_run_and_continue_continues(place):
    s = place.start("-i", "long.lua")
    s.expect(r"stage begun")
    s.interrupt()
    s.expect(r"Paused: interrupted\.\s+long\.lua:8, in the script\..*s> $")
    s.query("m.time > 0", r"^true$")
    first = float(s.query("m.time", r"^([0-9.e+-]+)$").group(1))
    s.line("continue")
    s.expect(RUNNING)
    s.interrupt()
    s.expect(r"Paused: interrupted")
    second = float(s.query("m.time", r"^([0-9.e+-]+)$").group(1))
    check(second > first, "it did not run on")
    s.line("stop")
    s.expect(r"stage ended.*stopped.*^the script goes on\s+^> $")
    s.query("m.time >= %r" % (second - 1e-6), r"^true$")


def session_ctrl_c_pauses_a_run_typed_at_the_console(place):
    s = place.console("-i", "fall.lua")
    s.line("r = m:run { duration = 1e4 }")
    s.expect(r"stage begun")
    s.interrupt()
    s.expect(r"Paused: interrupted\..*s> $")
    s.line("stop")
    s.expect(r"stage ended.*^> $")
    s.query("r.ending", r"^stopped$")


def session_locals_are_read_and_set_in_a_pause(place):
    place.write("local.lua", FALL + """local limit = 5
local function go()
  local inner = limit * 2
  m:run { duration = 1e4 }
  print("inner is", inner, "limit is", limit)
end
go()
""")
    s = place.start("-i", "local.lua")
    s.expect(r"stage begun")
    s.interrupt()
    s.expect(r"Paused: interrupted")
    s.query("inner, limit", r"^10\s+^5$")
    s.line("inner = 77; limit = 8")
    s.query("where", r"> 1  local\.lua:11, in go\s+  2  local\.lua:14, in the script")
    s.query("frame(2)", r"> 2  local\.lua:14")
    s.query("limit, go ~= nil", r"^8\s+^true$")
    s.line("stop")
    s.expect(r"inner is\s+77\s+limit is\s+8")


def session_what_is_changed_in_a_pause_holds(place):
    s = place.start("-i", "long.lua")
    s.expect(r"stage begun")
    s.interrupt()
    s.expect(r"Paused")
    s.line("m:fix(block)")
    s.query("m.speed", r"^0$")
    s.line("stop")
    s.expect(r"^> $")
    s.query("m.speed", r"^0$")


def session_ctrl_c_ends_an_endless_loop(place):
    s = place.console()
    s.line("print 'round'; while true do end")
    s.expect(r"^round$")
    s.interrupt()
    s.expect(r"^interrupted\s+^> $")
    s.query("1 + 1", r"^2$")


# Endless loops, each of which prints that it has begun. The first Ctrl-C ends them, and the console continues.
LOOPS = {
    "a function": "local function f() print 'begun' while true do end end f()",
    "a coroutine": "coroutine.wrap(function() print 'begun' while true do end end)()",
    "a resumed coroutine": "print(coroutine.resume(coroutine.create(function() print 'begun' while true do end end)))",
    "coroutines one in the other": "coroutine.wrap(function() coroutine.wrap(function() print 'begun' while true do end "
                                   "end)() end)()",
    "coroutines without end": "print 'begun' while true do coroutine.resume(coroutine.create(function() "
                              "while true do end end)) end",
    "pcall": "pcall(function() print 'begun' while true do end end)",
    "pcall in pcall": "pcall(pcall, function() print 'begun' while true do end end) while true do end",
    "pcall without end": "print 'begun' while true do pcall(function() while true do end end) end",
    "xpcall without end": "print 'begun' while true do xpcall(function() while true do end end, print) end",
    "pcall of errors": "print 'begun' while true do pcall(error) end",
    "a sort": "print 'begun' while true do table.sort({ 3, 1, 2 }, function(a, b) return a < b end) end",
    "readings": "print 'begun' while true do m:bodies {} end",
    "a script's own hook": "debug.sethook(function() end, 'c') print 'begun' while true do end",
    "handlers": "m:every(0.01, function() print 'begun' while true do end end) m:run { duration = 1 }",
    "handlers that catch": "m:every(0.01, function() print 'begun' while true do pcall(function() while true do end end) "
                           "end end) m:run { duration = 1 }",
    "stories": "m:story(function() m:wait(0.01) print 'begun' while true do end end) m:run { duration = 1 }",
    "handlers of a run in a coroutine": "m:every(0.01, function() print 'begun' while true do end end) "
                                        "coroutine.wrap(function() m:run { duration = 1 } end)()",
    "runs without end": "m:on_step(function() print 'begun' while true do end end) "
                        "while true do pcall(m.run, m, { duration = 1 }) end",
}


def session_the_first_ctrl_c_ends_every_loop(place):
    for name, loop in LOOPS.items():
        s = place.console("-i", "--trust", "fall.lua")  # a sandbox has no hooks
        s.line(loop)
        s.expect(r"^begun\r?$")
        s.interrupt()
        s.expect(r"^interrupted$")
        s.expect(r"^> $")
        s.query("1 + 1", r"^2$")
        s.query("pcall(error, 'caught')", r"false\s+caught")  # other errors are caught as before
        s.line("quit()")
        s.ends(0)


def session_the_first_ctrl_c_ends_every_loop_of_a_script(place):
    for name, loop in LOOPS.items():
        place.write("loop.lua", FALL + loop + "\n")
        s = place.start("run", "--trust", "loop.lua")
        s.expect(r"^begun$")
        s.interrupt()
        s.expect(r"interrupted$")
        s.ends(130)


def session_ctrl_c_pauses_a_run_whose_handlers_come_to_their_end(place):
    place.write("busy.lua", FALL + """m:on_step(function()
  coroutine.wrap(function() for i = 1, 2000 do pcall(math.sin, i) end end)()
end)
m:run { duration = 1e4 }
""")
    s = place.start("-i", "busy.lua")
    s.expect(r"stage begun")
    s.interrupt()
    s.expect(r"Paused: interrupted\..*s> $")
    s.line("continue")
    s.expect(RUNNING)
    s.interrupt()
    s.expect(r"Paused: interrupted\..*s> $")
    s.line("stop")
    s.expect(r"stage ended.*stopped")


def session_a_hook_of_the_script_outlives_ctrl_c(place):
    s = place.console("-i", "--trust", "fall.lua")
    s.line("calls = 0; debug.sethook(function() calls = calls + 1 end, 'c'); print 'begun' while true do end")
    s.expect(r"^begun$")
    s.interrupt()
    s.expect(r"^interrupted\s+^> $")
    s.line("was = calls; math.abs(1); print('more', calls > was)")
    s.expect(r"^more\s+true$")


def session_error_objects_are_reported_in_words(place):
    s = place.console("-i", "fall.lua")
    s.line("m:every(0.01, function() error { code = 5, why = 'so' } end)")
    s.expect("^> $")
    s.query("m:run { duration = 1 }", r"Paused: a handler failed: .*error object is a table value: \{ code = 5, why = \"so\" \}.*s> $")
    s.line("stop")
    s.expect(r"stage ended.*^> $")
    s.query("error(setmetatable({}, { __tostring = function() return 'in its own words' end }))", r"^in its own words")


def session_error_is_reported_and_the_session_continues(place):
    s = place.console("-i", "fall.lua")
    s.query("m:fix 'blokc'", r"^fix: there is no body or group 'blokc'; did you mean 'block'\?\s+^> $")
    s.query("m.tme", r"^model 'fall' has no 'tme'; did you mean 'time'\?\s+^> $")
    s.query("error { 1 }", r"error object is a table value.*^> $")
    s.query("blokc", r"^there is no 'blokc' here; did you mean 'block'\?")
    s.query("m:run { duration = 0.01 }.steps > 0", r"^true$")


def session_error_in_a_handler_leaves_the_model_usable(place):
    s = place.console("-i", "fall.lua")
    s.line("m:on('impact', function() local x = nil + 1 end)")
    s.expect("^> $")
    s.query("m:run { duration = 1 }", r"Paused: a handler failed: .*attempt to perform arithmetic on a nil value.*s> $")
    s.query("m.time > 0.2 and m.time < 0.21", r"^true$")
    s.line("stop")
    s.expect(r"stage ended.*^> $")
    s.query("m:run { duration = 0.05 }.ending", r"^time$")


def session_script_with_an_error_leaves_its_locals(place):
    place.write("wrong.lua", FALL + "local x = 12\nm:fix 'nobody'\n")
    s = place.console("-i", "wrong.lua")
    check("wrong.lua:9: fix: there is no body or group 'nobody'" in s.text, "the message is not there")
    s.query("x", r"^12$")
    s.line("m:fix 'base'")
    s.query("m:run { duration = 0.1 }.ending", r"^time$")
    s.type("\x04")
    s.ends(0)


def session_script_with_wrong_syntax(place):
    place.write("syntax.lua", "local x = = 1\n")
    s = place.console("-i", "syntax.lua")
    check("syntax.lua:1: unexpected symbol near '='" in s.text, "the message is not there")
    s.query("1 + 1", r"^2$")


def session_ctrl_d_in_a_pause_asks_once(place):
    s = place.start("-i", "long.lua")
    s.expect(r"stage begun")
    s.interrupt()
    s.expect(r"s> $")
    s.type("\x04")
    s.expect(r"Ctrl-D once more leaves.*s> $")
    s.type("\x04")
    s.ends(0)


def session_results_of_a_pause_that_is_left_are_unfinished(place):
    place.write("results.lua", FALL + "m:results { file = 'fall.h5' }\nm:run { duration = 1e4 }\n")
    s = place.start("-i", "results.lua")
    s.expect(r"stage begun")
    s.interrupt()
    s.expect(r"s> $")
    s.line("m:fix(block)")
    s.expect(r"s> $")
    s.line("quit")
    s.expect(r"results so far, unfinished, are in fall\.h5\.part")
    s.ends(0)
    check(place.has("fall.h5.part") and not place.has("fall.h5"), "the wrong file is left")
    info = subprocess.run([place.program, "info", "fall.h5.part"], cwd=place.folder, capture_output=True, text=True)
    check("s: m:fix(block)" in info.stdout, "what was typed is not in the results:\n" + info.stdout)


def session_quit_gives_its_code(place):
    s = place.console()
    s.line("quit(3)")
    s.ends(3)


if __name__ == "__main__":
    run_all(dict(globals()))
