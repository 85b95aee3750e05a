"""The order of a plan, and the composite skill that is written for it.

usage: order.py PROGRAM
"""

import pathlib
import random
import subprocess
import sys
import tempfile
import unittest
import unittest.mock
from fractions import Fraction

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = sys.argv[1]
SURVEY = ROOT / "docs/bridges/survey.proskill"
LID = """(defsv lid :states (Shut Open) :init Shut)
(defsv cup :states (Empty Full) :init Empty)
(defskill hold_lid :start (lid Open) :time_interval [5,6] :action (h) :success done (:effects (lid Shut)))
(defskill fill :precondition (open (lid Open)) :time_interval [0.1,2] :action (f)
  :success done (:effects (cup Full)) :failure spilt)
"""
sys.path.insert(0, str(ROOT / "python"))

from proskill.planning import loop, planner  # noqa: E402
from proskill.planning.order import Parallel, Sequence, Step, block_of, order_of, useful_steps  # noqa: E402
from proskill.planning.pddl import Action, Domain, Impossible, Refused, Undecided  # noqa: E402
from proskill.planning.planner import Planned  # noqa: E402
from proskill.planning.reach import can_reach  # noqa: E402
from proskill.planning.skill import in_words, skill_of  # noqa: E402


def emitted(*words, file=SURVEY):
    command = [PROGRAM, "emit", "pddl", *words, str(file)]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def domain_of(text, *words):
    """The domain of a program in a file of its own."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "p.proskill"
        path.write_text(text, encoding="utf-8")
        return Domain(emitted(*words, file=path))


def planned(*actions):
    return [Planned(name, Fraction(start), Fraction(end)) for name, start, end in actions]


def steps_in(block):
    if isinstance(block, Step):
        return [block.number]
    return [number for part in block.parts for number in steps_in(part)]


def follows(block, one, other):
    """Whether a block executes `one` before `other`."""
    if isinstance(block, Step):
        return False
    inside = [(one in steps_in(part), other in steps_in(part)) for part in block.parts]
    if (True, True) in inside:
        return follows(block.parts[inside.index((True, True))], one, other)
    return isinstance(block, Sequence) and inside.index((True, False)) < inside.index((False, True))


class Domains(unittest.TestCase):
    def setUp(self):
        self.domain = Domain(emitted())

    def test_actions_are_skills_and_events(self):
        self.assertEqual(set(self.domain.actions), {"take-off", "photograph", "land", "gps-fixed"})
        land = self.domain.actions["land"]
        self.assertEqual((land.skill, land.tag), ("land", "down"))
        self.assertIn("motion-is-free", land.reads())
        self.assertIn("flight-is-inair", land.writes())

    def test_values_of_inputs_are_those_of_the_call(self):
        domain = domain_of("""(defsv place :states (Dock Bed) :init Dock)
(defskill go :input ($to place $speed float) :action (go $to $speed) :success there (:effects (place $to)))
""")
        self.assertEqual(set(domain.actions), {"go-dock", "go-bed"})
        steps = planned(("go-bed", 0, 1), ("go-dock", 1, 2))
        block = block_of(steps, [domain.actions[each.action] for each in steps])
        self.assertEqual(in_words(block), "go Bed, go Dock")
        skill = skill_of(domain, "plan", block)
        self.assertIn(":input ($go_speed float $go2_speed float)", skill)
        self.assertIn("((go to Bed speed $go_speed)\n     (go to Dock speed $go2_speed)", skill)

    def test_conditions_are_those_of_the_program(self):
        term = ["and", ["flight-is-inair"], ["not", ["gps-is-lost"]]]
        self.assertEqual(self.domain.condition(term), "(and (flight InAir) (not (gps Lost)))")

    def test_a_constraint_forbids_two_skills_to_run_at_once(self):
        text = self.domain.with_constraints([("land", "photograph")])
        self.assertEqual(text.count("(over all (photograph-is-idle))"), 1)
        self.assertEqual(text.count("(over all (land-is-idle))"), 1)

    def test_all_outcomes_are_actions_if_wanted(self):
        actions = Domain(emitted("--outcomes", "all")).actions
        self.assertEqual(actions["photograph--blurred"].tag, "blurred")

    def test_an_environment_is_one_of_the_program_and_not_of_a_comment(self):
        self.assertFalse(domain_of("; no (defenvironment here\n" + LID).has_environment)
        self.assertTrue(domain_of(LID + "(defenvironment world :body ((^ 1)))").has_environment)

    def test_problem(self):
        problem = emitted("--goal", "(and (area Photographed) (flight OnGround))")
        self.assertIn("(:goal (and (area-is-photographed) (flight-is-onground)))", problem)
        self.assertIn("(gps-is-lost)", problem)


class Orders(unittest.TestCase):
    def setUp(self):
        self.domain = Domain(emitted())

    def block(self, *actions):
        plan = planned(*actions)
        return block_of(plan, [self.domain.actions[each.action] for each in plan])

    def test_times_do_not_matter(self):
        block = self.block(("gps-fixed", 0, 0), ("take-off", 1, 2), ("photograph", 3, 13), ("land", 14, 15))
        self.assertEqual(in_words(block), "gps_fixed, take_off, photograph, land")

    def test_what_overlaps_is_parallel(self):
        block = self.block(("gps-fixed", 0, 0), ("take-off", 1, 2), ("photograph", 3, 13), ("land", 10, 13))
        self.assertEqual(in_words(block), "gps_fixed, take_off, (photograph | land)")
        self.assertEqual(skill_of(self.domain, "mission", block), """\
(defskill mission
  :success reached
  :failure (land_failed photograph_failed take_off_failed)
  :body
    ((^ (gps Fixed))
     (case (take_off)
        ((success up))
        (else (failure take_off_failed)))
     (// ((case (photograph)
             ((success done))
             (else (failure photograph_failed))))
         ((case (land)
             ((success down))
             (else (failure land_failed)))))
     (success reached)))
""")

    def test_a_step_waits_for_the_start_of_one_beside_it(self):
        domain = domain_of(LID)
        plan = planned(("hold-lid", 0, 5), ("fill", 1, 2))
        block = block_of(plan, [domain.actions[each.action] for each in plan])
        self.assertEqual(in_words(block), "hold_lid | fill")
        self.assertIn("""\
    ((// ((hold_lid))
         ((^ (lid Open))
          (case (fill)
""", skill_of(domain, "mission", block))

    def test_a_planned_failure_is_an_arm_of_its_call(self):
        domain = domain_of(LID, "--outcomes", "all")
        block = block_of(planned(("fill--spilt", 0, 1)), [domain.actions["fill--spilt"]])
        self.assertIn("""\
    ((case (fill)
        ((failure spilt))
        (else (failure fill_failed)))
""", skill_of(domain, "mission", block))

    def test_any_plan_becomes_a_skill_that_is_read(self):
        """Random plans of all outcomes: their text is a program without errors."""
        domain = domain_of(LID, "--outcomes", "all")
        for seed in range(20):
            chance = random.Random(seed)
            names = chance.choices(list(domain.actions), k=chance.randint(1, 6))
            starts = [chance.randint(0, 9) for _ in names]
            plan = planned(*((name, start, start + chance.randint(1, 4)) for name, start in zip(names, starts)))
            skill = skill_of(domain, "mission", block_of(plan, [domain.actions[name] for name in names]))
            with tempfile.TemporaryDirectory() as folder:
                path = pathlib.Path(folder) / "p.proskill"
                path.write_text(LID + skill, encoding="utf-8")
                done = subprocess.run([PROGRAM, "check", str(path)], capture_output=True, text=True, check=False)
                self.assertNotIn("error", done.stdout + done.stderr, skill)
                self.assertNotIn("PS0435", done.stdout + done.stderr, skill)

    def test_every_order_is_kept(self):
        for seed in range(500):
            chance = random.Random(seed)
            plan, actions = [], []
            for number in range(chance.randint(1, 9)):
                start = chance.randint(0, 20)
                plan.append(Planned(f"a{number}", Fraction(start), Fraction(start + chance.randint(1, 6))))
                actions.append(Action(f"a{number}", skill=f"s{number}",
                                      start=[[f"x{chance.randint(0, 3)}"]], effects=[[f"x{chance.randint(0, 3)}"]]))
            block = block_of(plan, actions)
            self.assertEqual(sorted(steps_in(block)), list(range(len(plan))))
            for one, other in order_of(plan, actions):
                self.assertTrue(follows(block, one, other), (seed, one, other, in_words(block)))

    def test_independent_steps_are_parallel(self):
        actions = [Action(f"a{i}", skill=f"s{i}", start=[[f"x{i}"]], effects=[[f"y{i}"]]) for i in range(3)]
        block = block_of(planned(("a0", 0, 1), ("a1", 2, 3), ("a2", 4, 5)), actions)
        self.assertIsInstance(block, Parallel)


class Useful(unittest.TestCase):
    def test_steps_that_do_not_lead_to_the_goal_are_omitted(self):
        go = {place: Action(place, skill="go", effects=[[place], ["not", ["elsewhere"]]]) for place in "xyz"}
        grip = Action("grip", skill="grip", start=[["y"]], overall=[["arm"]], effects=[["held"]])
        lift = Action("lift", skill="lift", effects=[["arm"]])
        actions = [go["x"], lift, go["y"], grip, go["z"], go["x"]]
        plan = planned(*((each.name, i, i + 1) for i, each in enumerate(actions)))
        self.assertEqual(useful_steps(plan, actions, {"held"}, set()), [1, 2, 3])
        self.assertEqual(useful_steps(plan, actions, {"held", "x"}, set()), [1, 2, 3, 5])

    def test_steps_that_hold_the_same_resource_need_not_each_other(self):
        one, other = (Action(name, skill=name, start=[["one-is-idle"], [">=", ["left"], "1"]],
                             effects=[["not", ["one-is-idle"]], ["decrease", ["left"], "1"], [name]]) for name in "ab")
        plan = planned(("a", 0, 1), ("b", 2, 3))
        self.assertEqual(useful_steps(plan, [one, other], {"b"}, {"one-is-idle", "left"}), [1])

    def test_all_steps_that_count_are_needed(self):
        cut = Action("cut", skill="cut", effects=[["assign", ["depth"], ["+", ["depth"], "1"]]])
        take = Action("take", skill="take", start=[[">=", ["depth"], "2"]], effects=[["taken"]])
        plan = planned(("cut", 0, 1), ("cut", 2, 3), ("take", 4, 5), ("cut", 6, 7))
        self.assertEqual(useful_steps(plan, [cut, cut, take, cut], {"taken"}, set()), [0, 1, 2])

    def test_what_changes_beside_a_step_is_needed(self):
        start = Action("light", skill="light", effects=[["lit"]], start_effects=[["lit"]])
        photograph = Action("shoot", skill="shoot", start=[["lit"]], overall=[["lit"]], effects=[["shot"]])
        plan = planned(("light", 0, 10), ("shoot", 1, 5))
        self.assertEqual(useful_steps(plan, [start, photograph], {"shot"}, set()), [0, 1])


class Planners(unittest.TestCase):
    def test_a_panic_of_a_planner_is_its_reason(self):
        with tempfile.TemporaryDirectory() as folder:
            log = pathlib.Path(folder) / "log"
            log.write_text("Serving\nthread 'x' panicked at a.rs:3:9:\nOnly moments\nstack\n", encoding="utf-8")
            self.assertEqual(planner.panic_in(str(log)), "internal error: Only moments")
            log.write_text("Serving\n", encoding="utf-8")
            self.assertEqual(planner.panic_in(str(log)), "")

    def test_durations_are_whole_for_planners_and_the_plan_in_seconds(self):
        given = []

        def answer(_engine, domain, *_rest):
            given.append(domain)
            return planner.Answer("solved", planned(("fill", 1, 21)))

        with unittest.mock.patch.object(planner, "answer_of", answer):
            text = "(and (>= ?duration 0.100000) (<= ?duration 2)) (>= ?duration 5)"
            plan = planner.run_planner("aries", text, "", 1, 1).plan
        self.assertEqual(given, ["(and (>= ?duration 1) (<= ?duration 20)) (>= ?duration 50)"])
        self.assertEqual(plan, [Planned("fill", Fraction(1, 10), Fraction(21, 10))])

    def test_any_answer_is_read_or_refused(self):
        """Random cuts and changes of an answer: a plan, or words about why there is none."""
        whole = '{"status": "solved", "plan": [{"action": "fill", "start": "1/2", "end": "3/2"}], "words": ""}'
        self.assertEqual(planner.answer_in("noise\n" + whole, "").plan, planned(("fill", "1/2", "3/2")))
        for seed in range(2000):
            chance = random.Random(seed)
            text = list(whole)
            for _ in range(chance.randint(1, 4)):
                text[chance.randrange(len(text))] = chance.choice('{}[]",:0/x')
            answer = planner.answer_in("".join(text)[: chance.randint(0, 2 * len(text))], "last words")
            self.assertTrue(answer.status in ("solved", "unsolvable", "unknown"), text)
            self.assertTrue(answer.words or answer.status != "unknown" or "".join(text) == whole, text)


class Loops(unittest.TestCase):
    def test_an_event_with_every_comes_by_itself(self):
        """A plan may wait for it. Nothing else makes it come, and it comes when the plan does not need it, too."""
        text = SURVEY.read_text(encoding="utf-8") + "(defevent clouds :every [1,2] :effects (flight OnGround))\n"
        plans = [
            (planned(("gps-fixed", 0, 0), ("take-off", 1, 2), ("clouds", 3, 3)), "(and (gps Fixed) (flight OnGround))", ""),
            (planned(("gps-fixed", 0, 0), ("take-off", 1, 2), ("photograph", 2, 12), ("clouds", 12, 12)),
             "(and (area Photographed) (flight OnGround))", "not the work of two skills"),
        ]
        for steps, goal, refusal in plans:
            with self.subTest(goal), tempfile.TemporaryDirectory() as folder:
                path = pathlib.Path(folder) / "p.proskill"
                path.write_text(text, encoding="utf-8")
                answer = planner.Answer("solved", steps)
                said = []
                with unittest.mock.patch.object(loop, "run_planner", lambda *_: answer), \
                        unittest.mock.patch.object(loop, "can_reach", lambda *_: (None, "")), \
                        unittest.mock.patch.object(loop, "say", said.append):
                    asked = loop.Loop(loop.Settings(PROGRAM, str(path), goal, ["any"]))
                    if refusal:
                        self.assertRaisesRegex(Refused, refusal, asked.run)
                        self.assertIn("not verified: `photograph` can end", said[-1])
                    else:
                        self.assertIn("(^ (flight OnGround))", asked.run())
                        self.assertIn("verified: every run", said[-1])

    def test_a_goal_that_no_order_reaches(self):
        """The verifier says so before a planner is asked."""
        for goal, possible in (("(and (lid Open) (cup Full))", True), ("(and (lid Shut) (cup Empty))", True),
                               ("(and (lid Open) (cup Empty))", True)):
            self.assertEqual(reached(LID, goal), possible, goal)
        lost = LID.replace(":success done (:effects (cup Full))", ":success done")
        self.assertIs(reached(lost, "(cup Full)"), False)
        asked = []
        with tempfile.TemporaryDirectory() as folder, \
                unittest.mock.patch.object(loop, "run_planner", lambda *_: asked.append(1)):
            path = pathlib.Path(folder) / "p.proskill"
            path.write_text(lost, encoding="utf-8")
            self.assertRaisesRegex(Impossible, "no order", loop.Loop(settings(path, "(cup Full)")).run)
        self.assertEqual(asked, [])

    def test_a_variable_with_the_name_of_the_property(self):
        """Its own verdicts say nothing about the goal."""
        self.assertIs(reached("(defsv plan_goal :states (A B) :init A)\n" + LID, "(cup Full)"), True)

    def test_any_order_has_all_values_and_events(self):
        text = """(defsv place :states (Dock Bed Well) :init Dock)
(defsv light :states (Off On) :init Off)
(defsv bed :states (Dry Wet) :init Dry)
(defevent dusk :effects (light On))
(defskill go :input ($to place $what string) :precondition (away (/= place $to)) :action (go $to $what)
  :success there (:effects (place $to)))
(defskill pour :precondition (there (place Bed)) :interrupt (:effects (bed Dry)) :action (pour)
  :success done (:effects (bed Wet)) :failure dry (:effects (place Well)))
(defskill old_mission :body ((pour)))
"""
        for goal, possible in (("(and (bed Wet) (place Dock) (light On))", True), ("(and (bed Wet) (place Well))", True),
                               ("(and (light Off) (bed Wet))", True)):
            self.assertEqual(reached(text, goal), possible, goal)
        once = text.replace(":precondition (there (place Bed))", ":precondition (there (and (place Bed) (bed Wet)))")
        self.assertIs(reached(once, "(bed Wet)"), False)
        # In an environment of the program, only its events come.
        self.assertIs(reached(text + "(defenvironment day :body ((^ 1)))", "(light On)"), False)
        self.assertIs(reached(text + "(defenvironment day :body ((^ 1)))", "(place Well)"), True)

    def test_no_plan_is_no_proof(self):
        """What a planner does not find may exist: the limits are named."""
        answer = planner.Answer("unknown", [], "no plan within 1 s")
        with unittest.mock.patch.object(loop, "run_planner", lambda *_: answer):
            self.assertRaisesRegex(Undecided, "any: no plan within 1 s\n  verifier: there may be one",
                                   loop.Loop(settings(SURVEY, "(area Photographed)")).run)
            answer.status = "unsolvable"
            self.assertRaisesRegex(Undecided, "no plan reaches the goal, says any\n  verifier: there may be one",
                                   loop.Loop(settings(SURVEY, "(area Photographed)")).run)
            answer.status = "unknown"
            with unittest.mock.patch.object(loop, "can_reach", lambda *_: (None, "1 s passed")):
                self.assertRaisesRegex(Undecided, "verifier: undecided: 1 s passed",
                                       loop.Loop(settings(SURVEY, "(area Photographed)")).run)
            for status in ("unknown", "unsolvable"):  # the rest of the time may give a proof
                answer.status = status
                said = iter([(None, "5 s passed"), (False, "")])
                with unittest.mock.patch.object(loop, "can_reach", lambda *_, said=said: next(said)):
                    self.assertRaises(Impossible, loop.Loop(settings(SURVEY, "(area Photographed)")).run)
            said = iter([(True, "")])  # what is known is not asked again
            with unittest.mock.patch.object(loop, "can_reach", lambda *_: next(said)):
                self.assertRaises(Undecided, loop.Loop(settings(SURVEY, "(area Photographed)")).run)


def settings(path, goal):
    return loop.Settings(PROGRAM, str(path), goal, ["any"])


def reached(text, goal):
    """Whether any order of skills reaches a goal, by the verifier."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "p.proskill"
        path.write_text(text, encoding="utf-8")
        asked = settings(path, goal)
        possible, reason = can_reach(domain_of(text), asked, 60)
        assert possible is not None, reason
        return possible


unittest.main(argv=sys.argv[:1])
