"""Plans for ProSkill programs: a planner finds the order, the verifier judges it.

`proskill plan GOAL FILE` starts this package. It needs the PyPI package `unified-planning` and one of its planners.
"""
