"""What the checks of the house share: where the tree is, its files, and how to complain."""

import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
GENERATED = ("tree-sitter-proskill/src/parser.c", "tree-sitter-proskill/src/tree_sitter/")


def files(*suffixes):
    """The tree's own files with these suffixes, as paths relative to its root."""
    listed = subprocess.run(
        ["git", "ls-files", "--cached", "--others", "--exclude-standard"],
        cwd=ROOT, capture_output=True, text=True)
    if listed.returncode == 0:
        names = listed.stdout.splitlines()
    else:  # an unpacked archive
        names = [str(path.relative_to(ROOT)) for path in ROOT.rglob("*") if path.is_file()]
        names = [name for name in names if not name.startswith("build/")]
    return sorted(name for name in set(names)
                  if name.endswith(suffixes) and not name.startswith(GENERATED)
                  and (ROOT / name).is_file())


def read(name):
    return (ROOT / name).read_text(encoding="utf-8")


def finish(complaints, praise):
    """Ends the check: each complaint is a line, none of them is success."""
    for complaint in complaints:
        print(complaint)
    if complaints:
        sys.exit(1)
    print(praise)
