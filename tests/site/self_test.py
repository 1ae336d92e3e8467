#!/usr/bin/env python3
"""The checks of links and pages accept a correct tree and report each kind of error; the staged pages have links, menu and index."""
import contextlib
import io
import os
import sys
import tempfile

import check_links
import check_pages
from check_links import stage

PAGES = {
    "README.md": "# Start\n\n[guide](docs/guide/a.md#two-words) [code](scripts/x.lua) [all](docs/decisions)\n",
    "CONTRIBUTING.md": "# Contributing\n",
    "LICENSE": "MIT\n",
    "docs/README.md": "# Documentation\n\n[start](../README.md) `scripts/x.lua`\n",
    "docs/guide/a.md": "# A page\n\n## Two words\n\n## Two words\n\n[again](#two-words-1)\n\n```sh\n[no link](nowhere.md)\n```\n",
    "docs/gallery/wall.md": "# A wall\n\nA wall of stones. It stands.\n\n![wall](wall.png)\n",
    "docs/gallery/wall.png": "",
    "docs/decisions/code/0001-first.md": "# 1. First\n",
    "docs/reference/laws.md": "# Laws\n\n### `trilith.bonded{...}`\n\n| key | is |\n|---|---|\n| `kn` | number |\n\n### `event type`\n\n"
                              "| field | is |\n|---|---|\n| `seat.lost` | speed |\n",
    "docs/glossary.md": "# Glossary\n\n| term | meaning | unit | symbol | key |\n|---|---|---|---|---|\n| stiffness | of a joint | Pa/m | | `kn` |\n",
    "docs/site/navigation.txt": "Start\n  docs/README.md\nAll\n  docs/guide/*.md\n  docs/gallery/*.md\n  docs/reference/*.md\n  docs/*.md\n"
                                "  docs/decisions/index.md\n  scripts/index.md\n  CONTRIBUTING.md\n  genindex\n",
    "docs/site/synonyms.txt": "rigidity; docs/glossary.md\n",
    "scripts/x.lua": "-- A script.\nlocal m = 1\n",
}
WRONG = [  # a change, and a part of the line that it must give
    ("docs/guide/a.md", "# A\n\n[x](b.md)\n", "docs/guide/a.md:3: leads to b.md, which does not exist"),
    ("docs/guide/a.md", "# A\n\n[x](../README.md#no)\n", "../README.md has no heading #no"),
    ("docs/guide/a.md", "# A\n\n## Two words\n\n[x](#two-words-1)\n", "has no heading #two-words-1; near: two-words"),
    ("docs/guide/a.md", "# A\n\n## Two words\n\n![x](no.png)\n", "leads to no.png"),
    ("docs/guide/a.md", "No title\n\n## Two words\n", "docs/guide/a.md: has no title"),
    ("docs/theory/t.md", "# Theory\n", "navigation.txt names no section for docs/theory/t.md"),
    ("docs/site/synonyms.txt", "word; docs/no.md\n", "synonyms.txt: there is no page docs/no.md"),
    ("engine/a.hpp", "// See docs/theory/no.md.\n", "engine/a.hpp:1: names docs/theory/no.md, which does not exist"),
    ("docs/glossary.md", PAGES["docs/glossary.md"].replace("`kn`", "`knn`"), "the reference has no key or event knn"),
    ("docs/glossary.md", PAGES["docs/glossary.md"].replace("`kn`", "`trilith.bond`"), "the reference has no trilith.bond"),
]


FUNCTION = ("# Laws\n\n### `trilith.bonded{...}`\n\nA bond.\n\n```lua\nlocal law = 1\n```\n\n"
            "| key | type | unit | default | meaning |\n|---|---|---|---|---|\n| `kn` | number | | needed | stiffness |\n")
GUIDE = "# A page\n\nAfter this page you can stack.\n\n```lua\nlocal m = 1\n```\n\n## Detail\n"
RIGHT_PAGES = {"README.md": "# Start\n\nTrilith simulates stones.\n", "CONTRIBUTING.md": "# Contributing\n\nThis page is short.\n",
               "docs/guide/a.md": GUIDE, "docs/scripting.md": GUIDE, "docs/reference/laws.md": FUNCTION,
               "docs/site/synonyms.txt": "rigidity; docs/guide/a.md\n"}
WRONG_PAGES = [
    ("docs/guide/a.md", GUIDE.replace("After this page you", "You"), "docs/guide/a.md: begins with 'You can stack.'"),
    ("docs/guide/a.md", GUIDE.replace("```lua\nlocal m = 1\n```", "Text."), "docs/guide/a.md: has no example before its second heading"),
    ("docs/guide/a.md", GUIDE.replace("```lua", "```lau"), "docs/guide/a.md:5: the site has no language 'lau'"),
    ("docs/scripting.md", GUIDE + "line\n" * 200, "docs/scripting.md: has 209 lines, at most 200"),
    ("docs/reference/laws.md", FUNCTION.replace("```lua\nlocal law = 1\n```", ""), "trilith.bonded{...} has no example"),
    ("docs/reference/laws.md", FUNCTION.replace("| unit ", "| in "), "has a table with the head '| key | type | in | default | meaning |'"),
    ("docs/reference/more.md", FUNCTION, "trilith.bonded{...} is listed in docs/reference/laws.md too"),
    ("docs/site/synonyms.txt", "", "docs/guide/a.md: 'rigidity' is in no heading"),
]


def lines_of(pages, check=check_links.main):
    with tempfile.TemporaryDirectory() as folder:
        for path, text in pages.items():
            stage.write(os.path.join(folder, path), text)
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            code = check(folder)
        return code, out.getvalue()


def check_of_pages(folder):
    return check_pages.main(folder, {"rigidity": "docs/guide/a"})


def compared(right, wrong, check):
    """The check accepts the correct tree, and reports each wrong one with its line."""
    code, out = lines_of(right, check)
    yield from [f"a right tree gives {code}: {out}"] if code or out else []
    for path, text, line in wrong:
        code, out = lines_of({**right, path: text}, check)
        yield from [f"{path} = {text!r} gives {code} and {out!r}, not {line!r}"] if code != 1 or line not in out else []


def staged():
    with tempfile.TemporaryDirectory() as folder:
        for path, text in PAGES.items():
            stage.write(os.path.join(folder, "in", path), text)
        stage.main(os.path.join(folder, "in"), os.path.join(folder, "out"))
        wanted = {
            "index.md": ["(docs/guide/a.md#two-words)", "(scripts/x.md)", "(docs/decisions/index.md)", ":caption: Start\n\ndocs/README\n",
                         "docs/gallery/index\ndocs/gallery/wall\n", "<genindex>"],
            "docs/README.md": ["[start](../index.md)", "[`scripts/x.lua`](../scripts/x.md)"],
            "docs/reference/laws.md": ["single: trilith.bonded\n", "single: kn; of trilith.bonded\n", "single: seat.lost (event)\n"],
            "docs/glossary.md": ["single: stiffness (term)\n", "single: rigidity\n"],
            "docs/gallery/index.md": ["**A wall**", "A wall of stones.\n", "![A wall](wall.png)"],
            "docs/decisions/index.md": ["[1. First](code/0001-first.md)", "\ncode/0001-first\n"],
            "scripts/x.md": ["# x.lua\n\nA script.\n", "```lua\nlocal m = 1\n```"],
        }
        for path, parts in wanted.items():
            text = stage.read(os.path.join(folder, "out", path))
            yield from (f"{path} has no {part!r}:\n{text}" for part in parts if part not in text)


def main():
    errors = [*staged(), *compared(PAGES, WRONG, check_links.main), *compared(RIGHT_PAGES, WRONG_PAGES, check_of_pages)]
    print("".join(line + "\n" for line in errors), end="")
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
