"""The Lisp examples of docs/language.md form one program without errors.

usage: language.py PROGRAM
"""

import pathlib
import re
import subprocess
import sys
import tempfile

from house import finish, read

PROGRAM = sys.argv[1]

parts = re.findall(r"^```lisp\n(.*?)^```", read("docs/language.md"), re.M | re.S)
with tempfile.TemporaryDirectory() as directory:
    file = pathlib.Path(directory) / "language.proskill"
    file.write_text("\n".join(parts), encoding="utf-8")
    done = subprocess.run([PROGRAM, "check", str(file)], capture_output=True, text=True)
finish([done.stdout + done.stderr] if done.returncode else [], f"{len(parts)} examples")
