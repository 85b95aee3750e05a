"""What the verifier says about a model, as the cross-checks compare it."""
import json
import re
import subprocess


def run(command, where, limit=600):
    """The finished process; its output is text."""
    return subprocess.run([str(word) for word in command], cwd=where, capture_output=True, text=True, timeout=limit, check=False)


LIMITS = ["--time-limit", "20", "--memory-limit", "1000"]


class Refused(Exception):
    """A model that a tool does not take, with its reason."""


def plain(name):
    """A name of a property as it becomes an identifier."""
    return re.sub(r"_+", "_", re.sub(r"[^A-Za-z0-9]", "_", name))


class Ours:
    """The answers of `proskill verify` without reductions."""

    def __init__(self, program, model, where):
        self.program, self.model, self.where = program, model, where

    def found(self):
        """By property: whether what it asks for was found. Inconclusive ones are skipped."""
        done = run([self.program, "verify", "--format", "json", "--traces", "none", *LIMITS, self.model], self.where)
        if not done.stdout:
            raise Refused(done.stderr.strip() or f"it ended with {done.returncode}")
        answers = {}
        for each in json.loads(done.stdout)["properties"]:
            if each["verdict"] != "inconclusive":
                answers[plain(each["name"])] = each["verdict"] in ("violated", "reachable")
        return answers

    def counts(self):
        """States and transitions without regard to time; None if an error at run time or a limit ended the search."""
        done = run([self.program, "verify", "--graph", "counts", "--graph-of", "untimed", *LIMITS, self.model], self.where)
        sizes = re.search(r"^(\d+) classe\(s\), (\d+) marking\(s\), \d+ domain\(s\), (\d+) transition\(s\)", done.stdout, re.M)
        return (int(sizes[1]), int(sizes[3])) if sizes and done.returncode == 0 else None

    def markings(self):
        """Discrete states that are reachable in time; None if they cannot be counted within the limits."""
        done = run([self.program, "verify", "--graph", "counts", *LIMITS, self.model], self.where)
        sizes = re.search(r"(\d+) marking\(s\)", done.stdout)
        return int(sizes[1]) if sizes and done.returncode == 0 else None
