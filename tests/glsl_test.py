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
    # The types are those of src/gpu/kernel.cpp.
    types = re.findall(r'"(#define [^"]*)"', (source / "src/gpu/kernel.cpp").read_text())
    half = len(types) // 2
    in_double, in_float = ("".join(lines).replace("\\n", "\n") for lines in (types[:half], types[half:]))
    assert "dvec3" in in_double and "real float" in in_float, types

    def program(defines, *names):
        return "#version 430 core\n" + defines + "".join((kernels / name).read_text() for name in names)

    step = ["fields.glsl", "exact.glsl", "springs.glsl", "air.glsl", "contact.glsl", "force.glsl", "step.glsl"]
    # With all terms and with none; every update with every damping law.
    for terms, update, damping in product([0, 1], range(7), range(3)):
        defines = in_float + f"#define UPDATE {update}\n#define DAMPING {damping}\n"
        defines += "".join(f"#define {name} {terms}\n" for name in "STRUCTURAL SHEAR BEND AIR CONTACT CUT".split())
        yield f"step.glsl, terms {terms}, update {update}, damping {damping}", program(defines, *step), "comp"
    measure = ["fields.glsl", "exact_double.glsl", "air.glsl", "contact.glsl", "measure.glsl"]
    for terms, energy, axial in product([0, 1], [0, 1], [0, 1]):
        defines = in_double + f"#define ENERGY {energy}\n#define AXIAL {axial}\n"
        defines += "".join(f"#define {name} {terms}\n" for name in "AIR CONTACT CUT".split())
        yield f"measure.glsl, terms {terms}, energy {energy}, axial {axial}", program(defines, *measure), "comp"
    alone = {path.name for path in kernels.glob("*.glsl")} - {*step, *measure}
    for name in sorted(alone):
        yield name, program(in_float + "#define CUT 1\n", "fields.glsl", name), "comp"


assert complaint("#version 430 core\nvoid main() { int whole = 1.5; }\n", "vert"), "it takes what is wrong"
programs = [*shader_programs(), *kernel_programs()]
assert len(programs) > 70, f"only {len(programs)} programs"
bad = [f"{name}: {said}" for name, text, stage in programs if (said := complaint(text, stage))]
print("\n".join(bad))
sys.exit(1 if bad else 0)
