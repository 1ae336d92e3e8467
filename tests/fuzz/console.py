"""Lines at the console, through a pipe: calls, questions to the help, pauses, going back, half lines and bytes."""
import os
import random

import programs
import shared

LINES = ["help", "m", "a.model", "a.body", "a", "help(a.body)", "m:step()", "m:step(3)", "m:continue()", "m:rewind(0.005)",
         "m:rewind { to = 0 }", "m:compare()", "m:breaks()", "m:break_off()", "m:checkpoints { every = 0.002 }", "m:lint()",
         'm:break_on "*"', 'm:break_on "impact"', "m:break_on(function(m) return m.time > 0.004 end)", "m:explain_dt()",
         'm:change { law = "dry", mu = 0.2 }', "m:run { duration = 0.02 }", "m:consolidate { duration = 0.02, or_go_on = true }",
         "m:close()", "m = nil", "a = nil", "collectgarbage()", "error {}", "error()", 'error "mine"', "local x = 3", "x", "return",
         "for i = 1, 3 do", "end", "if", "=", "= 1 + 1", "1 +", "1", "(", ")", "]]", "[[", '"', "--[[", "--", "\\", "\t", "", " ",
         "function f()", "f()", "coroutine.yield()", "return coroutine.wrap(function() coroutine.yield() end)()", "os.exit()",
         "os.exit(2)", "exit", "quit", "goto a", "::a::", "nil", "0/0", "{ { { { {} } } } }", "('x'):rep(1e5)", "_G", "debug.traceback()",
         "setmetatable({}, { __tostring = function() error {} end })", "setmetatable({}, { __name = 3 })", "print(_ENV)",
         "setmetatable(_G, { __index = function() error() end })", "_ENV = {}",
         "\x00", "\x1b[A", "\x03", "\xff\xfe", "\u00e4", "x" * 3000, "help" * 500, "m:on_step(function(m) m:step() end)",
         "m:story(function() m:wait(0.004) error 'mine' end)", "m:on('*', function() a.x.y = 1 end)", "m:bodies { name = '*' }"]


def text(draw, made, dim):
    """A session with a model of `dim` dimensions; `made` makes programs from calls that succeed."""
    lines = []
    for _ in range(draw.randint(3, 25)):
        dice, call = draw.random(), draw.choice(made.calls_in(dim))
        if dice < 0.3:
            step = made.sound(draw, call, dim)
            if draw.random() < 0.4:
                programs.spoil(draw, step, "a.model.time")
            lines.append(step.text())
        elif dice < 0.4:
            word = draw.choice([call.name, call.name.split(":")[-1][:4], draw.choice(made.fields), "*", "%", "", "["])
            lines.append(f'{draw.choice(["help", "apropos"])} "{word}"')
        elif dice < 0.5:
            line = draw.choice(LINES) or " "
            at = draw.randrange(len(line))
            lines.append(line[:at] + draw.choice(["", "(", '"', "\x00", "\xe9", ".", ":", " "]) + line[at + draw.randrange(2):])
        else:
            lines.append(draw.choice(LINES))
    return "\n".join(lines) + draw.choice(["\n", ""])


def fuzz(program, until, seed, findings, made):
    path = os.path.abspath(program)

    def work(number):
        draw = random.Random(f"{seed} console {number}")
        dim = draw.choice(programs.DIMENSIONS)
        script = made.head(dim, dim) + "local m = a.model\n" + draw.choice(["", "m:run { duration = 0.005 }\n", 'm:break_on "stage.begun"\n'])
        files = {"models.lua": made.models, "model.lua": script, "typed": text(draw, made, dim).encode("utf8", "surrogateescape")}
        command = f"{path} {draw.choice(['-i model.lua', '-i model.lua', 'console', 'console -q model.lua'])} <typed"
        shared.attempt(shared.Job("console", command, files), findings)
    return f"{len(shared.in_parallel(until, work))} sessions at the console"
