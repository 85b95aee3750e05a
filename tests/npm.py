"""npm packages for tests; skips a test if they cannot be installed."""

import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
NO_NETWORK = re.compile(r"ENOTFOUND|EAI_AGAIN|ECONNREFUSED|ECONNRESET|ETIMEDOUT|ENETUNREACH")


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(77)


def need_node(major):
    """node and npm, and node not older than this."""
    for program in ("node", "npm"):
        if not shutil.which(program):
            skip(f"{program} is not installed (apt-get install npm)")
    version = subprocess.run(["node", "--version"], capture_output=True, text=True).stdout.strip()
    if int(version.lstrip("v").split(".")[0]) < major:
        skip(f"node is {version}, and {major} is needed")


def install(folder):
    """Installs the packages of a folder's package-lock.json, unless they are installed. Only without the registry is the test
    skipped: what else fails is a failure."""
    need_node(20)
    lock, done = folder / "package-lock.json", folder / "node_modules/.package-lock.json"
    if done.exists() and done.stat().st_mtime >= lock.stat().st_mtime:
        return
    ended = subprocess.run(["npm", "ci", "--ignore-scripts", "--no-audit", "--no-fund"], cwd=folder,
                           capture_output=True, text=True)
    if ended.returncode and NO_NETWORK.search(ended.stderr):
        skip(f"npm reaches no registry: {ended.stderr.strip().splitlines()[-1]}")
    if ended.returncode:
        print(ended.stdout + ended.stderr)
        sys.exit(1)
    done.touch()
