"""A model as Spin explores it."""
import re

from verdicts import Refused, plain, run

MODEL = "model.pml"
MOST_TEXT = 250_000
# Most of the time is that of the compiler, so it does not optimise.
COMPILER = ["cc", "-O0", "-w", "-DSAFETY", "-DNOREDUCE", "-DVECTORSZ=16384", "-DMEMLIM=1000"]


class Spin:
    """The text that `proskill emit promela` makes of a model, and what Spin says about it."""

    def __init__(self, program, model, where):
        done = run([program, "emit", "promela", "-o", MODEL, model], where)
        if done.returncode != 0:
            raise Refused(done.stderr.strip())
        self.where = where
        self.text = (where / MODEL).read_text(encoding="utf-8")
        if len(self.text) > MOST_TEXT:
            raise Refused("error: a text with which spin -a needs minutes")
        self.asked = {name: plain(question) for name, question in re.findall(r"^hidden byte (\w+) = true; /\* (.*) \*/$", self.text, re.M)}
        self.is_timed = "/* time passes */" in self.text
        self.is_exact = "with open bounds" not in self.text
        self.is_finished = True

    def explore(self, options, flags):
        """What `pan` prints within a minute and a gigabyte."""
        for old in self.where.glob("pan*"):
            old.unlink()
        # -o1 and -o2: otherwise Spin does not distinguish states by variables that nobody reads
        made = run(["spin", "-a", "-o1", "-o2", *options, MODEL], self.where)
        if made.returncode != 0 or not (self.where / "pan.c").exists():
            raise RuntimeError(f"spin -a: {made.stdout}{made.stderr}")
        made = run([*COMPILER, "-o", "pan", "pan.c"], self.where)
        if made.returncode != 0:
            raise RuntimeError(f"cc: {made.stderr[:2000]}")
        said = run(["./pan", "-m2000000", "-w18", "-Q1", *flags], self.where).stdout
        if "states, stored" not in said:
            raise RuntimeError(f"pan: {said[:2000]}")
        if re.search(r"search depth too small|out of memory|Search not completed|Time-limit", said):
            self.is_finished = False
        return said

    def counts(self):
        """States and transitions; None if it did not finish. Spin counts the initial state as a transition, too."""
        said = self.explore(["-DCOUNTS"], ["-E"])
        if not self.is_finished:
            return None
        return int(re.search(r"(\d+) states, stored", said)[1]), int(re.search(r"(\d+) transitions \(=", said)[1]) - 1

    def found(self):
        """By property: whether what it asks for was found."""
        said = self.explore([], ["-E", "-c0", "-e"])
        violated = set(re.findall(r"assertion violated (\w+)", said))
        unknown = violated - set(self.asked) - {"no_error"}
        if unknown:
            raise RuntimeError(f"Spin names assertions that are not there: {unknown}")
        return {question: name in violated for name, question in self.asked.items()}
