"""Viewers of runs (`proskill run --groot`), by a client of the protocol that uses libzmq's Python package.

usage: watch.py PROGRAM
"""

import contextlib
import ctypes
import json
import os
import pathlib
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import urllib.request

import btlog

DEBIANS = "/usr/bin/python3"  # the one that Debian's package is for
ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = pathlib.Path(sys.argv[1]).resolve()
DRONE = ROOT / "examples/drone/drone.proskill"
PATIENCE = 60
WAITING = """
(defsv door :states (Open Closed) :init Open :transitions :all)
(defskill fly :action (fly) :success there)
(defskill search :success found :body ((fly) (set (door Closed)) (success found)))
(defskill mission :success done :body ((search) (success done)))
"""
PATROL = """
(defsv place :states (Here There) :init Here :transitions :all)
(defskill patrol :body ((while true (^ 1) (set (place There)) (printf "it is There") (^ 1) (set (place Here)))))
"""
# Flies until somebody writes to the pipe.
ROBOT = """
import json, sys
print(json.dumps({"type": "ready", "protocol": 1}), flush=True)
for line in sys.stdin:
    said = json.loads(line)
    if said["type"] == "start":
        open("pipe").read()
        print(json.dumps({"type": "result", "run": said["run"], "result": "there"}), flush=True)
    if said["type"] == "end":
        break
"""

try:
    import zmq
except ImportError:
    found = os.access(DEBIANS, os.X_OK) and subprocess.run([DEBIANS, "-c", "import zmq"], capture_output=True).returncode == 0
    if found and sys.executable != DEBIANS:
        os.execv(DEBIANS, [DEBIANS, "-B", *sys.argv])
    print("skipped: ZeroMQ is not installed (apt-get install libzmq5 python3-zmq)")
    sys.exit(77)


def unpacked(data):
    """What a MessagePack text of strings, numbers and maps says."""
    def take(at):
        kind = data[at]
        if kind < 0x80:
            return kind, at + 1
        if kind < 0x90 or kind == 0xDE:
            size, at = (kind & 0x0F, at + 1) if kind < 0x90 else (int.from_bytes(data[at + 1:at + 3], "big"), at + 3)
            values = {}
            for _ in range(size):
                key, at = take(at)
                values[key], at = take(at)
            return values, at
        size, at = (kind & 0x1F, at + 1) if kind < 0xC0 else (data[at + 1], at + 2)
        assert 0xA0 <= kind < 0xC0 or kind == 0xD9, hex(kind)
        return data[at:at + size].decode(), at + size

    value, end = take(0)
    assert end == len(data)
    return value


def hook(uid, position=0, **more):
    """A breakpoint as Groot2 sends it; position 1: after the node."""
    return json.dumps({"uid": uid, "position": position, "mode": 0, "enabled": True, "once": False, "desired_status": "SKIPPED", **more})


class Viewer:
    def __init__(self, test, port):
        self.context = zmq.Context()
        self.socket = self.context.socket(zmq.REQ)
        self.socket.linger, self.socket.rcvtimeo = 0, PATIENCE * 1000
        self.port = port
        self.socket.connect(f"tcp://127.0.0.1:{port}")
        test.addCleanup(self.close)
        self.number = 0

    def close(self):
        self.socket.close()
        self.context.term()

    def send(self, letter, *more):
        self.number += 1
        self.head = struct.pack("<BBI", 2, ord(letter), self.number)
        self.socket.send_multipart([self.head, *(it.encode() for it in more)])

    def ask(self, letter, *more):
        """The second part of the reply; None: there is none."""
        self.send(letter, *more)
        head, *rest = self.socket.recv_multipart()
        if head == b"error":
            return f"error: {rest[0].decode()}"
        assert len(head) == 22 and head[:6] == self.head, head
        self.tree_id = head[6:]
        return rest[0] if rest else None

    def tree(self):
        return btlog.Tree(self.ask("T"))

    def statuses(self):
        data = self.ask("S")
        return {uid: status for uid, status in struct.iter_unpack("<HB", data)}

    def subscribe(self, test):
        """Messages, from now on."""
        self.messages = self.context.socket(zmq.SUB)
        self.messages.linger, self.messages.rcvtimeo = 0, PATIENCE * 1000
        test.addCleanup(self.messages.close)
        self.messages.subscribe(b"")
        with self.messages.get_monitor_socket(zmq.EVENT_HANDSHAKE_SUCCEEDED) as events:
            self.messages.connect(f"tcp://127.0.0.1:{self.port + 1}")
            assert events.poll(PATIENCE * 1000)
            self.messages.disable_monitor()

    def stopped_at(self):
        """The node at which the run has stopped, according to the next message."""
        head, uid = self.messages.recv_multipart()
        assert head[:2] == bytes([2, ord("N")]) and len(head) == 6, head
        return int(uid)

    def until(self, uid, status):
        end = time.monotonic() + PATIENCE
        while self.statuses()[uid] != status:
            assert time.monotonic() < end, f"{uid} never had the status {status}"


class Watch(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.path = pathlib.Path(directory.name)

    def begin(self, *options, program=DRONE):
        self.process = subprocess.Popen([PROGRAM, "run", "--no-record", "--groot", "--groot-port", "0", *options, program],
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(self.stop)
        line = self.process.stderr.readline()
        self.assertTrue(line.startswith("viewers of behavior trees can connect to port "), line)
        return int(line.split()[-1])

    def begin_to_wait(self):
        """Begins a run that flies until `let_go`."""
        (self.path / "mission.proskill").write_text(WAITING, encoding="utf-8")
        (self.path / "robot.py").write_text(ROBOT, encoding="utf-8")
        os.mkfifo(self.path / "pipe")
        platform = self.path / "platform.json"
        platform.write_text(json.dumps({"kind": "process", "command": [sys.executable, "robot.py"]}), encoding="utf-8")
        return self.begin("--platform", platform, program=self.path / "mission.proskill")

    def let_go(self):
        (self.path / "pipe").write_text("go")

    def stop(self):
        """\\return the exit code"""
        with contextlib.suppress(ProcessLookupError):
            self.process.send_signal(signal.SIGTERM)
        try:
            code = self.process.wait(PATIENCE)
        finally:
            self.process.kill()
            self.process.stdout.close()
            self.process.stderr.close()
        return code

    def until_it_ends(self):
        for line in self.process.stdout:
            if line.startswith("the mission has ended"):
                return line
        raise AssertionError("the run ended before the mission")

    def test_a_run_in_simulated_time_is_shown_after_its_end(self):
        log = self.path / "run.btlog"
        process = subprocess.run([PROGRAM, "run", "--record", log, DRONE], capture_output=True, text=True)
        viewer = Viewer(self, self.begin())
        self.until_it_ends()
        tree, _, changes = btlog.read(log.read_bytes())
        self.assertEqual(viewer.tree().nodes.keys(), tree.nodes.keys())
        shown = viewer.statuses()
        self.assertEqual({uid: 0 if status >= 10 else status for uid, status in shown.items()}, btlog.replay(tree, changes))
        self.assertTrue(any(status >= 11 for status in shown.values()))
        board = unpacked(viewer.ask("B", tree.name))[tree.name]
        self.assertIn(f"uav_mission: {board['uav_mission.status']}\n", process.stdout)
        self.assertEqual(self.stop(), process.returncode)

    def test_viewers_change_nothing(self):
        Viewer(self, self.begin("--seed", "5")).ask("T")
        alone = subprocess.run([PROGRAM, "run", "--seed", "5", DRONE], capture_output=True, text=True).stdout
        self.assertEqual("".join(self.process.stdout.readline() for _ in alone.splitlines()), alone)

    def test_a_run_in_real_time_is_shown_while_it_happens(self):
        port = self.begin_to_wait()
        viewer = Viewer(self, port)
        tree = viewer.tree()
        (fly,), (search,) = tree.tagged("fly"), tree.tagged("search")
        viewer.until(fly, btlog.RUNNING)
        self.assertEqual(viewer.statuses()[search], btlog.RUNNING)
        path = tree.nodes[search].get("_fullpath")
        boards = unpacked(viewer.ask("B", f"mission;{path};nobody"))
        self.assertEqual(boards["mission"]["door"], "Open")
        self.assertEqual(boards[path]["status"], "no_status")
        self.assertEqual(boards.keys(), {"mission", path})
        self.assertGreater(int(viewer.ask("r", "start")), 1_600_000_000_000_000)
        self.assertEqual(viewer.ask("t"), b"")
        self.let_go()
        viewer.until(1, btlog.SUCCESS)
        changes = list(btlog.changes(viewer.ask("t")))
        self.assertEqual(changes[0][1:], (fly, btlog.SUCCESS))
        self.assertEqual(changes[-1][1:], (1, btlog.SUCCESS))
        self.assertEqual([time for time, _, _ in changes], sorted(time for time, _, _ in changes))
        self.assertEqual(viewer.statuses()[search], 10 + btlog.SUCCESS)
        self.assertIsNone(viewer.ask("r", "stop"))
        self.assertEqual(self.stop(), 0)

    def begin_to_patrol(self, *options):
        """Begins a simulated run in real time, which goes back and forth."""
        (self.path / "patrol.proskill").write_text(PATROL, encoding="utf-8")
        return self.begin("--clock", "10x", *options, program=self.path / "patrol.proskill")

    def place(self, viewer):
        return unpacked(viewer.ask("B", "patrol"))["patrol"]["place"]

    def test_a_breakpoint_stops_a_simulation_before_or_after_a_node(self):
        viewer = Viewer(self, self.begin_to_patrol())
        viewer.subscribe(self)
        there, back = viewer.tree().tagged("Set")
        self.assertIsNone(viewer.ask("I", hook(there)))
        for _ in range(3):
            self.assertEqual(viewer.stopped_at(), there)
            self.assertEqual(self.place(viewer), "Here")
            self.assertEqual(viewer.statuses()[there], btlog.RUNNING)
            self.assertIsNone(viewer.ask("U", json.dumps({"uid": there, "position": 0, "desired_status": "SKIPPED", "remove_when_done": False})))
        self.assertEqual(viewer.stopped_at(), there)
        self.assertIsNone(viewer.ask("I", f"[{hook(there, 1)},{hook(back)}]"))
        self.assertEqual(len(json.loads(viewer.ask("D"))), 3)
        self.assertIn("decided by the program", viewer.ask("U", hook(there, desired_status="SUCCESS")))
        self.assertIsNone(viewer.ask("U", hook(there, once=True)))
        self.assertEqual(viewer.stopped_at(), there)
        self.assertEqual(self.place(viewer), "There")
        self.assertEqual(viewer.ask("U", hook(there)), "error: Node ID not found")  # that one was for once
        self.assertIsNone(viewer.ask("R", hook(there, 1)))  # lets it go on
        self.assertEqual(viewer.stopped_at(), back)
        self.assertIsNone(viewer.ask("A"))
        self.assertEqual(viewer.ask("D"), b"[]")
        viewer.until(there, btlog.SUCCESS)
        self.assertEqual(self.stop(), 3)

    def test_a_viewer_that_leaves_does_not_hold_the_run(self):
        viewer = Viewer(self, self.begin_to_patrol())
        viewer.subscribe(self)
        there = viewer.tree().tagged("Set")[0]
        self.assertIsNone(viewer.ask("I", hook(there)))
        self.assertEqual(viewer.stopped_at(), there)
        count = 0
        for line in self.process.stdout:  # comes to the end of these only after the viewer's 5 s of silence
            count += "is There" in line
            if count == 3:
                break
        self.assertIsNone(viewer.ask("A"))

    def test_a_run_of_a_robot_has_no_breakpoints(self):
        viewer = Viewer(self, self.begin_to_wait())
        self.assertEqual(viewer.ask("I", hook(1)), "error: only simulations can be paused: the robot would go on")
        self.assertEqual(viewer.ask("D"), b"[]")
        self.let_go()
        viewer.until(1, btlog.SUCCESS)
        self.assertEqual(self.stop(), 0)

    def test_breakpoints_and_pages_pause_one_run(self):
        port = self.begin_to_patrol("--view", "--no-open")
        url = self.process.stderr.readline().split()[-1]

        def control(action):
            request = urllib.request.Request(url + "api/control", json.dumps({"do": action}).encode(), {"Content-Type": "application/json"})
            with urllib.request.urlopen(request, timeout=PATIENCE) as answer:
                return json.load(answer)["result"]

        viewer = Viewer(self, port)
        viewer.subscribe(self)
        there = viewer.tree().tagged("Set")[0]
        self.assertIsNone(viewer.ask("I", hook(there)))
        self.assertEqual(viewer.stopped_at(), there)
        self.assertEqual(control("step")["state"], "paused")
        viewer.until(there, btlog.SUCCESS)
        self.assertEqual(control("continue")["state"], "running")
        self.assertEqual(viewer.stopped_at(), there)
        self.assertIsNone(viewer.ask("U", hook(there, once=True)))
        control("pause")
        self.assertEqual(viewer.ask("U", hook(there)), "error: Node ID not found")

    def test_each_run_has_an_id(self):
        ids = set()
        for _ in range(2):
            viewer = Viewer(self, self.begin())
            viewer.ask("S")
            ids.add(viewer.tree_id)
            self.stop()
        self.assertEqual(len(ids), 2)

    def test_viewers_that_misbehave_disturb_nobody(self):
        port = self.begin_to_wait()
        viewer = Viewer(self, port)
        gone = Viewer(self, port)
        gone.send("S")  # and never reads the reply
        gone.socket.close()
        with socket.create_connection(("127.0.0.1", port)) as stranger:
            stranger.sendall(b"GET / HTTP/1.1\r\n\r\n")
        greedy = Viewer(self, port)
        greedy.send("B", "x" * 100_000)  # is disconnected
        for letter, *more in [("Q",), ("N",), ("B",), ("r", "begin"), ("I", '{"uid": 1}'), ("I", hook(1)), ("U", "nonsense"), ("R",)]:
            self.assertTrue(str(viewer.ask(letter, *more)).startswith("error: "), letter)
        viewer.socket.send(b"")
        self.assertEqual(viewer.socket.recv_multipart(), [b"error", b"wrong request header"])
        self.assertTrue(viewer.ask("B", *["many"] * 10_000).startswith("error: "))
        self.assertEqual(viewer.ask("D"), b"[]")
        self.assertIsNone(viewer.ask("A"))
        others = [Viewer(self, port) for _ in range(5)]
        for other in others:
            other.send("S")
        self.assertEqual([len(other.socket.recv_multipart()) for other in others], [2] * 5)
        self.let_go()
        viewer.until(1, btlog.SUCCESS)
        self.assertEqual(self.stop(), 0)

    def test_a_viewer_may_subscribe_to_messages(self):
        port = self.begin_to_wait()
        with zmq.Context() as context, context.socket(zmq.SUB) as subscriber:
            with subscriber.get_monitor_socket(zmq.EVENT_HANDSHAKE_SUCCEEDED) as events:
                subscriber.connect(f"tcp://127.0.0.1:{port + 1}")
                self.assertTrue(events.poll(PATIENCE * 1000))
                subscriber.disable_monitor()
        self.let_go()
        self.until_it_ends()

    def refused(self, *options, surroundings=None):
        done = subprocess.run([PROGRAM, "run", "--groot", *options, DRONE], capture_output=True, text=True,
                              env=surroundings)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        return done.stderr

    def test_a_port_that_is_taken_is_an_error_before_the_run(self):
        for offset in (0, 1):
            with socket.socket() as taken:
                taken.bind(("127.0.0.1", 0))
                taken.listen()
                port = taken.getsockname()[1] - offset
                self.assertIn(f"`--groot` is not possible: ports {port} and {port + 1} must be free: Address already in use",
                              self.refused("--groot-port", str(port)))

    def test_without_zeromq_a_run_is_not_watched(self):
        (self.path / "libzmq.so.5").write_text("not a library")
        said = self.refused(surroundings={**os.environ, "LD_LIBRARY_PATH": str(self.path)})
        self.assertIn("`--groot` is not possible: ZeroMQ is not installed (apt-get install libzmq5)", said)


if __name__ == "__main__":
    try:
        ctypes.CDLL("libzmq.so.5")
    except OSError:
        print("skipped: ZeroMQ is not installed (apt-get install libzmq5 python3-zmq)")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
