#!/usr/bin/env python3
"""Writes the lists of keywords of the editors, of the panel and of the grammar's queries from ide/names/vocabulary.def.

usage: make_keywords.py [--check]: writes the files, or lists those that are outdated.
"""

import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
WORD = re.compile(r'^WORD\((\w+), "([a-z/][\w/-]*)"', re.M)
VOCABULARY = WORD.findall((ROOT / "ide/names/vocabulary.def").read_text(encoding="utf-8"))


def words(*kinds):
    """The words of these kinds in the order of the table, without signs such as `^`."""
    return [word for kind, word in VOCABULARY if kind in kinds]


DEFINITIONS = [word for word in words("Definition") if word != "include"]
FORMS = [word for word in words("Statement", "EnvironmentStatement") if word != "break"]
PATTERNS = words("Pattern")


def quoted(indent):
    return lambda names: "".join(f'{indent}"{name}"\n' for name in names)


def lisp(names):
    """A list of strings in lines of at most 100 characters, as Emacs indents it."""
    lines = ["   "]
    for name in names:
        if len(lines[-1]) + len(name) + 3 > 100:
            lines.append("   ")
        lines[-1] += f' "{name}"'
    return "\n".join(lines).lstrip()


# A file, the text before its list and after it, the words, and how they are written.
LISTS = [
    ("tree-sitter-proskill/queries/highlights.scm", "; Definitions.\n[\n", "] @keyword\n", DEFINITIONS, quoted("  ")),
    ("tree-sitter-proskill/queries/highlights.scm", "; Patterns.\n[\n", "] @keyword.operator\n", PATTERNS, quoted("  ")),
    ("vscode-extension/syntaxes/proskill.tmLanguage.json", '"property": {\n   "patterns": [\n    {\n     "begin": "(\\\\()\\\\s*((?:',
     ")\\\\b)", PATTERNS, "|".join),
    ("editors/emacs/proskill-mode.el", "(defconst proskill--definitions\n  '(", "))", DEFINITIONS, lisp),
    ("editors/emacs/proskill-mode.el", "(defconst proskill--statements\n  '(", "))", FORMS, lisp),
    ("editors/emacs/proskill-mode.el", "(defconst proskill--patterns\n  '(", "))",
     PATTERNS + words("Observation"), lisp),
    ("editors/nvim/syntax/proskill.vim", r'syntax match proskillDefinition "\v\(@<=(', ')>"', DEFINITIONS, "|".join),
    ("editors/nvim/syntax/proskill.vim", r'syntax match proskillProperty "\v\(@<=(', ')>"', PATTERNS, "|".join),
    ("panel/src/model/highlight.ts", "const forms = new Set(\n  '", "'", words("Definition", "Clause", "Until", "Statement", "EnvironmentStatement"),
     lambda names: " ".join(name for name in names if name[0].isalpha())),
]


def with_list(text, before, after, content):
    begin = text.index(before) + len(before)
    return text[:begin] + content + text[text.index(after, begin):]


def made():
    texts = {}
    for file, before, after, names, write in LISTS:
        text = texts.get(file) or (ROOT / file).read_text(encoding="utf-8")
        texts[file] = with_list(text, before, after, write(names))
    return texts


def missing():
    """Words that a file lacks whose lists have groups of their own: each statement is coloured by its kind."""
    for file in ("editors/nvim/syntax/proskill.vim", "vscode-extension/syntaxes/proskill.tmLanguage.json",
                 "tree-sitter-proskill/queries/highlights.scm"):
        text = (ROOT / file).read_text(encoding="utf-8")
        for word in words("Definition", "Statement", "EnvironmentStatement", "Clause", "Until", "Pattern"):
            if word[0].isalpha() and not re.search(rf"(?<![\w-]){word}(?![\w-])", text):
                yield f"{file} lacks `{word}` of ide/names/vocabulary.def"


def main():
    stale = {file: text for file, text in made().items() if text != (ROOT / file).read_text(encoding="utf-8")}
    if "--check" in sys.argv:
        complaints = [f"{file} is not what editors/make_keywords.py makes" for file in stale] + list(missing())
        print("\n".join(complaints) or f"{len(VOCABULARY)} words")
        return bool(complaints)
    for file, text in stale.items():
        (ROOT / file).write_text(text, encoding="utf-8")
    subprocess.run([sys.executable, "-B", ROOT / "editors/helix/make_queries.py"], check=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
