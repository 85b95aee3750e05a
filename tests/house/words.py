"""The words that docs/glossary.md has replaced do not come back: not in the manual, not in messages, not in the editors.

A row of its table has the term, what it replaced, its meaning, and what remains allowed; phrases are in backquotes, with `*` for any ending.
"""

import json
import re

from house import files, finish, read

GLOSSARY = "docs/glossary.md"
PAGES = ("README.md", "ARCHITECTURE.md", "CONTRIBUTING.md")
ELSEWHERE = ("tests/", "bench/", "fuzz/", "tree-sitter-proskill/", "examples/", "scripts/", "cmake/")
FENCE = re.compile(r"^( *)(```|~~~).*?^\1\2", re.M | re.S)
CODE = re.compile(r"`[^`\n]*`|(?<=\]\()[^)]*|^    .*$", re.M)
# A string, raw or not; or what only looks as if it held one.
LITERAL = re.compile(r'R"(\w*)\((?P<raw>.*?)\)\1"|"(?P<text>(?:[^"\\\n]|\\.)*)"|//[^\n]*|/\*.*?\*/|#include[^\n]*', re.S)
ELISP = re.compile(r'"(?P<text>(?:[^"\\]|\\.)*)"|;[^\n]*', re.S)
SCRIPT = re.compile(r"//[^\n]*|/\*.*?\*/|--[^\n]*|'(?P<one>(?:[^'\\\n]|\\.)*)'|\"(?P<two>(?:[^\"\\\n]|\\.)*)\"|`(?P<more>(?:[^`\\]|\\.)*)`", re.S)


def phrase(text):
    words = (re.escape(word).replace(r"\*", r"\w*") for word in text.split())
    return r"\b" + r"\s+".join(words) + r"\b"


def rules():
    """What is looked for, and the longer phrases in which it may stay."""
    replaced, allowed = [], []
    for row in re.findall(r"^\| (?!term |---)(.*) \|$", read(GLOSSARY), re.M):
        cells = [re.findall(r"`([^`]*)`", cell) for cell in row.split("|")]
        replaced += cells[1]
        allowed += cells[3] if len(cells) > 3 else []
    return re.compile("|".join(map(phrase, replaced)), re.I), re.compile("|".join(map(phrase, allowed)), re.I), replaced


def blank(match):
    """As many lines as there were, so that places stay right."""
    return "x" + "\n" * match[0].count("\n")


def prose(name, text):
    """The sentences of a file that people read, each with the line on which it begins."""
    if name.endswith(".md"):
        yield 1, CODE.sub(blank, FENCE.sub(blank, text))
    elif name.endswith(".json"):
        for number, line in enumerate(text.splitlines(), 1):
            yield from ((number, json.loads(value)) for value in re.findall(r'"(?:[^"\\]|\\.)*"', line))
    else:
        literal = ELISP if name.endswith(".el") else SCRIPT if name.endswith((".ts", ".lua", ".js", ".mjs")) else LITERAL
        end, sentence, start = 0, "", 1
        for match in literal.finditer(text):
            said = next((part for part in match.groupdict().values() if part is not None), None)
            if text[end:match.start()].strip() or said is None:  # not one literal directly after another
                yield start, re.sub(r"`[^`]*`", "x", sentence)
                sentence = ""
            start = start if sentence else text.count("\n", 0, match.start()) + 1
            end, sentence = match.end(), sentence + (said or "")
        yield start, re.sub(r"`[^`]*`", "x", sentence)


def complaints(name, text):
    for line, sentence in prose(name, text):
        if not re.search(r"\s", sentence):
            continue
        free = ALLOWED.sub(blank, sentence)
        for match in REPLACED.finditer(free):
            yield f"{name}:{line + free.count(chr(10), 0, match.start())}: \"{' '.join(match[0].split())}\" ({GLOSSARY})"


def looked_for():
    for name in files(".md", ".cpp", ".h", ".def", ".json", ".ts", ".lua", ".el"):
        if name == GLOSSARY or name.startswith(ELSEWHERE) and not name.endswith("README.md") or "/test" in name or "node_modules" in name:
            continue
        if name.endswith(".md") and not name.startswith("docs/") and not name.endswith(PAGES):
            continue
        if name.endswith(".json") and not name.endswith(("vscode-extension/package.json", ".schema.json")):
            continue
        yield name


def planted():
    """Each phrase is found in each kind of file, and not where it is code or a comment."""
    for text in (words.replace("*", "") for words in PHRASES):
        for name, sample in (("docs/x.md", f"This {text} it."), ("x.cpp", f'say("this " // why\n  "{text} it");'), ("x.def", f'R"(this\n{text}\nit)"'),
                             ("x.ts", f"say(`this {text} it`)"), ("x.el", f'(error "this {text} it")'), ("x.json", f'{{"a": "this {text} it"}}')):
            if not list(complaints(name, sample)):
                yield f"not found in {name}: {text}"
        for name, sample in (("docs/x.md", f"This `{text}`."), ("x.cpp", f"// this {text} it\n")):
            if list(complaints(name, sample)):
                yield f"found in {name}, where it is code: {text}"


REPLACED, ALLOWED, PHRASES = rules()
found = list(planted())
names = list(looked_for())
for name in names:
    found += complaints(name, read(name))
finish(found, f"{len(PHRASES)} phrases are not in {len(names)} files")
