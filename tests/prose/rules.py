"""The rules of the prose check: each has a name, a pattern over one sentence or line, and advice for the writer."""
import re

SENTENCE_WORDS = 35
LINE_CHARACTERS = 160

PEOPLE = (r"people|persons?|readers?|users?|engineers?|authors?|someone|somebody|anyone|anybody|everyone|everybody|nobody|those|"
          r"developers?|contributors?|researchers?|maintainers?|reviewers?|students?|writers?|one|you|he|she|they")


def phrase(name, pattern, advice, flags=re.IGNORECASE):
    return name, re.compile(pattern, flags), advice


BARE_NUMBER = re.compile(r"(?<![\w.)\]}/%:`'\"*\\])-?\.\d+(?![\w.]*[A-DF-Za-df-z_])")
LEADING_ZERO = "write 0.5, not .5"

# Patterns see a sentence with inline code, links' targets and format fields taken out.
PHRASES = [
    ("leading-zero", BARE_NUMBER, LEADING_ZERO),
    phrase("who", r"\b(?:who|whom)\b", "things are 'it' or 'which'; people are named"),
    phrase("what", r"\bwhat\b(?!-if)(?! (?:to|if|happens|happened)\b)", "name the thing: 'the force that ...', 'the value', 'the reason'"),
    phrase("that-of", r"\b(?:that|those) of\b", "repeat the noun"),
    phrase("pointing", r"\b(?:the same of|the former|the latter|of then|that which|those (?:that|which)|the ones? (?:that|of|which))\b",
           "repeat the noun"),
    phrase("pointing", r"^(?:That|Those) (?:is|are|was|were|has|have|does|do|did|can|may|must|holds?|makes?|takes?|gives?|keeps?)\b",
           "put a noun after 'that'", 0),
    phrase("as-pays", r"\b(?:as pays|that pays|pays? off|pays? for|what pays|which pays|it pays)\b",
           "say 'chosen automatically', 'is faster', 'costs less than it saves'"),
    phrase("goes-by", r"\b(?:goes|go|went|going) (?:by|with)\b", "say 'uses', 'depends on', 'follows'"),
    phrase("comes-to", r"\b(?:comes?|came|coming) to\b(?! (?:rest|a (?:stop|standstill|rest)|an end)(?:\b|1))", "say 'reaches', 'equals', 'starts to'"),
    phrase("is-told", r"\b(?:is|are|was|were|be|been|being|gets?) (?:told|spoken of|heard of)\b", "say 'is reported', 'is printed'"),
    phrase("persons", r"\b(?:tells(?! apart)|speaks?|doubts|wants|hears?|reckons?)\b", "programs report, print, warn, reject, require"),
    phrase("since", r"\b(?:of|ever|long) since\b", "name the time, or say 'because'"),
    phrase("beside", r"\bbeside\b", "say 'next to', 'in addition to', 'compared with', 'together with'"),
    phrase("begin", r"\b(?:the|its|their|a|of|at) begin\b", "the noun is 'start' or 'beginning'"),
    phrase("is-no", r"(?<!there )(?<!here )\b(?:is|are|was|were) no (?!longer|more|less|fewer|better|deeper|larger|closer|higher|"
           r"smaller|farther|further|shorter|greater)[a-z]", "say 'is not a ...'"),
    phrase("says-so", r"\b(?:says?|said) so\b", "say 'reports this', 'prints a note'"),
    phrase("some", r"\bsome (?:per ?cent|tenths|hundredths|thousandths|hundreds?|thousands?|tens?|parts (?:in|per))\b",
           "say 'a few per cent', 'about ten'"),
    phrase("dialect", r"\b(?:to and fro|anew|as preset|by preset|given? off|give off|giving off|gives off|giv(?:en|es?) back|taken for|stands? for|"
           r"as long as they may|no more than once|whence|thereof|therein|lest|aught|at one(?:s|ce) with|is at home|looked up again|"
           r"lets? be|let go|turned? down|put down|laid down|in the way of|at its own|by and by|of its own accord|"
           r"as (?:it|they) stands?|closed rooms?|not to be trusted|chang(?:es?|ed|ing) no bits?|other bits|"
           r"(?:keeps?|kept) (?:its|their) bits|comes? down|came down)\b",
           "say it with the field's verb: 'cyclic', 'restart', 'default', 'dissipate', 'return', 'mistaken for', 'represent'"),
]

PEOPLE_WHO = re.compile(rf"\b(?:{PEOPLE}) (?:who|whom)\b", re.IGNORECASE)
WORD = re.compile(r"[A-Za-z][A-Za-z'’]+|\ba\b|\d[\d.,]*", re.IGNORECASE)
NAMES = sorted({rule[0] for rule in PHRASES} | {"sentence", "line"})


def findings(sentence, heading=False):
    """(rule, advice, excerpt) for each construction in one sentence."""
    question = sentence.rstrip().endswith("?")
    for name, pattern, advice in PHRASES:
        if name == "what" and (question or heading):
            continue
        text = PEOPLE_WHO.sub("people", sentence) if name == "who" else sentence
        if name == "who" and question:
            continue
        for hit in pattern.finditer(text):
            yield name, advice, text[max(0, hit.start() - 25):hit.end() + 25].strip()
    words = len(WORD.findall(sentence))
    if words > SENTENCE_WORDS:
        yield "sentence", f"{words} words; at most {SENTENCE_WORDS}: one idea a sentence", sentence.strip()[:60]
