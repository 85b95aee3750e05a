"""The corpus passes, and shows every kind of node, and no error in any of them."""

import json
import shutil
import sys

from tool import GRAMMAR, run

ended, copy = run("test")
shutil.rmtree(copy.parent)
complaints = [ended.stdout + ended.stderr] if ended.returncode != 0 else []

types = json.loads((GRAMMAR / "src/node-types.json").read_text(encoding="utf-8"))
kinds = {entry["type"] for entry in types if entry["named"]}
corpus = {path.stem: path.read_text(encoding="utf-8")
          for path in (GRAMMAR / "test/corpus").glob("*.txt")}
complaints += [f"test/corpus/{kind}.txt is missing, or does not show the node"
               for kind in sorted(kinds) if f"({kind}" not in corpus.get(kind, "")]
complaints += [f"test/corpus/{name}.txt has {damage}: the grammar should take everything"
               for name, text in corpus.items() for damage in ("ERROR", "MISSING")
               if f"({damage}" in text]
print("\n".join(complaints) or f"{len(corpus)} files, {len(kinds)} kinds of nodes")
sys.exit(1 if complaints else 0)
