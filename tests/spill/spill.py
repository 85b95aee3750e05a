#!/usr/bin/env python3
"""Verifies with too little memory and `--spill`: verdicts and counts must be those of a search in memory. A disk
that fails must end a search with a clear reason, and nothing may be left in the directory.

    tests/spill/spill.py PROSKILL
"""
import json
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = pathlib.Path(sys.argv[1]).resolve()
PATIENCE = 300  # seconds after which a run counts as one that hangs
INCONCLUSIVE = 3  # the exit code

SAME_GRAPH = "dead-variables,live-variables,free-inputs,private-moves,stubborn-sets,extrapolation"
# each needs more than the program alone, and so much more that it does not fit
MODELS = [("philosophers 13", SAME_GRAPH), ("fischer 10", SAME_GRAPH), ("fischer 10", SAME_GRAPH + ",inclusion")]
COUNTED = "csma 7"
LONG = "philosophers 14"
LEAST_MIB = 5  # for a search on disk


def run(arguments, codes=(0, 1), program=PROGRAM, **how):
    command = [program, "verify", *arguments]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=PATIENCE, **how)
    assert done.returncode in codes, f"{command}: {done.returncode}\n{done.stdout}\n{done.stderr}"
    return done


def model(name, directory):
    """The file of a member of a family."""
    path = directory / (name.replace(" ", "") + ".fcr")
    if not path.exists():
        command = [sys.executable, ROOT / "bench/families.py", *name.split()]
        path.write_text(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    return path


def resident_alone(directory):
    """MiB that the program needs for almost nothing."""
    for limit in range(4, 1000):
        arguments = ["--memory-limit", str(limit), model("philosophers 3", directory)]
        if run(arguments, codes=(0, INCONCLUSIVE)).returncode == 0:
            return limit
    raise AssertionError("the program alone is too large")


class Bench:
    """A directory of models, one to spill to, and the arguments to do so."""

    def __init__(self, directory):
        self.directory = directory
        self.disk = directory / "disk"
        self.disk.mkdir()
        self.limit = str(resident_alone(directory) + LEAST_MIB)
        self.spill = ["--memory-limit", self.limit, "--spill", self.disk]
        self.long = [*self.spill, "--reduce", SAME_GRAPH, model(LONG, directory)]

    def is_empty(self):
        return not list(self.disk.iterdir())

    def started(self):
        """A long search that has written to the disk, and its open files without names."""
        child = subprocess.Popen([PROGRAM, "verify", *self.long], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                 text=True)
        begun = time.monotonic()
        while time.monotonic() < begun + PATIENCE:
            assert child.poll() is None, child.communicate()
            files = [file for file in spilled(child.pid, self.disk) if os.stat(file).st_size > 100_000]
            if files:
                return child, files
            time.sleep(0.02)
        raise AssertionError("nothing is written to the disk")


def spilled(process, disk):
    files = []
    for entry in pathlib.Path(f"/proc/{process}/fd").iterdir():
        try:
            if os.readlink(entry).startswith(f"{disk}/"):
                files.append(entry)
        except OSError:
            pass  # closed meanwhile
    return files


def report(arguments, **how):
    read = json.loads(run(["--format", "json", "--traces", "all", *arguments], **how).stdout)
    verdicts = {row["name"]: (row["verdict"], row.get("reason"), row["trace"]) for row in read["properties"]}
    size = read["exploration"]
    counts = {name: size[name] for name in ("classes", "markings", "domains", "transitions", "complete", "stopped")}
    return verdicts, counts, size.get("spilledBytes", 0)


def compare(bench):
    for name, reductions in MODELS:
        arguments = ["--reduce", reductions, model(name, bench.directory)]
        verdicts, counts, none = report(arguments)
        on_disk = report([*bench.spill, *arguments])
        assert none == 0
        assert on_disk[2] > 0, f"{name}: nothing was on disk"
        assert on_disk[0] == verdicts, f"{name}: {on_disk[0]} instead of {verdicts}"
        if "inclusion" not in reductions:
            assert on_disk[1] == counts, f"{name}: {on_disk[1]} instead of {counts}"
        assert bench.is_empty()


def compare_counts(bench):
    arguments = ["--graph", "counts", model(COUNTED, bench.directory)]
    alone = run(arguments).stdout.splitlines()
    on_disk = run([*bench.spill, *arguments]).stdout.splitlines()
    assert on_disk[0] == alone[0], f"{on_disk[0]} instead of {alone[0]}"
    assert on_disk[2].endswith("byte(s) on disk"), on_disk


def check_usage(bench):
    """What cannot be done is said at the start."""
    file = model("philosophers 3", bench.directory)
    limit = ["--memory-limit", "100"]
    there = [*limit, "--spill", bench.disk]
    state = bench.directory / "state"
    for arguments, said in [
        (["--spill", bench.disk, file], "--memory-limit"),
        ([*limit, "--spill", bench.directory / "missing", file], "No such file or directory"),
        ([*limit, "--spill", file, file], "Not a directory"),
        ([*there, "--checkpoint", state, file], "`--spill` has no checkpoints"),
        ([*there, "--mpi", file], "`--spill` is for one process"),
        ([*there, "--durations", file], "`--spill` is not for `--durations`"),
        ([*there, "--explain-size", file], "`--spill` is not for `--durations`"),
        ([*there, "--graph", "graph.aut", file], "but for no other graphs"),
        ([*there, "--graph", "counts", "--graph-of", "markings", file], "but for no other graphs"),
        ([*there, "--list", file], "but for no other graphs"),
        ([*there, "--backend", "tina", file], "`--spill` needs `--backend engine`"),
    ]:
        done = run(arguments, codes=(2,))
        assert said in done.stderr, f"{arguments}: {done.stderr}"
    assert not state.exists()


def check_permission(bench):
    """Root may write anywhere, so this runs as somebody else, who may not see where the program is."""
    closed = bench.directory / "closed"
    closed.mkdir(mode=0o755)
    file = model("philosophers 3", bench.directory)
    how = {"preexec_fn": lambda: os.setuid(65534)} if os.geteuid() == 0 else {}
    if not how:
        closed.chmod(0o555)
    bench.directory.chmod(0o755)
    program = shutil.copy(PROGRAM, bench.directory)
    said = run(["--memory-limit", "100", "--spill", closed, file], codes=(2,), program=program, **how).stderr
    assert "Permission denied" in said, said


def check_full_disk(bench):
    """A file may not grow any more: what is decided stays decided."""
    most = 200_000  # bytes of a file
    how = {"preexec_fn": lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))}
    said = run(bench.long, codes=(INCONCLUSIVE,), **how).stdout
    assert f"cannot write the files of the search in `{bench.disk}`: File too large" in said, said
    deadlock = bench.directory / "deadlock.fcr"
    text = model("philosophers 13", bench.directory).read_text()
    assert "property" in text
    deadlock.write_text(text + "\nproperty eats is absent (dining/1/state eating)\nassert eats\n")
    verdicts, _, _ = report([*bench.spill, "--reduce", SAME_GRAPH, deadlock], codes=(1,), **how)
    assert verdicts["eats"][0] == "violated" and verdicts["eats"][2], verdicts["eats"]
    assert any("File too large" in (reason or "") for _, reason, _ in verdicts.values()), verdicts
    assert bench.is_empty()


def check_shortened(bench):
    child, files = bench.started()
    for file in files:
        os.truncate(file, 0)
    out, problems = child.communicate(timeout=PATIENCE)
    assert child.returncode == INCONCLUSIVE, (out, problems)
    assert "another program has shortened a file" in out or "was changed by another program" in out, out


def check_removed_directory(bench):
    child, _ = bench.started()
    bench.disk.rmdir()
    out, problems = child.communicate(timeout=PATIENCE)
    bench.disk.mkdir()
    assert child.returncode == INCONCLUSIVE, (out, problems)
    assert "cannot create a file of the search" in out, out


def check_kill(bench):
    child, _ = bench.started()
    child.send_signal(signal.SIGKILL)
    child.communicate(timeout=PATIENCE)
    assert bench.is_empty()


def check_interrupt(bench):
    child, _ = bench.started()
    child.send_signal(signal.SIGINT)
    out, _ = child.communicate(timeout=PATIENCE)
    assert child.returncode == INCONCLUSIVE and "cancelled" in out, out
    assert bench.is_empty()


def check_two(bench):
    """Two processes with one directory."""
    arguments = [*bench.spill, "--reduce", SAME_GRAPH, model("philosophers 13", bench.directory)]
    commands = [[PROGRAM, "verify", *arguments]] * 2
    children = [subprocess.Popen(it, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) for it in commands]
    outs = [child.communicate(timeout=PATIENCE)[0] for child in children]
    assert [child.returncode for child in children] == [0, 0], outs
    assert all("on disk at most" in out for out in outs), outs


def check_time_limit(bench):
    said = run(["--time-limit", "1", *bench.long], codes=(INCONCLUSIVE,)).stdout
    assert "the time limit was reached" in said, said


def main():
    if not pathlib.Path("/proc/self/fd").exists():
        print("skipped: there is no /proc")
        return 77
    with tempfile.TemporaryDirectory() as name:
        bench = Bench(pathlib.Path(name))
        for check in (check_usage, check_permission, compare, compare_counts, check_two, check_full_disk,
                      check_shortened, check_removed_directory, check_kill, check_interrupt, check_time_limit):
            check(bench)
    return 0


sys.exit(main())
