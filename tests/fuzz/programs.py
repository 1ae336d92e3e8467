"""Random Lua programs over the whole interface, from a seed: valid calls, of which one to three are made invalid.

No list of valid calls exists: the first programs make every declared call with values for its rows, and later programs
consist of the calls that succeeded. So a new call is tried from the day of its declaration.
"""
import os
import random
import re

import declared
import shared

HERE = os.path.dirname(os.path.abspath(__file__))
SUBJECTS = {"model": "a.model", "space": "a.model", "motion": "a.motion", "set": "a.set", "body": "a.body",
            "section": "a.section"}
HANDLES = ["model", "body", "mesh", "base", "set", "bearing", "seat", "history", "motion", "law", "section"]
BODY = {"material", "name"}  # keys of most bodies
LEARNING = 25     # number of programs to learn from, times four; fixed, so that a seed gives the same programs
EACH = 25         # calls in each
HEAD = """\
local fuzz = dofile "models.lua"
local trilith, try = fuzz.trilith, fuzz.try
fuzz.fields = {{ {} }}
local a, b = fuzz.make("a", {}), fuzz.make("b", {})
"""
DIMENSIONS = (2, 3)
# Places of a call: %s is a function that makes the call.
PLACES = ['a.model:on("*", %s)', 'a.model:on("impact", %s)', "a.model:on_step(%s)", "a.model:every(0.01, %s)",
          "a.model:story(%s)", "a.model:story(function(m) m:wait(0.01) return (%s)(m) end)", "coroutine.wrap(%s)()",
          "coroutine.wrap(function() coroutine.yield() return (%s)() end)()", "setmetatable({}, { __gc = %s })",
          "table.insert(fuzz.late, %s)", 'a.model:history { name = "of" .. math.random(1e9), of = %s }',
          "a.model:break_on { when = %s }", "a.model:run { duration = 0.02, rest = setmetatable({}, { __index = %s }) }",
          "pcall(%s)", "table.sort({ 1, 2, 3 }, %s)", '("x"):gsub("x", %s)', "b.model:on_step(%s)", "xpcall(error, %s)"]
STAGES = ["a.model:run { duration = 0.05 }", "a.model:run { duration = 0.05 }", "a.model:run { duration = 0.05 }",
          "a.model:consolidate { duration = 0.2, or_go_on = true }", "b.model:run { duration = 0.01 }",
          "a.model:step(5)", "a.model:lint()", "collectgarbage()", "fuzz.forget()", "b.model:close()", 'a.model:results { file = "run.h5", frames = 0.01 }']
# Last statements: handles beyond their model's life, and all readings.
ENDS = ["b = nil fuzz.forget() a.model:run { duration = 0.05 } fuzz.read_all(a)", "fuzz.read_all(a) fuzz.read_all(b)",
        "a.model:close() fuzz.read_all(a)", "a.model = nil fuzz.forget() fuzz.read_all(a)",
        "a.model:run { duration = 0.05 } fuzz.read_all(a)", "table.insert(fuzz.late, function() fuzz.read_all(a) end)",
        "for _, x in pairs(a) do fuzz.late[#fuzz.late + 1] = function() fuzz.read(x) end end",
        'b = fuzz.make("b", 3) fuzz.forget() a.model:run { duration = 0.02 }', "a, b = b, a a.model:run { duration = 0.01 }"]


class Step:
    """A call with its values, each [row, text]; positional where `by_key` is false."""

    def __init__(self, call, subject, by_key, values, dim=2):
        self.call, self.subject, self.by_key, self.values, self.dim = call, subject, by_key, values, dim

    def text(self):
        name = self.call.name
        if ":" in name:
            name = f"{self.subject}:{name.split(':')[1]}"
        if not self.by_key:
            return f"{name}({', '.join(text for _, text in self.values)})"
        return f"{name} {{ {', '.join(f'{row[0]} = {text}' for row, text in self.values)} }}"

    def copy(self):
        return Step(self.call, self.subject, self.by_key, [list(pair) for pair in self.values], self.dim)


def guess(draw, call, dim=2):
    """The first attempt of a call, as declared, of a model of `dim` dimensions."""
    subject = SUBJECTS.get(call.name.split(":")[0], "a.model")
    if call.arguments and (not call.keys or draw.random() < 0.4):
        least = sum(row[2] for row in call.arguments)
        rows = call.arguments[:draw.randint(least, len(call.arguments))]
        return Step(call, subject, False, [[row, declared.sane(draw, row, dim)] for row in rows], dim)
    many = draw.choice([0, 1, 1, 2, 3, 5]) / max(1, len(call.keys))
    rows = [row for row in call.keys if row[2] or draw.random() < many or (call.bodies is not None and row[0] in BODY)]
    return Step(call, subject, bool(call.keys), [[row, declared.sane(draw, row, dim)] for row in rows], dim)


def vary(draw, step):
    """A valid call with another valid value, or a key more or less."""
    step = step.copy()
    for pair in step.values:
        if draw.random() < 0.15:
            pair[1] = declared.sane(draw, pair[0], step.dim)
    if step.by_key and draw.random() < 0.3:
        row = draw.choice(step.call.keys)
        step.values = [pair for pair in step.values if pair[0][0] != row[0]]
        if draw.random() < 0.8:
            step.values.append([row, declared.sane(draw, row, step.dim)])
    return step


def mend(draw, step, message):
    """The call as its error message requires: without the unknown key, with the missing one."""
    step = step.copy()
    unknown = re.search(r"unknown key '(\w+)'", message)
    choices = re.search(r"'(\w+)' is '[^']*', must be one of ([\w, ]+)", message)
    if unknown:
        step.values = [pair for pair in step.values if pair[0][0] != unknown[1]]
    elif choices:
        for pair in step.values:
            if pair[0][0] == choices[1]:
                pair[1] = f'"{draw.choice(choices[2].split(", "))}"'
    elif step.by_key:
        given, words = {pair[0][0] for pair in step.values}, set(re.findall(r"\w+", message))
        missed = [row for row in step.call.keys if row[0] in words - given]
        for row in draw.sample(missed, min(len(missed), draw.randint(1, 2))):
            step.values.append([row, declared.sane(draw, row, step.dim)])
    return step


def spoil(draw, step, nested):
    """Makes one part of the step invalid; `nested` is the text of another call, which a function may make."""
    dice = draw.random()
    if dice < 0.1 and ":" in step.call.name:
        step.subject = step.subject.replace("a.", "b.") if draw.random() < 0.6 else f"a.{draw.choice(HANDLES)}"
    elif dice < 0.15 and step.by_key:
        row = (draw.choice(["frobnicate", "[1]", "[0/1]", "[true]", "[{}]"]), "text", False, [])
        step.values.append([row, draw.choice(declared.WILD)])
    elif dice < 0.2 and step.values:
        step.values.pop(draw.randrange(len(step.values)))
    elif step.by_key and dice < 0.5 and step.call.keys:
        row = draw.choices(step.call.keys, [declared.weight(row) for row in step.call.keys])[0]
        step.values = [pair for pair in step.values if pair[0][0] != row[0]] + [[row, declared.odd(draw, row)]]
    elif step.values:
        pair = draw.choices(step.values, [declared.weight(row) for row, _ in step.values])[0]
        pair[1] = declared.odd(draw, pair[0])
        if "function" in pair[0][1] and draw.random() < 0.6:
            pair[1] = f"function() local given = {nested} return given end"


class Programs:
    """Makes programs and learns from their output. `known`: name of a call and dimensions of its model to the steps that
    succeeded; `building`: names of the calls after which nothing can be added to the model."""

    def __init__(self, program, seed):
        self.seed, self.known, self.building = seed, {}, set()
        calls, self.fields = declared.declarations(program)
        self.calls = [c for c in calls if c.name != declared.STUDY]
        self.command = f"{os.path.abspath(program)} run -q model.lua"
        with open(os.path.join(HERE, "models.lua"), "rb") as file:
            self.models = file.read()

    def calls_in(self, dim):
        return [call for call in self.calls if dim == 3 or not call.name.startswith("space:")]

    def head(self, dim=2, other=2):
        return HEAD.format(", ".join(f'"{field}"' for field in self.fields), dim, other)

    def job(self, text, more="", dim=2, other=2):
        return shared.Job("program", self.command + more,
                          {"models.lua": self.models, "model.lua": self.head(dim, other) + text})

    def learn(self, until, findings):
        """Each call separately with a new model, in the plane and in space. Number of calls that succeeded, and of all calls."""
        for dim in DIMENSIONS:
            self.learn_in(dim, until, findings)
        return len({name for name, _ in self.known}), len(self.calls)

    def learn_in(self, dim, until, findings):
        """The last time with a model that has run: each call as declared, then
        corrected by its error message."""
        failed, fresh = {}, f'a = fuzz.make("a", {dim})'
        for turn, new in enumerate([fresh] * 3 + [f"{fresh} a.model:run {{ duration = 0.01 }}"]):
            calls, made = [c for c in self.calls_in(dim) if len(self.known.get((c.name, dim), [])) < 4], {}

            def work(number, turn=turn, new=new, made=made, calls=calls):
                draw = random.Random(f"{self.seed} learn {dim} {turn} {number}")
                some = [calls[(number * EACH + i) % len(calls)] for i in range(EACH)]
                made[number] = [mend(draw, *draw.choice(failed[c.name])) if c.name in failed and draw.random() < 0.7
                                else self.sound(draw, c, dim) for c in some]
                lines = [f"{new} try({i}, function() local given = {step.text()} return given end) "
                         f"fuzz.tell_built(a, {i})" for i, step in enumerate(made[number])]
                return shared.attempt(self.job("\n".join(lines) + "\n", dim=dim, other=dim), findings)
            if not calls:
                return
            for number, output in enumerate(shared.in_parallel(until, work, LEARNING)):
                for at, message in re.findall(r"^(\d+): (.*)$", output, re.M):
                    step = made[number][int(at)]
                    failed.setdefault(step.call.name, []).append((step, message))
                for at in re.findall(r"^good (\d+)$", output, re.M):
                    step = made[number][int(at)]
                    self.known.setdefault((step.call.name, dim), []).append(step)
                if turn < 3:
                    self.building |= {made[number][int(i)].call.name for i in re.findall(r"^built (\d+)$", output, re.M)}

    def sound(self, draw, call, dim=2):
        steps = self.known.get((call.name, dim))
        return vary(draw, draw.choice(steps)) if steps and draw.random() < 0.85 else guess(draw, call, dim)

    @staticmethod
    def dimensions(number):
        """Of the models `a` and `b` of a program: half are in space, and a sixth has one of each."""
        dim = DIMENSIONS[number // 2 % 2]
        return dim, 5 - dim if number % 6 == 5 else dim

    def text(self, number):
        draw = random.Random(f"{self.seed} program {number}")
        dim, _ = self.dimensions(number)
        return self.singles(draw, dim) if number % 2 else self.story(draw, dim)

    def singles(self, draw, dim):
        """One invalid call for each of many models; the models continue after objects of other models are deleted."""
        lines, weights = ["local all = {}"], [sum(map(declared.weight, c.keys + c.arguments)) + 3 for c in self.calls_in(dim)]
        for at, call in enumerate(draw.choices(self.calls_in(dim), weights, k=EACH)):
            step = self.sound(draw, call, dim)
            spoil(draw, step, self.sound(draw, draw.choice(self.calls_in(dim)), dim).text())
            ran = draw.choice(["", "", "", "a.model:run { duration = 0.002 } "])
            lines.append(f'a = fuzz.make("a", {dim}) all[#all + 1] = a {ran}'
                         f"a.v = try({at}, function() local given = {step.text()} return given end)")
        lines += ["b = nil fuzz.forget()", "for _, x in ipairs(all) do a = x try('end', function() "
                  "a.model:run { duration = 0.004 } fuzz.read(a.v) fuzz.read(a.model) end) end"]
        return "\n".join(lines) + "\n"

    def story(self, draw, dim):
        """Several calls one after the other and within each other, of which one to three are invalid."""
        calls = [draw.choice(self.calls_in(dim)) for _ in range(draw.randint(2, 9))]
        if draw.random() < 0.8:
            calls.sort(key=lambda call: 2 * (call.name == "model:close") + (call.name in self.building))
        steps = [self.sound(draw, call, dim) for call in calls]
        for _ in range(draw.randint(1, 3)):
            spoil(draw, draw.choice(steps), self.sound(draw, draw.choice(self.calls_in(dim)), dim).text())
        lines = []
        for at, step in enumerate(steps):
            what, place = step.text(), draw.random()
            if place < 0.2:
                what = draw.choice(PLACES).replace("%s", f"function() local given = {what} return given end")
            # The result of a call may be an argument of the next ones.
            to = f"a.{draw.choice(['body', 'set', 'motion', 'law', 'spring'])}" if draw.random() < 0.1 else f"a.v{at}"
            made = f"local given = {what} return given" if not what.startswith(("fuzz.", "local")) else what
            lines.append(f"{to} = try({at}, function() {made} end) or {to}")
            if draw.random() < 0.1:
                lines.append(f"try('s{at}', function() {draw.choice(STAGES)} end)")
        lines.append(f"try('end', function() {draw.choice(ENDS)} end)")
        return "\n".join(lines) + "\n"


def fuzz(made, until, findings):
    def work(number):
        more = " --results run.h5" if number % 8 == 0 else ""
        shared.attempt(made.job(made.text(number), more, *made.dimensions(number)), findings)
    count = len(shared.in_parallel(until, work))
    return f"{count} Lua programs, with {(count + 1) // 2 + count // 2 * EACH} sequences of calls on models of their own"
