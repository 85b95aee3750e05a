"""Missions whose actions are a goal, a service and a topic, and whose battery is a topic's value."""

from runs import until

MISSION = """
(defsv battery :states (Unknown Good Critical Silent) :init Unknown)
(defevent battery_good :effects (battery Good))
(defevent battery_critical :effects (battery Critical))
(defevent battery_silent :effects (battery Silent))
(defskill fly :input ($how int) :action (fly $how) :interrupt () :success (there odd) :failure (lost refused))
(defskill arm :input ($on bool) :action (arm $on) :success armed :failure rejected)
(defskill say :input ($text string) :action (say $text))
(defskill mission :success done :failure failed :body (BODY (success done)))
MONITOR
"""
FLY = "(fly how {})"
OTHERS = '(arm on true) (say text "hello")'
STOP_AFTER = '(defskill watch :monitor t :body ((^ (battery Critical)) (fly.interrupt)))'


class Missions:
    """What a test does with such a mission. The classes have `platform`, and are `Runs`."""

    def mission(self, body, monitor="", **changes):
        if "(arm" not in body:
            body = f"(if (battery Silent) {OTHERS}) {body}"  # all skills are called somewhere
        if "(fly" not in body:
            body = f"(if (battery Silent) (fly how 0)) {body}"
        self.write(MISSION.replace("BODY", body).replace("MONITOR", monitor), {**self.platform, **changes})

    def fly(self, kind, monitor=""):
        self.mission(FLY.format(kind), monitor)
        self.begin()

    def tell(self, *lines):
        """To the server: levels of the battery, and commands."""
        for line in lines:
            self.server.stdin.write(f"{line}\n")
            self.server.stdin.flush()

    def stop_when(self, line):
        """Has the skill interrupted when the server has seen this."""
        self.sees(line)
        self.tell(0.1)

    def ends(self, *texts, code=0):
        self.assertEqual(self.finish(), code, f"{self.errors}\n{self.said}\n{self.log()}")
        for text in texts:
            self.assertTrue([said for said in self.said if text in said], f"{text}: {self.said}")

    def sees(self, line):
        """The server may hear of the last messages after the run has ended."""
        until(lambda: line in self.log(), line)

    def no_faults(self):
        self.assertFalse([text for text in self.said if "fault" in text])

    def fails(self, *parts):
        """Before the run."""
        self.assertEqual(self.run_it(), 2, self.said if self.lines else self.errors)
        for part in parts:
            self.assertIn(part, self.errors)
