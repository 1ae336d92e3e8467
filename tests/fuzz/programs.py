"""Random Lua programs over the whole interface, as the program itself declares it (trilith manual), from a seed."""
import os
import random
import re
import subprocess

# A sound model, another one, and what their handles are. Each call stands alone: an error in one lets the others go on.
HEAD = """\
local trilith = require "trilith"
local function try(name, f)
  local good, message = pcall(f)
  if not good then io.write(name, ": ", tostring(message), "\\n") end
  return good and message or nil
end
local function make(name)
  local m = trilith.model { name = name }
  m:material { name = "stone", density = 2400 }
  m:material { name = "soft", density = 2000, E = 1e8, nu = 0.2 }
  local law = trilith.frictional { name = "dry", kn = 1e8, ks = 5e7, mu = 0.5, beta = 1e-3 }
  m:contact { between = { "*", "*" }, law = law }
  local base = m:block { name = "base", width = 6, height = 0.5, at = { -3, -0.5 }, material = "stone",
    support = "fixed" }
  local low = m:block { name = "low", width = 1, height = 0.5, at = { -0.5, 0 }, material = "stone", groups = "pile" }
  local high = m:block { name = "high", width = 1, height = 0.5, at = { -0.5, 0.5 }, material = "soft", groups = "pile",
    body = { mesh = { 2, 1 } } }
  local spring = trilith.linear { stiffness = 1e6, damping = 1e3 }
  local bearing = m:bearing { name = "link", between = { "base", "low" }, at = { 0, 0 }, along = spring,
    limit = { along = 0.05 } }
  local seat = m:seat { name = "rest", body = low, support = base, at_end = { -0.5, 0 }, edge = { 3, 0 },
    inward = { -1, 0 } }
  local history = m:history { name = "top", body = high, what = "y" }
  local count = 0
  m:on_step(function() count = count + 1 if count % 200 == 0 then m:stop() end end)
  return { model = m, body = low, mesh = high, base = base, set = m:bodies { group = "pile" }, bearing = bearing,
    seat = seat, history = history, law = law, spring = spring,
    motion = trilith.ramp { by = 0.1, duration = 1 } }
end
local a, b = make "a", make "b"
"""
WILD = ["0/0", "1/0", "-1/0", "0", "-1", "1e308", "-1e308", "1e-308", "2^31", "2^53", "-2^63", "math.mininteger", "1e9",
        "nil", "true", "false", '""', '"*"', '"\\0"', '("x"):rep(5000)', '"\\27[2J"', "{}", "{ {} }", "{ 1 }",
        "{ 0/0, 1/0 }", "{ a = 1 }", "function() end", "function() error {} end", "function() error() end", "print",
        "coroutine.create(function() end)", "io.stdout",
        'setmetatable({}, { __index = function() error "mine" end })',
        
        "setmetatable({}, { __len = function() return -5 end })", "a.model", "b.model", "b.body", "b.set", "b.bearing",
        "b.seat", "b.history", "a.model.worst", "a.motion", "b.law", "a.spring", 'a.model:bodies { name = "zz*" }']
# Wrong ones of the right kind go further in than wrong kinds.
NUMBERS = ["0/0", "1/0", "-1/0", "0", "-1", "1e308", "1e-308", "2^31", "2^53", "-2^63", "1e9", "-1e9", "1e-9", "math.pi"]
OTHERS = ['a.model:bodies { name = "zz*" }', "b.body", "b.set", "b.base", "{}", "{ b.body }", '{ "low", "low" }', '"zz*"',
          "a.base", "{ a.base }"]
CLOSE = {"number": NUMBERS, "integer": NUMBERS, "bodies": OTHERS, "body": OTHERS, "list": OTHERS, "names": OTHERS,
         "bearing": ["b.bearing", "a.seat"], "seat": ["b.seat", "a.bearing"], "points": ["{ { 0, 0 } }", "{ { 0/0, 0 } }"],
         "point": ["{ 0/0, 0 }", "{ 1e308, -1e308 }", "{ 1 }", "{ 1e9, 1e9 }"]}
SANE = {
    "number": ["0.1", "0.5", "1", "2", "3", "10", "1e3", "1e6", "0.01"],
    "integer": ["1", "2", "3", "5", "0"],
    "flag": ["true", "false"],
    "text": ['"stone"', '"x"', '"dry"', '"rest"', '"link"', '"low"', '"top"', '"y"', '"mass"', '"impact"', '"*"'],
    "names": ['"stone"', '{ "stone", "soft" }', '"pile"', '{ "low", "high" }', '{ "dry" }'],
    "point": ["{ 0, 0 }", "{ 0, 0.5 }", "{ 3, 0 }", "{ -0.5, 1 }"],
    "points": ["{ { 0, 0 }, { 1, 0 }, { 1, 1 } }", "{ { 0, 0 }, { 1, 0 }, { 0.5, 0.1 }, { 0, 1 } }"],
    "place": ['"top"', '"centroid"', "{ 0, 0.2 }"],
    "bodies": ["a.body", "a.set", "a.mesh", '"low"', "{ a.body, a.mesh }", '"pile"'],
    "body": ["a.body", "a.mesh", '"high"', "a.base"],
    "bearing": ["a.bearing", '"link"'], "seat": ["a.seat", '"rest"'],
    "motion": ["a.motion", "trilith.motion { velocity = 0.1, duration = 0.1 }"],
    "numbers": ["{ 0, 1, 0, -1, 0 }", "{}"],
    "function": ["function() end", "function(m) return m.time end", "function() coroutine.yield() end",
                 'function(m) m:wait "impact" end', "function(m) m:wait(0.01) end"],
    "table": ["{}", "{ along = 0.1 }", "{ { 0, 1 } }", "a.model.energy"],
    "list": ["{}", "{ a.body, a.base }", "{ { width = 1, height = 1 } }", "{ { body = a.base, x = a.motion } }"],
    "rest": ["true", "{ speed = 1e-3, hold = 0.01 }"], "course": ["0.5", "{ ramp = 0.1 }", "{ { 0, 0 }, { 1, 1 } }"],
    "body form": ['"rigid"', '"quad"', "{ mesh = { 2, 2 } }"],
    "contact law": ["a.law", '"dry"', '"none"'], "direction law": ["a.spring"],
    "solid law": ["trilith.j2 { E = 1e8, nu = 0.2, yield = 1e5 }"],
}
# These run processes, end the program, or read names that are made up elsewhere.
LEFT_OUT = {"trilith.study", "trilith.params", "trilith.version"}


class Declared:
    def __init__(self, name):
        self.name, self.keys, self.arguments = name, [], []


def declarations(program):
    """Every call of the interface: its keys and arguments as (name, kind, needed), from the program's own manual."""
    def manual(*words):
        return subprocess.run([program, "manual", *words], capture_output=True, text=True, check=True).stdout
    calls, fields = [], set()
    for page in manual("--pages").split():
        rows = None
        for line in manual(page, "--markdown").splitlines():
            title = re.match(r"### `([\w.:]+)[({]", line)
            if title:
                calls.append(Declared(title[1]))
            elif line.startswith("| key ") and calls:
                rows = calls[-1].keys
            elif line.startswith("| argument ") and calls:
                rows = calls[-1].arguments
            elif not line.startswith("|"):
                rows = None
            cells = re.match(r"\| `(\w+)` \| ([^|]*?) \|[^|]*\| ?([^|]*?) ?\|", line)
            if cells and rows is not None:
                rows.append((cells[1], cells[2], cells[3] == "needed"))
            if cells and page == "fields":
                fields.add(cells[1])
    fields |= {"x", "y", "time", "mass", "name", "force", "worst"}
    return [c for c in calls if c.name not in LEFT_OUT], sorted(fields)


def value(draw, kind, wild):
    if draw.random() < wild:
        return draw.choice(CLOSE.get(draw.choice(kind.split(" or ")), WILD) if draw.random() < 0.6 else WILD)
    kinds = [k for k in kind.split(" or ") if k in SANE]
    return draw.choice(SANE[draw.choice(kinds)] if kinds else SANE["text"])


def fresh_name(draw):
    return f'"n{draw.randrange(1000)}"'


def call(draw, declared, wild):
    who = {"model": "a.model", "motion": "a.motion", "set": "a.set", "body": "a.body"}
    name = declared.name
    if ":" in name:
        kind, method = name.split(":")
        subject = who.get(kind, "a.model")
        if draw.random() < 0.05:
            subject = draw.choice(["b.model", "b.body", "b.motion", "b.set"])
        name = f"{subject}:{method}"
    if declared.arguments and (not declared.keys or draw.random() < 0.5):
        given = [value(draw, kind, wild) for _, kind, _ in declared.arguments]
        least = 0 if draw.random() < 0.1 else sum(needed for _, _, needed in declared.arguments)
        return f"{name}({', '.join(given[:draw.randint(least, len(given))])})"
    many = draw.choice([0.1, 0.3, 0.7])
    keys = [f"{key} = {fresh_name(draw) if key == 'name' and draw.random() < 0.7 else value(draw, kind, wild)}"
            for key, kind, needed in declared.keys if draw.random() < (0.97 if needed else many)]
    if draw.random() < 0.05:
        keys.append(f"{draw.choice(['frobnicate', '[1]', '[0/1]', '[true]'])} = {draw.choice(WILD)}")
    return f"{name} {{ {', '.join(keys)} }}" if declared.keys or draw.random() < 0.1 else f"{name}()"


def program_text(seed, calls, fields):
    draw = random.Random(seed)
    wild = draw.choice([0.02, 0.1, 0.4])
    lines = [HEAD]
    for number in range(draw.randint(3, 14)):
        dice = draw.random()
        if dice < 0.62:
            what = call(draw, draw.choice(calls), wild)
        elif dice < 0.78:
            what = draw.choice(["a.model:run { duration = 0.05 }", "a.model:consolidate { duration = 0.2 }",
                                "b.model:run { duration = 0.01 }", "a.model:lint()", "collectgarbage()"])
        elif dice < 0.9:
            handle = draw.choice(["model", "body", "mesh", "set", "bearing", "seat", "history", "motion", "law"])
            what = f"{draw.choice('ab')}.{handle}.{draw.choice(fields)}"
        elif dice < 0.96:
            what = f"setmetatable({{}}, {{ __gc = function() return {call(draw, draw.choice(calls), wild)} end }})"
        else:
            event = draw.choice(["*", "impact", "stage.begun"])
            what = f'a.model:on("{event}", function() return {call(draw, draw.choice(calls), wild)} end)'
        # What a call gives may be used by the next ones.
        known = draw.choice(["body", "set", "motion", "law", "spring"])
        target = f"a.{known}" if draw.random() < 0.1 else f"a.v{number}"
        lines.append(f"{target} = try({number}, function() return {what} end) or {target}")
    return "\n".join(lines) + "\n"


def write(path, seed, known):
    with open(path, "w", encoding="utf8") as script:
        script.write(program_text(seed, *known))


def command_of(program, path, draw):
    words = [program, "run", "-q", os.path.basename(path)]
    if draw.random() < 0.1:
        words += ["--results", "run.h5"]
    return words
