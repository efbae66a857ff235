#!/usr/bin/env python3
# Makes the manual page and the completions of shells from what the program says of itself by --help, so that they never
# say anything else. Needs nothing but Python and the program.
#   packaging/documents.py PATH_OF_TYG FOLDER     writes FOLDER/tyg.1, tyg.bash, _tyg (zsh) and tyg.fish
import json
import pathlib
import re
import subprocess
import sys
from dataclasses import dataclass, field

LEFT_COLUMN = re.compile(r"^  (\S.*?)(?:  +(\S.*))?$")
FILE_VALUES = re.compile(r"FILE|PATH|DIR|LOG|FOLDER|\.csv|\.toml")


@dataclass
class Option:
    names: list
    value: str = ""  # what the help shows in its place; nothing: a flag
    text: str = ""


@dataclass
class Command:
    name: str
    text: str = ""      # one line
    usage: str = ""
    about: str = ""     # the lines above the usage
    options: list = field(default_factory=list)
    footer: str = ""    # the lines below the options
    commands: list = field(default_factory=list)  # (name, text)


def said(tyg, *words):
    return subprocess.run([tyg, *words], capture_output=True, encoding="utf-8", check=True, timeout=60).stdout


def read_help(name, text):
    """One page of --help."""
    command, lines = Command(name), text.splitlines()
    at = next(i for i, line in enumerate(lines) if line.startswith("Usage: "))
    command.about = "\n".join(lines[:at]).strip()
    command.usage = lines[at].removeprefix("Usage: ").strip()
    heading, pending = "", None
    for i, line in enumerate(lines[at + 1:], at + 1):
        if re.fullmatch(r"[A-Z][A-Za-z ]*:", line) and line != "Examples:":
            heading, pending = line, None
        elif not line.strip():
            pending = None
        elif not line.startswith("  "):
            command.footer = "\n".join(lines[i:]).rstrip()
            break
        elif pending is not None and line.startswith(" " * 20):
            pending.text = f"{pending.text} {line.strip()}".strip()
        else:
            left, right = LEFT_COLUMN.match(line).groups()
            if heading == "Subcommands:":
                command.commands.append((left, right or ""))
                continue
            names, _, value = re.sub(r" (Excludes|Needs): .*", "", left).partition(" ")
            pending = Option(names.split(","), value, right or "")
            command.options.append(pending)
    return command


class Program:
    """Commands with their options; scenes and methods."""

    def __init__(self, tyg):
        self.version = said(tyg, "--version").split()[1]
        self.whole = read_help("tyg", said(tyg, "--help"))
        self.commands = []
        for name, text in self.whole.commands:
            command = read_help(name, said(tyg, name, "--help"))
            command.text = text
            self.commands.append(command)
        listed = json.loads(said(tyg, "list", "--json"))
        self.scenes = [scene["name"] for scene in listed["scenes"]]
        self.methods = [method["name"] for method in listed["methods"]]

    def values_of(self, option):
        """The words that an option takes; nothing where they cannot be listed."""
        if "--integrator" in option.names:
            return self.methods
        return option.value.split("|") if "|" in option.value else []


# The manual page (man(7) of groff).

def roff(text):
    return re.sub(r"^([.'])", r"\\&\1", text.replace("\\", "\\e").replace("-", "\\-"), flags=re.M)


def verbatim(text):
    return f".EX\n{roff(text)}\n.EE\n"


def entries(options):
    page = ""
    for option in options:
        names = ", ".join(f"\\fB{roff(name)}\\fR" for name in option.names)
        page += f".TP\n{names}{' ' if option.value else ''}\\fI{roff(option.value)}\\fR\n{roff(option.text)}\n"
    return page


def manual(program):
    page = f'.TH TYG 1 "" "tyg {program.version}" "User Commands"\n'
    page += ".SH NAME\ntyg \\- interactive cloth viewer and simulator\n"
    page += f".SH SYNOPSIS\n.B tyg\n[\\fICOMMAND\\fR] [\\fISCENE\\fR] [\\fIOPTIONS\\fR]\n"
    page += f".SH DESCRIPTION\n{roff(program.whole.about)}\n.SH OPTIONS\n{entries(program.whole.options)}"
    page += ".SH COMMANDS\n"
    for command in program.commands:
        page += f".SS tyg {roff(command.name)}\n{roff(command.about)}\n.PP\nUsage: {roff(command.usage)}\n"
        page += entries(command.options)
        if command.footer:
            page += ".PP\n" + verbatim(command.footer)
    return page + ".SH SCENES, EXAMPLES AND EXIT CODES\n" + verbatim(program.whole.footer)


# Completions. Each knows the value of an option only where it can be listed or is a file.

def bash(program):
    value_cases, option_cases, flags = [], [], []
    known = {}
    for command in program.commands:
        names = [name for option in command.options for name in option.names if name.startswith("-")]
        option_cases.append(f"    {command.name}) options='{' '.join(names)}' ;;")
        for option in command.options:
            for name in option.names:
                if name.startswith("-"):
                    known[name] = option
    for name, option in known.items():
        words = program.values_of(option)
        if words:
            value_cases.append(f"    {name}) _tyg_words '{' '.join(words)}'; return ;;")
        elif FILE_VALUES.search(option.value):
            value_cases.append(f"    {name}) _tyg_files; return ;;")
        elif option.value:
            flags.append(name)
    lines = ["# Completions of tyg for bash, made from what tyg --help says.",
             "_tyg_words() { # words; behind a comma the list goes on",
             "  local front=",
             '  if [[ $current == *,* ]]; then front=${current%,*},; fi',
             '  COMPREPLY=($(compgen -P "$front" -W "$1" -- "${current##*,}"))',
             "}",
             "_tyg_files() { compopt -o filenames 2>/dev/null; local IFS=$'\\n'; COMPREPLY=($(compgen -f -- \"$current\")); }",
             "_tyg() {",
             '  local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]} options=',
             "  COMPREPLY=()",
             "  case $before in",
             *value_cases,
             f"    {'|'.join(flags)}) return ;;",
             "  esac",
             "  case $command in",
             *option_cases,
             "    *) command=view; options='--help --version' ;;",
             "  esac",
             f"  local commands='{' '.join(command.name for command in program.commands)}'",
             f"  local scenes='{' '.join(program.scenes)}'",
             "  if [[ $current == -* ]]; then",
             '    COMPREPLY=($(compgen -W "$options" -- "$current"))',
             "  elif ((COMP_CWORD == 1)); then",
             '    COMPREPLY=($(compgen -W "$commands $scenes" -- "$current"))',
             "  else",
             "    _tyg_files",
             '    COMPREPLY+=($(compgen -W "$scenes" -- "$current"))',
             "  fi",
             "}",
             "complete -F _tyg tyg"]
    return "\n".join(lines) + "\n"


def quoted(text):
    return "'" + text.replace("'", "'\\''") + "'"


def zsh_text(text):
    return re.sub(r"([\[\]:\\])", r"\\\1", text).replace("'", "'\\''")


def zsh(program):
    lines = ["#compdef tyg", "# Completions of tyg for zsh, made from what tyg --help says.", "_tyg() {",
             f"  local -a scenes=({' '.join(program.scenes)}) commands=("]
    lines += [f"    '{command.name}:{zsh_text(command.text)}'" for command in program.commands]
    lines += ["  )", "  if ((CURRENT == 2)); then",
              "    _describe command commands", "    compadd -a scenes", "    return", "  fi",
              "  local command=$words[2]", "  shift words; ((CURRENT -= 1))", "  case $command in"]
    for command in program.commands:
        lines.append(f"    {command.name}) _arguments \\")
        for option in command.options:
            words = program.values_of(option)
            action = f"({' '.join(words)})" if words else "_files" if FILE_VALUES.search(option.value) else " "
            for name in option.names:
                if name.startswith("-"):
                    value = f":{zsh_text(option.value)}:{action}" if option.value else ""
                    lines.append(f"      '{name}[{zsh_text(option.text)}]{value}' \\")
        lines.append("      '*:scene:{compadd -a scenes; _files}' ;;")
    return "\n".join(lines + ["  esac", "}", '_tyg "$@"']) + "\n"


def fish(program):
    names = " ".join(command.name for command in program.commands)
    lines = ["# Completions of tyg for fish, made from what tyg --help says.",
             f"complete -c tyg -n 'not __fish_seen_subcommand_from {names}' -l version -d 'Print the version and leave'",
             f"complete -c tyg -a {quoted(' '.join(program.scenes))}"]
    for command in program.commands:
        lines.append(f"complete -c tyg -n 'not __fish_seen_subcommand_from {names}' -a {command.name} "
                     f"-d {quoted(command.text)}")
        for option in command.options:
            long = [name[2:] for name in option.names if name.startswith("--")]
            if not long:
                continue
            words = program.values_of(option)
            value = ""
            if option.value:
                value = f" -x -a {quoted(' '.join(words))}" if words else " -r" if FILE_VALUES.search(option.value) else " -x"
            lines += [f"complete -c tyg -n '__fish_seen_subcommand_from {command.name}' -l {name}{value} "
                      f"-d {quoted(option.text)}" for name in long]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(f"found {len(sys.argv) - 1} words, allowed are the path of tyg and a folder")
    tyg = Program(sys.argv[1])
    folder = pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    for file, text in (("tyg.1", manual(tyg)), ("tyg.bash", bash(tyg)), ("_tyg", zsh(tyg)), ("tyg.fish", fish(tyg))):
        (folder / file).write_text(text, encoding="utf-8")
