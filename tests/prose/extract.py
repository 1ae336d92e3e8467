"""Extracts prose from files: (line, text, kind) with kind "text" or "heading" for one sentence, "line" or "code" for a line."""
import ast
import inspect
import re

FENCE = re.compile(r"^\s*(```|~~~)")
END = re.compile(r"(?<=[.!?])[\"')\]*_]*\s+(?=[\"'(\[`*_]*[A-Z0-9`])")
ABBREVIATION = re.compile(r"\b(?:e\.g|i\.e|cf|vs|No|Eq|Eqs|Fig|Sec|approx|et al|etc|pp|Dr|St)\.$")
BLOCK = re.compile(r"^\s*(?:[-*+]|\d+[.)]|>|#+)\s+")

C_LIKE = re.compile(r"""(?P<comment>//[^\n]*|/\*.*?\*/)|(?P<string>R"(?P<mark>[^(\s"]*)\(.*?\)(?P=mark)"|"(?:[^"\\\n]|\\.)*")|"""
                    r"""(?P<char>'(?:[^'\\\n]|\\.)')""", re.S)
SCRIPT = re.compile(r"""(?P<comment>//[^\n]*|/\*.*?\*/)|(?P<string>"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)*'|`(?:[^`\\]|\\.)*`)""", re.S)
LUA = re.compile(r"""(?P<comment>--\[\[.*?\]\]|--[^\n]*)|(?P<string>"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)*'|\[\[.*?\]\])""", re.S)
HASH = re.compile(r"(?P<comment>(?:(?<=\s)|^)#(?!!)[^\n]*)|(?P<string>(?!))", re.M)
HTML = re.compile(r"(?P<comment><!--.*?-->|<(?:script|style)\b.*?</(?:script|style)>)|(?<=>)(?P<string>[^<>]+)(?=<)|"
                  r"\b(?:title|placeholder|aria-label)=(?P<quoted>\"[^\"]*\")", re.S)
LANGUAGES = {"html": HTML, "script": HASH, "cpp": C_LIKE, "hpp": C_LIKE, "in": C_LIKE, "js": SCRIPT, "lua": LUA, "py": HASH, "sh": HASH, "txt": HASH, "cmake": HASH}
DRAWN = " " * 4
# In literals of several lines, a row of keys or a line of code is a piece of its own.
KEY = re.compile(r"(?<=')what(?=')|\bwhat(?= ?=)")
ROW = re.compile(r"^\s*(?:[\w.\[\]/-]+\?? {2,}|local |for |if |print\(|\w+:\w+[ ({]|[.#:}@]|--|uniform |in )|[;{}(,|&\\]$|^\s*$")
FIRST_COLUMN = re.compile(r"^\s*[\w.\[\]/-]+\?? {2,}")
LEADER = re.compile(r"^\s*(?:///?!?<?|/\*+|\*+/|\*(?!\w)|--+\[*|#+)\s?|\*/\s*$|\]\]\s*$")


def plain(text):
    """Inline code becomes one word, links their text, format fields and HTML nothing."""
    text = re.sub(r"``.+?``|`[^`]*`", "code", text)
    text = re.sub(r"\$\$?[^$]+\$\$?|\\\(.+?\\\)", "formula", text)
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", text)
    text = re.sub(r"https?://\S+|<[^<>\n]*>|[\w./-]+\.(?:md|lua|[ch]pp|h5|py|svg|png|html|csv)\b", "link", text)
    return KEY.sub("key", re.sub(r"\{[^{} ]*\}|%[-+0-9.]*[a-z]", "1", text))


def sentences(pieces):
    """Sentences of a paragraph given as (line, text): each with the line on which it begins."""
    text, starts = "", []
    for line, piece in pieces:
        starts.append((len(text), line))
        text += piece + " "
    begin, ends = 0, []
    for gap in END.finditer(text):
        if not ABBREVIATION.search(text[begin:gap.start()]):
            ends.append(gap.end())
            begin = gap.end()
    begin = 0
    for end in ends + [len(text)]:
        sentence = text[begin:end].strip()
        if sentence:
            yield [line for at, line in starts if at <= begin][-1], plain(sentence)
        begin = end


def markdown(source):
    fence, pieces, heading = None, [], False
    for number, line in enumerate(source.split("\n") + [""], 1):
        mark = FENCE.match(line)
        code = fence is not None or mark or line.startswith("    ") and not pieces
        table = line.lstrip().startswith("|")
        breaks = code or table or not line.strip() or BLOCK.match(line) or heading
        if breaks:
            yield from ((at, text, "heading" if heading else "text") for at, text in sentences(pieces))
            pieces, heading = [], False
        if mark:
            fence = None if fence == mark[1] else fence or mark[1]
        elif code:
            yield number, line, "code"
        elif table:
            cells = re.split(r"(?<!\\)\|", line)
            for cell in cells:
                yield from ((at, text, "text") for at, text in sentences([(number, cell.strip())]))
        elif line.strip():
            heading = line.startswith("#")
            pieces.append((number, BLOCK.sub("", line).strip()))
            yield number, re.sub(r"\]\([^)]*\)|https?://\S+", "", line), "line"


def is_prose(text):
    return len(re.findall(r"[A-Za-z]{2,}", text)) >= 3 and " " in text.strip()


def code(source, extension, strings):
    """Comments, neighbouring ones as one paragraph; with `strings` literals of three words and more instead.

    Each item of a list begins a paragraph, and each line of a formula or drawing, which a comment indents, is one of its own."""
    if extension == "py" and not strings:
        yield from docstrings(source)
    pieces, last = [], 0
    for hit in LANGUAGES[extension].finditer(source):
        is_comment, string = hit["comment"] is not None, hit["string"] or hit.groupdict().get("quoted")
        if string is None and not is_comment or is_comment == strings:
            continue
        between = source[last:hit.start()]
        last = hit.end()
        joined = not between.strip() and between.count("\n") <= 1
        if pieces and not joined:
            yield from paragraph(pieces)
            pieces = []
        number = source.count("\n", 0, hit.start()) + 1
        body = hit[0] if is_comment else literal(string)
        for offset, line in enumerate(body.split("\n")):
            text = LEADER.sub("", line) if is_comment else line
            drawn = is_comment and text != line and text.startswith(DRAWN)
            row = not is_comment and (ROW if "\n" in body else FIRST_COLUMN).search(line)
            if drawn or row or is_comment and text.lstrip().startswith("- "):
                yield from paragraph(pieces)
                pieces = []
            pieces.append((number + offset, text.strip() if is_comment else FIRST_COLUMN.sub("", text) if row else text))
            if drawn or row:
                yield from paragraph(pieces)
                pieces = []
    yield from paragraph(pieces)


def docstrings(source):
    """Docstrings of a Python file. A blank line ends a paragraph, and an indented line is one of its own."""
    for node in ast.walk(ast.parse(source)):
        documented = isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef))
        if not documented or ast.get_docstring(node) is None:
            continue
        pieces, first = [], node.body[0].lineno
        for number, line in enumerate(inspect.cleandoc(node.body[0].value.value).split("\n") + [""], first):
            if not line.strip() or line.startswith(DRAWN) or line.startswith("usage:"):
                yield from paragraph(pieces)
                pieces = []
            if line.strip():
                pieces.append((number, line.strip()))
            if line.startswith(DRAWN):
                yield from paragraph(pieces)
                pieces = []


def literal(text):
    if text.startswith("R\""):
        text = text[text.index("(") + 1:text.rindex(")")]
    elif text[0] in "\"'`[":
        text = text[2:-2] if text.startswith("[[") else text[1:-1]
    return text.replace('\\"', '"').replace("\\n", " ").replace("\\t", " ")


def paragraph(pieces):
    if is_prose(" ".join(text for _, text in pieces)):
        yield from ((at, text, "text") for at, text in sentences(pieces))


TEST_NAME = re.compile(r"(?:TEST_CASE\w*\(|add_test\(NAME )\s*\"([^\"]*)\"")


def test_names(source):
    """Names of doctest cases and of ctest tests, as (line, name, "text")."""
    return [(source.count("\n", 0, found.start()) + 1, found[1], "text") for found in TEST_NAME.finditer(source)]
