"""Configuration of the site: Sphinx with MyST and the theme Furo, all from Debian packages; nothing is loaded from a network."""
import json
import os
import re
import shutil
import sys

from docutils import nodes
from pygments.lexers.special import TextLexer

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import stage  # noqa: E402

SOURCE = os.environ["TRILITH_SOURCE"]
KATEX = "/usr/share/javascript/katex"

with open(os.path.join(SOURCE, "CMakeLists.txt"), encoding="utf8") as f:
    release = re.search(r"project\(Trilith VERSION ([\d.]+)", f.read())[1]
project, author, language = "Trilith", "Trilith contributors", "en"
html_title = f"Trilith {release}"
html_show_copyright = False

extensions = ["myst_parser"]
root_doc = "index"
source_suffix = {".md": "markdown"}
myst_heading_anchors = 4
myst_enable_extensions = ["dollarmath", "amsmath"]
myst_dmath_double_inline = True
highlight_language = "text"
suppress_warnings = ["myst.header", "misc.highlighting_failure"]
nitpicky = True

html_theme = "furo"
html_static_path = [os.path.join(SOURCE, "docs/site/static")]
html_css_files = ["katex/katex.min.css", "site.css"]
html_js_files = [("katex/katex.min.js", {"defer": "defer"}), ("site.js", {"defer": "defer"})]
html_math_renderer = "katex"
html_copy_source = False
html_show_sourcelink = False
html_show_search_summary = False  # it would fetch pages, which browsers refuse for files; site.js shows first sentences
html_use_index = True
html_domain_indices = False
pygments_style, pygments_dark_style = "friendly", "monokai"


def inline_math(writer, node):
    writer.body.append(f'<span class="formula">{writer.encode(node.astext())}</span>')
    raise nodes.SkipNode


def block_math(writer, node):
    writer.body.append(f'<div class="formula">{writer.encode(node.astext())}</div>')
    raise nodes.SkipNode


def add_summaries(app, pagename, templatename, context, doctree):
    if pagename == "search":
        app.add_js_file("summaries.js")


def write_summaries(app, error):
    """The first sentence of each page, for the results of the search."""
    if error or app.builder.name != "html":
        return
    found = {}
    for name in sorted(app.env.found_docs):
        text = re.sub(r"```\{.*?\n```\n", "", stage.read(app.env.doc2path(name)), flags=re.S)
        found[name] = stage.first_sentence(re.sub(r"^---.*?---\n", "", text, flags=re.S)).replace("`", "")
    stage.write(os.path.join(app.outdir, "_static/summaries.js"), f"window.summaries = {json.dumps(found, ensure_ascii=False)};\n")


def copy_katex(app, error):
    """Scripts, style sheet and fonts of the Debian package, so that formulas are set without a network."""
    if error or app.builder.name != "html":
        return
    to = os.path.join(app.outdir, "_static/katex")
    os.makedirs(os.path.join(to, "fonts"), exist_ok=True)
    for name in ("katex.min.js", "katex.min.css"):
        shutil.copyfile(os.path.join(KATEX, name), os.path.join(to, name))
    for name in os.listdir(os.path.join(KATEX, "fonts")):
        if name.endswith(".woff2"):
            shutil.copyfile(os.path.join(KATEX, "fonts", name), os.path.join(to, "fonts", name))


def join_theme(app, error):
    """Debian's Furo has its script in two modules and a style sheet of the web server: browsers refuse both for files."""
    if error or app.builder.name != "html":
        return
    static = os.path.join(app.outdir, "_static")
    furo = stage.read(os.path.join(static, "scripts/furo.js"))
    imported = re.search(r'^import Gumshoe from "\./(gumshoe-patched\.js)";\n', furo, re.M)
    if imported:
        gumshoe = stage.read(os.path.join(static, "scripts", imported[1]))
        stage.write(os.path.join(static, "scripts/furo.js"), gumshoe + "\n" + furo.replace(imported[0], ""))
    css = stage.read(os.path.join(static, "styles/furo.css"))
    imported = re.search(r"@import url\((/javascript/\S+?)\);", css)
    if imported:
        common = stage.read("/usr/share" + imported[1])
        stage.write(os.path.join(static, "styles/furo.css"), css.replace(imported[0], common))


def setup(app):
    for name in stage.INSERTED:
        app.add_lexer(name, TextLexer)
    app.add_html_math_renderer("katex", (inline_math, None), (block_math, None))
    app.connect("html-page-context", add_summaries)
    app.connect("build-finished", copy_katex)
    app.connect("build-finished", write_summaries)
    app.connect("build-finished", join_theme)
