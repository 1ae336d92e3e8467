"""The project's own scripts with a few tokens changed, cut short after some steps."""
import glob
import os
import random
import re

import shared

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
NUMBERS = ["0", "-1", "1e308", "-1e308", "1e-308", "(0/0)", "(1/0)", "1e9", "1e6", "2^53", "0.1", "1", "2", "1e-9"]
TOKEN = re.compile(r'"[^"\n]*"|\b\d+(?:\.\d+)?(?:e[-+]?\d+)?\b|\b[a-z_]\w*\b|[-+*/^=,{}().:]', re.I)
# Placed on the first line, so that line numbers stay the same: each stage of each model ends after some steps.
SHORT = ('do local t = require "trilith" local make = t.model t.model = function(...) local m, n = make(...), 0 '
         "m:on_step(function() n = n + 1 if n % 40 == 0 then m:stop() end end) return m end "
         "local p = print print = function(...) p('printed', ...) end end ")


def changed(draw, text):
    for _ in range(draw.randint(1, 3)):
        found = draw.choice(list(TOKEN.finditer(text)))
        token, others = found[0], TOKEN.findall(text)
        if token[0].isdigit():
            new = draw.choice(NUMBERS)
        elif draw.random() < 0.6:
            new = draw.choice([other for other in others if (other[0] == '"') == (token[0] == '"')])
        else:
            new = draw.choice(["", "nil", "{}", '""', f"{token} {token}", "false", draw.choice(others)])
        text = text[:found.start()] + new + text[found.end():]
    return text


def fuzz(program, until, seed, findings):
    path = os.path.abspath(program)
    scripts = {}
    for name in sorted(glob.glob(os.path.join(ROOT, "scripts", "**", "*.lua"), recursive=True)):
        with open(name, encoding="utf8") as file:
            text = file.read()
        if "trilith.study" not in text:  # those are for words.py
            scripts[os.path.basename(name)] = text

    def work(number):
        draw = random.Random(f"{seed} scripts {number}")
        name = draw.choice(sorted(scripts))
        text = SHORT + changed(draw, scripts[name]).replace("consolidate {", "consolidate { or_go_on = true,")
        shared.attempt(shared.Job("script", f"{path} run -q --script-seconds 5 {name}", {name: text}), findings)
    return f"{len(shared.in_parallel(until, work))} scripts of the project with a change"
