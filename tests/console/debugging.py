"""Breaks, single steps, going back in time, comparing, findings."""
import os
import subprocess

from sessions import FALL, check, run_all

BRIDGE = """local trilith = require "trilith"
local m = trilith.model { name = "deck" }
m:material { name = "c", density = 2400 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.3, beta = 1e-3 }, name = "joint" }
m:block { name = "pier", width = 2, height = 1, at = { 0, 0 }, material = "c", support = "fixed" }
local deck = m:block { name = "deck", width = 1, height = 0.5, at = { 0.5, 1 }, material = "c" }
m:bearing { name = "B1", between = { "pier", "deck" }, at = { 1, 1 }, along = trilith.linear { stiffness = 2e5 },
            limit = { along = 0.02 } }
m:history { name = "slip", body = deck, what = "ux" }
m:consolidate { duration = 5 }
local pulse = {}
for i = 1, 401 do
  local t = (i - 1)*0.005
  pulse[i] = 12*math.sin(math.pi*2*t)*(t <= 2 and 1 or 0)
end
"""
SHAKE = "local r = m:shake { body = 'pier', x = trilith.motion { acceleration = pulse, dt = 0.005, allow_drift = true }, duration = 2 }\n"


def bridge(place, extra=""):
    place.write("deck.lua", BRIDGE + extra + SHAKE + "local hash = m.hash\n")


def session_break_on_an_event_then_continue(place):
    bridge(place, "m:break_on 'bearing.failed'\n")
    s = place.start("-i", "deck.lua")
    s.expect(r"Paused: .* s  bearing B1 failed.*s> $")
    s.query("m.bearings.B1", r"bearing 'B1'.*status\s+failed.*share")
    s.query("m:breaks()", r'\{ "event bearing\.failed" \}')
    s.line("continue")
    s.expect(r"stage ended.*^> $")
    s.query("r.ending", r"^time$")


def session_break_with_a_filter(place):
    place.write("filter.lua", FALL + "m:break_on { 'impact', body = 'block', above = 1.5 }\nm:run { duration = 1 }\n")
    s = place.start("-i", "filter.lua")
    s.expect(r"Paused: 0\.20\d* s  block hit base at 1\.98 m/s\..*s> $")
    s.line("continue")
    s.expect(r"stage ended.*^> $")
    check(s.text.count("Paused") == 1, "the second, slower impact paused too")


def session_break_on_a_condition(place):
    place.write("when.lua", FALL + "m:break_on(function() return block.y < 0.3 end)\nm:run { duration = 1 }\n")
    s = place.start("-i", "when.lua")
    s.expect(r"Paused: condition at when\.lua:8\..*s> $")
    s.query("block.y < 0.3 and block.y > 0.299", r"^true$")
    s.line("m:continue()")
    s.expect(r"stage ended.*^> $")


def session_break_on_a_line(place):
    place.write("line.lua", FALL + "m:break_on { line = 'line.lua:10' }\nlocal a = 5\na = a + 1\nprint('a is', a)\n")
    s = place.start("-i", "line.lua")
    s.expect(r"Paused: line\.lua:10\.\s+line\.lua:10, in the script\..*paused> $")
    s.query("a", r"^5$")
    s.line("a = 50")
    s.line("continue")
    s.expect(r"^a is\s+51\s+> $")


def session_break_is_taken_off(place):
    s = place.console("-i", "fall.lua")
    s.query("m:break_on 'impact'", r"^1$")
    s.line("m:break_off(1)")
    s.expect("^> $")
    s.line("m:run { duration = 1 }")
    s.expect(r"stage ended.*^> $")
    check("Paused" not in s.text, "it paused")


def session_wrong_breaks_are_reported(place):
    s = place.console("-i", "fall.lua")
    s.query("m:break_on 'impcat'", r"break_on: there is no event 'impcat'; did you mean 'impact'\?")
    s.query("m:break_on { 'impact', bdy = 'x' }", r"break_on: unknown key 'bdy'; did you mean 'body'\?")
    s.query("m:break_on(7)", r"break_on: takes an event, a function or a table; this is a number")
    s.query("m:break_on { line = 'x' }", r"must be a number or a text such as")
    s.query("m:break_off(3)", r"break_off: there is no break 3")


def session_steps_and_run_to_in_a_pause(place):
    bridge(place, "m:break_on { 'bearing.failed', once = true }\n")
    s = place.start("-i", "deck.lua")
    s.expect(r"s> $")
    s.line("local n, t = m.steps, m.time")
    s.expect(r"s> $")
    s.line("m:step(5)")
    s.expect(r"s> $")
    s.query("m.steps - n", r"^5$")
    s.line("m:run { to = t + 0.1 }")
    s.expect(r"s> $")
    s.query("m.time >= t + 0.1 and m.time < t + 0.101", r"^true$")
    s.query("m:run { to = 0 }", r"run: 'to' is 0 s, must be after the present")
    s.query("m:shake {}", r"shake: ")
    s.line("continue")
    s.expect(r"stage ended.*^> $")


def session_step_at_the_top(place):
    s = place.console("-i", "fall.lua")
    s.query("m:step(10).steps", r"^10$")
    s.query("m.steps", r"^10$")
    s.query("m:step(0)", r"step: takes a number of steps, at least 1; this is 0")


def session_rewind_and_run_on_gives_the_same_bits(place):
    bridge(place)
    s = place.console("-i", "deck.lua")
    s.query("m:checkpoints()", r"\d+ checkpoints from .* MB; one every 0\.1 s")
    s.query("m:rewind(1.5)", r"note: back at .*m:continue\(\) continues the stage")
    s.query("m.hash ~= hash", r"^true$")
    s.query("m:continue().ending", r"^time$")
    s.query("m.hash == hash", r"^true$")
    s.query("m:compare()", r"^identical at ")


def session_rewind_in_a_pause_gives_the_same_bits(place):
    bridge(place)
    s = place.start("-i", "deck.lua")
    s.expect(r"^> $")
    plain = s.query("hash", r"^([0-9a-f]{16})$").group(1)
    bridge(place, "m:break_on { 'bearing.failed', once = true }\n")
    s = place.start("-i", "deck.lua")
    s.expect(r"Paused.*s> $")
    s.query("m:rewind(0.1)", r"note: back at .*s> $")
    s.line("continue")
    s.expect(r"stage ended.*^> $")
    s.query("hash == '%s'" % plain, r"^true$")


def session_rewind_change_and_compare(place):
    bridge(place, "m:break_on { 'bearing.failed', once = true }\n")
    s = place.start("-i", "deck.lua")
    s.expect(r"Paused.*s> $")
    s.query("m:rewind(0.1)", r"note: back at .*s> $")
    s.query("m:change { bearing = 'B1', limit = { along = 0.5 } }", r"note: bearing 'B1' is now along: .*limit 0\.5 m")
    s.query("m:change { law = 'joint', mu = -1 }", r"change: 'mu' is -1, must be not below 0")
    s.query("m:change { law = 'jiont', mu = 1 }", r"change: there is no law 'jiont'; did you mean 'joint'\?")
    s.line("continue")
    s.expect(r"stage ended.*^> $")
    s.query("m.bearings.B1.status", r"^intact$")
    s.query("m:compare()", r"bearing\.failed  B1\s+before at .* s, not now")


def session_a_pause_that_did_not_come_leaves_nothing_behind(place):
    place.write("stale.lua", FALL + """wrong = true
m:break_on { 'impact', above = 1.5 }
m:on('impact', function() if wrong then error 'at fault' end end)
""")
    s = place.console("-i", "stale.lua")
    s.query("m:run { duration = 1 }", r"Paused: .*block hit base.*a handler failed: .*at fault.*s> $")
    hit = float(s.query("m.time", r"^([0-9.]+)$").group(1))
    s.query("m:rewind(0.1)", r"back at.*s> $")
    s.line("wrong = false")
    s.expect(r"s> $")
    s.line("continue")
    s.expect(r"Paused: ([0-9.]+) s  block hit base.*s> $")
    check(s.text.count("Paused") == 2, "it paused without a reason")
    check(float(s.query("m.time", r"^([0-9.]+)$").group(1)) >= hit - 1e-3, "it paused before the block hit")
    s.line("continue")
    s.expect(r"stage ended.*^> $")
    s.query("m:run { duration = 0.05 }.ending", r"^time$")
    check(s.text.count("Paused") == 2, "it paused again")


def session_rewind_that_cannot_be(place):
    s = place.console("-i", "fall.lua")
    s.query("m:rewind(1)", r"rewind: the model has not run yet")
    s.line("m:checkpoints { every = 0.05, count = 3 }")
    s.expect(r"no checkpoint yet; one every 0\.05 s, at most 3 in 256 MB")
    s.line("m:run { duration = 1 }")
    s.expect(r"^> $")
    s.query("m:checkpoints().count", r"^3$")
    s.query("m:rewind(0.9)", r"rewind: the oldest checkpoint is at 0\.[89]")
    s.query("m:rewind { to = 2 }", r"rewind: the present time is 1\.0000 s, and 2 s is later")
    s.query("m:rewind { to = 1e300 }", r"and 1e\+300 s is later")
    s.query("m:rewind(-1)", r"rewind: the time to go back is -1 s")
    s.query("m:compare()", r"compare: there is no earlier branch")
    s.query("m:continue()", r"continue: no stage is paused")


def session_rewind_within_the_pausing_stage_alone(place):
    bridge(place, "m:break_on { 'bearing.failed', once = true }\n")
    s = place.start("-i", "deck.lua")
    s.expect(r"Paused.*s> $")
    s.query("m:rewind { to = 0.2 }", r"rewind: the stage that pauses here began at .*end it first with stop")


def session_results_of_branches(place):
    bridge(place, "m:results { file = 'deck.h5' }\n")
    text = open(os.path.join(place.folder, "deck.lua")).read()
    place.write("deck.lua", text.replace("m:consolidate", "m:results { file = 'deck.h5' }\nm:consolidate").replace(
        "m:results { file = 'deck.h5' }\nlocal r", "local r"))
    s = place.console("-i", "deck.lua")
    s.line("m:rewind(1)")
    s.expect("^> $")
    s.line("m:continue()")
    s.expect("stage ended.*^> $")
    s.line("quit()")
    s.ends(0)
    check(place.has("deck.h5.part") and not place.has("deck.h5"), "the first branch looks finished")
    check(place.has("deck.branch2.h5"), "the second branch is not there")
    info = subprocess.run([place.program, "info", "deck.branch2.h5"], cwd=place.folder, capture_output=True, text=True)
    check("branch 2: the run went back from" in info.stdout, info.stdout)
    info = subprocess.run([place.program, "info", "deck.h5.part"], cwd=place.folder, capture_output=True, text=True)
    check("continues in deck.branch2.h5" in info.stdout and "NOT finished" in info.stdout, info.stdout)


def session_results_of_a_stage_not_gone_on_with_are_unfinished(place):
    place.write("r.lua", FALL + "m:results { file = 'r.h5' }\nm:run { duration = 1 }\n")
    s = place.console("-i", "r.lua")
    s.query("m:rewind(0.5)", r"back at")
    s.line("quit()")
    s.ends(0)
    check(place.has("r.branch2.h5.part") and not place.has("r.branch2.h5"), "it looks finished")


def session_worst_and_dt_and_lint(place):
    place.write("lint.lua", FALL.replace("beta = 2e-4", "beta = 0"))
    s = place.console("-i", "lint.lua")
    s.query("m:lint()", r"has no damping \(beta = 0\).*is not in equilibrium at the start.*nothing is recorded")
    s.query("m.worst", r"^block: 3530 N unbalanced, 1 of the largest force carried\s+it has no contacts")
    s.line("m:run { duration = 0.01 }")
    s.expect("^> $")
    s.query("m:explain_dt()", r".+")
    s.query("#m:contacts { between = { 'base', 'block' } }", r"^0$")


if __name__ == "__main__":
    run_all(dict(globals()))
