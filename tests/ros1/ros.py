"""ROS 1 on this machine alone: a master on a port of its own, nodes, and runs of proskill."""

import json
import os
import pathlib
import shutil
import socket
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = sys.argv[1]
PYTHON = "/usr/bin/python3"  # the one that Debian's ROS is for
HERE = pathlib.Path(__file__).resolve().parent


def why_not():
    """Why there is no ROS here; empty if there is."""
    if not os.access(PYTHON, os.X_OK):
        return f"there is no {PYTHON}"
    found = subprocess.run([PYTHON, "-c", "import rospy, actionlib.msg, std_srvs.srv"], capture_output=True)
    if found.returncode or not shutil.which("rosmaster"):
        return "ROS 1 is not installed (apt-get install python3-rospy python3-actionlib python3-roslaunch)"
    return ""


def free_port():
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        return taken.getsockname()[1]


def until(holds, what, seconds=30):
    """Waits for what another process does."""
    end = time.monotonic() + seconds
    while not holds():
        if time.monotonic() > end:
            raise AssertionError(f"still waiting for {what}")
        time.sleep(0.02)


class Ros(unittest.TestCase):
    """A master for all tests of a class; what a test starts ends with it."""

    @classmethod
    def setUpClass(cls):
        cls.directory = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.directory.cleanup)
        cls.home = pathlib.Path(cls.directory.name)
        port = free_port()
        cls.surroundings = {**os.environ, "ROS_MASTER_URI": f"http://127.0.0.1:{port}", "ROS_IP": "127.0.0.1",
                            "ROS_HOME": str(cls.home), "ROS_LOG_DIR": str(cls.home / "log"), "PYTHONDONTWRITEBYTECODE": "1"}
        cls.master = cls.start_master(port)

    @classmethod
    def start_master(cls, port):
        master = subprocess.Popen(["rosmaster", "--core", "-p", str(port)], env=cls.surroundings, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        cls.addClassCleanup(end, master)
        until(lambda: listens(port), "the master")
        return master

    def setUp(self):
        self.path = pathlib.Path(tempfile.mkdtemp(dir=self.home))
        self.events = self.path / "events"
        self.events.touch()

    def start(self, *command, **options):
        process = subprocess.Popen([*map(str, command)], env=self.surroundings, **options)
        self.addCleanup(end, process)
        return process

    def start_server(self):
        before = self.log().count("ready")
        self.server = self.start(PYTHON, HERE / "server.py", self.events, stdin=subprocess.PIPE, text=True,
                                 stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
        until(lambda: self.log().count("ready") > before, "the action server")

    def log(self):
        return self.events.read_text(encoding="utf-8").splitlines()

    def write(self, program, platform):
        (self.path / "mission.proskill").write_text(program, encoding="utf-8")
        (self.path / "platform.json").write_text(json.dumps(platform, indent=1), encoding="utf-8")

    def begin(self, *options):
        self.running = self.start(PROGRAM, "run", "--format", "json", "--platform", self.path / "platform.json", *options,
                                  self.path / "mission.proskill", stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        return self.running

    def finish(self):
        out, self.errors = self.running.communicate(timeout=60)
        self.lines = [json.loads(line) for line in out.splitlines()]
        self.said = [line["description"] for line in self.lines if "description" in line]
        self.outcome = self.lines[-1].get("mission") if self.lines else None
        return self.running.returncode

    def run_it(self, *options):
        self.begin(*options)
        return self.finish()


def listens(port):
    with socket.socket() as probe:
        return probe.connect_ex(("127.0.0.1", port)) == 0


def end(process):
    process.kill()
    process.communicate()


def main():
    reason = why_not()
    if reason:
        print(f"skipped: {reason}")
        sys.exit(77)
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
