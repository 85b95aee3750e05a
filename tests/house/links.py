"""Every relative link of a Markdown file leads to a file of the tree, and every anchor to a heading."""

import posixpath
import re

from house import ROOT, files, finish, read

LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)[^)]*\)")
FENCE = re.compile(r"^(```|~~~).*?^\1", re.M | re.S)
CODE = re.compile(r"`[^`\n]*`")


def prose(name):
    return CODE.sub("", FENCE.sub("", read(name)))


def anchors(name):
    """The anchors that the headings of a file get, as GitHub makes them."""
    headings = re.findall(r"^#+\s+(.*)$", FENCE.sub("", read(name)), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")
            for heading in headings}


def complaints(name):
    for target in LINK.findall(prose(name)):
        if re.match(r"[a-z]+:", target):
            continue
        path, _, anchor = target.partition("#")
        place = posixpath.normpath(posixpath.join(posixpath.dirname(name), path)) if path else name
        if not (ROOT / place).exists():
            yield f"{name}: {target} leads nowhere"
        elif anchor and place.endswith(".md") and anchor not in anchors(place):
            yield f"{name}: {target}: no such heading"


pages = files(".md")
finish([complaint for page in pages for complaint in complaints(page)], f"{len(pages)} pages")
