#!/usr/bin/env python3
# Holds README.md and docs/*.md to the program: every relative link and anchor leads somewhere, every scene, method,
# command and option that they name exists, and every one that exists is named. The truth comes from the built program.
# Proves first that it can fail: each planted mistake below must be found. Must not know: how the program finds it out.
#   tests/docs_test.py SOURCE_DIR PATH_OF_TYG
import json
import pathlib
import re
import subprocess
import sys
import tempfile

MOST_LINES_OF_README = 150
EXAMPLE = "examples/hello_cloth/hello_cloth.cpp"
PROBE = "docs_test_probe"  # a key that no scene has
BASE_SCENE = {
    "": 'title = "Probe"',
    "sheet": "columns = 2\nrows = 2\nspacing = 1.0\nparticle_mass = 1.0",
    "run": 'duration = 1.0\nintegrator = "rk4"\ndt = 0.1',
}


# The truth.

class Truth:
    """What the program has: scenes, methods, options by command, keys by table of a scene, keys of JSON objects."""

    def __init__(self, tyg):
        self.tyg = tyg
        listed = json.loads(self.run("list", "--json").stdout)
        self.scenes = {scene["name"] for scene in listed["scenes"]}
        self.methods = {method["name"] for method in listed["methods"]}
        commands = re.search(r"a command \(([^)]*)\)", self.run("no-such-command").stderr).group(1).split(", ")
        helps = {command: self.run(command, "--help").stdout for command in commands}
        named = {command: re.findall(r"^  (--[a-z-]+)(?:,(--[a-z-]+))?", text, re.M) for command, text in helps.items()}
        self.options = {command: {name for names in pairs for name in names if name} | {"--help"}
                        for command, pairs in named.items()}
        self.shared = set.intersection(*(each for each in self.options.values() if "--threads" in each))
        self.json_keys = set(json.loads(self.run("run", "spring", "--duration", "0.1", "--json").stdout))
        self.json_keys |= {key for entries in listed.values() for entry in entries for key in entry}
        self.scene_keys = self.ask_scene_keys()

    def run(self, *words):
        return subprocess.run([self.tyg, *words], capture_output=True, encoding="utf-8", timeout=60)

    def allowed_in(self, scene):
        """The keys that a scene's refusal of PROBE allows; none where it was refused for another reason."""
        with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
            file.write(scene)
            file.flush()
            message = self.run("run", file.name).stderr
        if PROBE not in message:
            return []
        return re.findall(r'"([^"]+)"', message.split("allowed", 1)[1])

    def ask_scene_keys(self):
        def scene_with(table, line, header="[%s]"):
            parts = {**BASE_SCENE, table: BASE_SCENE.get(table, "") + "\n" + line}
            return "\n".join((header % name if name == table and name else "[%s]" % name if name else "") + "\n" + text
                             for name, text in parts.items())

        keys = {"": self.allowed_in(scene_with("", f"{PROBE} = 1"))}
        for name in keys[""]:
            found = (self.allowed_in(scene_with(name, f"{PROBE} = 1"))
                     or self.allowed_in(scene_with(name, f"{PROBE} = 1", "[[%s]]")))
            inner = [key for outer in found
                     for key in self.allowed_in(scene_with(name, f"{outer} = {{ {PROBE} = 1 }}"))]
            if found:
                keys[name] = list(dict.fromkeys(found + inner))
        keys[""] = [name for name in keys[""] if name not in keys]
        return keys


# What pages say.

def without_blocks(text):
    return re.sub(r"^```.*?^```", "", re.sub(r"^    .*$", "", text, flags=re.M), flags=re.M | re.S)


def spans_of(text):
    """What stands in backticks."""
    return [" ".join(span.split()) for span in re.findall(r"`([^`]+)`", without_blocks(text))]


def lines_of_code(text):
    """Lines of code blocks, and what stands in backticks."""
    blocks = [line for block in re.findall(r"^```.*?\n(.*?)^```", text, re.M | re.S) for line in block.splitlines()]
    return blocks + re.findall(r"^    (\S.*)$", text, re.M) + spans_of(text)


def anchors_of(text):
    """As GitHub makes them from headings."""
    headings = re.findall(r"^#+ (.+)$", without_blocks(text), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def section(text, heading):
    """From a line that begins with this heading to the next heading of its level or above."""
    level = len(heading) - len(heading.lstrip("#"))
    found = re.search(r"^%s.*?$(.*?)(?=^#{1,%d} |\Z)" % (re.escape(heading), level), text, re.M | re.S)
    return found.group(1) if found else ""


def first_cells(text):
    """What the first cells of tables hold in backticks."""
    cells = [re.split(r"(?<!\\)\|", line)[1] for line in text.splitlines() if line.startswith("|")]
    return [span for cell in cells for span in re.findall(r"`([^`]+)`", cell)]


# The checks. Each gets the pages (path: text), the truth and a function that tells whether a path exists, and yields
# complaints.

def broken_links(pages, _, exists):
    for page, text in pages.items():
        for target in re.findall(r"\]\(([^)]+)\)", without_blocks(text)):
            if re.match(r"[a-z]+:", target):
                continue
            path, _, anchor = target.partition("#")
            parts = []
            for part in (str(pathlib.PurePosixPath(page).parent / path) if path else page).split("/"):
                parts = parts[:-1] if part == ".." else parts if part == "." else parts + [part]
            reached = "/".join(parts)
            if not exists(reached):
                yield f"{page}: link to {target}: there is no {reached}"
            elif anchor and anchor not in anchors_of(pages.get(reached, "")):
                yield f"{page}: link to {target}: no such heading"


def lost_pages_and_pictures(pages, _, exists):
    linked = set(re.findall(r"\]\(([\w-]+\.md)", pages["docs/README.md"]))
    for page in pages:
        if page.startswith("docs/") and page != "docs/README.md" and page[5:] not in linked:
            yield f"{page}: docs/README.md has no link to it"
    used = {target for text in pages.values() for target in re.findall(r"pictures/([\w-]+\.png)", text)}
    for picture in sorted(exists("docs/pictures", "*.png")):
        if picture not in used:
            yield f"docs/pictures/{picture}: no page shows it"
        if picture not in spans_of(pages["docs/README.md"]):
            yield f"docs/pictures/{picture}: docs/README.md names no command that makes it"


def missing_paths(pages, _, exists):
    rooms = r"(?:\./)?((?:src|include|tests|shaders|docs|cmake|examples|\.ci)/[\w./-]*|(?:run|test)\.sh)"
    for page, text in pages.items():
        for line in lines_of_code(text):
            for path in re.findall(rf"(?:^|\s){rooms}(?=$|[\s,:;])", line):
                if not exists(path):
                    yield f"{page}: there is no {path}"
            for header in re.findall(r"tyg/\w+\.h\b", line):
                if not exists(f"include/{header}"):
                    yield f"{page}: there is no include/{header}"
            found = re.match(r"build/\w+/tests/(\w+)", line)
            if found and not any(exists(f"tests/{folder}{found[1]}.cpp") for folder in ("", "benchmarks/")):
                yield f"{page}: nothing builds {found[0]}"
    for line in section(pages["README.md"], "## Where things are").splitlines():
        words = line.split()
        for folder in [word.rstrip(":,") for word in words[1:] if re.fullmatch(r"\w+/[:,]?", word)]:
            if not exists(words[0] + folder) and not exists(folder):
                yield f"README.md: there is no {words[0]}{folder}"


def wrong_commands(pages, truth, _):
    every = set.union(*truth.options.values()) | {"--version"}
    for page, text in pages.items():
        for line in lines_of_code(text):
            words = re.split(r"\s{2,}|; ", line)[0].split()  # what follows explains
            if line.startswith("--") and len(words) > 0 and words[0] not in every and re.fullmatch(r"--[a-z-]+", words[0]):
                yield f"{page}: no command has {words[0]}"
            while words and words[0] in ("$", "./run.sh"):
                if words.pop(0) == "./run.sh":
                    words.insert(0, "tyg")
            if len(words) < 2 or words[0] != "tyg" or words[1].endswith(":"):  # `tyg run: ...` is what it says
                continue
            yield from (f"{page}: `{line}`: {wrong}" for wrong in wrong_words(words[1:], truth))


def wrong_words(words, truth):
    """Of one command line without `tyg`."""
    is_placeholder = re.compile(r"[A-Z\[<(].*|.*[./].*").fullmatch
    command = "view"
    if words[0] in truth.options:
        command = words.pop(0)
    elif not words[0].startswith("-") and words[0] not in truth.scenes and not is_placeholder(words[0]):
        yield f"{words[0]} is no command and no scene"
        return
    if words and words[0] not in truth.scenes and not words[0].startswith("-") and not is_placeholder(words[0]):
        yield f"{words[0]} is no scene"
    known = truth.options[command] | ({"--version"} if command == "view" else set())
    for word, value in zip(words, words[1:] + [""]):
        if word.startswith("--") and word not in known:
            yield f"{command} has no {word}"
        if word in ("--integrator", "--methods"):
            for name in value.split(","):
                if name and name not in truth.methods and not is_placeholder(name):
                    yield f"{name} is no method"


def unnamed(pages, truth, _):
    spans = {span for text in pages.values() for span in spans_of(text)}
    for kind, names in (("scene", truth.scenes), ("method", truth.methods)):
        yield from (f"no page names the {kind} {name}" for name in sorted(names - spans))
    yield from (f"{span} is no scene" for span in sorted(spans) if re.fullmatch(r"fail-[a-z-]+", span)
                and span not in truth.scenes)
    tables = (("docs/scenes.md", "## Built-in scenes", truth.scenes), ("docs/methods.md", "# Methods", truth.methods),
              ("docs/model.md", "## 6.", truth.methods), ("docs/model.md", "## 8.", truth.methods))
    for page, heading, names in tables:
        listed = set(first_cells(section(pages[page], heading)))
        yield from (f"{page}: {name} is not in the table" for name in sorted(names - listed)
                    if not name.startswith("fail-"))
        yield from (f"{page}: the table has {name}, the program does not" for name in sorted(listed - names))


def options_of_commands(pages, truth, _):
    page = "docs/commands.md"
    shared = truth.shared - {"--help"}
    described = set(re.findall(r"--[a-z-]+", " ".join(first_cells(section(pages[page], "## Options of every command")))))
    yield from (f"{page}: options of all commands: {option} is missing" for option in sorted(shared - described))
    for command, options in truth.options.items():
        text = section(pages[page], f"## tyg {command}\n".rstrip())
        described = {span.split()[0] for span in first_cells(text) if span.startswith("--")}
        yield from (f"{page}: {command}: {option} is missing" for option in sorted(options - truth.shared - described))
        yield from (f"{page}: {command} has no {option}" for option in sorted(described - options))
    named = {word for span in spans_of(pages[page]) for word in span.split()}
    yield from (f"{page}: the JSON key {key} is missing" for key in sorted(truth.json_keys - named))


def keys_of_scenes(pages, truth, _):
    page = "docs/scenes.md"
    every = section(pages[page], "## Every key")
    for table, keys in truth.scene_keys.items():
        if not keys:
            yield f"{page}: the program did not tell the keys of [{table}]"
        heading = re.search(r"^### .*\[%s\].*$" % re.escape(table), every, re.M)
        text = section(every, heading.group(0) if heading else "### At the top of the file")
        if table and not heading:
            yield f"{page}: no section tells of the table {table}"
            continue
        described = first_cells(text)
        yield from (f"{page}: {table}: the key {key} is missing" for key in keys if key not in described)
        yield from (f"{page}: {table} has no key {key}" for key in described if key not in keys)


def long_readme(pages, _, __):
    lines = pages["README.md"].count("\n")
    if lines > MOST_LINES_OF_README:
        yield f"README.md: {lines} lines, allowed are {MOST_LINES_OF_README}"


def wrong_example(pages, truth, _):
    if f"```cpp\n{truth.example}```" not in pages["docs/embedding.md"]:
        yield f"docs/embedding.md: does not hold the text of {EXAMPLE}"


CHECKS = (wrong_example, broken_links, lost_pages_and_pictures, missing_paths, wrong_commands, unnamed, options_of_commands,
          keys_of_scenes, long_readme)


def complaints(pages, truth, exists):
    return [complaint for check in CHECKS for complaint in check(pages, truth, exists)]


def wrong_citations(source, pages):
    """What comments in the code cite is there."""
    sections = set(re.findall(r"^## (\d+)\.", pages["docs/model.md"], re.M))
    for folder in ("src", "include", "tests", "examples"):
        for path in (source / folder).rglob("*"):
            if path.suffix not in (".h", ".cpp", ".toml", ".sh"):
                continue
            text = re.sub(r"\n\s*(///?|#) ?", " ", path.read_text(encoding="utf-8"))
            name = path.relative_to(source)
            yield from (f"{name}: docs/model.md has no section {number}"
                        for number in re.findall(r"model(?:\.md)?, section (\d+)", text) if number not in sections)
            yield from (f"{name}: there is no {page}" for page in re.findall(r"docs/[\w-]+\.md", text)
                        if page not in pages)
            yield from (f'{name}: README.md has no heading "{heading}"' for heading in re.findall(r'README, "([^"]+)"', text)
                        if f"# {heading}\n" not in pages["README.md"])


# Planted mistakes: (page, what is there, what it becomes, what must be said).
PLANTED = (
    ("README.md", "## Commands", "[x](docs/nowhere.md)\n\n## Commands", "there is no docs/nowhere.md"),
    ("README.md", "## Commands", "[x](docs/model.md#9-beyond)\n\n## Commands", "no such heading"),
    ("docs/README.md", "(window.md)", "(scenes.md)", "docs/window.md: docs/README.md has no link"),
    ("docs/README.md", "`front.png`", "`back.png`", "front.png: docs/README.md names no command"),
    ("README.md", "docs/pictures/front.png", "docs/pictures/window.png", "front.png: no page shows it"),
    ("README.md", "## Commands", "`src/cellar/`\n\n## Commands", "there is no src/cellar/"),
    ("README.md", "## Commands", "    build/release/tests/nothing\n\n## Commands", "nothing builds"),
    ("docs/embedding.md", "tyg/sheet.h", "tyg/cellar.h", "there is no include/tyg/cellar.h"),
    ("docs/embedding.md", "cloth.tick(100)", "cloth.tick(10)", "does not hold the text of"),
    ("README.md", "work/ limits/", "work/ attic/", "there is no src/study/attic/"),
    ("docs/methods.md", "# Methods\n", "# Methods\n\n`tyg dance`\n", "dance is no command"),
    ("docs/methods.md", "# Methods\n", "# Methods\n\n`tyg run carpet`\n", "carpet is no scene"),
    ("docs/methods.md", "# Methods\n", "# Methods\n\n    tyg run curtain --budget 4ms\n", "run has no --budget"),
    ("docs/methods.md", "# Methods\n", "# Methods\n\n`tyg flag --integrator rk5`\n", "rk5 is no method"),
    ("docs/methods.md", "# Methods\n", "# Methods\n\n`--faster`\n", "no command has --faster"),
    ("docs/methods.md", "| `xpbd` |", "| `xpbdd` |", "docs/methods.md: xpbd is not in the table"),
    ("docs/scenes.md", "`fail-wet`", "`fail-dry`", "fail-dry is no scene"),
    ("docs/scenes.md", "| `hammock` |", "| `swing` |", "the table has swing"),
    ("docs/commands.md", "| `--ledger` |", "| ledger |", "run: --ledger is missing"),
    ("docs/commands.md", "| `--ledger` |", "| `--leger` |", "run has no --leger"),
    ("docs/commands.md", "| `--sheet CxR` |", "| sheet |", "options of all commands: --sheet is missing"),
    ("docs/commands.md", "`max_stretch`", "max stretch", "the JSON key max_stretch is missing"),
    ("docs/scenes.md", "| `spacing` |", "| spacing |", "sheet: the key spacing is missing"),
    ("docs/scenes.md", "| `kd` |", "| `kx` |", "springs has no key kx"),
    ("docs/scenes.md", "### `[world]`", "### World", "no section tells of the table world"),
    ("README.md", "## Commands", "\n" * MOST_LINES_OF_README + "## Commands", "lines, allowed are"),
)


def main(source, tyg):
    def exists(path, pattern=None):
        if pattern:
            return {found.name for found in (source / path).glob(pattern)}
        return (source / path).exists()

    files = [source / "README.md", *sorted((source / "docs").glob("*.md"))]
    pages = {str(file.relative_to(source)): file.read_text(encoding="utf-8") for file in files}
    truth = Truth(tyg)
    truth.example = (source / EXAMPLE).read_text(encoding="utf-8")
    found = complaints(pages, truth, exists) + list(wrong_citations(source, pages))
    for page, before, after, expected in PLANTED:
        spoiled = {**pages, page: pages[page].replace(before, after)}
        if spoiled == pages:
            found.append(f"docs_test.py: cannot plant '{expected}': {page} does not hold '{before}'")
        elif not any(expected in complaint for complaint in complaints(spoiled, truth, exists)):
            found.append(f"docs_test.py: a planted mistake was not noticed: {expected}")
    print("\n".join(found), end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]), sys.argv[2]))
