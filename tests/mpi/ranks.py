#!/usr/bin/env python3
"""Verifies under mpirun: 1, 2 and 4 ranks must give the same verdicts and counts, and those of a
process of its own. A rank that dies, or has another program, must end the run with an error.

    tests/mpi/ranks.py PROSKILL PRINT_MODELS
"""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM, PRINT_MODELS = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
LIBRARY = PROGRAM.parent.parent / "lib/libproskill_mpi.so"
MPIRUN = ["mpirun", "--oversubscribe"] + (["--allow-run-as-root"] if os.geteuid() == 0 else [])
RANKS = 1, 2, 4
PATIENCE = 300  # seconds after which a run counts as one that hangs

# Without slices, so that the ranks share a search from its start.
SAME_GRAPH = "dead-variables,live-variables,free-inputs,private-moves,stubborn-sets,extrapolation"
INCLUSION = SAME_GRAPH + ",inclusion"
FAMILIES = [("csma", 5), ("fischer", 6), ("philosophers", 8)]
EXAMPLES = ["examples/lift/timed.proskill", "examples/gripper/gripper.proskill"]
RANDOM = [("plain", 1), ("data", 1), ("observer", 1), ("untimed", 1)]  # how many of each kind


def run(command, codes=(0, 1)):
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=PATIENCE)
    assert done.returncode in codes, f"{command}: {done.returncode}\n{done.stdout}\n{done.stderr}"
    return done


def verify(prefix, arguments):
    """The verdicts and the counts of a report, and whether the whole graph was explored."""
    report = json.loads(run([*prefix, *arguments]).stdout)
    size = report["exploration"]
    counts = {name: size[name] for name in ("classes", "markings", "domains", "transitions", "stopped")}
    verdicts = {row["name"]: (row["verdict"], row["trace"] is not None) for row in report["properties"]}
    return verdicts, counts, size["complete"], "ranks" in size


def compare_verdicts(file, reductions, is_same_graph):
    arguments = ["verify", "--format", "json", "--traces", "all", "--reduce", reductions, file]
    alone, size, is_whole, _ = verify([PROGRAM], arguments)
    seen = [verify([*MPIRUN, "-n", str(ranks), PROGRAM], [*arguments, "--mpi"]) for ranks in RANKS]
    for verdicts, counts, _, is_shared in seen:
        assert is_shared, f"{file}: no search was shared"
        assert verdicts == alone, f"{file}: {verdicts} instead of {alone}"
        assert counts == seen[0][1], f"{file}: {counts} instead of {seen[0][1]}"
        if is_same_graph and is_whole:
            assert counts == size, f"{file}: {counts} instead of {size}"


def compare_counts(file):
    """The numbers of classes, markings, domains and transitions."""
    arguments = ["verify", "--graph", "counts", file]
    alone = run([PROGRAM, *arguments]).stdout.splitlines()[0]
    for ranks in RANKS:
        seen = run([*MPIRUN, "-n", str(ranks), PROGRAM, *arguments, "--mpi"]).stdout.splitlines()
        assert seen[0].strip() == alone, f"{file}, {ranks} ranks: {seen[0]} instead of {alone}"
        assert f"{ranks} rank(s)" in seen[2], seen


def members(directory):
    for family, size in FAMILIES:
        file = directory / f"{family}{size}.fcr"
        file.write_text(run([sys.executable, ROOT / "bench/families.py", family, str(size)]).stdout)
        yield file


def random_models(directory):
    for kind, count in RANDOM:
        run([PRINT_MODELS, kind, "40", str(count), directory])
    return sorted(directory.glob("*-*.fcr"))


def searching(process):
    """The ranks that it has started and that have stored many states. Others may not have connected yet, and
    mpirun waits for ever if such a rank is killed."""
    stored = 26_000  # KiB resident; a rank that has only connected takes 20,000
    listed = subprocess.run(["ps", "-o", "pid=,rss=", "--ppid", str(process.pid)], capture_output=True, text=True,
                            check=False).stdout
    return [int(pid) for pid, size in map(str.split, listed.splitlines()) if int(size) > stored]


def check_death(directory):
    """One of three ranks is killed in the middle of a search that would not end for hours."""
    file = directory / "philosophers16.fcr"
    file.write_text(run([sys.executable, ROOT / "bench/families.py", "philosophers", "16"]).stdout)
    command = [*MPIRUN, "-n", "3", PROGRAM, "verify", "--mpi", "--reduce", "none", file]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as child:
        try:
            while len(ranks := searching(child)) < 3:
                assert child.poll() is None, child.communicate()
                time.sleep(0.1)
            os.kill(max(ranks), signal.SIGKILL)
            _, problems = child.communicate(timeout=PATIENCE)
        finally:
            child.kill()
    assert child.returncode != 0
    assert "signal 9" in problems, problems


def check_difference(directory):
    """Each rank reads a program of its own."""
    files = sorted(directory.glob("*-*.fcr"))
    one, other = (["-n", "1", PROGRAM, "verify", "--mpi", file] for file in files[:2])
    found = run([*MPIRUN, *one, ":", *other], codes=(2,)).stderr
    assert "rank 1 has another program" in found, found
    missing = ["-n", "1", PROGRAM, "verify", "--mpi", directory / "missing.fcr"]
    found = run([*MPIRUN, *one, ":", *missing], codes=(2,)).stderr
    assert "rank 1: error: cannot read" in found, found


def check_limits(file):
    """A limit leaves questions open, and ends all ranks."""
    arguments = ["verify", "--mpi", "--reduce", "none", "--time-limit", "0.001", file]
    assert "the time limit was reached" in run([*MPIRUN, "-n", "2", PROGRAM, *arguments], codes=(3,)).stdout


def main():
    if not shutil.which("mpirun") or not LIBRARY.exists():
        print("skipped: Open MPI is not installed (openmpi-bin, libopenmpi-dev)")
        return 77
    with tempfile.TemporaryDirectory() as name:
        directory = pathlib.Path(name)
        families = list(members(directory))
        models = random_models(directory)
        for file in [*families, *models]:
            compare_verdicts(file, SAME_GRAPH, True)
        for file in [*families, *(ROOT / example for example in EXAMPLES)]:
            compare_verdicts(file, INCLUSION, False)
        for file in [*families, *directory.glob("plain-*.fcr")]:  # others may have no classes
            compare_counts(file)
        check_limits(families[0])
        check_difference(directory)
        check_death(directory)
    print(f"{len(families) + len(models) + len(EXAMPLES)} programs, ranks {RANKS}")
    return 0


sys.exit(main())
