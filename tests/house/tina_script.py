"""`./dev tina` reports the result of each example, here with fake tools."""

import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SELT = '#!/bin/sh\nfor word in "$@"; do if [ "$word" = -S ]; then exit 0; fi; done\ncat "$(dirname "$0")/verdicts"\n'


def stand_ins(directory, verdicts):
    """A frac that takes everything, and a selt that says the same of every model."""
    scripts = {
        "frac": '#!/bin/sh\nmkdir "$2" && : > "$2/model.c"\ncat > "$2/model.ltl" <<X\n# user formulas\n'
                + "op p = T;\np;\n" * len(verdicts) + "X\n",
        "cc": "#!/bin/sh\n: > model.tts/model.so\n",
        "sift": '#!/bin/sh\n: > model.ktz\necho "1 classe(s), 1 marking(s), 1 domain(s), 0 transition(s)"\n',
        "selt": SELT,
        "ktzio": "#!/bin/sh\nexit 1\n",
    }
    for name, text in scripts.items():
        (directory / name).write_text(text)
        (directory / name).chmod(0o755)
    (directory / "verdicts").write_text("".join(each + "\n" for each in verdicts))
    (directory / "lib" / "avl").mkdir(parents=True)


def results(proskill, directory, out, files):
    env = dict(os.environ, CC=str(directory / "cc"), FRACLIB=str(directory / "lib"))
    done = subprocess.run([sys.executable, "-B", ROOT / "tests/tina/real_tools.py", proskill, directory, out, *files],
                          env=env, capture_output=True, text=True, check=False)
    rows = [line.split("|")[2].strip() for line in done.stdout.splitlines() if line.startswith("| ")]
    return done, rows[2:]


def main():
    proskill = sys.argv[1]
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        model = scratch / "two.fcr"
        model.write_text("process P is\nstates s, t\nfrom s\n    wait [1,1];\n    to t\n\nfrom t\n    wait [1,1];\n    to s\n\n"
                         "P\n\nproperty good is always P/state s or P/state t\nassert good\n")
        tools = scratch / "tools"
        tools.mkdir()
        stand_ins(tools, ["TRUE"])
        done, rows = results(proskill, tools, scratch / "out", [str(model), str(scratch / "missing.fcr")])
        print(done.stdout + done.stderr)
        assert done.returncode == 1, "a file that cannot be read is a failure"
        assert len(rows) == 2 and rows[1].startswith("FAILED"), rows
        assert (scratch / "out" / "report.md").exists()
        assert (scratch / "out" / "two_fcr" / "err.txt").exists()
        assert rows[0] == "agree", rows
        (tools / "frac").write_text("#!/bin/sh\necho 'line 1: not this' >&2\nexit 1\n")
        done, rows = results(proskill, tools, scratch / "out2", [str(model)])
        assert done.returncode == 1 and rows[0] in ("DIFFER", "FAILED (2)"), (rows, done.stdout)
    print("the script was tried with programs that stand in for the tools")


main()
