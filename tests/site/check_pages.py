#!/usr/bin/env python3
"""Checks the form of the Markdown pages without the tools of the site: check_pages.py [SOURCE]

Each page begins with a sentence on its use. Guides have an example in their first section, and pages on scripts are short.
Blocks of code have a language of the site. The reference lists each function once with an example and its keys in a table.
Each searched term is in the title, a heading or the synonyms of its page."""
import os
import re
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "../../docs/site"))
sys.dont_write_bytecode = True
import stage  # noqa: E402
from searches import SEARCHES  # noqa: E402

BEGINS = re.compile(r"(After this page|With this page|This page|These pages|This example|Trilith simulates) ")
WITH_EXAMPLE = re.compile(r"docs/(scripting|guide|tour)\b|docs/[a-z]+\.md$")
WITHOUT_EXAMPLE = ("docs/README.md", "docs/architecture.md", "docs/glossary.md")
SHORT, MOST_LINES = re.compile(r"docs/(scripting|guide/space)(\.md|/)"), 200
HEADS = {f"| {first} | type | unit | default | {last}meaning |" for first in ("key", "argument") for last in ("", "range | ")}
HEADS.add("| field | type | unit | meaning |")


def paragraphs(text):
    return [part.strip() for part in re.sub(r"^# .+$", "", text, count=1, flags=re.M).split("\n\n") if part.strip()]


def form_of(page, text):
    """Errors in the beginning and the length of a page."""
    first = paragraphs(text)[0] if paragraphs(text) else ""
    if not re.match(r"docs/(decisions/.*\d{4}-|reference/)", page) and not BEGINS.match(first):
        yield f"{page}: begins with '{first[:50]}'; begin with what the reader can do after it: 'After this page you can ...'"
    if WITH_EXAMPLE.match(page) and page not in WITHOUT_EXAMPLE:
        beginning = re.split(r"^## ", text, flags=re.M)[:2]
        if "```" not in "".join(beginning):
            yield f"{page}: has no example before its second heading"
    lines = text.rstrip("\n").count("\n") + 1
    if SHORT.match(page) and lines > MOST_LINES:
        yield f"{page}: has {lines} lines, at most {MOST_LINES}; make a page of a part of it"


def languages_of(page, text):
    opened = False
    for number, line in enumerate(text.split("\n"), 1):
        fence = re.match(r"\s*```+(\w*)", line)
        if not fence:
            continue
        opened = not opened
        if opened and fence[1] and fence[1] not in stage.LANGUAGES:
            yield f"{page}:{number}: the site has no language '{fence[1]}'; known: {', '.join(stage.LANGUAGES)}"


def reference(pages):
    """Each function once, with an example; tables of keys with their columns."""
    known = {}
    for page, text in pages.items():
        for entry in re.split(r"^### ", text, flags=re.M)[1:]:
            name = entry.split("\n")[0].strip("`")
            if name in known:
                yield f"{page}: {name} is listed in {known[name]} too"
            known[name] = page
            heads = re.findall(r"^(\|.*\|)\n\|---", entry, re.M)
            yield from (f"{page}: {name} has a table with the head '{head}'" for head in heads if head not in HEADS)
            is_function = not any(head.startswith("| field |") for head in heads)
            if is_function and "```lua" not in entry:
                yield f"{page}: {name} has no example; add one to `examples` in lua/manual"


def searched(source, pages, searches):
    synonyms = stage.synonyms(source)
    for term, page in searches.items():
        text = pages.get(page + ".md", "")
        places = re.findall(r"^#+ (.+)$", text, re.M) + re.findall(r"^\| `([^`]+)` \|", text, re.M) + synonyms.get(page + ".md", [])
        if not any(term.lower() in place.lower() for place in places):
            yield f"{page}.md: '{term}' is in no heading; add it to docs/site/synonyms.txt"


def main(source=os.path.join(HERE, "../.."), searches=None):
    pages = {page: stage.read(os.path.join(source, page)) for page in stage.pages_of(source)}
    found = []
    for page, text in pages.items():
        found += form_of(page, text)
        found += languages_of(page, text)
    found += reference({page: text for page, text in pages.items() if page.startswith("docs/reference/")})
    found += searched(source, pages, SEARCHES if searches is None else searches)
    print("".join(line + "\n" for line in found), end="")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
