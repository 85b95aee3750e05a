"""The bundle in the tree is the one that the panel's sources give."""

import filecmp
import pathlib
import sys
import tempfile

from packages import PANEL, run

with tempfile.TemporaryDirectory() as scratch:
    ended = run("node", "build.mjs", "--out", scratch)
    names = sorted(path.name for path in pathlib.Path(scratch).iterdir())
    complaints = [f"panel/dist/{name} is not what the sources give: run `npm run build` in panel/"
                  for name in names
                  if not filecmp.cmp(pathlib.Path(scratch) / name, PANEL / "dist" / name, shallow=False)]
print("\n".join(complaints) or f"{len(names)} files are as built")
sys.exit(1 if complaints or ended or not names else 0)
