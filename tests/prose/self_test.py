#!/usr/bin/env python3
"""The prose check reports each construction: a small grid of sentences for each rule, of places and of kinds of files."""
import sys

import extract
import rules

WRONG = {
    "leading-zero": ["a ratio of .5", "takes -.25 m", "(.02 s)"],
    "who": ["a body who stands", "The step who is looked up."],
    "what": ["It holds what stands.", "What flies past wakes none."],
    "that-of": ["longer than that of a beam", "as those of the plane"],
    "pointing": ["That is slow.", "it keeps those that touch", "the one which moves", "the same of its end", "the former holds"],
    "as-pays": ["explicitly or as pays"],
    "goes-by": ["it goes by the mass", "who goes with whom"],
    "comes-to": ["the sum comes to 5 N"],
    "is-told": ["the value is told"],
    "persons": ["the page tells more", "the solver wants a step"],
    "since": ["as of since"],
    "beside": ["one file beside another"],
    "dialect": ["led to and fro", "0.5 as preset", "energy given off", "the run begins anew", "the joint as it stands", "it changes no bit", "runs in a closed room", "the wall comes down"],
    "begin": ["at the begin of a step", "from its begin"],
    "is-no": ["the text is no number", "faces that are no pair"],
    "says-so": ["then the program says so"],
    "some": ["some percent of the time", "some ten steps", "some hundred joints"],
    "sentence": ["word " * 36 + "end."],
}
RIGHT = ["A ratio of 0.5 at v1.2 in file.5a of {:.3g} and %.2f, section 3.1.", "People who read it know what to do.", "What is a gap?",
         "The block comes to rest.", "The step has been limited since version 1.0.", "It tells apart two cases.", "word " * 34 + "end.",
         "Install it with `what .5`.", "There is no number, and it is no longer than 2 m.", "Lines that begin with a blank.", "Some bodies move."]
FILES = [
    ("md", "# What it does\n\nIt is .5 m.\n", {("leading-zero", 3)}),
    ("md", "| a | b |\n|---|---|\n| of .5 | fine |\n", {("leading-zero", 3)}),
    ("md", "```lua\nx = 1 -- what\ny = .5\n```\n", {("leading-zero", 3)}),
    ("md", "One sentence here.\nAnother holds\nwhat stands.\n", {("what", 2)}),
    ("md", "- the first\n- what stands\n", {("what", 2)}),
    ("cpp", "int a; // a body\n// holds what stands\nint what;\n", {("what", 1)}),
    ("cpp", 'auto s = "this is // what it " // no\n  "holds of .5 m";', set()),
    ("cpp", "// The sum:\n//\n//     " + "x + " * 20 + "\n" + "// more words " * 9 + "\n", set()),
    ("cpp", "// " + "word " * 20 + "\n// - " + "word " * 20 + "\n", set()),
    ("cpp", "//     holds what stands\n", {("what", 1)}),
    ("lua", "-- a body\n-- who stands\nlocal who = 'who is not read'\n", {("who", 1)}),
    ("lua", "--[[ a body who\nstands ]]\n", {("who", 1)}),
    ("script", "#!/bin/sh\n# a body who stands\n", {("who", 2)}),
    ("py", "# a body who stands\nwho = '#'\n", {("who", 1)}),
    ("py", 'def f():\n    """One line.\n\n    It holds what\n    stands."""\n    return """what stands here"""\n', {("what", 4)}),
]
STRINGS = [("cpp", 'f("the body who", "x", "it " "surely holds .5 m"); // what stands here', {("who", 1), ("leading-zero", 1)}),
           ("html", '<p class="who">a body who stands</p>\n<b title="it surely holds .5 m"></b>', {("who", 1), ("leading-zero", 2)}),
           ("script", "x=1 # a body who stands", set()),
           ("lua", "error('a body who stands') -- what stands here", {("who", 1)}),
           ("lua", "f [[what  text?  a body who stands\nm:history { what = 'ux' }\nIt surely holds\nwhat stands.]]", {("who", 1), ("what", 3)}),
           ("lua", "error(\"'what' is given here\")", set())]


def of_file(extension, source, strings=False):
    parts = extract.markdown(source) if extension == "md" else extract.code(source, extension, strings)
    found = set()
    for line, text, kind in parts:
        if kind == "code" and rules.BARE_NUMBER.search(text):
            found.add(("leading-zero", line))
        elif kind in ("text", "heading"):
            found |= {(rule, line) for rule, _, _ in rules.findings(text, kind == "heading")}
    return found


def main():
    errors = []
    for rule, sentences in WRONG.items():
        errors += [f"{rule} misses: {s[:60]}" for s in sentences if rule not in [f[0] for f in rules.findings(s)]]
    errors += [f"{list(rules.findings(extract.plain(s)))} wrongly found in: {s}" for s in RIGHT if list(rules.findings(extract.plain(s)))]
    errors += [f"no wrong sentence for rule {rule}" for rule in rules.NAMES if rule not in WRONG and rule != "line"]
    for strings, cases in ((False, FILES), (True, STRINGS)):
        for extension, source, wanted in cases:
            found = of_file(extension, source, strings)
            errors += [f"{extension}: {source!r} gives {found}, not {wanted}"] if found != wanted else []
    named = extract.test_names('int a;\nTEST_CASE(\n    "a block") {}\nadd_test(NAME "a wall" COMMAND x)\n')
    errors += [f"names of tests: {named}"] if named != [(2, "a block", "text"), (4, "a wall", "text")] else []
    print("".join(line + "\n" for line in errors), end="")
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
