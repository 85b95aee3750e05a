#!/usr/bin/env python3
"""Prints a member of a family of models whose size grows with n, in Fiacre or for a peer.

    bench/families.py philosophers 14            # Fiacre
    bench/families.py philosophers 14 promela    # the same for Spin
    bench/families.py fischer 10
    bench/families.py csma 10
"""
import sys


def philosophers(n):
    """Each takes the fork at his left, then the one at his right, and puts them back in that order."""
    yield """process philosopher (&left: bool, &right: bool) is
states thinking, one, eating, putting

from thinking
    on not left;
    left := true;
    to one

from one
    on not right;
    right := true;
    to eating

from eating
    left := false;
    to putting

from putting
    right := false;
    to thinking

component dining is"""
    forks = [f"f{i}" for i in range(n)]
    yield "var " + ", ".join(f"{fork}: bool := false" for fork in forks)
    yield "par * in"
    yield "\n||  ".join(f"philosopher (&{forks[i]}, &{forks[(i + 1) % n]})" for i in range(n))
    yield "end\n\ndining\n"
    yield "property two is absent (dining/1/state eating) and (dining/2/state eating)\nassert two"


def philosophers_promela(n):
    yield f"bool fork[{n}];"
    yield f"active [{n}] proctype philosopher() {{"
    yield f"""thinking: atomic {{ !fork[_pid] -> fork[_pid] = true }}
one: atomic {{ !fork[(_pid + 1) % {n}] -> fork[(_pid + 1) % {n}] = true }}
eating: atomic {{ fork[_pid] = false }}
putting: atomic {{ fork[(_pid + 1) % {n}] = false; goto thinking }}
}}"""


def fischer(n):
    """Fischer's protocol: a process that looks later than any other writes has the lock alone."""
    yield f"""const WRITE: nat is 2
const LOOK: nat is 2

type id is 0..{n}

process contender (me: id, &lock: id) is
states idle, writing, looking, critical

from idle
    on lock = 0;
    to writing

from writing
    wait [0,WRITE];
    lock := me;
    to looking

from looking
    select
        wait ]LOOK,...[;
        on lock = me;
        to critical
    []  on lock = 0;
        to writing
    end

from critical
    lock := 0;
    to idle

component fischer is
var lock: id := 0
par * in"""
    yield "\n||  ".join(f"contender ({i}, &lock)" for i in range(1, n + 1))
    yield "end\n\nfischer\n\nproperty exclusive is absent (fischer/1/state critical) and (fischer/2/state critical)\nassert exclusive"


def csma(n):
    """CSMA/CD: a station that begins within a slot of another's beginning collides with it."""
    each = range(1, n + 1)
    yield """const SLOT: nat is 26
const FRAME: nat is 808

process station [begin_: sync, end_: sync, collide: sync, busy: sync] is
states silent, sending, sent
var backs_off: bool := false

from silent
    select
        on not backs_off;
        begin_;
        to sending
    []  on backs_off;
        wait [0,2 * SLOT[;
        backs_off := false;
        to silent
    []  on not backs_off;
        busy;
        backs_off := true;
        to silent
    []  collide;
        to silent
    end

from sending
    select
        wait [FRAME,FRAME];
        backs_off := false;
        to sent
    []  collide;
        backs_off := true;
        to silent
    end

from sent
    end_;
    to silent
"""
    ports = [f"{kind}{i}" for kind in ("begin", "end", "busy") for i in each]
    yield f"process bus [{', '.join(ports)}, collide: sync] is"
    yield "states quiet, young, carries, collided\n"
    begins = "\n[]  ".join(f"begin{i}; to young" for i in each)
    again = "\n[]  ".join(f"begin{i}; to collided" for i in each)
    taken = "\n[]  ".join([f"end{i}; to quiet" for i in each] + [f"busy{i}; loop" for i in each])
    yield f"from quiet\n    select\n    {begins}\n    end\n"
    yield f"from young\n    select\n    wait [SLOT,SLOT]; to carries\n[]  {again}\n    end\n"
    yield f"from carries\n    select\n    {taken}\n    end\n"
    yield "from collided\n    collide;\n    to quiet\n"
    yield "component ethernet is"
    ends = [f"end{i}" for i in each]
    yield f"port {', '.join(f'{kind}{i}' for kind in ('begin', 'busy') for i in each)}: sync,"
    yield f"     {', '.join(ends)}: sync in [0,0], collide: sync in [0,26["
    yield "par * in"
    for i in each:
        yield f"    station [begin{i}, end{i}, collide, busy{i}]\n||"
    yield f"    bus [{', '.join(ports)}, collide]\nend\n\nethernet\n"
    yield "property alone is absent (ethernet/1/state sent) and (ethernet/2/state sent)\nassert alone"


if __name__ == "__main__":
    family = sys.argv[1] + ("_promela" if sys.argv[3:] == ["promela"] else "")
    print("\n".join(globals()[family](int(sys.argv[2]))))
