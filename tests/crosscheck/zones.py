"""A reader's own exploration of timed automata in TChecker's format: zones as difference bound matrices, with inclusion.

It shares nothing with the verifier. It does not replace TChecker, since it knows only what `proskill emit tchecker` writes.
"""
import re
from collections import deque

INFINITE = 1 << 40
ZERO = 1  # a bound is 2 * value + (1 if it is included)


def plus(a, b):
    return INFINITE if INFINITE in (a, b) else a + b - ((a | b) & 1)


class Zone:
    """Values of clocks. Index 0 stands for the constant 0; `rows[i][j]` bounds x_i - x_j."""

    def __init__(self, rows):
        self.rows = rows

    @staticmethod
    def origin(size):
        return Zone([[ZERO] * size for _ in range(size)])

    def over(self, origins):
        """The zone of other clocks, each of which continues the one at an index here, or starts (0)."""
        origins = [0, *origins]
        return Zone([[self.rows[i][j] for j in origins] for i in origins])

    def copy(self):
        return Zone([row[:] for row in self.rows])

    def constrain(self, i, j, bound):
        """Intersects with x_i - x_j within the bound. \\return whether anything is left"""
        rows = self.rows
        if bound >= rows[i][j]:
            return True
        if plus(bound, rows[j][i]) < ZERO:
            return False
        rows[i][j] = bound
        size = range(len(rows))
        for k in size:
            head = plus(rows[k][i], bound)
            if head < INFINITE:
                for m in size:
                    through = plus(head, rows[j][m])
                    if through < rows[k][m]:
                        rows[k][m] = through
        return True

    def elapse(self):
        for row in self.rows[1:]:
            row[0] = INFINITE

    def close(self):
        size = range(len(self.rows))
        for k in size:
            for i in size:
                for j in size:
                    through = plus(self.rows[i][k], self.rows[k][j])
                    if through < self.rows[i][j]:
                        self.rows[i][j] = through

    def extrapolate(self, most):
        """Extra_M: forgets bounds beyond the constants. Behrmann et al., "Lower and upper bounds in zone-based abstractions", 2006."""
        changed = False
        for i, row in enumerate(self.rows):
            for j, bound in enumerate(row):
                if i != j and i > 0 and bound < INFINITE and bound >> 1 > most[i]:
                    row[j], changed = INFINITE, True
                elif i != j and bound < INFINITE and -(bound >> 1) > most[j]:
                    row[j], changed = -2 * most[j], True
        if changed:
            self.close()

    def includes(self, other):
        return all(mine >= their for rows in zip(self.rows, other.rows) for mine, their in zip(*rows))


def constraints(text):
    """`x0>=3 && x1<5` as (clock, whether it is an upper bound, bound) each."""
    made = []
    for each in text.split(" && ") if text else []:
        clock, relation, value = re.fullmatch(r"(\w+)(<=|<|>=|>)(\d+)", each).groups()
        upper = relation[0] == "<"
        made.append((clock, upper, 2 * (int(value) if upper else -int(value)) + (1 if relation.endswith("=") else 0)))
    return made


class Explorer:
    """Finds the locations that can be reached in time."""

    def __init__(self, automaton):
        self.initial = automaton.initial
        self.urgent = {name for name, attributes in automaton.locations.items() if "urgent" in attributes}
        self.invariants = {name: constraints(attributes.get("invariant", "")) for name, attributes in automaton.locations.items()}
        self.edges = {name: [] for name in automaton.locations}
        for source, target, attributes in automaton.edges:
            started = {each.removesuffix("=0") for each in attributes["do"].split("; ")} if "do" in attributes else set()
            self.edges[source].append((target, constraints(attributes.get("provided", "")), started))
        self.most = self.constants()
        self.index = {name: {clock: i + 1 for i, clock in enumerate(sorted(most))} for name, most in self.most.items()}

    def constants(self):
        """By location and clock: the greatest constant that it is compared with before it starts again. Clocks that are not compared are absent."""
        most = {name: {} for name in self.edges}
        before = {name: [] for name in self.edges}  # edges to it
        for name, here in most.items():
            for clock, _, bound in self.invariants[name] + [each for _, guard, _ in self.edges[name] for each in guard]:
                here[clock] = max(here.get(clock, 0), abs(bound >> 1))
            for target, _, started in self.edges[name]:
                before[target].append((name, started))
        waiting = deque(most)
        while waiting:
            name = waiting.popleft()
            for source, started in before[name]:
                more = {clock: value for clock, value in most[name].items() if clock not in started and value > most[source].get(clock, -1)}
                if more:
                    most[source].update(more)
                    waiting.append(source)
        return most

    def narrowed(self, name, zone, conditions):
        """Whether anything is left of the zone of a location within the conditions."""
        index = self.index[name]
        return all(zone.constrain(index[clock], 0, bound) if upper else zone.constrain(0, index[clock], bound)
                   for clock, upper, bound in conditions)

    def settle(self, name, zone):
        """The zone after time has passed in a location. \return None if nothing is left"""
        if not self.narrowed(name, zone, self.invariants[name]):
            return None
        if name not in self.urgent:
            zone.elapse()
            if not self.narrowed(name, zone, self.invariants[name]):
                return None
        zone.extrapolate([0, *(self.most[name][clock] for clock in self.index[name])])
        return zone

    def reached(self, limit):
        """The names of the locations. \return None if there are more successors than the limit"""
        stored = {}
        waiting = deque()

        def add(name, zone):
            zone = self.settle(name, zone)
            known = stored.setdefault(name, []) if zone else []
            if not zone or any(other.includes(zone) for other in known):
                return
            known[:] = [other for other in known if not zone.includes(other)] + [zone]
            waiting.append((name, zone))

        add(self.initial, Zone.origin(len(self.index[self.initial]) + 1))
        while waiting:
            name, zone = waiting.popleft()
            limit -= len(self.edges[name])
            if limit < 0:
                return None
            for target, guard, started in self.edges[name]:
                after = zone.copy() if guard else zone
                if self.narrowed(name, after, guard):
                    add(target, after.over(0 if clock in started else self.index[name][clock] for clock in self.index[target]))
        return set(stored)
