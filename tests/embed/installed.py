"""Programs in C and C++ that execute a ProSkill program: built outside of the tree against what `cmake --install` copies.

usage: installed.py BUILD_DIRECTORY
"""

import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest
import urllib.error
import urllib.request

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(sys.argv[1])
PROGRAM = ROOT / "docs/tour/dock.proskill"
EXAMPLE = ROOT / "examples/embedded"
STRICT = ["-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Werror"]
THROWS = r"""
#include <proskill/executor.hpp>
#include <iostream>

static void say(const std::string& what, const std::string& why) { std::cout << what << ": " << why << '\n'; }

template <class Call> void attempt(const std::string& what, Call call) {
  try {
    call();
    say(what, "done");
  } catch (const proskill::Error& error) {
    say(what, error.what());
  } catch (const std::exception& error) {
    say(what, std::string("thrown: ") + error.what());
  }
}

int main(int, char** words) {
  proskill::Program program(words[1]);
  auto options = proskill::defaultOptions();
  options.clock = PROSKILL_SIMULATED_TIME;
  proskill::Executor executor(program, options);
  attempt("a file", [] { proskill::Program("/nowhere"); });
  attempt("proceed", [&] { executor.proceed(); });
  attempt("event", [&] { executor.report("pushed_away"); });
  attempt("start", [&] { executor.start(); });
  attempt("perform", [&] { executor.perform("dive", [](proskill::Start, proskill::Arguments) {}); });
  executor.perform("charge", [](proskill::Start start, proskill::Arguments) { start.finish("full"); });
  executor.perform("drive_onto_dock", [](proskill::Start, proskill::Arguments arguments) {
    std::cout << arguments[1].string << '\n';
  });
  bool throws = true;
  executor.observe([&](const proskill_entry& entry) {
    if (entry.is_fault) say("fault", std::string(entry.subject) + ": " + entry.text);
    if (throws && entry.kind == PROSKILL_STARTED) {
      throws = false;
      throw std::runtime_error("no paper");
    }
  });
  attempt("run", [&] { executor.run(); });
  attempt("run", [&] { executor.run(); });
  attempt("run", [&] { executor.run(); });
  attempt("event", [&] { executor.report("pushed"); });
  std::cout << executor.outcome() << " " << executor.end() << '\n';
}
"""

MISSION = """
(defplatform "robot/robot.json")
(defskill look :action (look) :success seen)
(defskill drive :action (drive "dock") :success there)
(defskill mission :success done :body ((look) (drive) (success done)))
"""
ROBOT = r"""
#include <proskill/platform.h>
#include <string.h>

PROSKILL_LIBRARY;

PROSKILL_EXPORT const char *skill_drive(proskill_run run, const proskill_value *arguments, size_t count) {
  proskill_wait(run, 0.01);
  return count == 1 && !strcmp(arguments[0].string, "dock") ? "there" : "elsewhere";
}
"""
LOOKS = r"""
#include <proskill/executor.hpp>
#include <iostream>

int main(int, char** words) {
  try {
    const proskill::Program program(words[1]);
    proskill::Executor executor(program);
    executor.perform("look", [](proskill::Start start, proskill::Arguments) { start.finish("seen"); });
    executor.run();
    std::cout << executor.outcome() << " with " << executor.faults() << " faults\n";
  } catch (const proskill::Error& error) {
    std::cout << error.code() << ": " << error.what() << '\n';
  }
}
"""
RECORDS = r"""
#include <proskill/executor.hpp>
#include <iostream>

/* MISSION RECORDING [real] */
int main(int count, char** words) {
  const proskill::Program program(words[1]);
  auto options = proskill::defaultOptions();
  options.seed = 5;
  if (count == 3) options.clock = PROSKILL_SIMULATED_TIME;
  proskill::Executor executor(program, options);
  executor.record(words[2]);
  executor.observe([](const proskill_entry& entry) { std::cout << entry.subject << ' ' << entry.text << std::endl; });
  executor.run();
  std::cout << executor.outcome() << ':' << executor.recordingError() << '\n';
}
"""
SHOWS = r"""
#include <proskill/executor.hpp>
#include <iostream>

/* Waits for the event at the door, and then for its input to end. */
int main(int, char** words) {
  try {
    const proskill::Program program(words[1]);
    proskill::Executor executor(program);
    std::cout << executor.serveView() << std::endl;
    executor.run();
    std::cout << executor.outcome() << std::endl;
    std::cin.get();
  } catch (const proskill::Error& error) {
    std::cout << error.code() << ": " << error.what() << std::endl;
  }
}
"""
DOOR = """
(defsv door :states (Closed Open) :init Closed :transitions :all)
(defevent opens :effects (door Open))
(defskill mission :success done :body ((^ (door Open)) (success done)))
"""
FLIES = """
(defplatform "sky.json")
(defsv sky :states (Clear Stormy) :init Clear :transitions :all)
(defevent storm :effects (sky Stormy))
(defskill fly :action (fly) :time_interval [0,9] :success there :failure lost)
(defskill mission :success done :body (MANY (success done)))
"""


def run(*command, **options):
    return subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=120, **options)


def succeed(*command, **options):
    done = run(*command, **options)
    if done.returncode:
        raise AssertionError(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done.stdout


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        directory = tempfile.TemporaryDirectory()
        cls.addClassCleanup(directory.cleanup)
        cls.home = pathlib.Path(directory.name)
        cls.prefix = cls.home / "root"
        succeed("cmake", "--install", BUILD, "--prefix", cls.prefix)
        cls.library = next(cls.prefix.rglob("libproskill.so.1"))
        cls.built = cls.home / "built"
        succeed("cmake", "-S", EXAMPLE, "-B", cls.built, f"-DCMAKE_PREFIX_PATH={cls.prefix}",
                f"-DCMAKE_C_FLAGS={' '.join(STRICT)}", f"-DCMAKE_CXX_FLAGS={' '.join(STRICT)}")
        succeed("cmake", "--build", cls.built)

    def compile(self, compiler, standard, source):
        """The program that a compiler makes with what pkg-config says, and how to run it."""
        flags = succeed("pkg-config", "--cflags", "--libs", "proskill",
                        env={**os.environ, "PKG_CONFIG_PATH": str(self.library.parent / "pkgconfig")}).split()
        target = self.home / "program"
        succeed(compiler, standard, *STRICT, source, "-o", target, *flags)
        return target, {**os.environ, "LD_LIBRARY_PATH": str(self.library.parent)}

    def dock(self):
        """The program in C, whose output is read line by line."""
        process = subprocess.Popen([self.built / "dock_c", PROGRAM], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.stdin.close)
        return process

    def await_line(self, process, part):
        for line in process.stdout:
            if part in line:
                return
        self.fail(f"no line with {part}")

    def test_a_program_in_cpp_runs_in_simulated_time(self):
        out = succeed(self.built / "dock_cpp", PROGRAM)
        self.assertIn("the robot drives to the dock", out)
        self.assertIn("3 s  drive_onto_dock: succeeds with `docked`", out)
        self.assertIn("18 s  charge: succeeds with `full`", out)
        self.assertTrue(out.endswith("the mission ends with success; the robot is on the Dock\n"), out)

    def test_a_program_in_cpp_runs_in_real_time_with_a_thread(self):
        out = succeed(self.built / "dock_cpp", "--real", PROGRAM)
        self.assertTrue(out.endswith("the mission ends with success; the robot is on the Dock\n"), out)

    def test_a_program_in_c_has_an_event_loop(self):
        process = self.dock()
        self.await_line(process, "charge: (charge)")
        process.stdin.write("pushed_awy\npushed_away\n")
        self.await_line(process, "not reported: there is no event `pushed_awy`; did you mean `pushed_away`?")
        self.await_line(process, "charge: is asked to stop")
        self.await_line(process, "the mission ends with failure; the robot is on the Floor")
        self.assertEqual(process.wait(), 1)

    def test_a_program_in_c_ends_in_order_on_a_signal(self):
        process = self.dock()
        self.await_line(process, "charge: (charge)")
        process.send_signal(signal.SIGINT)
        self.await_line(process, "charge: is asked to stop")
        self.await_line(process, "the mission ends with no_status")
        self.assertEqual(process.wait(), 1)

    def test_a_file_that_is_not_there_and_a_program_with_errors(self):
        done = run(self.built / "dock_c", "/nowhere.proskill")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("cannot read `/nowhere.proskill`", done.stderr)
        wrong = self.home / "wrong.proskill"
        wrong.write_text("(defskill drive :success docked)\n(defevent e :effects (place Floor))\n")
        done = run(self.built / "dock_cpp", wrong)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn(f"{wrong}:2:23: error: unknown state variable `place`", done.stderr)

    def test_pkg_config_is_enough_for_c99(self):
        program, environment = self.compile("cc", "-std=gnu99", EXAMPLE / "dock.c")
        done = run(program, "/nowhere.proskill", env=environment)
        self.assertEqual(done.returncode, 2)
        self.assertIn("cannot read", done.stderr)

    def test_failures_are_exceptions_in_cpp11(self):
        source = self.home / "throws.cpp"
        source.write_text(THROWS)
        program, environment = self.compile("c++", "-std=c++11", source)
        done = run(program, PROGRAM, env=environment)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout.splitlines()[0], "a file: cannot read `/nowhere`: no such file or directory")
        self.assertEqual(done.stdout.splitlines()[1:], [
            "proceed: the run has not started",
            "event: the run has not started",
            "start: nobody performs the action of `drive_onto_dock`",
            "perform: there is no basic skill `dive`",
            "run: thrown: no paper",
            "fault: drive_onto_dock: its action failed: the action has fewer arguments",
            "fault: drive_onto_dock: took less time than its interval says",
            "fault: drive_onto_dock: its action ends without a known result",
            "fault: recharge: took less time than its interval says",
            "run: done",
            "run: the run has ended",
            "event: there is no event `pushed`",
            "failure 1"])

    def test_a_library_performs_what_no_function_performs(self):
        robot = self.home / "robot"
        robot.mkdir()
        mission = self.home / "mission.proskill"
        mission.write_text(MISSION)
        (robot / "robot.c").write_text(ROBOT)
        (robot / "robot.json").write_text('{"kind": "library",\n "library": "librobot.so"}')
        source = self.home / "looks.cpp"
        source.write_text(LOOKS)
        program, environment = self.compile("c++", "-std=c++11", source)
        self.assertEqual(succeed(program, mission, env=environment),
                         f"8: {robot}/robot.json:2:13: error: there is no file `librobot.so`\n")
        succeed("cc", "-shared", "-fPIC", f"-I{self.prefix}/include", robot / "robot.c", "-o", robot / "librobot.so")
        self.assertEqual(succeed(program, mission, env=environment), "success with 0 faults\n")
        # a library without its program
        alone = self.home / "alone"
        alone.mkdir()
        shutil.copy(self.library, alone)
        self.assertEqual(succeed(program, mission, env={"LD_LIBRARY_PATH": str(alone)}),
                         f"8: {robot}/robot.json:2:13: error: the program `proskill`, which loads libraries, is not found beside "
                         "libproskill.so or on the PATH\n")

    def recorder(self, flights):
        """A program that records, and a mission of so many flights."""
        (self.home / "sky.json").write_text('{"actions": {"fly": {"duration": [0.001, 0.003]}}, "events": {"storm": [0.001, 0.01]}}')
        mission = self.home / "flights.proskill"
        mission.write_text(FLIES.replace("MANY", flights))
        source = self.home / "records.cpp"
        source.write_text(RECORDS)
        return *self.compile("c++", "-std=c++11", source), mission

    def test_a_recording_is_that_of_the_program(self):
        program, environment, mission = self.recorder("(fly) " * 300)
        mine, its = self.home / "mine.mcap", self.home / "its.mcap"
        out = succeed(program, mission, mine, env=environment)
        self.assertTrue(out.endswith("success:\n"), out[-200:])
        succeed(self.prefix / "bin/proskill", "run", "--seed", 5, "--record", its, mission)
        self.assertEqual(mine.read_bytes(), its.read_bytes())

    def test_a_run_that_is_killed_leaves_a_recording(self):
        program, environment, mission = self.recorder("(while true (fly))")
        recording = self.home / "killed.mcap"
        process = subprocess.Popen([program, mission, recording, "real"], stdout=subprocess.PIPE, text=True, env=environment)
        self.addCleanup(process.stdout.close)
        for _, _ in zip(range(200), process.stdout):
            pass
        process.kill()
        process.wait()
        told = succeed(self.prefix / "bin/proskill", "conform", recording, mission)
        self.assertRegex(told, r"the run conforms to the model: \d\d+ steps")

    def ask(self, address, method, **params):
        request = urllib.request.Request(f"{address}api/{method}", json.dumps(params).encode(), {"Content-Type": "application/json"})
        with urllib.request.urlopen(request, timeout=60) as answer:
            return json.load(answer)["result"]

    def test_a_page_shows_and_controls_a_run(self):
        mission = self.home / "door.proskill"
        mission.write_text(DOOR)
        source = self.home / "shows.cpp"
        source.write_text(SHOWS)
        program, environment = self.compile("c++", "-std=c++11", source)
        process = subprocess.Popen([program, mission], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=environment)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.stdin.close)
        address = process.stdout.readline().strip()
        self.assertRegex(address, r"^http://127\.0\.0\.1:\d+/[0-9a-f]{32}/$")
        with urllib.request.urlopen(address, timeout=60) as page:
            self.assertIn(b"panel.js", page.read())
        self.assertIn("<svg", json.dumps(self.ask(address, "picture", kind="body", name="mission")))
        self.assertEqual([it["name"] for it in self.ask(address, "hello")["run"]["signals"]], ["opens"])
        self.ask(address, "control", do="send", signal="opens")
        self.assertEqual(process.stdout.readline(), "success\n")
        self.assertEqual(self.ask(address, "hello")["run"]["status"]["state"], "ended")
        process.stdin.close()
        self.assertEqual(process.wait(60), 0)
        with self.assertRaises(urllib.error.URLError):
            urllib.request.urlopen(address, timeout=60)
        # a library without the one that shows runs, and with one of another build
        alone = self.home / "without_view"
        alone.mkdir()
        shutil.copy(self.library, alone)
        environment = {"LD_LIBRARY_PATH": str(alone)}
        self.assertEqual(succeed(program, mission, env=environment),
                         "7: libproskill_view.so, which shows runs, is not beside libproskill.so\n")
        (alone / "libproskill_view.so").write_text("not a library")
        self.assertIn(f"7: cannot load {alone}/libproskill_view.so: ", succeed(program, mission, env=environment))

    def test_the_library_exports_what_the_header_declares(self):
        header = (self.prefix / "include/proskill/executor.h").read_text()
        declared = set(re.findall(r"^(?:[a-z]\w* |const char\* )(proskill_\w+)\(", header, re.M))
        symbols = {line.split()[-1].split("@")[0] for line in succeed("nm", "-D", "--defined-only", self.library).splitlines()}
        self.assertEqual(symbols - {"PROSKILL_1"}, declared)
        version = re.search(r"#define PROSKILL_EXECUTOR_ABI (\d+)", header)[1]
        self.assertIn(f"[libproskill.so.{version}]", succeed("readelf", "-d", self.library))

    def test_the_library_needs_little(self):
        needed = set(re.findall(r"NEEDED.*\[(lib[^.]+)", succeed("readelf", "-d", self.library)))
        self.assertEqual(needed - {"libc", "libm", "libgcc_s", "libstdc++"}, {"libtree-sitter", "libutf8proc", "libfmt"})


for program, package in [("cmake", "cmake"), ("cc", "gcc"), ("c++", "g++"), ("pkg-config", "pkg-config"), ("nm", "binutils")]:
    if not shutil.which(program):
        print(f"skipped: {package} is not installed")
        sys.exit(77)
unittest.main(argv=sys.argv[:1])
