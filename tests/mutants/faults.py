"""Reads tests/mutants/faults.txt: faults that `./dev mutants` seeds, and the tests of each module."""
import re
import sys
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LIST = Path(__file__).with_name("faults.txt")


@dataclass
class Fault:
    number: int
    module: str
    file: str
    before: str = ""
    original: str = ""
    after: str = ""
    faulty: str = ""
    reason: str = ""

    @property
    def text(self):
        return self.before + self.original + self.after

    @property
    def is_statement(self):
        return self.original.endswith(";")

    def switched(self):
        """The text of the source in which TRILITH_FAULT selects the faulty part."""
        if self.is_statement:
            assigned = re.match(r"const ([\w:<>]+) (\w+) = (.*);$", self.original)
            if assigned:  # a declaration: both values have its type
                kind, name, value = assigned.groups()
                faulty = re.match(r"const [\w:<>]+ \w+ = (.*);$", self.faulty).group(1)
                part = f"const {kind} {name} = trilith_fault({self.number}) ? {kind}({faulty}) : {kind}({value});"
            else:
                part = f"if (trilith_fault({self.number})) {{ {self.faulty} }} else {{ {self.original} }}"
        else:
            kind = match[1] if (match := re.match(r"(Vec[23])\(", self.faulty)) else ""  # both of one type
            part = f"(trilith_fault({self.number}) ? {kind}({self.faulty}) : {kind}({self.original}))"
        return self.before + part + self.after


@dataclass
class FaultList:
    faults: list = field(default_factory=list)
    tests: dict = field(default_factory=dict)  # module: [(kind, words)]
    errors: list = field(default_factory=list)


def set_original(fault, text):
    """Splits at the marks of the swapped part, if there are any."""
    if "«" not in text:
        fault.original = text
        return
    fault.before, rest = text.split("«")
    fault.original, fault.after = rest.split("»")


def read_list(path=LIST):
    out = FaultList()
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if not line.strip() or line.startswith("#"):
            continue
        if match := re.match(r"tests (\w+) = (doctest|lua|ctest) (.+)", line):
            out.tests.setdefault(match[1], []).append((match[2], match[3].split()))
        elif match := re.match(r"\[(\d+)\] (\w+) (\S+)$", line):
            out.faults.append(Fault(int(match[1]), match[2], match[3]))
        elif line.startswith("- "):
            set_original(out.faults[-1], line[2:])
        elif line.startswith("+ "):
            out.faults[-1].faulty = line[2:]
        elif line.startswith("! "):
            out.faults[-1].reason = line[2:]
        else:
            out.errors.append(f"line {number}: cannot be read: {line}")
    return out


def problems(found, root=ROOT):
    """Errors in the list, as lines of text."""
    out = list(found.errors)
    for count, fault in enumerate(found.faults, 1):
        where = f"fault {fault.number} ({fault.file})"
        if fault.number != count:
            out.append(f"{where}: the numbers must rise by one; this one must be {count}")
        if fault.module not in found.tests:
            out.append(f"{where}: module '{fault.module}' has no line 'tests {fault.module} = ...'")
        if not fault.original or not fault.faulty or fault.original == fault.faulty:
            out.append(f"{where}: needs an original and another, faulty part")
        if fault.is_statement != fault.faulty.endswith(";"):
            out.append(f"{where}: a statement must be replaced by a statement, an expression by an expression")
        if not re.search(r"\w", fault.original + fault.faulty):
            out.append(f"{where}: the marked part is an operator; mark an operand with it")
        path = root / fault.file
        times = path.read_text().count(fault.text) if path.is_file() else -1
        if times != 1:
            out.append(f"{where}: the file is missing" if times < 0 else f"{where}: its text occurs {times} times, must occur once: {fault.text}")
    modules = [fault.module for fault in found.faults]
    out += [f"module '{m}' has {modules.count(m)} faults, must have at least 3" for m in found.tests if modules.count(m) < 3]
    return out


if __name__ == "__main__":
    listed = read_list()
    errors = problems(listed)
    print("\n".join(errors) if errors else f"{len(listed.faults)} faults in {len(listed.tests)} modules, each in one place of its file")
    sys.exit(1 if errors else 0)
