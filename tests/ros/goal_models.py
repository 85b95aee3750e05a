"""The model of a goal is verified, and so are those of clients that have an error."""

import copy
import subprocess
import sys
import tempfile
import unittest

PROGRAM = sys.argv[1]


def only(model, name):
    """The model with one property."""
    head = model[:model.index("// No goal runs after")]
    begin = model.index(f"property {name} ")
    return head + model[begin:model.index("assert", begin)] + f"assert {name}\n"


class Model(unittest.TestCase):
    """The classes have `model`, its text; `client`, which prints a table; and `table`, that of the adapter."""

    def verify(self, text):
        """The marks of the first six: its properties, and that no error can occur. The exit code."""
        with tempfile.NamedTemporaryFile("w", suffix=".fcr") as file:
            file.write(text)
            file.flush()
            done = subprocess.run([PROGRAM, "verify", file.name], capture_output=True, text=True)
        return [line.strip()[0] for line in done.stdout.splitlines() if line.startswith("  ")][:6], done.returncode

    def has_its_table(self):
        self.assertIn(self.client(), self.model)

    def finds(self, changes, broken):
        """Clients that differ in some entries break a property."""
        table = copy.deepcopy(self.table)
        for (state, given), careless in changes.items():
            table[state][given] = careless
        marks, code = self.verify(only(self.model.replace(self.client(), self.client(table)), broken))
        self.assertEqual((marks[0], code), ("✗", 1))

    def finds_each(self, careless_clients):
        for state, given, careless, broken in careless_clients:
            with self.subTest(f"{state.value} {given.value} {broken}"):
                self.finds({(state, given): careless}, broken)
