"""The panel, with its packages of npm."""

import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import npm  # noqa: E402

PANEL = npm.ROOT / "panel"


def run(*command):
    """In the panel's folder, its packages installed; what it prints is the check's."""
    npm.install(PANEL)
    return subprocess.run(command, cwd=PANEL).returncode
