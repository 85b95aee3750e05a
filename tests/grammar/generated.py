"""The parser in the tree is the one that grammar.js generates."""

import filecmp
import shutil
import sys

from tool import GRAMMAR, run

ended, copy = run("generate", "--abi", "14")
names = [path.relative_to(copy) for path in (copy / "src").rglob("*") if path.is_file()]
complaints = [f"{name} is not what grammar.js generates: run `npm run generate` there"
              for name in names if not filecmp.cmp(copy / name, GRAMMAR / name, shallow=False)]
shutil.rmtree(copy.parent)
if ended.returncode != 0:
    complaints.append(ended.stderr)
print("\n".join(complaints) or f"{len(names)} files are as generated")
sys.exit(1 if complaints else 0)
