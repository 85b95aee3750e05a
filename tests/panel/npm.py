"""npm and what it installs for the panel; ends a check as skipped where there is none."""

import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PANEL = ROOT / "panel"


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(77)


def install():
    """The packages of package-lock.json, where they are not there yet."""
    for program in ("node", "npm"):
        if not shutil.which(program):
            skip(f"{program} is not installed")
    version = subprocess.run(["node", "--version"], capture_output=True, text=True).stdout.strip()
    if int(version.lstrip("v").split(".")[0]) < 20:
        skip(f"node is {version}, the panel needs 20")
    lock, done = PANEL / "package-lock.json", PANEL / "node_modules/.package-lock.json"
    if done.exists() and done.stat().st_mtime >= lock.stat().st_mtime:
        return
    ended = subprocess.run(["npm", "ci", "--no-audit", "--no-fund"], cwd=PANEL,
                           capture_output=True, text=True)
    if ended.returncode:
        skip(f"npm cannot install the packages: {ended.stderr.strip().splitlines()[-1:]}")
    done.touch()


def run(*command):
    """In the panel's folder; what it prints is the check's."""
    return subprocess.run(command, cwd=PANEL).returncode
