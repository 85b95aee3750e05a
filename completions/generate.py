#!/usr/bin/env python3
"""Makes the manual page and the completions of the shells from what `--help` shows.

usage: generate.py PROGRAM [--check]: writes the files, or lists those that are outdated.
"""

import json
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
PROGRAM_FILES = {"view": "proskill|json"}


class Option:
    def __init__(self, row):
        self.names = ["-" + it for it in row["short"]] + ["--" + it for it in row["long"]]
        self.positional, self.group, self.sentence = row["positional"], row["group"], row["sentence"]
        self.value, self.required, self.many = row["value"], row["required"], row["many"]

    @property
    def long(self):
        return self.names[-1] if self.names else ""

    @property
    def words(self):
        """The allowed values of an option, if they are a list."""
        if "|" in self.value:
            return self.value.split("|")
        return ["counts"] if self.long == "--graph" else []


def commands_of(program):
    data = json.loads(subprocess.run([program, "help-data"], capture_output=True, text=True, check=True).stdout)
    for command in data["commands"]:
        command["options"] = [Option(row) for row in command["options"]]
    return data


def plain(command):
    return [it for it in command["options"] if not it.positional]


# The manual page.

def roff(text):
    return text.replace("\\", "\\e").replace("-", "\\-").replace("'", "\\(aq")


def roff_command(command):
    yield f".SS {command['name']}"
    yield roff(command["sentence"]) + "."
    group = None
    for option in command["options"]:
        if option.long == "--help":
            continue
        if not option.positional and option.group != group:
            group = option.group
            yield f".PP\n.I {roff(group)}"
        names = option.positional or ", ".join(option.names)
        value = f" \\fI{roff(option.value)}\\fR" if option.value and not option.positional else ""
        yield f".TP\n\\fB{roff(names)}\\fR{value}\n{roff(option.sentence)}."
    yield ".PP\n.nf\n" + roff(command["below"]) + "\n.fi"


def roff_argument(option):
    if option.words:
        text = ".BR " + " | ".join(option.words)
    else:
        text = f".I {option.positional.upper()}" + ("..." if option.many else "")
    return text if option.required else f".RI [ {text.split(' ', 1)[1]} ]"


def synopsis(data):
    """One line for each command."""
    for command in data["commands"]:
        arguments = [roff_argument(it) for it in command["options"] if it.positional]
        yield "\n".join([f".B proskill {command['name']}", ".RI [ OPTION ]...", *arguments])


def exits_of(below):
    """The exit codes in the text below the options, with their meanings."""
    text = re.sub(r"\n {5,}", " ", below.partition("Exit code:\n")[2])
    return dict(re.findall(r"^  (\d+) +(.+)", text, re.M))


def exit_status(data):
    """What each code means in general, and for each command that has it."""
    for code, meaning in exits_of(data["below"]).items():
        yield f".TP\n.B {code}\n{roff(meaning)}."
        special = [(it["name"], exits_of(it["below"]).get(code)) for it in data["commands"]]
        if code.startswith("7"):
            continue
        yield ".RS"
        yield from (f".TP\n.B {name}\n{roff(text)}." for name, text in special if text)
        yield ".RE"


def manual(data):
    body = "\n".join(line for command in data["commands"] for line in roff_command(command))
    page = (HERE / "proskill.1.head").read_text() + body + "\n" + (HERE / "proskill.1.tail").read_text()
    for mark, text in (("VERSION", data["version"]), ("SYNOPSIS", "\n.br\n".join(synopsis(data))),
                       ("EXITS", "\n".join(exit_status(data)))):
        page = page.replace(f"@{mark}@", text)
    return page


# The shells.

def bash_kind(option):
    return {"DIRECTORY": "-d", "FILE": "-f", "PROGRAM": "-c"}.get(option.value)


def bash(data):
    names = [it["name"] for it in data["commands"]]
    values, options, kinds = [], [], []
    endings = [f"    {name}) echo '{words.replace('|', ' ')}' ;;" for name, words in PROGRAM_FILES.items()]
    for command in data["commands"]:
        options.append(f"    {command['name']}) echo '{' '.join(it.long for it in plain(command))}' ;;")
        for option in plain(command):
            for name in option.names:
                if option.words:
                    values.append(f"    '{command['name']} {name}') echo '{' '.join(option.words)}' ;;")
                elif bash_kind(option):
                    kinds.append(f"    '{command['name']} {name}') echo '{bash_kind(option)}' ;;")
        for option in command["options"]:
            if option.positional and option.words:
                values.append(f"    '{command['name']} {command['name']}') echo '{' '.join(option.words)}' ;;")
    text = (HERE / "proskill.bash.in").read_text()
    for mark, lines in (("VALUES", values), ("KINDS", kinds), ("ENDINGS", endings), ("OPTIONS", options), ("COMMANDS", [" ".join(names)])):
        text = text.replace(f"@{mark}@", "\n".join(lines).strip() if mark == "COMMANDS" else "\n".join(lines))
    return text


def zsh_quoted(text):
    return text.replace("'", "'\\''").replace("[", "(").replace("]", ")").replace(":", "\\:")


def zsh_value(option):
    words = " ".join(option.words)
    if option.long == "--graph":
        return ":file:_files"
    if option.many and words:
        return f":names:_values -s , name {words}"
    if words:
        return f":value:({words})"
    kind = {"FILE": "_files", "PROGRAM": "_files", "DIRECTORY": "_files -/", "PROPERTY": "_proskill_properties"}
    return f":{option.value.lower()}:{kind.get(option.value, ' ')}" if option.value else ""


def zsh(data):
    commands = "\n".join(f"    '{it['name']}:{zsh_quoted(it['sentence'])}'" for it in data["commands"])
    cases = []
    for command in data["commands"]:
        lines = []
        for option in plain(command):
            spec = f"[{zsh_quoted(option.sentence)}]{zsh_value(option)}"
            repeated = "*" if option.value == "PROPERTY" else ""
            names = "{" + ",".join(option.names) + "}" if len(option.names) > 1 else ""
            lines.append(f"        {names}'{spec}'" if names else f"        '{repeated}{option.long}{spec}'")
        for option in command["options"]:
            if option.positional:
                lines.append(f"        '1:{option.positional}:({' '.join(option.words)})'" if option.words else
                             f"        '*:{option.positional}:" + zsh_positional(command, option) + "'")
        cases.append(f"    {command['name']})\n      _arguments \\\n" + " \\\n".join(lines) + " ;;")
    return (HERE / "_proskill.in").read_text().replace("@COMMANDS@", commands).replace("@CASES@", "\n".join(cases))


def zsh_positional(command, option):
    if option.positional == "code":
        return " "
    return f'_files -g "*.({PROGRAM_FILES.get(command["name"], "proskill|fcr")})"'


def fish_quoted(text):
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"


def fish_value(option):
    if option.words:
        return f" -x -a '{' '.join(option.words)}'" if option.long != "--graph" else " -r -a counts"
    kind = {"FILE": " -r", "PROGRAM": " -r", "DIRECTORY": " -x -a '(__fish_complete_directories)'",
            "PROPERTY": " -x -a '(__proskill_properties)'"}
    return kind.get(option.value, " -x") if option.value else ""


def fish(data):
    lines = []
    for command in data["commands"]:
        name = command["name"]
        seen = f"complete -c proskill -n '__fish_seen_subcommand_from {name}'"
        lines.append(f"complete -c proskill -n __fish_use_subcommand -a {name} -d {fish_quoted(command['sentence'])}")
        for option in plain(command):
            short = "".join(f" -s {it[1:]}" for it in option.names if not it.startswith("--"))
            lines.append(f"{seen}{short} -l {option.long[2:]} -d {fish_quoted(option.sentence)}{fish_value(option)}")
        for option in command["options"]:
            if option.positional and option.words:
                lines.append(f"{seen} -a '{' '.join(option.words)}'")
            elif option.positional == "file":
                for ending in PROGRAM_FILES.get(name, "proskill|fcr").split("|"):
                    lines.append(f"{seen} -ka '(__fish_complete_suffix .{ending})'")
    return (HERE / "proskill.fish.in").read_text().replace("@OPTIONS@", "\n".join(lines))


def main():
    data = commands_of(sys.argv[1])
    made = {HERE.parent / "man/proskill.1": manual(data), HERE / "proskill.bash": bash(data),
            HERE / "_proskill": zsh(data), HERE / "proskill.fish": fish(data)}
    stale = [path for path, text in made.items() if not path.exists() or path.read_text() != text]
    if "--check" in sys.argv:
        for path in stale:
            print(f"{path.relative_to(HERE.parent)} is not what completions/generate.py makes")
        return 1 if stale else 0
    for path in stale:
        path.write_text(made[path])
    return 0


if __name__ == "__main__":
    sys.exit(main())
