"""The planning problem of a program in ANML, by the writer of unified-planning."""

from __future__ import annotations

import os
import re
import tempfile

from proskill.planning.planner import limited


def anml_of(domain: str, problem: str) -> str:
    """A domain and a problem in PDDL, as ANML. Its names have `_` where those of PDDL have `-`, which is a minus."""
    from unified_planning.io import ANMLWriter, PDDLReader

    with tempfile.TemporaryDirectory(prefix="proskill-plan-") as folder:
        paths = [os.path.join(folder, name) for name in ("domain.pddl", "problem.pddl")]
        for path, text in zip(paths, (limited(domain), problem)):
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
        written = str(ANMLWriter(PDDLReader().parse_problem(*paths)).get_problem())
    return re.sub(r"(?<=\w)-(?=\w)", "_", written)
