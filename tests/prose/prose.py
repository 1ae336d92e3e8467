#!/usr/bin/env python3
"""Checks how pages, comments and messages are written: prose.py [--list [AREA|PATH]...] [--rule NAME] [--lower]

Without options: counts by area and rule against counts.txt in this folder. An area without a row there must have none. A count
above its row fails; for a count below it, --lower writes a lower row. --list prints each place. A justified exception is a line
of exceptions.txt."""
import argparse
import collections
import fnmatch
import os
import random
import signal
import subprocess
import sys

import extract
import rules

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
CODE = ("cpp", "hpp", "js", "html", "lua", "py", "sh", "cmake")


def language_of(path):
    name = os.path.basename(path)
    return "txt" if name.endswith(".txt") else name.rsplit(".", 1)[1] if "." in name else "script"


def area_of(path):
    """Areas of a path: pages have one, code has one for comments and one for messages, tests one for the names of cases."""
    extension = language_of(path)
    if path.startswith("tests/prose/"):
        return []
    if extension == "md":
        return ["reference" if path.startswith("docs/reference/") else "docs" if path.startswith("docs/") else "readme"]
    if extension not in CODE and not path.endswith("CMakeLists.txt") and (extension != "script" or path == "LICENSE"):
        return []
    top = path.split("/")[0]
    if top == "tests":
        named = extension == "cpp" or path.endswith("CMakeLists.txt")
        return ["tests-comments"] + (["tests-names"] if named else [])
    if top in ("engine", "lua"):
        return [f"{top}-comments"] + ([f"{top}-messages"] if extension in ("cpp", "hpp", "js", "html", "lua") else [])
    return ["scripts-comments"] + (["scripts-messages"] if extension == "lua" else [])


def read_exceptions():
    """Rows 'path pattern | rule | part of the sentence | reason'."""
    rows = []
    with open(os.path.join(HERE, "exceptions.txt"), encoding="utf8") as f:
        for number, line in enumerate(f, 1):
            if line.strip() and not line.startswith("#"):
                row = [part.strip() for part in line.split("|")]
                if len(row) != 4 or not row[3] or row[1] not in rules.NAMES + ["*"]:
                    sys.exit(f"tests/prose/exceptions.txt:{number}: a row is 'path pattern | rule | part of the sentence | reason'")
                rows.append(row + [number])
    return rows


def parts_of(path, area, source):
    if area in ("docs", "reference", "readme"):
        return extract.markdown(source)
    if area.endswith("-names"):
        return extract.test_names(source)
    language = language_of(path)
    is_python = language == "script" and "python3" in source.split("\n", 1)[0]
    return extract.code(source, "py" if is_python else language, area.endswith("-messages"))


def texts_of(path, area, source):
    return [(line, text) for line, text, kind in parts_of(path, area, source) if kind == "text"]


def findings_of(path, area, source):
    for line, text, kind in parts_of(path, area, source):
        if kind == "line":
            if len(text) > rules.LINE_CHARACTERS:
                yield line, "line", f"{len(text)} characters; at most {rules.LINE_CHARACTERS}", text[:60], text
        elif kind == "code":
            if rules.BARE_NUMBER.search(text):
                yield line, "leading-zero", rules.LEADING_ZERO, text.strip()[:60], text
        else:
            for rule, advice, excerpt in rules.findings(text, kind == "heading"):
                yield line, rule, advice, excerpt, text


def collect(paths):
    exceptions, used, found = read_exceptions(), set(), []
    for path in paths:
        areas = area_of(path)
        if not areas:
            continue
        with open(os.path.join(ROOT, path), encoding="utf8") as f:
            source = f.read()
        mine = [row for row in exceptions if fnmatch.fnmatch(path, row[0])]
        for area in areas:
            for line, rule, advice, excerpt, text in findings_of(path, area, source):
                excused = [row[4] for row in mine if row[1] in (rule, "*") and row[2] in text]
                used.update(excused)
                if not excused:
                    found.append((area, path, line, rule, advice, excerpt))
    return found, [row for row in exceptions if row[4] not in used]


def read_counts():
    allowed = {}
    with open(os.path.join(HERE, "counts.txt"), encoding="utf8") as f:
        for line in f:
            if line.strip() and not line.startswith("#"):
                area, rule, count = line.split()
                allowed[area, rule] = int(count)
    return allowed


def write_counts(allowed):
    with open(os.path.join(HERE, "counts.txt"), encoding="utf8") as f:
        head = [line for line in f if line.startswith("#")]
    with open(os.path.join(HERE, "counts.txt"), "w", encoding="utf8") as f:
        f.writelines(head)
        f.writelines(f"{area} {rule} {count}\n" for (area, rule), count in sorted(allowed.items()) if count)


def table(counts, areas):
    print(f"{'':18}" + "".join(f"{name[:9]:>10}" for name in rules.NAMES))
    for area in areas:
        print(f"{area:18}" + "".join(f"{counts[area, name]:>10}" for name in rules.NAMES))


def compare(found, unused):
    counts, allowed = collections.Counter((f[0], f[3]) for f in found), read_counts()
    table(counts, sorted({f[0] for f in found}))
    failed = False
    for area, rule in sorted(set(counts) | set(allowed)):
        now, most = counts[area, rule], allowed.get((area, rule), 0)
        if now > most:
            failed = True
            print(f"{area}: {now} of rule {rule}, at most {most} allowed; to see them: tests/prose/prose.py --list {area} --rule {rule}")
            for _, path, line, _, advice, excerpt in [f for f in found if (f[0], f[3]) == (area, rule)][:3]:
                print(f"  {path}:{line}: {excerpt} ({advice})")
        elif now < most:
            print(f"{area}: {now} of rule {rule}, {most} allowed: please lower it (tests/prose/prose.py --lower)")
    for row in unused:
        print(f"tests/prose/exceptions.txt:{row[4]}: nothing matches this row any more; remove it")
    return failed


def draw(paths, count, seed):
    """Sentences at random: first the kind (page, comment, message), then one of its sentences of five words and more."""
    kinds = {"page": [], "comments": [], "messages": []}
    for path in paths:
        for area in area_of(path):
            kind = area.rsplit("-", 1)[-1].replace("names", "messages")
            with open(os.path.join(ROOT, path), encoding="utf8") as f:
                source = f.read()
            kinds[kind if kind in kinds else "page"] += [(path, line, text) for line, text in texts_of(path, area, source)
                                                         if len(rules.WORD.findall(text)) >= 5]
    dice = random.Random(seed)
    for _ in range(count):
        path, line, text = dice.choice(kinds[dice.choice(sorted(kinds))])
        print(f"{path}:{line}: {text}")
    return 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--list", nargs="*", metavar="AREA|PATH", help="print each place, of these areas or paths alone")
    parser.add_argument("--rule", help="this rule alone")
    parser.add_argument("--draw", type=int, metavar="N", help="print N sentences at random, from pages, comments and messages alike")
    parser.add_argument("--seed", type=int, default=1, help="of --draw (1)")
    parser.add_argument("--lower", action="store_true", help="lower the rows of counts.txt that are above today's counts")
    parser.add_argument("--record", action="store_true", help="after a merge: write today's counts of the areas that have rows")
    args = parser.parse_args()
    listed = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard"], cwd=ROOT, text=True, check=True,
                            stdout=subprocess.PIPE).stdout
    paths = [path for path in sorted(set(listed.split("\n"))) if os.path.isfile(os.path.join(ROOT, path))]
    if args.draw:
        return draw(paths, args.draw, args.seed)
    found, unused = collect(paths)
    if args.list is not None or args.rule:
        for area, path, line, rule, advice, excerpt in [f for f in found if args.rule in (None, f[3])]:
            if not args.list or area in args.list or any(path.startswith(p) for p in args.list):
                print(f"{path}:{line}: [{rule}] {excerpt} ({advice})")
        return 0
    if args.lower:
        counts = collections.Counter((f[0], f[3]) for f in found)
        write_counts({key: min(most, counts[key]) for key, most in read_counts().items()})
        return 0
    if args.record:
        areas = {area for area, _ in read_counts()}
        write_counts(collections.Counter((f[0], f[3]) for f in found if f[0] in areas))
        return 0
    return int(compare(found, unused))


if __name__ == "__main__":
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)
    sys.exit(main())
