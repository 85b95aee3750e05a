"""Every skipped test is reported, and with CI=true each must be listed; what failed earlier is said again, and what took how
long."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

from house import ROOT, finish

SUITE = """<testsuite>
  <testcase name="editors: emacs" status="notrun" time="0.1"><skipped/><system-out>{said}</system-out></testcase>
  <testcase name="cli: all is well" status="run" time="71.6"><system-out>skipped: of another test</system-out></testcase>
</testsuite>"""
CTEST = "1/2 Test #1: editors: emacs ...***Skipped\n\n100% tests passed, 0 tests failed out of 2\nTotal Test time\n"
LISTED = "# why\neditors: * | emacs is * | there is no Emacs\n"


def run(said, ci, *more):
    """Exit code and output if ctest writes its results while the script waits for them."""
    with tempfile.TemporaryDirectory() as directory:
        junit, listed = pathlib.Path(directory, "tested-release.xml"), pathlib.Path(directory, "skips.txt")
        listed.write_text(LISTED, encoding="utf-8")
        pathlib.Path(directory, "phases").mkdir()
        pathlib.Path(directory, "phases/begun.txt").write_text("3 packages\n7 a long compilation\n107 tests\n", encoding="utf-8")
        summary = subprocess.Popen([sys.executable, "-B", ROOT / "scripts/summary.py", directory, "--listed", listed, *more],
                                   stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=dict(os.environ, CI=ci))
        summary.stdin.write(CTEST[:3])
        summary.stdin.flush()
        if said:
            junit.write_text(SUITE.format(said=said), encoding="utf-8")
        text, _ = summary.communicate(CTEST[3:])
    return summary.returncode, text


FLAKY = "FAILED  hover: too late\nok      hover\nretried: hover: too late\n"
GOOD, ODD = "begin\nskipped: emacs is not installed\n", "skipped: the moon is full\n"
found = []


def expect(what, holds):
    if not holds:
        found.append(f"not so: {what}")


code, text = run(GOOD, "true")
expect("a listed skip passes", code == 0)
expect("it is named with its reason", "editors: emacs\n      emacs is not installed\n" in text)
expect("what another test prints is no skip", "of another test" not in text)
expect("the phases are said with their times", re.search(r"\nIn 10\d s: packages 4 s, a long compilation 100 s, tests \d s\n", text))
expect("the longest tests come first", "longest:\n    72 s  cli: all is well\n     0 s  editors: emacs\n" in text)
expect("ctest's closing lines come last", text.endswith(CTEST.split("\n\n")[1]) and text.startswith("1/2 Test"))
expect("another reason fails in CI", run(ODD, "true")[0] == 1)
expect("another reason passes elsewhere, and is said", run(ODD, "")[0] == 0 and "the moon is full" in run(ODD, "")[1])
expect("no reason fails in CI", run("nothing", "true")[0] == 1)
expect("what was not tried at all counts", run(GOOD, "true", "--not-tried", "random bytes", "no libFuzzer")[0] == 1)
expect("no results at all are a failure", run("", "")[0] == 1)
expect("a second try is said, with the reason", "\nTried twice, because the first try failed:\n  editors: emacs\n      hover: too late\n" in run(FLAKY, "")[1])
expect("without one nothing is said of it", "Tried twice" not in text)
with tempfile.NamedTemporaryFile("w", suffix=".txt") as output:
    output.write("".join(f"warning {number}\n" for number in range(100)))
    output.flush()
    code, text = run(GOOD, "", "--failed", "clang-tidy", output.name)
expect("what failed before the tests fails", code == 1)
expect("its last lines are repeated", "\nFailed before the tests: clang-tidy\n  warning 70\n" in text and "  warning 99\n" in text)
finish(found, "15 cases")
