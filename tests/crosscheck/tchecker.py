"""The timed automata of `proskill emit tchecker`: reading them, and TChecker's answers where it is installed."""
import functools
import re
import shutil

from verdicts import Refused, plain, run

FILE = "model.tck"
EDGE = re.compile(r"edge:model:(\w+):(\w+):step(\{.*\})")


def installed():
    return shutil.which("tck-reach") is not None


class Automaton:
    """A text in TChecker's format, as far as the export uses it."""

    def __init__(self, text):
        self.labels = {label: plain(name) for label, name in re.findall(r"^#   (\w+): `(.*)`$", text, re.M)}
        self.clocks = []
        self.locations = {}  # by name: its attributes
        self.edges = []  # source, target, attributes
        self.initial = None
        for line in text.splitlines():
            edge = EDGE.fullmatch(line)  # nearly all lines are edges
            if edge:
                self.add_edge(line, *edge.groups())
            else:
                self.read(line)

    def add_edge(self, line, source, target, attributes):
        assert source in self.locations and target in self.locations, line
        self.edges.append((source, target, attributes_of(attributes)))

    def read(self, line):
        if not line or line.startswith("#"):
            return
        kind, rest = line.split(":", 1)
        if kind == "clock":
            size, name = rest.split(":")
            assert size == "1" and name not in self.clocks, line
            self.clocks.append(name)
        elif kind == "location":
            process, name, attributes = re.fullmatch(r"(\w+):(\w+)(\{.*\})", rest).groups()
            assert process == "model" and name not in self.locations, line
            self.locations[name] = attributes_of(attributes)
            if "initial" in self.locations[name]:
                assert self.initial is None, line
                self.initial = name
        else:
            assert line in ("system:model", "event:step", "process:model"), line


@functools.cache
def attributes_of(text):
    """`{initial: : invariant:x0<=3}` as a dictionary, which many edges share."""
    keys = re.split(r" : ", text[1:-1]) if text != "{}" else []
    return dict(each.split(":", 1) for each in keys)


def emitted(ours):
    done = run([ours.program, "emit", "tchecker", "-o", FILE, ours.model], ours.where)
    if done.returncode != 0:
        raise Refused(done.stderr.strip())
    return Automaton((ours.where / FILE).read_text(encoding="utf-8"))


def reaches(_, label, where):
    """Whether TChecker finds a location with the label."""
    said = run(["tck-reach", "-a", "covreach", "-l", label, FILE], where)
    found = re.search(r"^REACHABLE (true|false)", said.stdout, re.M)
    if not found:
        raise RuntimeError(f"tck-reach: {said.stdout}{said.stderr}")
    return found[1] == "true"
