"""Runs the tests of the Emacs mode in Emacs.

usage: emacs.py

PROSKILL_EMACS names another Emacs than the one on the PATH.
"""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]

program = os.environ.get("PROSKILL_EMACS") or shutil.which("emacs")
if not program:
    print("skipped: emacs is not installed (apt-get install emacs-nox)")
    sys.exit(77)


def has_eglot():
    return subprocess.run([program, "-q", "--no-site-file", "--batch", "--eval",
                           "(progn (require 'package) (package-initialize) (require 'eglot))"], capture_output=True).returncode == 0


with tempfile.TemporaryDirectory() as directory:
    done = subprocess.run([program, "-q", "--no-site-file", "--batch", "-L", ROOT / "editors/emacs",
                           "-l", HERE / "emacs/proskill-mode-test.el",
                           "-f", "ert-run-tests-batch-and-exit"],
                          env=dict(os.environ, HOME=directory, PROSKILL_ROOT=str(ROOT), LC_ALL="C.UTF-8"),
                          cwd=directory, stdin=subprocess.DEVNULL, timeout=280)
    if done.returncode == 0:
        # Warnings of the Emacs compiler are errors here.
        files = [shutil.copy(file, directory) for file in (ROOT / "editors/emacs").glob("*.el")]
        done = subprocess.run([program, "-Q", "--batch", "-L", directory, "--eval", "(setq byte-compile-error-on-warn t)",
                               "-f", "batch-byte-compile", *files], stdin=subprocess.DEVNULL)
if done.returncode == 0 and not has_eglot():
    print("skipped: Emacs has no eglot (apt-get install elpa-eglot); all but the session with the server was tried")
    sys.exit(77)
sys.exit(done.returncode)
