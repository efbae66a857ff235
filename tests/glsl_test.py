#!/usr/bin/env python3
"""The reference compiler of OpenGL's makers takes every shader and every kind of compute program: a driver may take what
others refuse. Proves first that it can fail.
    tests/glsl_test.py SOURCE_DIR GLSLANG_VALIDATOR
"""
import re
import subprocess
import sys
import tempfile
from itertools import product
from pathlib import Path

source, compiler = Path(sys.argv[1]), sys.argv[2]
shaders, kernels = source / "shaders", source / "src/gpu/kernels"


def complaint(text, stage):
    with tempfile.NamedTemporaryFile("w", suffix="." + stage) as file:
        file.write(text)
        file.flush()
        return subprocess.run([compiler, "-S", stage, file.name], capture_output=True, text=True).stdout.strip()


def shader_programs():
    for path in sorted([*shaders.glob("*.vert"), *shaders.glob("*.frag")]):
        text = path.read_text()
        for name in re.findall(r'#include "(.*)"', text):
            text = text.replace(f'#include "{name}"', (shaders / name).read_text())
        for pattern in ["", *sorted(set(re.findall(r"defined\((\w+)\)", text)))]:
            define = f"#define {pattern}\n" if pattern else ""
            yield f"{path.name} {pattern}", text.replace("#version 330 core\n", "#version 330 core\n" + define), path.suffix[1:]


def kernel_programs():
    def program(file, **defines):
        text = (kernels / file).read_text()
        while found := re.search(r'#include "(.*)"', text):
            text = text.replace(found[0], (kernels / found[1]).read_text())
        lines = "".join(f"#define {name} {value}\n" for name, value in defines.items())
        return " ".join([file, *map(str, defines.values())]), "#version 430 core\n" + lines + text, "comp"

    mains = sorted(path.name for path in kernels.glob("*.glsl") if "void main()" in path.read_text())
    assert len(mains) == 5, mains
    # With all terms and with none; every update with every damping law.
    for terms in [0, 1]:
        all_terms = {name: terms for name in "STRUCTURAL SHEAR BEND AIR CONTACT CUT".split()}
        for update, damping in product(range(7), range(3)):
            yield program("step.glsl", UPDATE=update, DAMPING=damping, **all_terms)
        for energy, axial in product([0, 1], [0, 1]):
            yield program("measure.glsl", ENERGY=energy, AXIAL=axial, **all_terms)
    for name in set(mains) - {"step.glsl", "measure.glsl"}:
        yield program(name, CUT=1)


assert complaint("#version 430 core\nvoid main() { int whole = 1.5; }\n", "vert"), "it takes what is wrong"
programs = [*shader_programs(), *kernel_programs()]
assert len(programs) > 70, f"only {len(programs)} programs"
bad = [f"{name}: {said}" for name, text, stage in programs if (said := complaint(text, stage))]
print("\n".join(bad))
sys.exit(1 if bad else 0)
