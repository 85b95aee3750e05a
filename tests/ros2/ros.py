"""ROS 2 on this machine alone: a domain of its own on the loopback interface, nodes, and runs of proskill."""

import contextlib
import fcntl
import os
import pathlib
import sys
import tempfile

sys.path.insert(1, str(pathlib.Path(__file__).resolve().parents[1] / "ros"))
from runs import PROGRAM, Runs  # noqa: E402

LIBRARY = PROGRAM.parent.parent / "lib/libproskill_dds.so"
HERE = pathlib.Path(__file__).resolve().parent


def why_not():
    """Why there is no DDS here; empty if there is."""
    return "" if LIBRARY.exists() else "Fast DDS is not installed (apt-get install libfastrtps-dev)"


@contextlib.contextmanager
def own_domain():
    """A domain that no other test of this machine has: the lock of a file says whose it is."""
    folder = pathlib.Path(tempfile.gettempdir())
    for domain in range(20, 101):
        with open(folder / f"proskill-ros2-domain-{domain}-{os.getuid()}", "w", encoding="utf-8") as file:
            try:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except OSError:
                continue
            yield domain
            return
    raise AssertionError("no domain is free")


class Ros(Runs):
    """A domain for all tests of a class."""

    @classmethod
    def setUpClass(cls):
        cls.home = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        domain = cls.enterClassContext(own_domain())
        cls.surroundings = {**os.environ, "ROS_DOMAIN_ID": str(domain), "ROS_LOCALHOST_ONLY": "1",
                            "AMENT_PREFIX_PATH": "", "PYTHONDONTWRITEBYTECODE": "1"}

    def start_server(self):
        self.start_server_by(sys.executable, HERE / "server.py", LIBRARY)
