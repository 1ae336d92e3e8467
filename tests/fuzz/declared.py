"""The Lua interface as the program declares it (trilith manual), and values for its arguments."""
import re
import subprocess

# Plausible values, by declared kind.
SANE = {
    "number": ["0.1", "0.5", "1", "2", "3", "10", "1e3", "1e6", "0.01"],
    "integer": ["1", "2", "3", "5"],
    "flag": ["true", "false"],
    "text": ['"stone"', '"x"', '"dry"', '"rest"', '"link"', '"low"', '"top"', '"y"', '"impact"', '"*"'],
    "names": ['"stone"', '{ "stone", "soft" }', '"pile"', '{ "low", "high" }', '{ "dry" }'],
    "point": ["{ 0, 0 }", "{ 0, 0.5 }", "{ 3, 0 }", "{ -0.5, 1 }", "{ 2, 3 }"],
    "points": ["{ { 4, 0 }, { 5, 0 }, { 5, 1 } }", "{ { 0, 4 }, { 1, 4 }, { 0.5, 4.1 }, { 0, 5 } }"],
    "vector": ["{ 0, 0, 0 }", "{ 0, 0, 1 }", "{ 3, 0, 0.5 }", "{ 1, 1, 0.5 }", "{ -0.5, 1, 2 }"],
    "vectors": ["{ { 4, 0, 0 }, { 5, 0, 0 }, { 4, 1, 0 }, { 4, 0, 1 } }",
                "{ { 0, 4, 0 }, { 1, 4, 0 }, { 1, 5, 0 }, { 0, 5, 0 }, { 0, 4, 1 }, { 1, 4, 1 }, { 1, 5, 1 }, { 0, 5, 1 } }"],
    "place": ['"top"', '"centroid"', "{ 0, 0.2 }"],
    "bodies": ["a.body", "a.set", "a.mesh", '"low"', "{ a.body, a.mesh }", '"pile"'],
    "two bodies": ["{ a.body, a.base }", '{ "low", "high" }'],
    "body": ["a.body", "a.mesh", '"high"', "a.base"],
    "storeys": ["{ a.set }", "{ a.body, a.mesh }"],
    "bearing": ["a.bearing", '"link"'], "seat": ["a.seat", '"rest"'],
    "motion": ["a.motion", "trilith.motion { velocity = 0.1, duration = 0.1 }"],
    "numbers": ["{ 0, 1, 0, -1, 0 }", "{ 0.1, 0.2 }"],
    "function": ["function() end", "function(m) return m.time end", "function(m) return m end"],
    "table": ["{ along = 0.1 }", "{ { 0, 1 } }", "{ mu = 0.3 }", "{ x = { 1, 2 } }"],
    "list": ["{ a.body, a.base }", "{ { width = 1, height = 1 } }", "{ { body = a.base, x = a.motion } }",
             "{ { 0, 1 }, { 1, 2 } }", "{ { x = 1 }, { x = 2 } }"],
    "rest": ["true", "{ speed = 1e-3, hold = 0.01 }"], "load curve": ["0.5", "{ ramp = 0.1 }", "{ { 0, 0 }, { 1, 1 } }"],
    "level": ["2", "{ { 0, 1 }, { 1, 2 } }"], "course": ["2", "{ { 0, 1 }, { 1, 2 }, period = 3 }"], "planes": ["\"mid\"", "2", "false", "{ { { 0, 0 }, { 1, 0 } } }"],
    "body form": ['"rigid"', '"quad"', "{ mesh = { 2, 2 } }"],
    "contact law": ["a.law", '"dry"', '"none"'], "law": ["a.law"], "direction law": ["a.spring"],
    "hinge law": ["trilith.end_hinge { sagging = 1e4 }", "trilith.end_hinge { sagging = 1e4, across = 2e4, ultimate = 0.05 }"],
    "fibre law": ["trilith.kent_park { strength = 30e6 }", "trilith.bilinear_steel { E = 2e11, yield = 4e8 }"],
    "solid law": ["trilith.j2 { E = 1e8, nu = 0.2, yield = 1e5 }"],
    "section": ["trilith.rectangle_section { width = 0.2, depth = 0.3 }", "trilith.circle_section { diameter = 0.3 }"],
}
# Plausible values for keys with the name of a required part of a model.
BY_NAME = {"joints": ['{ A = { 3, 1 }, B = { 3, 4 }, C = { at = { 5, 4 }, mass = 10 } }'],
           "members": ["{ { from = 'A', to = 'B', section = trilith.rectangle_section { width = 0.2, depth = 0.3 } }, "
                       "{ from = 'B', to = 'C', pinned = 'to', section = trilith.circle_section { diameter = 0.3 } } }"],
           "beams": ["{ along = 'x', count = 2, width = 0.1 }", "{ { along = 'y', spacing = 0.5, width = 0.1, bearing = 0.1 } }"],
           "pinned": ['"from"', '{ "from", "to" }'], "from_support": ['"fixed"'], "to_support": ['{ x = "fixed" }'],
           "material": ['"stone"', '"soft"'], "what": ['"y"', '"speed"', '"force_along"', '"length"', '"drift"']}
# Values of models in space for kinds and names with two coordinates in the plane.
IN_SPACE = {"point": SANE["vector"], "points": SANE["vectors"],
            "place": ['"centroid"', "{ 0, 0, 0.2 }", "{ 0.2, 0.1, 0.1 }"],
            "body form": ['"rigid"', '"brick"', "{ mesh = { 1, 2, 1 } }", '{ mesh = { 1, 1, 1 }, element = "tet10" }'],
            "list": ["{ a.body, a.base }", "{ { body = a.base, x = a.motion } }", "{ { 0, 1 }, { 1, 2 } }",
                     "{ { body = a.base, z = a.motion, rotation_x = a.motion } }", "{ { x = 1 }, { y = 2 } }"]}
BY_NAME_IN_SPACE = {"joints": ["{ A = { 3, 1, 0 }, B = { 3, 1, 3 }, C = { at = { 5, 1, 3 }, mass = 10 } }"],
                    "size": ["{ 1, 1, 1 }", "{ 0.5, 0.4, 0.3 }"], "divisions": ["{ 1, 1, 1 }", "2"],
                    "outline": ["{ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }", "{ { 3, 3 }, { 4, 3 }, { 3.5, 4 } }"],
                    "what": ['"z"', '"uz"', '"speed"', '"force_along"', '"rotation_x"'],
                    "spheres": ["{ { at = { 3, 3, 1 }, radius = 0.2 }, { at = { 3.2, 3, 1 }, radius = 0.2 } }"],
                    "force": ["{ 0, 0, -1e3 }", "{ 1e3, 0, 0 }"], "axis": ["{ 0, 0, 1 }", '"x"'],
                    "face": ['"top"', '"front"'], "direction": ['"x"', "{ 0, 1, 0 }"]}
# Values that are wrong for every key.
WILD = ["0/0", "1/0", "-1/0", "0", "-1", "1e308", "-1e308", "1e-308", "2^31", "2^53", "-2^63", "math.mininteger", "1e9",
        "nil", "true", "false", '""', '"*"', '"\\0"', '("x"):rep(5000)', '"\\27[2J"', '"%s%n"', '"a/../b"', "{}", "{ {} }",
        "{ 1 }", "{ 0/0, 1/0 }", "{ a = 1 }", "function() end", "function() error {} end", "function() error() end",
        "print", "coroutine.create(function() end)", "io.stdout", "fuzz.endless",
        'setmetatable({}, { __index = function() error "mine" end })',
        "setmetatable({}, { __len = function() return -5 end })", "a.model", "b.model", "b.body", "b.set", "b.bearing",
        "b.seat", "b.history", "a.model.worst", "a.motion", "b.law", "a.spring", "a.none"]
# Wrong values of the right kind pass more checks.
NUMBERS = ["0/0", "1/0", "-1/0", "0", "-1", "-0.0", "1e308", "1e-308", "2^31", "-2^31 - 1", "2^53", "2^63", "-2^63", "1e9",
           "-1e9", "1e-9", "math.pi", '"3"']
WHOLE = ["2^31", "2^31 - 1", "-2^31 - 1", "2^53", "2^62", "2^63", "-2^63", "0", "-1", "0/0", "1e9", "1.5"]
OTHERS = ["a.none", "a.none", "b.body", "b.set", "b.base", "{}", "{ b.body }", '{ "low", "low" }', '"zz*"', "a.base",
          "{ a.base }"]
WORDS = ['""', '"zz"', '"*"', '("*a"):rep(30)', '"\\0a"', '"\\27[31m"', '"\\xff\\xfe"', '"low,high"', '("x"):rep(300)']
FUNCTIONS = ["function() error {} end", 'function() error "mine" end', "function() coroutine.yield() end",
             'function(m) m:wait "impact" end', "function(m) m:wait(0.01) end", "function() return 0/0 end",
             "function() return {} end", "function(m) m:stop() end", "function(m) m:close() end", "a.model.run",
             "function(m) m:run { duration = 0.01 } end", "coroutine.wrap(function() error {} end)",
             "function() a = {} b = {} collectgarbage() end", "function() os.exit(1) end"]
TABLES = ["{}", "{ {} }", "{ 0/0 }", "{ { 0/0, 1 } }", "{ [1] = 1, [3] = 3 }", "{ { 1, 0 }, { 0, 1 } }", "{ b.body }",
          "setmetatable({}, { __index = a })", "{ false }", "{ a = {} }"]
CLOSE = {"number": NUMBERS, "integer": WHOLE, "bodies": OTHERS, "body": OTHERS, "list": OTHERS + TABLES,
         "two bodies": ["{ a.body, b.body }", "{ a.body, a.body }", "{ a.none, a.none }"], "names": OTHERS + WORDS,
         "text": WORDS, "function": FUNCTIONS, "table": TABLES, "numbers": TABLES, "storeys": OTHERS,
         "bearing": ["b.bearing", "a.seat", '"zz"'], "seat": ["b.seat", "a.bearing", '"zz"'], "motion": ["b.motion", "a.model"],
         "contact law": ["b.law", "a.spring"], "law": ["b.law", "a.spring"], "direction law": ["a.law", "b.spring"],
         "points": ["{ { 0, 0 } }", "{ { 0/0, 0 } }", "{ { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 } }", "{ { 0, 0 }, { 0, 0 } }"],
         "point": ["{ 0/0, 0 }", "{ 1e308, -1e308 }", "{ 1 }", "{ 1e9, 1e9 }", "{}", "{ 0, 0, 0 }"],
         "vector": ["{ 0/0, 0, 0 }", "{ 1e308, -1e308, 1 }", "{ 1, 2 }", "{ 1e9, 1e9, 1e9 }", "{}", "{ 0, 0, 0, 0 }"],
         "vectors": ["{ { 0, 0, 0 } }", "{ { 0/0, 0, 0 } }", "{ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 } }"],
         "hinge law": ["b.law", "a.spring"], "fibre law": ["a.law", "trilith.end_hinge { sagging = 1 }"],
         "place": ["{ 0/0, 0 }", '"nowhere"', "{ 1e9, 0 }"]}
# These end the program, run for long, or read names that are made up elsewhere.
LEFT_OUT = {"trilith.params", "trilith.version"}
# Runs processes: only in studies.py.
STUDY = "trilith.study"


class Call:
    """A call of the interface: keys and arguments are rows (name, kind, needed, words that its declaration mentions)."""

    def __init__(self, name):
        self.name, self.keys, self.arguments = name, [], []
        self.bodies = None  # where it takes the keys of bodies: how many keys are its own
        self.others = []  # builders without a model that take the same keys


def row_of(cells):
    description = f"{cells[4]} {cells[5] if len(cells) > 5 else ''}"
    return cells[0].strip("`"), cells[1], "needed" in cells, sorted(set(re.findall(r"\b[a-z_]{2,}\b", description)))


def declarations(program):
    """Every call, and the names of all fields that can be read."""
    def manual(*words):
        return subprocess.run([program, "manual", *words], capture_output=True, text=True, check=True).stdout
    calls, fields = [], set()
    for page in manual("--pages").split():
        rows = None
        for line in manual(page, "--markdown").splitlines():
            title = re.match(r"### `([\w.:]+)[({]", line)
            cells = [cell.strip() for cell in line.strip("|").split("|")]
            if title:
                calls.append(Call(title[1]))
            elif line.startswith(("| key ", "| argument ")) and calls:
                rows = calls[-1].keys if line.startswith("| key ") else calls[-1].arguments
            elif line.startswith("Further keys"):
                calls[-1].bodies = len(calls[-1].keys)
            elif line.startswith("Also without a model:"):
                calls[-1].others = re.findall(r"`([\w.]+)[({]", line)
            elif not line.startswith("|"):
                rows = None
            elif line.startswith("| `") and page == "fields":
                fields.add(cells[0].strip("`"))
            elif line.startswith("| `") and rows is not None:
                rows.append(row_of(cells))
    body = next(call for call in calls if call.name == "model:body")
    for call in list(calls):
        for name in call.others:
            other = Call(name)
            other.keys, other.arguments = call.keys[:call.bodies], list(call.arguments)
            calls.append(other)
    for call in calls:
        if call.bodies is not None and call is not body:
            call.keys += body.keys[body.bodies:]
    return [c for c in calls if c.name not in LEFT_OUT], sorted(fields | {"x", "y", "time", "mass", "name"})


def weight(row):
    """Frequency with which the argument is made invalid. Handles, names and counts have had the most errors."""
    return 4 if any(word in row[1] for word in ("bod", "bearing", "seat", "storey", "list", "motion", "integer", "law")) else 1


def kinds_of(kind):
    return [kind] if kind in SANE else kind.split(" or ")


def sane(draw, row, dim=2):
    """A probably valid value for the row of a declaration in a model of `dim` dimensions."""
    name, kind, _, words = row
    kinds = [k for k in kinds_of(kind) if k in SANE]
    if dim == 3 and name in BY_NAME_IN_SPACE and draw.random() < 0.7:
        return draw.choice(BY_NAME_IN_SPACE[name])
    in_space = [k for k in kinds if k in IN_SPACE]
    if dim == 3 and in_space and draw.random() < 0.85:
        return draw.choice(IN_SPACE[draw.choice(in_space)])
    if name in BY_NAME and draw.random() < 0.8:
        return draw.choice(BY_NAME[name])
    if name == "name" and draw.random() < 0.7:
        return f'"n{draw.randrange(1000)}"'
    if (not kinds or "text" in kinds) and words and draw.random() < 0.6:
        return f'"{draw.choice(words)}"'
    return draw.choice(SANE[draw.choice(kinds or ["text"])])


def odd(draw, row):
    """A wrong or unusual value."""
    close = [k for k in kinds_of(row[1]) if k in CLOSE]
    return draw.choice(CLOSE[draw.choice(close)] if close and draw.random() < 0.7 else WILD)
