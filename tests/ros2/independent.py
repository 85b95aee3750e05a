"""The platform `ros2` against an implementation of ROS 2 that shares nothing with ours: the crate `ros2-client`.

Its server is built on request, in the user's cache: it takes minutes. Without it the test is skipped.

usage: independent.py PROGRAM
       independent.py --build
"""

import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import threading

import ros
from runs import main, until

CRATE = ros.HERE / "crate"
SUCCEED, WAIT, ABORT, REJECT, LATE = range(5)
MISSION = """
(defsv battery :states (Unknown Good Critical) :init Unknown)
(defevent battery_good :effects (battery Good))
(defevent battery_critical :effects (battery Critical))
(defskill fly :input ($how int) :action (fly $how) :interrupt () :success (there odd) :failure (lost refused))
(defskill arm :input ($on bool) :action (arm $on) :success armed :failure rejected)
(defskill say :input ($text string) :action (say $text))
(defskill mission :success done :body (
  (^ (battery Good)) (fly how 0) (fly how 2) (fly how 3) (arm on true) (say text "hello") (fly how HOW) (success done)))
(defskill watch :monitor t :body ((^ (battery Critical)) (fly.interrupt)))
"""
PLATFORM = {
    "kind": "ros2",
    "node": "robot_1",
    "namespace": "fleet",
    "startup": 60,
    "python": sys.executable,
    "types": {"test_msgs/action/Fly": {"goal": {"name": "string", "how": "int32", "height": "float64"},
                                       "result": {"path": "int32[]"}}},
    "actions": {
        "fly": {"action": "/fly", "type": "test_msgs/action/Fly", "goal": {"how": "$how", "name": "drone", "height": 2.5},
                "results": {"succeeded": [{"field": "path[1]", "equals": 7, "result": "there"}, {"result": "odd"}],
                            "aborted": [{"field": "path[0]", "equals": 2, "result": "lost"}], "rejected": "refused"}},
        "arm": {"service": "/arm", "type": "std_srvs/srv/SetBool", "request": {"data": "$on"},
                "results": [{"field": "message", "equals": "no", "result": "armed"}, {"result": "rejected"}]},
        "say": {"topic": "/say", "type": "std_msgs/msg/String", "message": {"data": "$text"}},
    },
    "variables": {
        "battery": {"topic": "/battery", "type": "std_msgs/msg/Float32", "field": "data",
                    "values": [{"value": "Critical", "below": 0.2}, {"value": "Good"}]},
    },
}


def cache():
    """A folder for this version of the crate."""
    digest = hashlib.sha256()
    for name in ("Cargo.toml", "Cargo.lock", "src/main.rs"):
        digest.update((CRATE / name).read_bytes())
    home = os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache"
    return pathlib.Path(home, "proskill", f"ros2-{digest.hexdigest()[:16]}")


def cargo(folder, *arguments):
    return subprocess.run(["cargo", *arguments, "--locked", "--manifest-path", CRATE / "Cargo.toml"],
                          env={**os.environ, "CARGO_TARGET_DIR": str(folder)}, capture_output=True, text=True)


def need_cargo():
    if not shutil.which("cargo"):
        sys.exit("cargo is not installed (apt-get install cargo-web)")
    shown = subprocess.run(["cargo", "--version"], capture_output=True, text=True).stdout
    version = re.match(r"cargo 1\.(\d+)", shown)
    if not version or int(version[1]) < 88:
        sys.exit(f"this is {shown.strip()}, and 1.88 is needed (apt-get install cargo-web)")


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(77)


def built_server():
    server = cache() / "server"
    if not server.exists():
        skip("ros2-client is not built (./dev peers)")
    return server


def build():
    server = cache() / "server"
    need_cargo()
    folder = cache() / "target"
    fetched = cargo(folder, "fetch")
    if fetched.returncode:
        sys.exit(fetched.stderr)
    print(f"building ros2-client in {cache()}, which takes minutes", flush=True)
    built = cargo(folder, "build", "--release", "--offline")
    if built.returncode:
        sys.exit(built.stderr)
    half = server.with_suffix(f".{os.getpid()}")
    shutil.copy(folder / "release/independent_server", half)
    half.rename(server)
    shutil.rmtree(folder, ignore_errors=True)


class Independent(ros.Ros):
    def setUp(self):
        super().setUp()
        self.surroundings = {**self.surroundings, "ROS_DISTRO": "jazzy"}  # for which the crate is built
        self.server = self.start(SERVER, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        self.heard = []
        self.reader = threading.Thread(target=lambda: self.heard.extend(map(str.strip, iter(self.server.stdout.readline, ""))))
        self.reader.start()
        self.addCleanup(self.reader.join)
        self.addCleanup(self.server.kill)
        self.await_line("ready")

    def await_line(self, line):
        until(lambda: line in self.heard, f"{line}: {self.heard}")

    def tell(self, line):
        self.server.stdin.write(f"{line}\n")
        self.server.stdin.flush()

    def fly(self, how):
        self.write(MISSION.replace("HOW", str(how)), PLATFORM)
        self.begin()
        self.tell(0.9)

    def ends_well(self):
        self.assertEqual(self.finish(), 0, f"{self.errors}\n{self.said}\n{self.heard}")
        for text in ("succeeds with `there`", "fails with `lost`", "fails with `refused`", "succeeds with `armed`",
                     "asks its action to stop"):
            self.assertIn(text, self.said)
        self.assertFalse([text for text in self.said if "fault" in text])
        self.await_line("said hello")
        self.await_line("node /fleet/robot_1")
        self.assertIn("goal 0 drone 2.5", self.heard)

    def test_goals_a_service_topics_and_a_cancel(self):
        self.fly(WAIT)
        self.await_line(f"accepted {WAIT}")
        self.tell(0.1)
        self.ends_well()

    def test_an_interrupt_before_the_goal_is_accepted(self):
        self.fly(LATE)
        self.await_line(f"goal {LATE} drone 2.5")
        self.tell(0.1)
        self.until_it_says("asks its action to stop")
        self.tell("decide")
        self.ends_well()
        self.await_line(f"accepted {LATE}")


if __name__ == "__main__":
    if sys.argv[1:] == ["--build"]:
        sys.exit(build())
    if ros.why_not():
        skip(ros.why_not())
    SERVER = built_server()
    main("")
