"""ROS 1 on this machine alone: a master on a port of its own, nodes, and runs of proskill."""

import os
import pathlib
import shutil
import socket
import subprocess
import sys
import tempfile

sys.path.insert(1, str(pathlib.Path(__file__).resolve().parents[1] / "ros"))
from runs import Runs, end, until  # noqa: E402

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


class Ros(Runs):
    """A master for all tests of a class."""

    server_errors = subprocess.DEVNULL

    @classmethod
    def setUpClass(cls):
        cls.home = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
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

    def start_server(self):
        self.start_server_by(PYTHON, HERE / "server.py")


def listens(port):
    with socket.socket() as probe:
        return probe.connect_ex(("127.0.0.1", port)) == 0
