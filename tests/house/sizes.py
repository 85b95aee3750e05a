"""No source file has more than 400 lines and no folder more than 25 files: beyond that they hold more than one idea. Half of
all functions have at most 8 lines."""

import re
import statistics
from collections import Counter

from house import files, finish, read

LINES = 400
FILES = 25
FUNCTION = 8

# Tables, which nobody reads from end to end.
TABLES = {
    "syntax/diagnostics/diagnostics_flow.def": "the diagnostics of the flow analysis, with their explanations",
    "tree-sitter-proskill/grammar.js": "the grammar, a rule after the other",
}
# What comes in pairs or by the dozen, and is found by its name.
COLLECTIONS = {
    "tree-sitter-proskill/test/corpus": "a file for each form of the language",
}
SUFFIXES = (".cpp", ".h", ".def", ".c", ".ts", ".js", ".mjs", ".py", ".lua", ".el", ".sh", ".cmake", "dev")
FUNCTION_END = re.compile(r"^(\s*)\}(?: // .*)?$")
FUNCTION_BEGIN = re.compile(r"^(\s*)(?!namespace|struct|class|enum|union|if|for|while|switch|else|do|try|return|using|extern)"
                            r"[\w\[:~].*\).*\{$")


def function_lengths(text):
    """The lengths of functions formatted by clang-format: the lines from the opening brace to the closing one. A function
    on one line has length one."""
    lengths, open_at = [], None
    for number, line in enumerate(text.splitlines()):
        if open_at is None and re.match(r"^\s*[\w\[:~<>&*, ]+\(.*\).*\{ .*\}$", line):
            lengths.append(1)
        elif open_at is None and (begin := FUNCTION_BEGIN.match(line)):
            open_at = (number, begin.group(1))
        elif open_at and (end := FUNCTION_END.match(line)) and len(end.group(1)) <= len(open_at[1]):
            lengths.append(number - open_at[0] + 1)
            open_at = None
    return lengths


names = [name for name in files(*SUFFIXES) if "/dist/" not in name]
lengths = {name: read(name).count("\n") for name in names}
complaints = [f"{name}: {lines} lines, more than {LINES}" for name, lines in lengths.items()
              if lines > LINES and name not in TABLES]
complaints += [f"{name}: is no longer than others; strike it from the tables" for name in TABLES
               if lengths.get(name, 0) <= LINES]
folders = Counter(name.rsplit("/", 1)[0] for name in files("") if "/" in name)
complaints += [f"{folder}/: {count} files, more than {FILES}" for folder, count in folders.items()
               if count > FILES and folder not in COLLECTIONS]
functions = [length for name in names if name.endswith((".cpp", ".h")) and not name.startswith("tests/")
             for length in function_lengths(read(name))]
median = statistics.median(functions)
if median > FUNCTION:
    complaints.append(f"the median function has {median} lines, more than {FUNCTION}")
finish(complaints, f"{len(lengths)} files in {len(folders)} folders, the median of {len(functions)} functions has {median} lines")
