"""The words that docs/glossary.md has replaced do not come back: not in the manual, messages or editors, and not in comments.

A row of its table has the term, what it replaced, its meaning, and what remains allowed; phrases are in backquotes, with `*` for any ending.
"""

import re

from house import files, finish, read
from prose import blank, comments, prose

GLOSSARY = "docs/glossary.md"
PAGES = ("README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "CHANGELOG.md")
SOURCES = (".cpp", ".h", ".hpp", ".def", ".ts", ".mjs", ".py", ".lua", ".el")
# Their strings are not for users; their comments are checked.
INTERNAL = ("tests/", "bench/", "fuzz/", "tree-sitter-proskill/", "examples/", "scripts/", "cmake/", "panel/test/", "panel/e2e/")


def phrase(text):
    words = (re.escape(word).replace(r"\*", r"\w*") for word in text.split())
    return r"\b" + r"\s+".join(words) + r"\b"


def rules():
    """The phrases that were replaced, and the longer ones in which they are allowed."""
    replaced, allowed = [], []
    for row in re.findall(r"^\| (?!term |---)(.*) \|$", read(GLOSSARY), re.M):
        cells = [re.findall(r"`([^`]*)`", cell) for cell in row.split("|")]
        replaced += cells[1]
        allowed += cells[3] if len(cells) > 3 else []
    return re.compile("|".join(map(phrase, replaced)), re.I), re.compile("|".join(map(phrase, allowed)), re.I), replaced


def is_read_by_users(name):
    if name.endswith(".md"):
        return name.startswith("docs/") or name.endswith(PAGES)
    if name.endswith(".json"):
        return name.endswith(("vscode-extension/package.json", ".schema.json"))
    return not name.startswith(INTERNAL) and not name.endswith((".py", ".mjs"))


def pieces(name, text):
    """The pieces of English to check in a file, each with its first line."""
    if is_read_by_users(name):
        yield from ((line, piece) for line, piece in prose(name, text) if re.search(r"\s", piece))
    if name.endswith(SOURCES):
        yield from ((line, re.sub(r"`[^`]*`", "x", piece)) for line, piece in comments(name, text))


def complaints(name, text):
    for line, piece in pieces(name, text):
        free = ALLOWED.sub(blank, piece)
        for match in REPLACED.finditer(free):
            yield f"{name}:{line + free.count(chr(10), 0, match.start())}: \"{' '.join(match[0].split())}\" ({GLOSSARY})"


def checked():
    for name in files(".md", ".json", *SOURCES):
        if name != GLOSSARY and "node_modules" not in name and "/dist/" not in name and (is_read_by_users(name) or name.endswith(SOURCES)):
            yield name


def planted():
    """Each phrase is found in each kind of file, and not in code."""
    for text in (words.replace("*", "") for words in PHRASES):
        for name, sample in (("docs/x.md", f"This {text} it."), ("CHANGELOG.md", f"- This {text} it."),
                             ("x.cpp", f'say("this " // why\n  "{text} it");'), ("x.def", f'R"(this\n{text}\nit)"'),
                             ("x.ts", f"say(`this {text} it`)"), ("x.el", f'(error "this {text} it")'), ("x.json", f'{{"a": "this {text} it"}}'),
                             ("tests/x.cpp", f"f(); ///< this\n     ///< {text} it\n"), ("x.h", f"/* this {text} it */"), ("tests/x.ts", f"// this {text} it\n"),
                             ("x.py", f"f()  # this {text} it\n"), ("x.py", f'"""This {text} it."""\n'), ("x.lua", f"-- this {text} it\n"),
                             ("x.el", f";; this {text} it\n")):
            if not list(complaints(name.replace("x.json", "x.schema.json"), sample)):
                yield f"not found in {name}: {text}"
        for name, sample in (("docs/x.md", f"This `{text}`."), ("x.cpp", f"// this `{text}` it\n"), ("tests/x.cpp", f'say("this {text} it");'),
                             ("x.py", f'say("this {text} it")\n')):
            if list(complaints(name, sample)):
                yield f"found in {name}, where it is code: {text}"


REPLACED, ALLOWED, PHRASES = rules()
found = list(planted())
names = list(checked())
for name in names:
    found += complaints(name, read(name))
finish(found, f"{len(PHRASES)} phrases are not in {len(names)} files")
