"""`proskill view` answers only requests with its token from its own page.

usage: protocol.py PROGRAM
"""

import html
import http.client
import json
import os
import pathlib
import re
import resource
import select
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = sys.argv.pop(1)
LIFT = pathlib.Path(__file__).resolve().parents[2] / "examples/lift/bug.proskill"


class View:
    """A running `proskill view`."""

    def __init__(self, file, *options, before=None):
        self.process = subprocess.Popen([PROGRAM, "view", "--no-open", *options, str(file)], text=True,
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, preexec_fn=before)
        self.url = self.process.stdout.readline().strip()
        found = re.fullmatch(r"http://127\.0\.0\.1:(\d+)(/[0-9a-f]{32}/)", self.url)
        if not found:
            raise AssertionError(f"no address: {self.url} {self.process.communicate()}")
        self.port, self.path = int(found[1]), found[2]

    def ask(self, target, method="GET", body=None, **headers):
        """The answer to a request: its status, headers and body."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=30)
        headers = {name.replace("_", "-"): value for name, value in headers.items()}
        connection.request(method, target, body, headers)
        answer = connection.getresponse()
        return answer.status, dict(answer.getheaders()), answer.read()

    def call(self, method, **params):
        status, _, body = self.ask(f"{self.path}api/{method}", "POST", json.dumps(params),
                                   Content_Type="application/json")
        assert status == 200, (status, body)
        return json.loads(body)

    def verified(self):
        """The program once it is decided, according to the events."""
        program, after = self.call("hello")["result"]["program"], 0
        while program["state"] == "checking":
            news = self.call("news", after=after)["result"]
            after = news["next"]
            for it in news["news"]:
                if it["method"] == "program":
                    program = it["params"]
        return program

    def end(self):
        self.process.send_signal(signal.SIGINT)
        out, err = self.process.communicate(timeout=60)
        return self.process.returncode, out, err


class Protocol(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.view = View(LIFT)

    @classmethod
    def tearDownClass(cls):
        assert cls.view.end() == (0, "", ""), "Ctrl-C ends it without a word"

    def test_the_page_lets_in_nothing_from_elsewhere(self):
        status, headers, body = self.view.ask(self.view.path)
        self.assertEqual(status, 200)
        policy = headers["Content-Security-Policy"]
        self.assertIn("default-src 'none'", policy)
        self.assertIn("frame-ancestors 'none'", policy)
        self.assertNotIn("unsafe", policy)
        self.assertEqual(headers["Cache-Control"], "no-store")
        self.assertEqual(headers["Referrer-Policy"], "no-referrer")
        self.assertNotRegex(body.decode(), r"<script>|style=|\son\w+=")

    def test_script_and_style_are_those_of_the_panel(self):
        dist = LIFT.parents[2] / "panel/dist"
        for name in ("panel.js", "panel.css"):
            status, _, body = self.view.ask(self.view.path + name)
            self.assertEqual((status, body), (200, (dist / name).read_bytes()))

    def test_without_the_token_there_is_nothing(self):
        wrong = self.view.path[:-2] + ("0" if self.view.path[-2] != "0" else "1") + "/"
        for target in ("/", "/panel.js", "/api/hello", wrong, wrong + "panel.js", self.view.path[:-1], "//"):
            self.assertEqual(self.view.ask(target)[0], 403, target)
        self.assertEqual(self.view.ask(wrong + "api/hello", "POST", "{}", Content_Type="application/json")[0], 403)

    def test_a_foreign_host_or_origin_is_refused(self):
        path, port = self.view.path, self.view.port
        for headers in ({"Host": "evil.example"}, {"Host": f"evil.example:{port}"}, {"Host": "127.0.0.1"},
                        {"Host": f"127.0.0.1:{port + 1}"}, {"Origin": "http://evil.example"}, {"Origin": "null"},
                        {"Origin": f"https://127.0.0.1:{port}"}, {"Origin": f"http://127.0.0.1:{port}.evil.example"},
                        {"Sec_Fetch_Site": "cross-site"}):
            self.assertEqual(self.view.ask(path, **headers)[0], 403, headers)
        self.assertEqual(self.view.ask(path, Host=f"localhost:{port}")[0], 200)
        self.assertEqual(self.view.ask(path, Origin=f"http://127.0.0.1:{port}")[0], 200)

    def test_what_is_no_request_of_ours_is_refused(self):
        path = self.view.path
        self.assertEqual(self.view.ask(path + "nothing")[0], 404)
        self.assertEqual(self.view.ask(path + "../../etc/passwd")[0], 404)
        self.assertEqual(self.view.ask(path, "POST", "")[0], 405)
        self.assertEqual(self.view.ask(path + "api/hello")[0], 405)
        json_type = {"Content_Type": "application/json"}
        self.assertEqual(self.view.ask(path + "api/hello", "POST", "{}")[0], 400)
        self.assertEqual(self.view.ask(path + "api/hello", "POST", "[", **json_type)[0], 400)
        self.assertEqual(self.view.ask(path + "api/trace", "POST", '{"name": 3}', **json_type)[0], 400)
        self.assertIn("error", self.view.call("everything"))

    def raw(self, data):
        with socket.create_connection(("127.0.0.1", self.view.port), timeout=30) as connection:
            connection.sendall(data)
            with connection.makefile("rb") as answer:
                return answer.read()

    def test_odd_bytes_are_refused(self):
        self.assertIn(b" 400 ", self.raw(b"hello\r\n\r\n"))
        self.assertIn(b" 400 ", self.raw(b"GET / HTTP/1.1\r\nHost: a\r\nHost: b\r\n\r\n"))
        self.assertIn(b" 400 ", self.raw(b"GET / HTTP/1.1\r\nHost: a\nX: b\r\n\r\n"))
        self.assertIn(b" 400 ", self.raw(b" / HTTP/1.1\r\n\r\n"))
        self.assertIn(b" 413 ", self.raw(b"GET / HTTP/1.1\r\nX: " + b"x" * 20000))
        self.assertIn(b" 413 ", self.raw(b"POST / HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\n"))
        self.assertIn(b" 413 ", self.raw(b"POST / HTTP/1.1\r\nContent-Length: 1048577\r\n\r\n"))
        self.assertIn(b" 413 ", self.raw(b"POST / HTTP/1.1\r\nContent-Length: -1\r\n\r\n"))

    def test_the_program_is_verified_and_its_traces_are_asked_for_one_by_one(self):
        program = self.view.verified()
        self.assertEqual((program["state"], program["stale"]), ("done", False))
        self.assertEqual([file["label"] for file in program["files"]][0], "bug.proskill")
        found = {it["name"]: it for it in program["properties"]}["doors_closed_when_moving"]
        self.assertEqual((found["verdict"], found["trace"]), ("violated", None))
        trace = self.view.call("trace", name=found["name"])["result"]
        self.assertEqual(len(trace["steps"]), found["steps"])
        self.assertEqual(trace["description"], found["description"])
        self.assertIn("error", self.view.call("trace", name="nobody"))

    def test_sources_are_those_of_the_program_alone(self):
        uri = self.view.call("hello")["result"]["program"]["files"][0]["uri"]
        self.assertEqual(self.view.call("source", uri=uri)["result"]["text"], LIFT.read_text())
        self.assertIn("error", self.view.call("source", uri="/etc/passwd"))

    def test_pictures_have_a_place_for_each_node(self):
        picture = self.view.call("picture", kind="body", name="run_lift")["result"]
        content = html.unescape(picture["content"])
        for node in picture["nodes"]:
            self.assertIn(f'<g id="{node["id"]}" class="node role-{node["role"]}"', content)
        call = next(node for node in picture["nodes"] if node["label"] == "serve_call")
        begin, end = call["location"]["begin"], call["location"]["end"]
        line = pathlib.Path(call["location"]["file"]).read_text().splitlines()[begin["line"] - 1]
        self.assertEqual(line[begin["column"] - 1:end["column"] - 1], "(serve_call)")
        self.assertIn("error", self.view.call("picture", kind="body", name="nobody"))
        self.assertIn("error", self.view.call("picture", kind="nothing", name=""))


class Load(unittest.TestCase):
    """More than one page asks for."""

    def setUp(self):
        self.view = View(LIFT)
        self.view.verified()

    def tearDown(self):
        self.view.end()

    def test_many_that_wait_for_news_keep_nobody_waiting(self):
        after = self.view.call("news", after=0)["result"]["next"]
        body = json.dumps({"after": after}).encode()
        head = (f"POST {self.view.path}api/news HTTP/1.1\r\nHost: 127.0.0.1:{self.view.port}\r\n"
                f"Content-Type: application/json\r\nContent-Length: {len(body)}\r\n\r\n").encode()
        polls = [socket.create_connection(("127.0.0.1", self.view.port), timeout=30) for _ in range(40)]
        try:
            for poll in polls:
                poll.sendall(head + body)
            begin = time.monotonic()
            self.assertEqual(self.view.ask(self.view.path)[0], 200)
            self.assertLess(time.monotonic() - begin, 5)  # each poll waits for 20 s
            self.view.call("verify")
            for poll in polls:  # and each of them receives the event
                self.assertIn(b'"news":[{', poll.makefile("rb").read())
        finally:
            for poll in polls:
                poll.close()

    def test_the_oldest_of_too_many_that_wait_is_told_nothing(self):
        after = self.view.call("news", after=0)["result"]["next"]
        body = json.dumps({"after": after}).encode()
        head = (f"POST {self.view.path}api/news HTTP/1.1\r\nHost: 127.0.0.1:{self.view.port}\r\n"
                f"Content-Type: application/json\r\nContent-Length: {len(body)}\r\n\r\n").encode()
        polls = []
        try:
            for _ in range(129):
                polls.append(socket.create_connection(("127.0.0.1", self.view.port), timeout=10))
                polls[-1].sendall(head + body)
            ready, _, _ = select.select(polls, [], [], 10)
            self.assertTrue(ready)
            self.assertIn(b'"news":[]', ready[0].makefile("rb").read())
        finally:
            for poll in polls:
                poll.close()

    def test_head_has_no_body(self):
        connection = socket.create_connection(("127.0.0.1", self.view.port), timeout=30)
        connection.sendall(f"HEAD {self.view.path} HTTP/1.1\r\nHost: 127.0.0.1:{self.view.port}\r\n\r\n".encode())
        answer = connection.makefile("rb").read()
        connection.close()
        self.assertRegex(answer, rb"^HTTP/1\.1 200 OK\r\n")
        self.assertRegex(answer, rb"Content-Length: [1-9]")
        self.assertTrue(answer.endswith(b"\r\n\r\n"))

    def test_without_descriptors_it_neither_spins_nor_ends(self):
        limited = View(LIFT, before=lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (40, 40)))
        limited.verified()
        held = [socket.create_connection(("127.0.0.1", limited.port), timeout=30) for _ in range(60)]
        deadline = time.monotonic() + 30
        while len(os.listdir(f"/proc/{limited.process.pid}/fd")) < 40:
            self.assertLess(time.monotonic(), deadline, "some descriptors are still free")
            time.sleep(0.01)
        before = cpu_seconds(limited.process.pid)
        time.sleep(2)
        self.assertLess(cpu_seconds(limited.process.pid) - before, 0.2)
        for connection in held:
            connection.close()
        self.assertEqual(limited.ask(limited.path)[0], 200)
        self.assertEqual(limited.end()[0], 0)

    def test_whoever_leaves_without_a_request_gives_the_descriptor_back(self):
        self.until_it_has(connections=0)  # those that setUp has used
        held = [socket.create_connection(("127.0.0.1", self.view.port), timeout=30) for _ in range(20)]
        self.until_it_has(connections=20)
        held[0].sendall(b"GET / HTTP/1.1\r\nContent-Length: 9\r\n\r\nhal")
        for connection in held:
            connection.close()
        self.until_it_has(connections=0)

    def until_it_has(self, connections):
        """The server closes an idle connection after ten seconds, which is too late."""
        deadline = time.monotonic() + 8
        while (has := len(sockets(self.view.process.pid)) - 1) != connections:  # one listens
            self.assertLess(time.monotonic(), deadline, f"{has} connections, not {connections}")
            time.sleep(0.01)


def sockets(process):
    """The descriptors of a process that are sockets."""
    found = []
    for descriptor in pathlib.Path(f"/proc/{process}/fd").iterdir():
        try:
            found += [descriptor] if os.readlink(descriptor).startswith("socket:") else []
        except FileNotFoundError:
            pass  # closed meanwhile
    return found


def cpu_seconds(process):
    """Processor time of a process."""
    fields = pathlib.Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


class Files(unittest.TestCase):
    def test_what_cannot_be_shown_is_refused(self):
        with tempfile.TemporaryDirectory() as directory:
            for name, text in (("a.json", "{"), ("b.json", "[]"), ("c.json", '{"properties": [3]}'), ("d.json", '{"properties": [{"trace": {}}]}')):
                path = pathlib.Path(directory, name)
                path.write_text(text)
                done = subprocess.run([PROGRAM, "view", "--no-open", str(path)], capture_output=True, text=True)
                self.assertEqual((done.returncode, done.stdout), (2, ""), name)
                self.assertRegex(done.stderr, "^error: .*json")
        done = subprocess.run([PROGRAM, "view", "--no-open", "nowhere.proskill"], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (2, "error: cannot read `nowhere.proskill`: no such file or directory\n"))

    def test_saved_traces_and_reports_are_shown(self):
        with tempfile.TemporaryDirectory() as directory:
            saved = subprocess.run([PROGRAM, "verify", "--format", "json", "--save-traces", directory, str(LIFT)],
                                   capture_output=True, text=True)
            report = pathlib.Path(directory, "report.json")
            report.write_text(saved.stdout)
            for path, properties in ((pathlib.Path(directory, "doors_closed_when_moving.json"), 1),
                                     (report, len(json.loads(saved.stdout)["properties"]))):
                view = View(path)
                program = view.verified()
                self.assertEqual(len(program["properties"]), properties)
                trace = view.call("trace", name="doors_closed_when_moving")["result"]
                place = trace["steps"][0]["location"]["file"]
                self.assertEqual(view.call("source", uri=place)["result"]["text"], pathlib.Path(place).read_text())
                self.assertIn("error", view.call("source", uri="/etc/passwd"))
                self.assertEqual(view.end()[0], 0)

    def test_a_large_program_builds_traces_when_somebody_wants_to_see_them(self):
        count = 30
        skills = "".join(f"(defsv d{i} :states (A B) :init A)"
                         f"(defskill s{i} :start (d{i} B) :action (a) :success ok (:effects (d{i} A))"
                         f" :failure ko (:effects (d{i} A)))\n" for i in range(count))
        calls = "".join(f"(s{i})" for i in range(count))
        with tempfile.TemporaryDirectory() as directory:
            path = pathlib.Path(directory, "chain.proskill")
            path.write_text(f"{skills}(defskill mission :body ({calls}))\n")
            view = View(path)
            found = [it for it in view.verified()["properties"] if it["steps"] is not None]
            self.assertGreater(sum(it["steps"] for it in found), 4000)  # twice as many as are kept
            for it in (found[0], max(found, key=lambda it: it["steps"]), found[-1]):
                trace = view.call("trace", name=it["name"])["result"]
                self.assertEqual((trace["name"], trace["verdict"], len(trace["steps"])), (it["name"], it["verdict"], it["steps"]))
            self.assertIn("error", view.call("trace", name="program.no_deadlock"))
            self.assertEqual(view.end()[0], 0)

    def test_a_program_that_changes_is_verified_anew(self):
        with tempfile.TemporaryDirectory() as directory:
            path = pathlib.Path(directory, "p.proskill")
            good = "(defsv a :states (X Y) :init X)\n(defproperty stays (always (a X)))\n"
            path.write_text(good)
            view = View(path)
            self.assertTrue(view.verified()["properties"])

            def wait(state, holds):
                after = 0
                while True:
                    news = view.call("news", after=after)["result"]
                    after = news["next"]
                    for it in news["news"]:
                        program = it["params"]
                        if it["method"] == "program" and program["state"] == state and holds(program):
                            return program

            path.write_text(good + "(defskill")
            broken = wait("errors", lambda program: True)
            self.assertTrue(broken["stale"])
            self.assertTrue(broken["properties"], "the last verdicts stay")
            self.assertTrue(view.call("picture", kind="sv", name="a")["result"]["errors"])
            path.write_text(good + "(defevent moves :effects (a Y))\n")
            verdict = lambda program: {it["name"]: it["verdict"] for it in program["properties"]}["stays"]
            program = wait("done", lambda program: verdict(program) == "violated")
            self.assertFalse(program["stale"])
            self.assertEqual(view.end()[0], 0)


unittest.main()
