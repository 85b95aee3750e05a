"""Runs of proskill beside an action server, for both platforms of ROS."""

import json
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = pathlib.Path(sys.argv[1]).resolve()


def until(holds, what, seconds=60):
    """Waits for what another process does."""
    end = time.monotonic() + seconds
    while not holds():
        if time.monotonic() > end:
            raise AssertionError(f"still waiting for {what}")
        time.sleep(0.02)


class Runs(unittest.TestCase):
    """What a test starts ends with it. The classes have `home`, a folder, and `surroundings`, the environment of processes."""

    def setUp(self):
        self.path = pathlib.Path(tempfile.mkdtemp(dir=self.home))
        self.events = self.path / "events"
        self.events.touch()

    def start(self, *command, **options):
        process = subprocess.Popen([*map(str, command)], env=self.surroundings, **options)
        self.addCleanup(end, process)
        return process

    def start_server_by(self, *command):
        """Starts an action server, which writes to `events` what it sees."""
        before = self.log().count("ready")
        self.server = self.start(*command, self.events, stdin=subprocess.PIPE, text=True, stderr=self.server_errors,
                                 stdout=subprocess.DEVNULL)
        until(lambda: self.log().count("ready") > before, "the action server")

    server_errors = None

    def log(self):
        return self.events.read_text(encoding="utf-8").splitlines()

    def write(self, program, platform):
        (self.path / "mission.proskill").write_text(program, encoding="utf-8")
        (self.path / "platform.json").write_text(json.dumps(platform, indent=1), encoding="utf-8")

    def begin(self, *options):
        self.early = []
        self.running = self.start(PROGRAM, "run", "--format", "json", "--no-record", "--platform", self.path / "platform.json",
                                  *options, self.path / "mission.proskill", stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE, text=True)
        return self.running

    def until_it_says(self, text):
        """Reads the run's steps up to one."""
        for line in self.running.stdout:
            self.early.append(line)
            if text in line:
                return
        self.fail(f"no {text}: {self.running.stderr.read()}")

    def finish(self):
        out, self.errors = self.running.communicate(timeout=120)
        self.lines = [json.loads(line) for line in [*self.early, *out.splitlines()]]
        self.said = [line["description"] for line in self.lines if "description" in line]
        return self.running.returncode

    def run_it(self, *options):
        self.begin(*options)
        return self.finish()


def end(process):
    process.kill()
    process.communicate()


def main(why_not):
    if why_not:
        print(f"skipped: {why_not}")
        sys.exit(77)
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
