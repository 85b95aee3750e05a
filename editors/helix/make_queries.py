#!/usr/bin/env python3
"""Writes the queries for Helix that follow from the grammar's own: Helix calls the captures otherwise.

usage: make_queries.py [--print]

After a change of tree-sitter-proskill/queries/highlights.scm; a test says when it was forgotten.
"""

import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = HERE.parents[1] / "tree-sitter-proskill/queries/highlights.scm"
TARGET = HERE / "queries/proskill/highlights.scm"

# https://docs.helix-editor.com/themes.html#syntax-highlighting
SCOPES = {
    "string.escape": "constant.character.escape",
    "number": "constant.numeric",
    "boolean": "constant.builtin.boolean",
    "property": "attribute",
    "variable.member": "variable.other.member",
    "function.call": "function",
    "keyword.conditional": "keyword.control.conditional",
    "keyword.coroutine": "keyword.control",
    "keyword.import": "keyword.control.import",
    "keyword.repeat": "keyword.control.repeat",
    "keyword.return": "keyword.control.return",
}


def highlights():
    text = re.sub(r" @spell\b", "", SOURCE.read_text())
    text = re.sub(r"@([\w.]+)", lambda found: "@" + SCOPES.get(found[1], found[1]), text)
    return "; Made by make_queries.py of the grammar's own; do not edit.\n" + text


if "--print" in sys.argv:
    sys.stdout.write(highlights())
else:
    TARGET.write_text(highlights())
