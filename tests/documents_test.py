#!/usr/bin/env python3
# The manual page and the completions, made from the program's help: every command and every option is in each of them, the
# manual page has no mistake that man finds, and bash completes words as a person would type them.
#   tests/documents_test.py SOURCE_DIR PATH_OF_TYG
import importlib.util
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

source, tyg = pathlib.Path(sys.argv[1]), sys.argv[2]
spec = importlib.util.spec_from_file_location("documents", source / "packaging/documents.py")
documents = importlib.util.module_from_spec(spec)
sys.modules["documents"] = documents
spec.loader.exec_module(documents)


def help_of(*words):
    return subprocess.run([tyg, *words, "--help"], capture_output=True, encoding="utf-8", check=True, timeout=60).stdout


def commands_and_options():
    """Found without the reader that is tested."""
    listed = help_of().split("Subcommands:")[1].split("\n\n")[0]
    for command in re.findall(r"^  ([a-z]+) ", listed, re.M):
        pairs = re.findall(r"^  (?:-h,)?(--[a-z-]+)(?:,(--[a-z-]+))?", help_of(command), re.M)
        yield command, [name for pair in pairs for name in pair if name]


def must(condition, words):
    if not condition:
        sys.exit(words)


def completed(script, *words):
    """What bash offers for the last of these words."""
    asked = f'source "$1"; shift; COMP_WORDS=(tyg "$@"); COMP_CWORD=$#; _tyg; printf "%s\\n" "${{COMPREPLY[@]}}"'
    said = subprocess.run(["bash", "-c", asked, "bash", script, *words], capture_output=True, encoding="utf-8", timeout=60)
    must(said.returncode == 0, f"bash: {said.stderr}")
    return said.stdout.split()


with tempfile.TemporaryDirectory() as folder:
    subprocess.run([sys.executable, source / "packaging/documents.py", tyg, folder], check=True, timeout=120)
    page, bash, zsh, fish = (pathlib.Path(folder, name) for name in ("tyg.1", "tyg.bash", "_tyg", "tyg.fish"))
    manual = page.read_text(encoding="utf-8")
    count = 0
    for command, options in commands_and_options():
        section = manual.split(f"\n.SS tyg {command}\n")[1].split("\n.SS ")[0]
        must(command in completed(bash, command[:2]), f"bash offers no {command}")
        offered = completed(bash, command, "--")
        for option in options:
            count += 1
            must(f"\\fB{documents.roff(option)}\\fR" in section, f"the manual page of {command} lacks {option}")
            must(option in offered, f"bash offers no {option} of {command}")
            must(re.search(rf"'{option}\[", zsh.read_text(encoding="utf-8")), f"zsh offers no {option}")
            must(f"from {command}' -l {option[2:]} " in fish.read_text(encoding="utf-8"), f"fish offers no {option} of {command}")
    must(count > 100, f"found only {count} options")
    must(completed(bash, "run", "--integrator", "leap") == ["leapfrog"], "bash completes no method")
    must(completed(bash, "chart", "--methods", "rk4,leap") == ["rk4,leapfrog"], "bash completes no list of methods")
    must(completed(bash, "run", "--precision", "d") == ["double"], "bash completes no precision")
    must("hammock" in completed(bash, "run", "ham"), "bash completes no scene")
    must(completed(bash, "run", "--no-such") == [], "bash offers what is not there")
    if shutil.which("groff"):
        said = subprocess.run(["groff", "-man", "-Tutf8", "-ww", "-z", page], capture_output=True, encoding="utf-8", timeout=60)
        must(said.returncode == 0 and not said.stderr, f"groff: {said.stderr}")
    for shell, script in (("zsh", zsh), ("fish", fish)):
        if shutil.which(shell):
            subprocess.run([shell, "-n", script], check=True, timeout=60)
