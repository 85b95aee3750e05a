"""Recordings in MCAP: whole, cut off at any byte, and as the package `mcap` of PyPI reads them.

usage: mcap_files.py PROGRAM
"""

import importlib
import io
import json
import os
import pathlib
import random
import signal
import struct
import subprocess
import sys
import tempfile
import unittest

try:
    import jsonschema
except ImportError:
    print("skipped: python3-jsonschema is not installed (apt-get install python3-jsonschema)")
    sys.exit(77)

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = sys.argv[1]
DRONE = ROOT / "examples/drone/drone.proskill"
PYTHON = os.environ.get("PROSKILL_PYTHON", sys.executable)  # one that has pip, where planners are
UNTRIED = []  # the reason why the package was not used
MAGIC = b"\x89MCAP0\r\n"
FOOTER, SCHEMA, CHANNEL, MESSAGE, CHUNK, DATA_END = 2, 3, 4, 5, 6, 15
ENDLESS = "(defskill m :body ((while true (^ 1))))"


class Fields:
    """Reads what the specification says of a record, in its order."""

    def __init__(self, content):
        self.content = content

    def number(self, size):
        value, self.content = int.from_bytes(self.content[:size], "little"), self.content[size:]
        return value

    def text(self):
        size = self.number(4)
        value, self.content = self.content[:size], self.content[size:]
        return value.decode("utf-8")


def records(data, at=len(MAGIC)):
    """The whole records of a file or of a chunk, which may be cut off, and those in its chunks."""
    while at + 9 <= len(data) and data[at:] != MAGIC:
        opcode, size = struct.unpack_from("<BQ", data, at)
        content = data[at + 9:at + 9 + size]
        if opcode == CHUNK:
            yield from records(content, 40)
        elif len(content) < size:
            return
        yield opcode, Fields(content)
        at += 9 + size


def messages(data):
    """Topic, time and content of each message; channels come before their messages, and schemas before their channels."""
    schemas, channels, found = {}, {}, []
    for opcode, fields in records(data):
        if opcode == SCHEMA:
            number, _, encoding, text = fields.number(2), fields.text(), fields.text(), fields.text()
            assert encoding == "jsonschema"
            schemas[number] = jsonschema.Draft202012Validator(json.loads(text))
        if opcode == CHANNEL:
            number, schema, topic, encoding = fields.number(2), fields.number(2), fields.text(), fields.text()
            assert encoding == "json"
            channels[number] = (topic, schemas[schema])
        if opcode == MESSAGE:
            topic, schema = channels[fields.number(2)]
            assert fields.number(4) == len(found)
            logged, published = fields.number(8), fields.number(8)
            assert logged == published
            content = json.loads(fields.content)
            schema.validate(content)
            found.append((topic, logged, content))
    return found


class Files(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.addCleanup(self.directory.cleanup)
        self.path = pathlib.Path(self.directory.name)
        self.mcap = self.path / "run.mcap"

    def record(self, *options, name="run.mcap"):
        return subprocess.run([PROGRAM, "run", "--record", self.path / name, *options, DRONE], capture_output=True, text=True)

    def test_a_file_says_what_a_trace_says(self):
        for seed in range(5):
            self.record("--seed", str(seed))
            self.record("--seed", str(seed), name="run.json")
            data = self.mcap.read_bytes()
            self.assertTrue(data.startswith(MAGIC) and data.endswith(MAGIC))
            opcodes = [opcode for opcode, _ in records(data)]
            self.assertEqual((opcodes.count(DATA_END), opcodes[-1]), (1, FOOTER))
            trace = json.loads((self.path / "run.json").read_text())
            found = messages(data)
            self.assertEqual([content for topic, _, content in found if topic == "/steps"], trace["steps"])
            values = dict(trace["initial"])
            states = {f"{skill}.status": status for topic, _, content in found[:2] if topic == "/skills"
                      for skill, status in content.items()}
            states.update(found[0][2])
            self.assertEqual({key: str(value) for key, value in states.items()}, values)
            for topic, time, content in found[2:]:
                if topic == "/steps":
                    values.update({change["variable"]: change["after"] for change in content["changes"]})
                    self.assertAlmostEqual(content["date"]["seconds"], time / 1e9)
                else:
                    names = {f"{key}.status": value for key, value in content.items()} if topic == "/skills" else content
                    self.assertEqual({key: str(value) for key, value in names.items()},
                                     {key: value for key, value in values.items() if key in names})

    def package(self):
        """The readers of the package `mcap`; None where it cannot be installed."""
        packages = pathlib.Path(PROGRAM).resolve().parents[1] / "mcap"
        sys.path.append(str(packages))
        try:
            import mcap.reader
        except ImportError:
            done = subprocess.run([PYTHON, "-m", "pip", "install", "-q", "--target", packages, "mcap==1.6.0"],
                                  capture_output=True, text=True)
            if done.returncode:
                UNTRIED.append((done.stderr.strip().splitlines() or ["pip fails"])[-1])
                return None
            importlib.invalidate_caches()  # the directory did not exist when it was searched first
            import mcap.reader
        return mcap.reader

    def is_read_as_ours(self, reader):
        data = self.mcap.read_bytes()
        ours = messages(data)
        for make in (reader.make_reader, reader.NonSeekingReader):
            theirs = [(channel.topic, message.log_time, json.loads(message.data))
                      for _, channel, message in make(io.BytesIO(data)).iter_messages()]
            self.assertEqual(sorted(theirs, key=str), sorted(ours, key=str))
        return ours

    def test_the_package_reads_it(self):
        if not (reader := self.package()):
            return
        self.record()
        self.is_read_as_ours(reader)

    def test_the_package_uses_the_index_of_a_long_recording(self):
        if not (reader := self.package()):
            return
        self.long("--until", "10000")
        ours = self.is_read_as_ours(reader)
        with open(self.mcap, "rb") as file:
            indexed = reader.make_reader(file)
            summary = indexed.get_summary()
            self.assertEqual(summary.statistics.message_count, len(ours))
            self.assertGreater(len(summary.chunk_indexes), 3)
            begin, end = 3_600_000_000_000, 3_700_000_000_000
            found = [(channel.topic, message.log_time, json.loads(message.data))
                     for _, channel, message in indexed.iter_messages(topics=["/steps"], start_time=begin, end_time=end)]
            self.assertEqual(found, [each for each in ours if each[0] == "/steps" and begin <= each[1] < end])
            self.assertEqual(next(indexed.iter_metadata()).name, "proskill.trace")

    def test_the_package_reads_what_a_killed_run_leaves(self):
        if not (reader := self.package()):
            return
        (self.path / "endless.proskill").write_text(ENDLESS)
        # Whoever is killed within a write leaves a file without an end; our own reader reads that, the package does not.
        data = b""
        while not data.endswith(MAGIC):
            data = self.killed()
        self.assertGreater(len(self.is_read_as_ours(reader)), 5_000)

    def killed(self):
        """The file of a run that was killed after 5 MB."""
        self.mcap.unlink(missing_ok=True)
        process = subprocess.Popen([PROGRAM, "run", "--until", "900d", "--record", self.mcap, self.path / "endless.proskill"],
                                   stdout=subprocess.DEVNULL)
        while not self.mcap.exists() or self.mcap.stat().st_size < 5_000_000:
            self.assertIsNone(process.poll())
        process.send_signal(signal.SIGKILL)
        process.wait()
        return self.mcap.read_bytes()

    def long(self, *options):
        (self.path / "endless.proskill").write_text(ENDLESS)
        subprocess.run([PROGRAM, "run", "--record", self.mcap, *options, self.path / "endless.proskill"],
                       stdout=subprocess.DEVNULL, check=False)

    def test_a_file_cut_off_anywhere_has_what_came_before(self):
        self.record()
        data = self.mcap.read_bytes()
        ours = messages(data)
        for length in random.Random(1).sample(range(len(MAGIC), len(data)), 200):
            part = messages(data[:length])
            self.assertEqual(part, ours[:len(part)])
            # At most one message is lost: the truncated one.
            rest = sum(1 for opcode, _ in records(data[:length]) if opcode == MESSAGE)
            self.assertEqual(rest, len(part))

    def test_a_run_that_is_killed_leaves_a_whole_file(self):
        process = subprocess.Popen([PROGRAM, "run", "--clock", "10x", "--format", "json", "--record", self.mcap, DRONE],
                                   stdout=subprocess.PIPE, text=True)
        seen = [json.loads(process.stdout.readline()) for _ in range(12)]
        process.send_signal(signal.SIGKILL)
        process.wait()
        process.stdout.close()
        data = self.mcap.read_bytes()
        self.assertTrue(data.endswith(MAGIC))
        steps = [content for topic, _, content in messages(data) if topic == "/steps"]
        # The latest messages may not have been written.
        self.assertTrue(all(step["description"] == line["description"] for step, line in zip(steps, seen)))

    def test_a_full_disk_ends_the_file_and_not_the_run(self):
        done = subprocess.run(["sh", "-c", f"trap '' XFSZ; ulimit -f 16; exec '{PROGRAM}' run --record '{self.mcap}' '{DRONE}'"],
                              capture_output=True, text=True)
        self.assertIn("uav_mission", done.stdout.splitlines()[-2])
        self.assertIn("the recording ends here", done.stderr)
        data = self.mcap.read_bytes()
        self.assertTrue(data.endswith(MAGIC))
        self.assertGreater(len(messages(data)), 5)


if __name__ == "__main__":
    ended = unittest.main(argv=sys.argv[:1], exit=False)
    if not ended.result.wasSuccessful():
        sys.exit(1)
    if UNTRIED:
        print(f"skipped: pip cannot install the package mcap, and the other tests passed: {UNTRIED[0]}")
        sys.exit(77)
