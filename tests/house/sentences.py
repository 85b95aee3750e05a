"""Half of all sentences have at most 18 words: those of the manual, and those of messages and help texts.

Prints the median of each group; with pages or sources as arguments, their sentences of more than twice as many words.
"""

import re
import statistics
import sys

from house import files, finish, read
from prose import prose

WORDS = 18
LONG = 2 * WORDS
END = re.compile(r"(?<=[.!?])\s+|\n\s*\n|\n\s*(?:[-*]|\d+\.) |^#+ .*$|^\|.*$", re.M)
WORD = re.compile(r"[^\W\d_][\w'’-]*")


def sentences(name):
    """The number of words of each sentence with at least three, and the sentence. Headings and tables do not count."""
    for _, piece in prose(name, read(name)):
        for sentence in END.split(piece.replace("\\n", "\n")):
            words = len(WORD.findall(sentence))
            if words >= 3:
                yield words, " ".join(sentence.split())


def group(names):
    return [sentence for name in names for sentence in sentences(name)]


if len(sys.argv) > 1:
    for words, sentence in sorted(group(sys.argv[1:]), reverse=True):
        if words > LONG:
            print(words, sentence)
    sys.exit()

GROUPS = {
    "manual": [name for name in files(".md") if name.startswith("docs/") or name in ("README.md", "CHANGELOG.md")],
    "diagnostics": files(".def"),
    "other messages": [name for name in files(".cpp") if not name.startswith(("tests/", "bench/", "fuzz/"))],
    "editors": [name for name in files(".ts", ".lua", "vscode-extension/package.json") if "test" not in name and "/dist/" not in name],
}
complaints, praise = [], []
for title, names in GROUPS.items():
    found = group(names)
    median = statistics.median(words for words, _ in found)
    praise.append(f"{title}: {median:.0f} words in the median of {len(found)} sentences")
    if median > WORDS:
        complaints.append(f"{title}: the median sentence has {median:.0f} words, more than {WORDS}")
finish(complaints, "; ".join(praise))
