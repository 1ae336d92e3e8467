#!/usr/bin/env python3
"""Copies the Markdown of the tree for the site: stage.py SOURCE TARGET

Paths stay, so that links remain valid. It adds the menu, pages for the scripts, lists of the gallery and the decisions,
and entries of the index."""
import fnmatch
import os
import re
import shutil
import sys
import textwrap

FENCE = re.compile(r"^\s*(```+|~~~+)")
LINK = re.compile(r"(\]\()([^)\s#]+)(#[^)\s]*)?(\))")
CASES = "scripts/verification/"  # listed by the pages of docs/verification
EXPERIMENTS = "scripts/experiments/"  # listed by docs/verification/experiments.md
INSERTED = ("row", "event")  # languages of blocks that tests insert into source files
LANGUAGES = ("lua", "cpp", "sh", "text", "python", "py", "cmake", "json") + INSERTED
MADE = ("docs/gallery/index.md", "docs/decisions/index.md", "scripts/index.md")


def read(path):
    with open(path, encoding="utf8") as f:
        return f.read()


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf8") as f:
        f.write(text)


def walk(source, top, ending):
    return sorted(os.path.relpath(os.path.join(folder, name), source) for folder, _, names in os.walk(os.path.join(source, top))
                  for name in names if name.endswith(ending))


def pages_of(source):
    top = [p for p in ("README.md", "CONTRIBUTING.md", "SECURITY.md") if os.path.exists(os.path.join(source, p))]
    return top + [p for p in walk(source, "docs", ".md") if not p.startswith("docs/site/")]


def navigation(source):
    """[(section, [patterns])]"""
    sections = []
    for line in read(os.path.join(source, "docs/site/navigation.txt")).splitlines():
        if line.startswith("#") or not line.strip():
            continue
        if line.startswith(" "):
            sections[-1][1].append(line.strip())
        else:
            sections.append((line.strip(), []))
    return sections


def menu(source, pages):
    """[(section, [page])], and the pages that no pattern names."""
    left, sections = set(pages) - {"README.md"} | {"genindex"}, []
    front = {p for p in ("docs/decisions/README.md", "docs/decisions/index.md") if p in left}
    left -= {p for p in left if p.startswith("docs/decisions/")} - front
    explicit = {p for _, patterns in navigation(source) for p in patterns if "*" not in p}
    for section, patterns in navigation(source):
        listed = []
        for pattern in patterns:
            depth = pattern.count("/")
            found = sorted(p for p in left if p == pattern or p not in explicit and fnmatch.fnmatch(p, pattern) and p.count("/") == depth)
            left -= set(found)
            listed += found
        sections.append((section, listed))
    return sections, sorted(left)


def title_of(text):
    found = re.search(r"^# (.+)$", text, re.M)
    return found[1].strip() if found else ""


def first_sentence(text):
    body = re.sub(r"^# .+$", "", text, count=1, flags=re.M)
    for paragraph in body.split("\n\n"):
        paragraph = " ".join(paragraph.split())
        if re.match(r"[`A-Z*\[]", paragraph):
            paragraph = LINK.sub("", paragraph).replace("[", "").replace("]", "").replace("**", "")
            return re.split(r"(?<=[a-z`)\d])\.\s", paragraph + " ")[0].rstrip(". ") + "."
    return ""


def moved(target, here, source):
    """The target of a page's link on the site."""
    if re.match(r"\w+:", target):
        return target
    path = os.path.normpath(os.path.join(os.path.dirname(here), target))
    to = path
    if path == "README.md":
        to = "index.md"
    elif path.startswith("scripts/") and path.endswith(".lua"):
        to = path[:-4] + ".md"
    elif os.path.isdir(os.path.join(source, path)):
        names = [name for name in ("README.md", "index.md") if os.path.exists(os.path.join(source, path, name))]
        to = f"{path}/{names[0] if names else 'index.md'}"
        if not names and to not in MADE:
            to = f"{path}/index.md" if path != "docs/theory" else "docs/README.md"
    return target if to == path else os.path.relpath(to, os.path.dirname(here) or ".")


def titled(line, here, source):
    """Replaces link texts that are names of pages by their titles."""
    def title(found):
        path = os.path.normpath(os.path.join(os.path.dirname(here), found[2]))
        if not os.path.basename(path).endswith(os.path.basename(found[1])) or not os.path.isfile(os.path.join(source, path)):
            return found[0]
        return f"[{title_of(read(os.path.join(source, path))) or found[1]}]({found[2]}{found[3] or ''})"
    return re.sub(r"\[`?([\w/.-]+\.md)`?\]\(([^)\s#]+\.md)(#[^)\s]*)?\)", title, line)


def linked(line, here, source):
    line = titled(line, here, source)
    line = LINK.sub(lambda m: m[1] + moved(m[2], here, source) + (m[3] or "") + m[4], line)

    def script(found):
        path = os.path.join(source, found[1])
        return f"[{found[0]}]({os.path.relpath(found[1][:-4] + '.md', os.path.dirname(here) or '.')})" if os.path.exists(path) else found[0]
    return re.sub(r"(?<!\[)`(scripts/[\w/]+\.lua)`(?!\])", script, line) if not line.startswith("#") else line


def index_entries(lines):
    """Each function, key, field and event of the reference, as an entry of the index before its heading."""
    out, pending, name = [], [], ""
    for line in lines:
        heading, row = re.match(r"### `([^`]+)`", line), re.match(r"\| `([^`|]+)` \|", line)
        if heading or line.startswith("#"):
            out, pending = flushed(out, pending), []
            name = re.sub(r"[{(].*", "", heading[1]).strip() if heading else ""
            out.append(line)
            if name:
                out.append("@entries")
                pending.append(f"single: {name}")
        else:
            if row and name == "event type":
                pending.append(f"single: {row[1]} (event)")
            elif row and name and not row[1].startswith("["):
                pending.append(f"single: {row[1]}; of {name}")
            out.append(line)
    return flushed(out, pending)


def flushed(out, pending):
    if "@entries" not in out:
        return out
    at = out.index("@entries")
    unique = list(dict.fromkeys(entry.replace(",", " ").replace("!", "") for entry in pending))
    return out[:at - 1] + entries_block(unique) + [out[at - 1]] + out[at + 1:]


def entries_block(entries):
    return ["```{eval-rst}", ".. index::"] + ["   " + entry for entry in entries] + ["```", ""]


def glossary_entries(lines):
    """Each term of the glossary, under the heading of its subject. With "(term)" the search lists pages on the subject first."""
    out, at, pending = [], 0, []
    for line in lines + ["## end"]:
        row = re.match(r"\| ([^|`]+?) \|", line)
        if line.startswith("## "):
            if pending:
                out[at:at] = entries_block(pending)
            pending, at = [], len(out)
        elif row and row[1] not in ("term", "") and not row[1].startswith("-"):
            pending.append(f"single: {row[1].replace(',', ' and').replace(';', ' ')} (term)")
        out.append(line)
    return out[:-1]


def synonyms(source):
    found = {}
    for line in read(os.path.join(source, "docs/site/synonyms.txt")).splitlines():
        if line.strip() and not line.startswith("#"):
            word, page = (part.strip() for part in line.split(";"))
            found.setdefault(page, []).append(word)
    return found


def staged(page, source, words):
    lines, fence = [], False
    for line in read(os.path.join(source, page)).split("\n"):
        if FENCE.match(line):
            fence = not fence
        lines.append(line if fence else linked(line, page, source))
    if not title_of("\n".join(lines)):
        lines = ["# " + os.path.basename(page)[:-3].lstrip("0123456789-").replace("-", " ").capitalize(), ""] + lines
    if page.startswith("docs/reference/"):
        lines = index_entries(lines)
    if page == "docs/glossary.md":
        lines = glossary_entries(lines)
    if words.get(page):
        lines = entries_block([f"single: {word}" for word in words[page]]) + lines
    return "\n".join(lines)


def script_page(path, source):
    """The comment at the head of a script as text, the rest as code; and the text."""
    text = read(os.path.join(source, path))
    text = re.sub(r"^#![^\n]*\n", "", text)
    head = re.match(r"((?:--[^\n]*\n)*)", text)[1]
    about = re.sub(r"^--+[ ]?", "", head, flags=re.M).strip()
    about = re.sub(r"([<>*_\[\]])", r"\\\1", about)

    def page(found):
        to = found[0].replace("\\", "")
        if not os.path.exists(os.path.join(source, to)):
            return found[0]
        return f"[{title_of(read(os.path.join(source, to)))}]({os.path.relpath(to, os.path.dirname(path))})"
    linked_about = re.sub(r"docs/[\w/.\\-]+\.md", page, about)
    name = os.path.basename(path)[:-4]
    command = (f"trilith verify {name}" if path.startswith(CASES) else
               f"trilith verify --experiments {name}" if path.startswith(EXPERIMENTS) else f"trilith run {path}")
    return (f"---\norphan: true\n---\n# {os.path.relpath(path, 'scripts')}\n\n{linked_about}\n\nRun it with `{command}`.\n\n"
            f"```lua\n{text[len(head):].strip()}\n```\n"), " ".join(about.split())


def list_of_scripts(scripts, abouts):
    topics = [("Tour", lambda p: "/tour/" in p), ("Bridges", lambda p: re.search(r"bridge|viaduct|scour", p)),
              ("Masonry", lambda p: re.search(r"wall|arch|dome|facade", p)), ("Others", lambda p: True)]
    text, left = "# Example scripts\n\nEach script runs as it is; `trilith run FILE --params` lists its parameters.\n", list(scripts)
    for topic, belongs in topics:
        mine = [p for p in left if belongs(p)]
        left = [p for p in left if p not in mine]
        rows = [f"| [{os.path.relpath(p, 'scripts')}]({os.path.relpath(p, 'scripts')[:-4]}.md) | {shorter(abouts[p])} |" for p in mine]
        text += f"\n## {topic}\n\n| script | subject |\n|---|---|\n" + "\n".join(rows) + "\n" if mine else ""
    return text


def shorter(text):
    sentence = re.split(r"(?<=[a-z)])[.:;]\s", text.replace("|", "/") + " ")[0].strip()
    return textwrap.shorten(sentence, 150, placeholder=" …")


def gallery(source, pages):
    cards = []
    for page in pages:
        text = read(os.path.join(source, page))
        picture = re.search(r"!\[[^\]]*\]\(([^)]+)\)", text)
        name = os.path.basename(page)
        image = f"![{title_of(text)}]({picture[1]})\n\n" if picture else ""
        cards.append(f'<a class="card" href="{name[:-3]}.html">\n\n{image}**{title_of(text)}**\n\n{first_sentence(text)}\n\n</a>\n')
    head = "# Gallery\n\nLarger models with their scripts, pictures and figures.\n\n"
    return head + '<div class="cards">\n' + "\n".join(cards) + "\n</div>\n"


def below_decisions(page):
    """The path of a page from the folder of the decisions, which has a folder for each subject."""
    return os.path.relpath(page, "docs/decisions")


def hidden_menu(pages):
    names = "\n".join(below_decisions(page)[:-3] for page in pages)
    return f"\n\n```{{toctree}}\n:hidden:\n\n{names}\n```\n"


def decisions(source, pages):
    """The list of the decisions, where they have no page of their own for it."""
    rows = [f"- [{title_of(read(os.path.join(source, p))) or os.path.basename(p)[:-3]}]({below_decisions(p)})" for p in pages]
    head = "# Design decisions\n\nEach page states the context, the decision and its consequences.\n\n"
    return head + "\n".join(rows) + hidden_menu(pages)


def main(source, target):
    shutil.rmtree(target, ignore_errors=True)
    pages, words = pages_of(source), synonyms(source)
    for ending in (".png", ".svg", ".py", ".txt"):
        for path in walk(source, "docs", ending):
            if not path.startswith("docs/site/"):
                os.makedirs(os.path.dirname(os.path.join(target, path)), exist_ok=True)
                shutil.copyfile(os.path.join(source, path), os.path.join(target, path))
    shutil.copyfile(os.path.join(source, "LICENSE"), os.path.join(target, "LICENSE"))
    scripts, abouts = walk(source, "scripts", ".lua"), {}
    for path in scripts:
        text, abouts[path] = script_page(path, source)
        write(os.path.join(target, path[:-4] + ".md"), text)
    numbered = sorted((p for p in pages if re.match(r"docs/decisions/(\w+/)?\d", p)), key=os.path.basename)
    made = {"scripts/index.md": list_of_scripts([p for p in scripts if not p.startswith((CASES, EXPERIMENTS))], abouts),
            "docs/gallery/index.md": gallery(source, [p for p in pages if p.startswith("docs/gallery/")])}
    if "docs/decisions/README.md" not in pages:
        made["docs/decisions/index.md"] = decisions(source, numbered)
    for path, text in made.items():
        write(os.path.join(target, path), text)
    sections, left = menu(source, pages + list(made))
    for page in left:
        sys.exit(f"docs/site/navigation.txt names no section for {page}")
    for page in pages:
        if page not in made:
            text = staged(page, source, words) + (hidden_menu(numbered) if page == "docs/decisions/README.md" else "")
            write(os.path.join(target, "index.md" if page == "README.md" else page), text)
    with open(os.path.join(target, "index.md"), "a", encoding="utf8") as f:
        for section, listed in sections:
            entries = "\n".join("Index of functions, keys and events <genindex>" if p == "genindex" else p[:-3] for p in listed)
            f.write(f"\n\n```{{toctree}}\n:hidden:\n:caption: {section}\n\n{entries}\n```\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
