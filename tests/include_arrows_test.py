#!/usr/bin/env python3
"""The arrows between the rooms of the house and between their folders, read from the includes; and which rooms may know
the screen, the clock, the terminal and the operating system. Proves first that it can fail.
    tests/include_arrows_test.py SOURCE_DIR
"""
import re
import sys
import tempfile
from pathlib import Path

# Room: the rooms that it may include, besides itself. Lower rooms come first: none may name a later one.
ROOMS = {
    "util": "",
    "core": "util",
    "integrators": "util core",
    "study": "util core integrators",
    "view": "util core",
    "gfx": "util core view",
    "gpu": "util core",
    "viewer": "util core integrators study view",
    "ui": "util core integrators study view gfx viewer",
    "app": "util core integrators study view gfx gpu viewer ui",
}

# Room: its folders (what lies deeper belongs to them) and the folders of the same room that each may include, again from the lowest up; "." is the room's
# own folder. A room that is not named here has no folders.
FOLDERS = {
    "util": {".": "", "posix": ".", "windows": "."},
    "core": {
        "public": "",
        "forces": "public",
        "scene": "public forces",
        "spectrum": "public forces scene",
        "simulation": "public forces scene spectrum",
    },
    "study": {
        "limits": "",
        "motion": "limits",
        "work": "limits motion",
        "diet": "limits motion work",
        "advice": "limits motion work diet",
        "check": "limits motion work",
        "charts": "limits motion work check",
    },
    "gfx": {".": "", "passes": ".", "contexts": "."},
    "ui": {"windows": "", "panels": "windows", ".": "windows panels"},
    "app": {"reports": "", "output": "reports", "commands": "reports output", ".": "reports output commands"},
}

# include/tyg/NAME: the place that it belongs to; a header that is not named here belongs to core/public, which
# all of core may include. Public headers include public headers only.
PUBLIC_HEADERS = {
    "input_error.h": "util",
    "event_log.h": "core/simulation",
    "simulation.h": "core/simulation",
    "methods.h": "integrators",
}

# What, the headers <...> that tell of it, and the rooms or folders that may include them.
HEADERS = [
    ("OpenGL", r"glad/|GL/|GLES|EGL/", "gfx gpu ui"),
    ("a window or ImGui", r"GLFW/|GL/(free)?glut|X11/|imgui|backends/imgui", "ui"),
    ("a clock", r"(chrono|ctime|time\.h|sys/time\.h)$", "util ui app"),
    ("the terminal", r"(iostream|syncstream|print)$", "ui app"),
    ("the operating system", r"(unistd|fcntl|spawn|poll|dlfcn|pthread|signal|windows|shellapi|io)\.h$|csignal$|sys/",
     "util gfx/contexts ui/windows"),
]

# What, the words in the code that tell of it, and the rooms or folders that may use them.
WORDS = [
    ("prints", r"\b(v?printf|puts|putchar|perror)\s*\(|\b(stdout|stderr)\b|\bstd::(cout|cerr|clog)\b", "ui app"),
    ("reads a clock", r"\b(clock_gettime|gettimeofday)\s*\(|\b(steady|system|high_resolution)_clock\b", "util ui app"),
]

INCLUDE = re.compile(r'\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>)')


def place_of(path):
    """(room, folder) of src/PATH, which is also what an #include names; a room of None is no room of the house."""
    first, *rest = path.split("/")
    if first == "tyg":
        room, _, folder = PUBLIC_HEADERS.get("/".join(rest), "core/public").partition("/")
        return room, folder or "."
    if path == "main.cpp":
        return "app", "."
    if not rest or first not in ROOMS:
        return None, "."
    return first, rest[0] if len(rest) > 1 else "."


def is_in(place, allowed):
    return place[0] in allowed.split() or "/".join(place) in allowed.split()


def may_include(place, target):
    if place[0] != target[0]:
        return target[0] in ROOMS[place[0]].split()
    return place[1] == target[1] or target[1] in FOLDERS[place[0]][place[1]].split()


def breaches_of(path, text):
    is_public = path.startswith("include/")
    place = place_of(path.partition("/")[2])
    if place[0] is None or place[1] not in FOLDERS.get(place[0], {".": ""}):
        yield f"{path}: lies in no room or folder of the house"
        return
    name = "/".join(place).removesuffix("/.")
    for number, line in enumerate(text.splitlines(), 1):
        code, where = line.partition("//")[0], f"{path}:{number}"
        include = INCLUDE.match(line)
        if include and include[1]:
            if is_public and not include[1].startswith("tyg/"):
                yield f"{where}: a public header includes \"{include[1]}\", which is not public"
            elif not may_include(place, place_of(include[1])):
                yield f"{where}: {name} may not include \"{include[1]}\""
        elif include:
            for what, pattern, allowed in HEADERS:
                if re.match(pattern, include[2]) and not is_in(place, allowed):
                    yield f"{where}: <{include[2]}> tells of {what}, and {name} must not know it; allowed in: {allowed}"
        else:
            for what, pattern, allowed in WORDS:
                if re.search(pattern, code) and not is_in(place, allowed):
                    yield f"{where}: {name} {what}; allowed in: {allowed}"


def breaches(root):
    files = sorted(f for folder in ["include", "src"] for f in (root / folder).rglob("*") if f.suffix in {".h", ".cpp"})
    found = [] if files else [f"{root}: no source file"]
    for file in files:
        found += breaches_of(file.relative_to(root).as_posix(), file.read_text(encoding="utf-8"))
    return found


WRONG = [
    ("src/util/a.cpp", '#include "core/scene/scene_table.h"'),
    ("src/util/a.cpp", '#include "tyg/scene.h"'),
    ("src/core/forces/a.cpp", '#include "integrators/rk4.h"'),
    ("src/core/forces/a.cpp", '#include "tyg/methods.h"'),
    ("src/core/forces/a.cpp", '#include "core/spectrum/rest_spectrum.h"'),
    ("src/core/scene/a.cpp", '#include "tyg/simulation.h"'),
    ("src/core/forces/a.cpp", '#include "core/scene/scene_table.h"'),
    ("src/core/forces/a.cpp", '#include "forces.h"'),
    ("src/core/a.cpp", "int x;"),
    ("include/tyg/a.h", 'int x;\n  #  include "core/forces/row_kernel.h"  '),
    ("include/tyg/scene.h", '#include "tyg/simulation.h"'),
    ("src/integrators/a.cpp", '#include "study/work/work_rows.h"'),
    ("src/integrators/explicit/a.cpp", "int x;"),
    ("src/study/work/a.cpp", '#include "view/camera.h"'),
    ("src/study/work/a.cpp", '#include "study/charts/gnuplot.h"'),
    ("src/study/a.cpp", "int x;"),
    ("src/study/cellar/a.cpp", "int x;"),
    ("src/view/a.cpp", '#include "tyg/methods.h"'),
    ("src/view/a.h", '#include "gfx/sheet_renderer.h"'),
    ("src/gfx/a.cpp", '#include "ui/windows/window.h"'),
    ("src/gfx/a.cpp", '#include "study/work/work_rows.h"'),
    ("src/gfx/passes/a.cpp", '#include "gfx/contexts/offscreen.h"'),
    ("src/viewer/a.cpp", '#include "gfx/sheet_renderer.h"'),
    ("src/viewer/a.h", '#include "ui/overlay.h"'),
    ("src/ui/a.cpp", '#include "app/commands/commands.h"'),
    ("src/ui/windows/a.cpp", '#include "ui/panels/panels.h"'),
    ("src/app/reports/a.cpp", '#include "app/output/render.h"'),
    ("src/view/a.cpp", "#include <glad/gl.h>"),
    ("src/study/work/a.cpp", "#include <GLFW/glfw3.h>"),
    ("src/gfx/contexts/a.cpp", "#include <GL/freeglut.h>"),
    ("src/viewer/a.cpp", "#include <imgui.h>"),
    ("src/app/a.cpp", "#include <imgui.h>"),
    ("src/viewer/a.cpp", "#include <chrono>"),
    ("src/gfx/a.cpp", "#include <iostream>"),
    ("src/core/scene/a.cpp", "#include <unistd.h>"),
    ("src/ui/panels/a.cpp", "#include <sys/wait.h>"),
    ("src/app/output/a.cpp", "#include <unistd.h>"),
    ("src/study/charts/a.cpp", "#include <windows.h>"),
    ("src/util/a.cpp", '#include "util/windows/wide.h"'),
    ("src/core/forces/a.cpp", 'void f() { std::printf("x"); }'),
    ("src/viewer/a.cpp", 'void f() { std::cerr << "x"; }'),
    ("src/util/a.cpp", 'void f() { fprintf(stderr, "x"); }'),
    ("src/study/work/a.cpp", "auto now = Clock::steady_clock::now();"),
    ("src/cellar/a.cpp", "int x;"),
    ("src/a.cpp", "int x;"),
]
RIGHT = [
    ("src/util/a.cpp", '#include <unistd.h>\n#include <chrono>\n#include "tyg/input_error.h"'),
    ("src/core/scene/a.cpp", '#include "tyg/sheet.h"\n#include "util/workers.h"\n#include "core/forces/forces.h"'),
    ("src/core/simulation/a.cpp", '#include "core/spectrum/rest_spectrum.h"\n#include "tyg/simulation.h"'),
    ("src/core/forces/a.cpp", 'void f() { std::snprintf(text, 9, "x"); }  // printf( to stderr'),
    ("src/viewer/a.cpp", 'void f() { std::fputs("x", file_); }'),
    ("include/tyg/simulation.h", '#include "tyg/method.h"'),
    ("src/integrators/a.cpp", '#include "tyg/methods.h"\n#include "core/forces/row_kernel.h"'),
    ("src/study/charts/a.cpp", '#include "study/work/work_rows.h"'),
    ("src/gfx/contexts/a.cpp", '#include <glad/gl.h>\n#include "gfx/contexts/offscreen.h"\n#include "view/camera.h"'),
    ("src/gfx/contexts/a.cpp", "#include <dlfcn.h>\n#include <EGL/egl.h>"),
    ("src/viewer/a.cpp", '#include "view/camera.h"\n#include "study/work/work_rows.h"'),
    ("src/ui/panels/a.cpp", '#include <imgui.h>\n#include "viewer/viewer.h"'),
    ("src/ui/windows/a.cpp", "#include <GL/freeglut.h>\n#include <poll.h>\n#include <chrono>"),
    ("src/app/commands/a.cpp", '#include <iostream>\n#include "ui/frame_loop.h"\n#include "app/output/progress.h"'),
    ("src/main.cpp", '#include "app/commands/command_line.h"'),
]


def prove_that_it_can_fail():
    for table in [ROOMS, *FOLDERS.values()]:
        for number, (name, allowed) in enumerate(table.items()):
            if not set(allowed.split()) <= set(list(table)[:number]):
                sys.exit(f"the table lets {name} see what is not below it: {allowed}")
    for path, text in WRONG:
        if len(list(breaches_of(path, text))) != 1:
            sys.exit(f"not noticed once in {path}: {text}")
    for path, text in RIGHT:
        for breach in breaches_of(path, text):
            sys.exit(f"wrongly refused: {breach}")
    with tempfile.TemporaryDirectory() as folder:
        for path in ["src/core/forces/a.h", "include/tyg/a.h"]:
            planted = Path(folder, path)
            planted.parent.mkdir(parents=True)
            planted.write_text('#include "app/commands/commands.h"\n', encoding="utf-8")
        if len(breaches(Path(folder))) != 2:
            sys.exit("what lies in files is not noticed")


prove_that_it_can_fail()
found = breaches(Path(sys.argv[1]))
sys.exit("\n".join(found) if found else 0)
