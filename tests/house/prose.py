"""The English of a file: the sentences that users read, and the comments."""

import io
import json
import re
import tokenize

FENCE = re.compile(r"^( *)(```|~~~).*?^\1\2", re.M | re.S)
CODE = re.compile(r"`[^`\n]*`|(?<=\]\()[^)]*|^    .*$", re.M)
# A string, raw or not, or a comment.
CPP = re.compile(r'R"(\w*)\((?P<raw>.*?)\)\1"|"(?P<text>(?:[^"\\\n]|\\.)*)"|//(?P<line>[^\n]*)|/\*(?P<block>.*?)\*/|#include[^\n]*', re.S)
ELISP = re.compile(r'"(?P<text>(?:[^"\\]|\\.)*)"|;+(?P<line>[^\n]*)', re.S)
SCRIPT = re.compile(r"(?://|--)(?P<line>[^\n]*)|/\*(?P<block>.*?)\*/|'(?P<one>(?:[^'\\\n]|\\.)*)'"
                    r"|\"(?P<two>(?:[^\"\\\n]|\\.)*)\"|`(?P<more>(?:[^`\\]|\\.)*)`", re.S)
COMMENT = ("line", "block")


def blank(match):
    """As many lines as there were, so that line numbers stay right."""
    return "x" + "\n" * match[0].count("\n")


def lexer(name):
    if name.endswith(".el"):
        return ELISP
    return SCRIPT if name.endswith((".ts", ".lua", ".js", ".mjs")) else CPP


def strings(name, text):
    """The string literals of a program, each with its first line; adjacent ones are joined."""
    end, sentence, start = 0, "", 1
    for match in lexer(name).finditer(text):
        said = next((part for kind, part in match.groupdict().items() if part is not None and kind not in COMMENT), None)
        if text[end:match.start()].strip() or said is None:
            yield start, sentence
            sentence = ""
        start = start if sentence else text.count("\n", 0, match.start()) + 1
        end, sentence = match.end(), sentence + (said or "")
    yield start, sentence


def python_comments(text):
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT:
            yield token.start[0], token.string.lstrip("#")
        elif token.type == tokenize.STRING and token.line[:token.start[1]].strip() == "" and '"""' in token.string:
            yield token.start[0], token.string.strip('"')


def comments(name, text):
    """The comments of a program, each with its first line; those on consecutive lines are joined."""
    if name.endswith(".py"):
        found = python_comments(text)
    else:
        found = ((text.count("\n", 0, match.start()) + 1, match["line"] if match["line"] is not None else match.groupdict().get("block"))
                 for match in lexer(name).finditer(text))
    start, last, joined = 1, None, ""
    for line, said in found:
        if said is None:
            continue
        said = re.sub(r"^\s*[*/!<]+ ?", "", said, flags=re.M)
        if last is not None and line != last + 1:
            yield start, joined
            joined = ""
        start = start if joined else line
        joined += ("\n" if joined else "") + said
        last = line + said.count("\n")
    yield start, joined


def prose(name, text):
    """What users read in a file, without code: the first line and the text of each piece."""
    if name.endswith(".md"):
        yield 1, CODE.sub(blank, FENCE.sub(blank, text))
    elif name.endswith(".json"):
        for number, line in enumerate(text.splitlines(), 1):
            yield from ((number, json.loads(value)) for value in re.findall(r'"(?:[^"\\]|\\.)*"', line))
    else:
        yield from ((line, re.sub(r"`[^`]*`", "x", sentence)) for line, sentence in strings(name, text))
