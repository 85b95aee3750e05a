"""The schemas in docs/ agree with `proskill run`: those of its messages, and of platform files.

usage: protocol.py PROGRAM
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

try:
    from jsonschema import Draft202012Validator as Validator
except ImportError:
    print("skipped: no python3-jsonschema")
    sys.exit(77)

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = sys.argv[1]

# Writes all messages in both directions to files.
ROBOT = r'''
import json, sys
heard, said = open("heard", "wb"), open("said", "wb")
def say(**message):
    line = json.dumps(message).encode() + b"\n"
    said.write(line); said.flush()
    sys.stdout.buffer.write(line); sys.stdout.buffer.flush()
for line in sys.stdin.buffer:
    heard.write(line); heard.flush()
    message = json.loads(line)
    if message["type"] == "hello":
        say(type="ready", protocol=1)
        say(type="log", text="ready")
        say(type="event", name="storm")
    elif message["type"] == "start" and message["run"] == 1:
        say(type="failed", run=1, text="no wings")
    elif message["type"] == "start" and message["run"] == 2:
        say(type="result", run=2, result="there")
    elif message["type"] == "start":
        say(type="interrupt", skill="fly")
    elif message["type"] == "stop":
        say(type="stopped", run=message["run"])
'''
MISSION = """
(defsv sky :states (Clear Stormy) :init Clear :transitions :all)
(defevent storm :effects (sky Stormy))
(defskill fly :input ($height float $where string $fast bool $seen sky)
  :action (fly $height $where $fast $seen 3) :interrupt () :success there)
(defskill mission :success done :body (
  (^ (sky Stormy)) (fly height -1.50 where "a\\n\\"b\\"" fast false seen Stormy)
  (fly height 2 where "" fast true seen Clear) (fly height 2 where "" fast true seen Clear) (success done)))
"""

GOOD = ['{"kind":"process","command":["sh","run.sh"]}',
        '{"kind":"process","command":["sh","run.sh"],"startup":20,"restarts":2,"restart_delay":0,"$schema":"x"}']
BAD = ['{"kind":"process"}', '{"kind":"process","command":[]}', '{"kind":"process","command":"sh run.sh"}',
       '{"kind":"process","command":["sh","run.sh"],"startup":0}', '{"kind":"process","command":["sh",3]}',
       '{"kind":"process","command":["sh","run.sh"],"restarts":-1}',
       '{"kind":"process","command":["sh","run.sh"],"restarts":1.5}',
       '{"kind":"process","command":["sh","run.sh"],"restart_delay":-1}',
       '{"kind":"process","command":["sh","run.sh"],"comand":1}', '{"kind":1}', '{"kind":"magic"}', "[]",
       '{"kind":"library"}', '{"kind":"library","library":""}', '{"kind":"library","library":1}',
       '{"kind":"library","library":"robot.so","functions":{"fly":1}}',
       '{"kind":"library","library":"robot.so","functions":{"fly":""}}',
       '{"kind":"library","library":"robot.so","functions":[]}',
       '{"kind":"library","library":"robot.so","restarts":-1}',
       '{"kind":"library","library":"robot.so","command":["sh"]}',
       '{"command":["sh","run.sh"]}', '{"actions":{"fly":{"duration":[1]}}}',
       '{"actions":{"fly":{"results":{"there":-1}}}}', '{"events":{"storm":3}}']
SIMULATED = ["{}", '{"kind":"simulated"}',
             '{"actions":{"fly":{"duration":[1,2],"stops":[0,0.5],"results":{"there":3}}},'
             '"events":{"storm":[1,2]},"interrupts":{"fly":null}}']


def schema(name):
    read = json.loads((ROOT / "docs" / name).read_text(encoding="utf-8"))
    Validator.check_schema(read)
    return Validator(read)


class InDirectory(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.addCleanup(self.directory.cleanup)
        self.path = pathlib.Path(self.directory.name)
        (self.path / "mission.proskill").write_text(MISSION, encoding="utf-8")
        (self.path / "robot.py").write_text(ROBOT, encoding="utf-8")
        (self.path / "run.sh").write_text(f"exec {sys.executable} robot.py\n", encoding="utf-8")

    def run_on(self, platform):
        (self.path / "platform.json").write_text(platform, encoding="utf-8")
        return subprocess.run([PROGRAM, "run", "--until", "60", "--platform", self.path / "platform.json",
                               self.path / "mission.proskill"], capture_output=True, text=True)

    def messages(self, name):
        return [json.loads(line) for line in (self.path / name).read_text(encoding="utf-8").splitlines()]


class Messages(InDirectory):
    def test_every_message_is_as_the_schema_says(self):
        done = self.run_on(GOOD[0])
        self.assertIn("mission: success", done.stdout)
        heard, said = self.messages("heard"), self.messages("said")
        self.assertEqual([m["type"] for m in heard],
                         ["hello", "start", "start", "start", "stop", "end"])
        self.assertEqual([m["type"] for m in said],
                         ["ready", "log", "event", "failed", "result", "interrupt", "stopped"])
        one = schema("platform-protocol.schema.json")
        for side, messages in (("fromExecutor", heard), ("fromPlatform", said)):
            validator = one.evolve(schema={**one.schema, "oneOf": [{"$ref": f"#/$defs/{side}"}]})
            for message in messages:
                validator.validate(message)
                for member in set(message) - {"command"} - ({"run"} if message["type"] == "failed" else set()):
                    less = {key: value for key, value in message.items() if key != member}
                    self.assertFalse(validator.is_valid(less), f"{message} without {member}")
        self.assertEqual(heard[1]["arguments"], [-1.5, 'a\n"b"', False, "Stormy", 3])
        self.assertEqual(heard[2]["arguments"], [2, "", True, "Clear", 3])


class Files(InDirectory):
    def test_the_schema_takes_what_the_program_takes(self):
        validator = schema("platform.schema.json")
        for text in GOOD + SIMULATED + BAD:
            with self.subTest(text):
                takes = self.run_on(text).returncode != 2
                self.assertEqual(takes, text not in BAD)
                self.assertEqual(validator.is_valid(json.loads(text)), takes)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
