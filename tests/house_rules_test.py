#!/usr/bin/env python3
"""The house rules that a machine can hold: every source file opens with a comment that says something, none is longer
than 400 lines, nothing is left to be done, the project's words are used, and no run has left its files beside the
sources. Proves first that it can fail.
    tests/house_rules_test.py SOURCE_DIR
"""
import re
import sys
import tempfile
from pathlib import Path

FOLDERS = ["include", "src", "shaders", "tests", "examples"]
ENDINGS = {".h", ".cpp", ".vert", ".frag", ".geom", ".glsl"}
LONGEST = 400
UNFINISHED = re.compile(r"(?<![A-Za-z0-9])(TODO|FIXME|XXX|HACK)(?![A-Za-z0-9])")
# A particle is a particle everywhere; `vertex` belongs to OpenGL.
FOREIGN = re.compile(r"\b(nodes?|solvers?)\b", re.IGNORECASE)
WRITTEN_BY_RUNS = {".csv", ".png", ".toml", ".mp4", ".svg", ".gp"}
SAYS_NOTHING = re.compile(r"([^;.]*; )?[Ss]ee \S+\.h\.?")


def opening_comment(lines):
    """The text of the comment in the first two lines and on, or nothing."""
    first = next((number for number, line in enumerate(lines[:2]) if line.startswith("//")), None)
    if first is None:
        return ""
    text = []
    for line in lines[first:]:
        if not line.startswith("//"):
            break
        text.append(line.lstrip("/ "))
    return " ".join(text)


def comment_of(line):
    """What follows // in a line, outside its texts in quotes."""
    return re.sub(r'"[^"]*"', "", line).partition("//")[2]


def breaches_of(path, lines):
    opening = opening_comment(lines)
    if not opening:
        yield f"{path}: does not open with a comment"
    elif SAYS_NOTHING.fullmatch(opening):
        yield f"{path}: opens with '{opening}', which says nothing of this file"
    if len(lines) > LONGEST:
        yield f"{path}: more than {LONGEST} lines"
    for number, line in enumerate(lines, 1):
        if UNFINISHED.search(line):
            yield f"{path}:{number}: unfinished: {line.strip()}"
        if not path.startswith("tests/") and FOREIGN.search(comment_of(line)):
            yield f"{path}:{number}: not a word of this project: {line.strip()}"


def breaches(root):
    files = sorted(file for folder in FOLDERS for file in (root / folder).rglob("*") if file.suffix in ENDINGS)
    found = [] if files else [f"{root}: no source file"]
    for file in files:
        found += breaches_of(file.relative_to(root).as_posix(), file.read_text(encoding="utf-8").splitlines())
    for file in sorted(root.iterdir()):
        if file.suffix in WRITTEN_BY_RUNS:
            found.append(f"{file.name}: written by a run, and no part of the sources")
    return found


def prove_that_it_can_fail():
    with tempfile.TemporaryDirectory() as folder:
        planted = Path(folder, "src", "core", "a.cpp")
        planted.parent.mkdir(parents=True)

        def found_in(text):
            planted.write_text(text, encoding="utf-8")
            return "\n".join(breaches(Path(folder)))

        def must_find(words, text):
            if words not in found_in(text):
                sys.exit(f"not noticed: {words}")

        must_find("does not open", "int x;\n")
        must_find("does not open", "\n\n// Too late.\nint x;\n")
        must_find("says nothing", "// See a.h.\n#include <a.h>\n")
        must_find("says nothing", "// The colours; see a.h.\n#include <a.h>\n")
        must_find("more than", "// What for.\n" + 400 * "int x;\n")
        must_find("unfinished", "// What for.\nint x;  // TO" + "DO later\n")
        must_find("not a word", "// Every node of the sheet.\n")
        must_find("not a word", "// What for.\nint x;  // The Solver.\n")
        for right in [
            "// Every particle of the sheet.\nint x;\n",
            "// See a.h. Greedy: a word goes onto the line as long as it fits.\nint x;\n",
            "// What for.\nint nodes;\nauto x = \"// a node\";\n",
            "// What for.\n" + 399 * "int x;\n",
        ]:
            if found_in(right):
                sys.exit(f"wrongly refused: {found_in(right)}")
        Path(folder, "tyg-curtain-1.csv").touch()
        must_find("written by a run", "// What for.\n")


prove_that_it_can_fail()
found = breaches(Path(sys.argv[1]))
sys.exit("\n".join(found) if found else 0)
