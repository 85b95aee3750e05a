"""clang-format would change nothing."""

import re
import shutil
import subprocess
import sys

from house import ROOT, files, finish

SKIPPED = 77  # as ctest expects

program = shutil.which("clang-format")
if not program:
    print("skipped: clang-format is not installed (apt-get install clang-format)")
    sys.exit(SKIPPED)

sources = [name for name in files(".cpp", ".h") if not name.startswith("tree-sitter-proskill/")]
run = subprocess.run([program, "--dry-run", *sources], cwd=ROOT, capture_output=True, text=True)
changed = sorted(set(re.findall(r"^([^:\n]+):\d+:\d+: warning", run.stderr, re.M)))
finish([f"{name}: not as clang-format writes it" for name in changed]
       + ([run.stderr] if run.returncode else []),
       f"{len(sources)} files")
