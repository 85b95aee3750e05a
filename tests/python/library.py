"""Platforms of kind `library` under `proskill run`: libraries compiled here, and the effects of their failures.

usage: library.py PROGRAM
"""

import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest

import taken_names

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = sys.argv[1]
MISSION = """
(defsv hit :states (No Yes) :init No :transitions :all)
(defevent touched :effects (hit Yes))
(defskill fly :input ($how string $height float $count int $high bool $seen hit)
  :action (fly $how $height $count $high $seen) :interrupt () :success there :failure lost)
(defskill look :action (look) :interrupt () :success seen)
(defskill mission :success done :failure failed
  :body (BODY (if (= fly.status success) (success done)) (failure failed)))
"""
FLY = '(fly how "{}" height 2.5 count -3 high true seen Yes)'
ROBOT = r"""
#include <proskill/platform.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

PROSKILL_LIBRARY;

static pthread_t late;
static bool has_late;

static void *speak_without_end(void *unused) {
  (void)unused;
  for (int i = 0; i < 100000; ++i) proskill_report("touched");
  return NULL;
}

static void write_to(const char *name, const char *text) {
  FILE *file = fopen(name, "a");
  fputs(text, file);
  fclose(file);
}

static void on_stop(proskill_run run, void *data) {
  proskill_log((const char *)data);
  proskill_finish(run, PROSKILL_STOPPED);
}

PROSKILL_EXPORT const char *skill_fly(proskill_run run, const proskill_value *arguments, size_t count) {
  const char *how = arguments[0].string;
  printf("this is no message\n");
  fflush(stdout);
  if (strcmp(how, "arguments") == 0) {
    char text[200];
    snprintf(text, sizeof text, "%zu %g %d %d %s %s", count, arguments[1].number, (int)arguments[2].integer,
             (int)arguments[3].integer, arguments[4].string, proskill_skill(run));
    proskill_log(text);
  }
  if (strcmp(how, "crash") == 0) raise_signal();
  if (strcmp(how, "crash once") == 0) {
    if (access("crashed", F_OK) == 0) return "there";
    write_to("crashed", "once\n");
    abort();
  }
  if (strcmp(how, "wait") == 0) {
    proskill_interrupt("fly");
    if (proskill_wait(run, 1000)) return PROSKILL_STOPPED;
  }
  if (strcmp(how, "poll") == 0) {
    struct pollfd stop = {proskill_stop_descriptor(run), POLLIN, 0};
    proskill_interrupt("fly");
    poll(&stop, 1, -1);
    return proskill_stop_requested(run) ? PROSKILL_STOPPED : "there";
  }
  if (strcmp(how, "killed") == 0) {
    kill(getppid(), SIGKILL);
    proskill_wait(run, 1000);
    write_to("stopped", "in order\n");
    return PROSKILL_STOPPED;
  }
  if (strcmp(how, "hang") == 0) {
    proskill_interrupt("fly");
    for (;;) pause();
  }
  if (strcmp(how, "unknown") == 0) return "nowhere";
  if (strcmp(how, "stopped") == 0) return PROSKILL_STOPPED;
  if (strcmp(how, "fail") == 0) proskill_fail(run, "no wind");
  if (strcmp(how, "twice") == 0) proskill_finish(run, "there");
  if (strcmp(how, "late") == 0) {
    has_late = pthread_create(&late, NULL, speak_without_end, NULL) == 0;
  }
  return "there";
}

static void *finish_later(void *run) {
  proskill_wait((proskill_run)(uintptr_t)run, 0.01);
  proskill_finish((proskill_run)(uintptr_t)run, "seen");
  proskill_finish((proskill_run)(uintptr_t)run, "seen"); /* nobody listens to this */
  return NULL;
}

PROSKILL_EXPORT void begin_look(proskill_run run, const proskill_value *arguments, size_t count) {
  (void)arguments;
  if (count > 0) return;
#ifdef STOPS
  proskill_on_stop(run, on_stop, "the camera is closed");
  proskill_interrupt("look");
#else
  (void)on_stop;
  pthread_t thread;
  pthread_create(&thread, NULL, finish_later, (void *)(uintptr_t)run);
  pthread_detach(thread);
#endif
}

PROSKILL_EXPORT const char *proskill_open(void) { return getenv("WHY_NOT"); }
PROSKILL_EXPORT void proskill_close(void) {
  write_to("closed", "once\n");
  if (has_late) pthread_join(late, NULL);
}
""".replace("raise_signal()", "*(volatile int *)0 = 1")


class Library(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.addCleanup(self.directory.cleanup)
        self.path = pathlib.Path(self.directory.name)
        self.program(FLY.format("there"))
        self.platform()

    def program(self, body):
        (self.path / "mission.proskill").write_text(MISSION.replace("BODY", body), encoding="utf-8")

    def platform(self, **members):
        text = json.dumps({"kind": "library", "library": "robot.so", **members}, indent=1)
        (self.path / "platform.json").write_text(text, encoding="utf-8")

    def compile(self, source=ROBOT, *options, name="robot.c", compiler="cc", standard="-std=gnu11"):
        (self.path / name).write_text(source, encoding="utf-8")
        subprocess.run([compiler, standard, "-Wall", "-Wextra", "-Werror", "-shared", "-fPIC", "-pthread",
                        f"-I{ROOT / 'include'}", "-o", self.path / "robot.so", self.path / name, *options], check=True)

    def run_it(self, *options, **surroundings):
        done = subprocess.run([PROGRAM, "run", "--format", "json", "--platform", self.path / "platform.json",
                               "--record", self.path / "run.json", *options, self.path / "mission.proskill"],
                              capture_output=True, text=True, timeout=120, env={**os.environ, **surroundings})
        self.lines = [json.loads(line) for line in done.stdout.splitlines()]
        self.said = [line["description"] for line in self.lines if "description" in line]
        return done

    def fly(self, how, *options):
        self.program(FLY.format(how))
        self.compile()
        return self.run_it(*options)

    def ends(self, done, code, mission):
        self.assertEqual((done.returncode, self.lines[-1]["mission"]), (code, mission), f"{done.stderr}\n{self.said}")


class Actions(Library):
    def test_functions_block_or_end_later(self):
        self.program(FLY.format("arguments") + " (look)")
        self.compile()
        done = self.run_it()
        self.assertIn("note: 5 2.5 -3 1 Yes fly", self.said)
        self.assertIn("succeeds with `there`", self.said)
        self.assertIn("succeeds with `seen`", self.said)
        self.assertEqual(self.lines[-1]["mission"], "success")
        self.assertEqual((self.path / "closed").read_text(), "once\n")
        self.assertIn("this is no message", done.stderr)

    def test_what_is_interrupted_while_it_blocks_stops(self):
        for how in ("wait", "poll"):
            with self.subTest(how):
                self.ends(self.fly(how), 1, "failure")
                self.assertIn("is interrupted from outside", self.said)
                self.assertFalse([text for text in self.said if "fault" in text])

    def test_what_ends_later_is_called_when_it_is_to_stop(self):
        self.program(FLY.format("there") + " (look)")
        self.compile(ROBOT.replace("static void *finish_later", "__attribute__((unused)) static void *finish_later"), "-DSTOPS")
        self.ends(self.run_it(), 0, "success")
        self.assertIn("note: the camera is closed", self.said)
        self.assertIn("is interrupted from outside", self.said)

    def test_two_callers_share_a_function(self):
        self.platform(functions={"look": "skill_fly", "fly": "skill_fly"})
        self.program("(// (" + FLY.format("both") + ") ((look)))")
        self.compile(r"""
            #include <proskill/platform.h>
            #include <pthread.h>
            #include <string.h>
            PROSKILL_LIBRARY;
            static pthread_barrier_t both;
            PROSKILL_EXPORT const char *proskill_open(void) { pthread_barrier_init(&both, NULL, 2); return NULL; }
            PROSKILL_EXPORT const char *skill_fly(proskill_run run, const proskill_value *arguments, size_t count) {
              (void)arguments; (void)count;
              pthread_barrier_wait(&both);
              return strcmp(proskill_skill(run), "look") == 0 ? "seen" : "there";
            }""")
        self.ends(self.run_it(), 0, "success")

    def test_exceptions_of_cpp_end_an_action(self):
        self.compile(r"""
            #include <proskill/platform.hpp>
            #include <stdexcept>
            PROSKILL_LIBRARY;
            PROSKILL_EXPORT const char *skill_fly(proskill_run, const proskill_value *, size_t) {
              throw std::runtime_error("out of fuel");
            }
            PROSKILL_EXPORT const char *skill_look(proskill_run run, const proskill_value *, size_t) {
              return proskill::perform(run, [&]() -> const char * { proskill::Run(run).sleep(0); return "seen"; });
            }""", name="robot.cpp", compiler="c++", standard="-std=c++17")
        self.ends(self.run_it(), 1, "failure")
        self.assertIn("fault: its action failed: out of fuel", self.said)


    def test_the_drone_flies(self):
        shutil.copytree(ROOT / "examples/drone", self.path / "drone")
        folder = self.path / "drone/library"
        subprocess.run(["make", "-B", "-C", folder, f"CFLAGS=-Wall -Wextra -Werror -I{ROOT / 'include'}"],
                       check=True, stdout=subprocess.DEVNULL)
        done = subprocess.run([PROGRAM, "run", "--clock", "50x", "--platform", folder / "platform.json",
                               self.path / "drone/drone.proskill"], capture_output=True, text=True)
        self.assertIn("uav_mission: success", done.stdout, done.stderr)
        self.assertIn("camera_survey                   is interrupted", done.stdout)


class Faults(Library):
    def test_a_crash_ends_the_action_and_not_the_run(self):
        self.ends(self.fly("crash"), 1, "failure")
        self.assertIn("note: the action of `fly` crashes", self.said)
        self.assertTrue([text for text in self.said if "it was ended by signal 11" in text], self.said)
        recorded = json.loads((self.path / "run.json").read_text())["steps"]
        self.assertIn("note: the action of `fly` crashes", [step["description"] for step in recorded])

    def test_a_library_that_crashed_is_loaded_again(self):
        self.platform(restarts=1, restart_delay=0)
        self.program(FLY.format("crash once") + " " + FLY.format("crash once"))
        self.compile()
        self.ends(self.run_it(), 1, "success")
        self.assertTrue([text for text in self.said if "it was ended by signal 6" in text], self.said)

    def test_what_hangs_is_left_and_its_process_killed(self):
        done = self.fly("hang", "--clock", "100x")
        self.ends(done, 1, "failure")
        self.assertIn("fault: its action does not stop; its skill ends without it", self.said)

    def test_what_has_no_known_result_is_a_fault(self):
        for how, fault in (("unknown", "its action has no result `nowhere`"),
                           ("stopped", "its action has stopped without being asked to"),
                           ("fail", "its action failed: no wind")):
            with self.subTest(how):
                self.ends(self.fly(how), 1, "failure")
                self.assertIn("fault: " + fault, self.said)

    def test_a_second_end_of_a_run_is_nothing(self):
        self.ends(self.fly("twice"), 0, "success")

    def test_events_after_the_end_are_nothing(self):
        self.ends(self.fly("late"), 0, "success")

    def test_actions_stop_when_the_executor_is_killed(self):
        for pipe in ("stopped", "closed"):
            os.mkfifo(self.path / pipe)
        self.program(FLY.format("killed"))
        self.compile()
        process = subprocess.Popen([PROGRAM, "run", "--platform", self.path / "platform.json",
                                    self.path / "mission.proskill"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.assertEqual((self.path / "stopped").read_text(), "in order\n")  # blocks until somebody writes
        self.assertEqual((self.path / "closed").read_text(), "once\n")
        self.assertEqual(process.wait(), -signal.SIGKILL)


class Errors(Library):
    def fails(self, *parts, **surroundings):
        done = self.run_it(**surroundings)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        for part in parts:
            self.assertIn(part, done.stderr)

    def test_each_says_what_is_wrong_and_where(self):
        self.fails("platform.json:3:13: there is no file `robot.so`")
        (self.path / "robot.so").write_text("no library" * 100)
        self.fails("platform.json:3:13: `robot.so` cannot be loaded: ", "invalid ELF header")
        self.compile("int nothing;")
        self.fails("`robot.so` is not a platform: write `PROSKILL_LIBRARY;`")
        header = (ROOT / "include/proskill/platform.h").read_text()
        (self.path / "proskill").mkdir()
        (self.path / "proskill/platform.h").write_text(header.replace("PROSKILL_ABI 1", "PROSKILL_ABI 99"))
        self.compile(ROBOT.replace("<proskill/platform.h>", '"proskill/platform.h"'))
        self.fails("was compiled with version 99 of platform.h, and this proskill has version 1: compile it again")
        self.compile(ROBOT.replace("begin_look", "begin_looking"))
        self.fails("mission.proskill:6:11: error: `robot.so` has no function for `look`: neither `skill_look` nor `begin_look`")
        self.platform(functions={"look": "see"})
        self.fails("mission.proskill:6:11: error: `robot.so` has no function for `look`: no `see`")
        self.platform(functions={"lok": "see"})
        self.fails("there is no basic skill `lok`; did you mean `look`?")
        self.platform()
        self.compile(ROBOT + "int elsewhere(void); int call(void) { return elsewhere(); }")
        self.fails("undefined symbol: elsewhere")
        self.compile()
        self.fails("`robot.so` cannot begin: no battery", WHY_NOT="no battery")
        self.ends(self.run_it(), 0, "success")

    def test_what_does_not_begin_in_time_is_killed(self):
        self.platform(startup=0.2)
        self.compile(ROBOT.replace('return getenv("WHY_NOT");', "for (;;) pause();"))
        self.fails("the process of the library is not ready after 0.2 s")


class Stubs(Library):
    def stubs(self, language):
        done = subprocess.run([PROGRAM, "stubs", "--language", language, self.path / "mission.proskill", self.path],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)

    def make(self):
        return subprocess.run(["make", "-C", self.path, "CFLAGS=-Wall -Wextra -Werror -Wno-unused-parameter",
                               "CXXFLAGS=-Wall -Wextra -Werror -Wno-unused-parameter"], capture_output=True, text=True)

    def check(self, language, users, before, written):
        (self.path / "platform.json").unlink()
        self.program(FLY.format("there") + " (look)")
        self.stubs(language)
        self.assertEqual(self.make().returncode, 0)
        self.ends(self.run_it(), 1, "failure")
        self.assertIn("fault: its action failed: not written yet", self.said)
        robot = self.path / users
        text = robot.read_text()
        for old, new in zip(before, written):
            self.assertIn(old, text)
            text = text.replace(old, new, 1)
        robot.write_text(text)
        self.stubs(language)
        self.assertEqual(robot.read_text(), text)
        built = self.make()
        self.assertEqual(built.returncode, 0, built.stderr)
        self.ends(self.run_it(), 0, "success")
        self.assertIn("hit: No", str([line.get("changes") for line in self.lines]).replace("'variable': 'hit', 'before': 'No'", "hit: No"))
        # A changed program shows up as compiler errors.
        mission = self.path / "mission.proskill"
        mission.write_text(mission.read_text().replace(":success seen", ":success noticed"))
        self.stubs(language)
        built = self.make()
        self.assertNotEqual(built.returncode, 0)
        self.assertIn("Seen" if language == "cpp" else "LOOK_SEEN", built.stderr)

    def test_names_that_mean_something_in_c_or_in_the_generated_text(self):
        (self.path / "platform.json").unlink()
        (self.path / "mission.proskill").write_text(taken_names.MISSION, encoding="utf-8")
        for language in ("c", "cpp"):
            with self.subTest(language):
                self.stubs(language)
                built = self.make()
                self.assertEqual(built.returncode, 0, built.stderr)
                self.run_it()
                self.assertEqual(self.said.count("fault: its action failed: not written yet"), taken_names.ACTIONS)
                shutil.rmtree(self.path / "proskill")
                for each in ("platform.json", "Makefile", "librobot.so"):
                    (self.path / each).unlink()

    def test_in_c(self):
        self.check("c", "robot.c", ['proskill_fail(run, "not written yet");\n  return FLY_WAS_STOPPED;',
                                    'proskill_fail(run, "not written yet");\n  return LOOK_WAS_STOPPED;'],
                   ["report_event(EVENT_TOUCHED);\n  return seen == HIT_YES && count == -3 && height > 2 && high ? FLY_THERE : FLY_LOST;",
                    "return proskill_wait(run, 0) ? LOOK_WAS_STOPPED : LOOK_SEEN;"])

    def test_in_cpp(self):
        self.check("cpp", "robot.cpp", ['throw std::logic_error("not written yet");'] * 2,
                   ['report(Event::Touched);\n    return seen == Hit::Yes && how == "there" && count == -3 && height > 2 && high ? '
                    'FlyResult::There : FlyResult::Lost;', "run.sleep(0);\n    return LookResult::Seen;"])


if __name__ == "__main__":
    if not shutil.which("cc") or not shutil.which("c++") or not shutil.which("make"):
        print("skipped: no compiler (apt-get install g++ make)")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
