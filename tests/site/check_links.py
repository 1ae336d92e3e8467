#!/usr/bin/env python3
"""Checks links of the Markdown pages without the tools of the site: check_links.py [SOURCE]

Files and anchors that links lead to exist, and so do pages that code names. Each page has a title and a section of the menu.
Functions that the glossary names are in the reference."""
import os
import re
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "../../docs/site"))
sys.dont_write_bytecode = True
import stage  # noqa: E402


def without_code(text):
    """The text with fences and inline code blanked; lines stay."""
    text = re.sub(r"^(\s*)(```+|~~~+).*?^\s*\2\s*$", lambda m: "\n" * m[0].count("\n"), text, flags=re.M | re.S)
    return re.sub(r"(`+)(?!`).+?(?<!`)\1(?!`)", lambda m: "x" * len(m[0]), text)


def slug(heading):
    """The anchor that GitHub and MyST give a heading."""
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)
    text = re.sub(r"[^\w\- ]", "", text.strip().lower())
    return text.replace(" ", "-")


def anchors(path):
    text = stage.read(path)
    text = re.sub(r"^(\s*)(```+|~~~+).*?^\s*\2\s*$", "", text, flags=re.M | re.S)
    found = {}
    for heading in re.findall(r"^#{1,6} +(.+?) *#*$", text, re.M):
        name = slug(heading)
        found[name] = found.get(name, -1) + 1
    return {f"{name}-{n}" if n else name for name, count in found.items() for n in range(count + 1)}


def links_of(source, page, known):
    folder = os.path.dirname(os.path.join(source, page))
    for number, line in enumerate(without_code(stage.read(os.path.join(source, page))).split("\n"), 1):
        for target in re.findall(r"\]\(<?([^)\s>]+)>?(?: \"[^\"]*\")?\)", line):
            if re.match(r"\w+:", target):
                continue
            path, _, anchor = target.partition("#")
            to = os.path.normpath(os.path.join(folder, path)) if path else os.path.join(source, page)
            if not os.path.exists(to):
                yield f"{page}:{number}: leads to {target}, which does not exist"
            elif anchor and to.endswith(".md"):
                if to not in known:
                    known[to] = anchors(to)
                if anchor not in known[to]:
                    near = [a for a in known[to] if a.split("-")[0] == anchor.split("-")[0]]
                    hint = f"; near: {', '.join(sorted(near)[:3])}" if near else ""
                    yield f"{page}:{number}: {path or page} has no heading #{anchor}{hint}"


def glossary(source):
    reference = "".join(stage.read(os.path.join(source, p)) for p in stage.walk(source, "docs/reference", ".md"))
    reference = set(re.findall(r"\b[a-z_]+[:.][a-z0-9_]+(?:\.[a-z_]+)?", reference))
    fields = set(re.findall(r"^\| `(\w+(?:\.\w+)?)`", "".join(stage.read(os.path.join(source, p))
                                                        for p in stage.walk(source, "docs/reference", ".md")), re.M))
    for number, line in enumerate(stage.read(os.path.join(source, "docs/glossary.md")).split("\n"), 1):
        if not line.startswith("|"):
            continue
        key = line.rsplit("|", 2)[-2]
        for name in re.findall(r"`((?:m|space|motion|trilith|body|storey|seat|bearing|event)[:.][a-z0-9_]+)`", key):
            whole, last = re.sub(r"^m:", "model:", name), re.split(r"[:.]", name)[-1]
            if whole not in reference and last not in fields:
                yield f"docs/glossary.md:{number}: the reference has no {name}"
        for name in re.findall(r"`([a-z_]+(?:\.[a-z_]+)?)`", key):
            if "." in name and name.split(".")[0] in ("m", "space", "motion", "trilith", "body", "storey", "seat", "bearing", "event"):
                continue
            if name not in fields and f"`{name}" not in line.split("|")[1]:
                yield f"docs/glossary.md:{number}: the reference has no key or event {name}"


def named_in_code(source):
    """Pages that comments and messages of the code name by their path."""
    for top in ("engine", "lua", "tests", "scripts", "cmake", ".ci"):
        for path in stage.walk(source, top, (".cpp", ".hpp", ".lua", ".py", ".js", ".txt", ".cmake", "check", "run", "tidy", "make")):
            if path.startswith("tests/site/"):
                continue
            for number, line in enumerate(stage.read(os.path.join(source, path)).split("\n"), 1):
                for page in re.findall(r"\bdocs/[\w/-]+\.md\b", line):
                    if not os.path.exists(os.path.join(source, page)):
                        yield f"{path}:{number}: names {page}, which does not exist"


def main(source=os.path.join(HERE, "../..")):
    source, found, known = os.path.abspath(source), [], {}
    pages = stage.pages_of(source)
    for page in pages:
        found += links_of(source, page, known)
        if not stage.title_of(stage.read(os.path.join(source, page))):
            found.append(f"{page}: has no title ('# ...')")
    found += [f"docs/site/navigation.txt names no section for {page}" for page in stage.menu(source, pages + list(stage.MADE))[1]]
    found += [f"docs/site/synonyms.txt: there is no page {page}" for page in stage.synonyms(source) if page not in pages]
    found += named_in_code(source)
    if os.path.exists(os.path.join(source, "docs/glossary.md")):
        found += glossary(source)
    print("".join(line + "\n" for line in found), end="")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
