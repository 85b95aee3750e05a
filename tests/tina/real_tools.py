"""Runs every example through the Tina tools of a directory and beside the engine: `./dev tina DIRECTORY`.

Usage: real_tools.py PROSKILL DIRECTORY OUT FILE…
Input and output of the tools are kept in OUT/NAME; OUT/report.md has the result of each file. Exit status 1:
the two differ somewhere, or a tool failed.
"""

import os
import pathlib
import subprocess
import sys
import time

RESULTS = {0: "agree", 1: "agree, something is violated", 3: "undecided", 4: "DIFFER"}
TOOLS = ["frac", "sift", "tina", "selt", "ktzio"]


def environment(directory):
    """The tools of the directory go before those of the system."""
    folders = [str(directory), str(directory / "bin")]
    found = dict(os.environ, PATH=os.pathsep.join(folders + [os.environ.get("PATH", "")]))
    for folder in folders:
        for tool in TOOLS:
            if os.access(os.path.join(folder, tool), os.X_OK):
                found.setdefault("PROSKILL_" + tool.upper(), os.path.join(folder, tool))
    return found


def run_one(proskill, file, out, env):
    kept = out / (pathlib.Path(file).stem + pathlib.Path(file).suffix.replace(".", "_"))
    kept.mkdir(parents=True, exist_ok=True)
    command = [proskill, "verify", file, "--backend", "both", "--time-limit", "120", "--keep",
               str(kept / "tools"), "--difference", str(kept / "difference.md")]
    began = time.monotonic()
    done = subprocess.run(command, env=env, capture_output=True, text=True, check=False)
    (kept / "out.txt").write_text(done.stdout)
    (kept / "err.txt").write_text(done.stderr)
    result = RESULTS.get(done.returncode, f"FAILED ({done.returncode})")
    first = next((line for line in done.stderr.splitlines() if line.strip()), "")
    return result, time.monotonic() - began, first, kept


def report(rows):
    lines = ["| file | result | s | first message |", "| --- | --- | --- | --- |"]
    for file, (result, seconds, message, _) in rows:
        lines.append(f"| {file} | {result} | {seconds:.1f} | {message.replace('|', '/')} |")
    return "\n".join(lines) + "\n"


def main():
    proskill, directory, out = sys.argv[1], pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(sys.argv[3])
    env = environment(directory)
    rows = [(file, run_one(proskill, file, out, env)) for file in sys.argv[4:]]
    text = report(rows)
    (out / "report.md").write_text(text)
    print(text, end="")
    bad = [file for file, row in rows if row[0] == "DIFFER" or row[0].startswith("FAILED")]
    print(f"{len(rows)} files, {len(bad)} of them differ or failed; everything is kept in {out}")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
