#include "tests/cli/imports.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

using namespace proskill::test;
using Json = nlohmann::json;

namespace import_command {

using imports::command;
using imports::contains;
using imports::contentOf;
using imports::kLeaves;
using imports::kPatrol;

namespace {

constexpr auto kBug = PROSKILL_SOURCE_DIR "/examples/patrol/bug.xml";

} // namespace

TEST_CASE("import bt writes a program that has no errors and is formatted") {
  const TemporaryDirectory directory;
  const auto path = directory.path("patrol.proskill");
  const auto done = command({"import", "bt", kPatrol, "--leaves", kLeaves, "-o", path});
  CHECK(done.exitCode == 0);
  CHECK(done.out.empty());
  CHECK(contains(done.err, "verdicts are exact for this tree"));
  CHECK(command({"check", path}).exitCode == 0);
  CHECK(command({"fmt", "--check", path}).exitCode == 0);
  const auto verified = command({"verify", path});
  CHECK(verified.exitCode == 0);
  CHECK(contains(verified.out, "`Record` can succeed with `done`: reachable"));
}

TEST_CASE("the verdicts on the patrol's bug are those of its README") {
  const TemporaryDirectory directory;
  const auto path = directory.path("bug.proskill");
  REQUIRE(command({"import", "bt", kBug, "--leaves", kLeaves, "-o", path}).exitCode == 0);
  const auto verified = command({"verify", path});
  CHECK(contains(verified.out, "`Record` can succeed with `done`: unreachable"));
  CHECK(contains(verified.out, "`Record` can fail with `failed`: unreachable"));
  CHECK(contains(verified.out, "`visit_hall` can succeed with `done`: reachable"));
}

TEST_CASE("import names errors with their places and writes nothing") {
  const TemporaryDirectory directory;
  const auto xml = directory.path("tree.xml");
  const auto out = directory.path("tree.proskill");
  std::ofstream(xml) << "<root BTCPP_format=\"4\">\n<BehaviorTree ID=\"A\">\n  <Sequence/>\n"
                        "</BehaviorTree>\n</root>\n";
  const auto done = command({"import", "bt", xml, "-o", out});
  CHECK(done.exitCode == 2);
  CHECK(done.err == xml + ":3:3: error: `Sequence` must have at least 1 child, not 0\n");
  CHECK_FALSE(std::filesystem::exists(out));
  CHECK(command({"import", "bt", "/dev/zero"}).exitCode == 2);
  CHECK(command({"import", "bt", kPatrol, "--leaves", kPatrol}).exitCode == 2);
}

TEST_CASE("emit bt writes a mission as a tree that imports again") {
  const TemporaryDirectory directory;
  const auto path = directory.write(
      "dock.proskill",
      "(defskill drive :time_interval [2,5] :action (drive) :success ok :failure no)\n"
      "(defskill Mission :success ok :failure no\n  :body ((label again)\n"
      "  (drive)\n  (if (/= drive.status success) (^ 5) (goto again))))\n");
  const auto xml = directory.path("dock.xml");
  const auto leaves = directory.path("leaves.json");
  CHECK(command({"emit", "bt", path, "--leaves", leaves, "-o", xml}).exitCode == 0);
  const auto again = command({"import", "bt", xml, "--leaves", leaves});
  CHECK(contains(again.out, ":time_interval [2,5]"));
  CHECK(contains(again.err, "verdicts are exact"));
  CHECK(command({"emit", "rl", path, "--leaves", leaves}).exitCode == 2);
  for (const auto& [one, other] : {std::pair{leaves, directory.path("./leaves.json")}, {"-", "-"}})
    CHECK(contains(command({"emit", "bt", path, "--leaves", one, "-o", other}).err,
                   "`--leaves` and `-o` must name two files"));
  CHECK(contains(command({"emit", "bt", path, "--main", "drive"}).err,
                 "`drive` is not a composite skill"));
}

TEST_CASE("a run of a tree with a node of one's own draws what the node decides") {
  const TemporaryDirectory directory;
  const auto xml = directory.write("own.xml", R"(<root BTCPP_format="4"><BehaviorTree ID="Main">
<RetryUntilSuccessful num_attempts="-1"><Mine><Action ID="Go"/><Condition ID="Clear"/></Mine>
</RetryUntilSuccessful></BehaviorTree></root>)");
  const auto path = directory.path("own.proskill");
  REQUIRE(command({"import", "bt", xml, "-o", path}).exitCode == 0);
  std::string runs;
  for (const auto* seed : {"1", "2", "3", "4"}) {
    const auto ran = command({"run", path, "--no-record", "--seed", seed}).out;
    CHECK(contains(ran, "the mission has ended"));
    CHECK_FALSE(contains(ran, "the mission has ended after 0 s"));
    runs += ran;
  }
  CHECK(contains(runs, "→ (Go)"));
  CHECK(contains(runs, "is interrupted"));
}

// --- Components

TEST_CASE("the example of a component is what its import writes, and its bug is found") {
  const std::filesystem::path folder = PROSKILL_SOURCE_DIR "/examples/gripper";
  const TemporaryDirectory directory;
  for (const auto* name : {"gripper.gen", "leaves.json", "bug.proskill"})
    std::filesystem::copy_file(folder / name, directory.path(name));
  const auto path = directory.path("gripper.proskill");
  const auto done = command({"import", "gen", directory.path("gripper.gen"), "--leaves",
                             directory.path("leaves.json"), "-o", path});
  CHECK(done.exitCode == 0);
  CHECK(contains(done.err, "verdicts are exact for what the file declares"));
  CHECK(contentOf(path) == contentOf(folder / "gripper.proskill"));
  const auto verified = command({"verify", directory.path("bug.proskill")});
  CHECK(verified.exitCode == 1);
  CHECK(contains(verified.out, "violated (never (and (running hold) (called park)))"));
}

// --- Skillsets

constexpr auto kCrane = PROSKILL_SOURCE_DIR "/examples/crane/crane.rl";
constexpr auto kCraneBug = PROSKILL_SOURCE_DIR "/examples/crane/bug.rl";

TEST_CASE("import rl and emit rl are inverse on the crane") {
  const TemporaryDirectory directory;
  const auto path = directory.path("crane.proskill");
  const auto done = command({"import", "rl", kCrane, "-o", path});
  CHECK(done.exitCode == 0);
  CHECK(contains(done.err, "verdicts are exact for these skillsets"));
  CHECK(command({"check", path}).exitCode == 0);
  CHECK(command({"fmt", "--check", path}).exitCode == 0);
  CHECK(command({"verify", path}).exitCode == 0);
  const auto written = command({"emit", "rl", path});
  CHECK(written.exitCode == 0);
  CHECK(written.err.empty());
  const auto again = directory.write("again.rl", written.out);
  std::filesystem::create_directory(directory.path("again"));
  const auto second = directory.path("again/crane.proskill");
  REQUIRE(command({"import", "rl", again, "-o", second}).exitCode == 0);
  CHECK(command({"emit", "rl", second}).out == written.out);
  CHECK(command({"import", "rl", kCrane, "--leaves", kLeaves}).exitCode == 2);
}

TEST_CASE("verdicts and findings name the original, from the program's folder") {
  const TemporaryDirectory directory;
  std::filesystem::create_directory(directory.path("in"));
  std::filesystem::copy_file(kCraneBug, directory.path("in/bug.rl"));
  const auto path = directory.path("bug.proskill");
  REQUIRE(command({"import", "rl", directory.path("in/bug.rl"), "-o", path}).exitCode == 0);
  const auto original = directory.path("in/bug.rl") + ":28:9 resource battery";
  const auto verified = command({"verify", path});
  CHECK(contains(verified.out, "\n  from " + original + "\n"));
  const auto report = Json::parse(command({"verify", "--format", "json", path}).out);
  const Json place{{"file", directory.path("in/bug.rl")},
                   {"line", 28},
                   {"column", 9},
                   {"what", "resource battery"}};
  for (const auto& row : report["properties"])
    if (row["name"] == "battery.no_forbidden_transition") CHECK(row["original"] == place);
  const auto sarif = Json::parse(command({"verify", "--format", "sarif", path}).out);
  CHECK(sarif["runs"][0]["results"][0]["relatedLocations"][0]["physicalLocation"]["region"] ==
        Json{{"startLine", 28}, {"startColumn", 9}});
  const auto checked = command({"check", path});
  CHECK(contains(checked.out, " = from: " + directory.path("in/bug.rl") + ":5"));
  const auto findings = Json::parse(command({"check", "--format", "json", path}).out);
  CHECK(findings["diagnostics"][0]["original"]["file"] == directory.path("in/bug.rl"));
  const auto log = Json::parse(command({"check", "--format", "sarif", path}).out);
  CHECK(contains(log["runs"][0]["results"][0]["relatedLocations"].dump(), "in/bug.rl"));
}

TEST_CASE("emit rl names what RL cannot say") {
  const TemporaryDirectory directory;
  const auto path = directory.write("p.proskill", "(defsv n :init 0 :min 0 :max 3)\n"
                                                  "(defevent up :effects (n (+ n 1)))\n");
  const auto done = command({"emit", "rl", path});
  CHECK(done.exitCode == 2);
  CHECK(done.out.empty());
  CHECK(contains(done.err, path + ":1:8: error: RL cannot say this: a number\n"));
}

// --- Planning problems

TEST_CASE("plan does not replace the program, and needs a goal") {
  const TemporaryDirectory directory;
  const std::string text = "(defskill go)\n";
  const auto path = directory.write("p.proskill", text);
  const auto replaces = command({"plan", "true", path, "-o", path});
  CHECK(replaces.exitCode == 2);
  CHECK(contains(replaces.err, "`-o` names the file that is read"));
  CHECK(contains(command({"plan", " ", path}).err, "the goal is empty"));
  CHECK(run({"/bin/cat", path}).out == text);
}

TEST_CASE("errors of a goal are at their place in the goal") {
  const auto survey = std::string(PROSKILL_SOURCE_DIR "/docs/bridges/survey.proskill");
  const auto errors = [&](const std::string& goal) {
    const auto done = command({"emit", "pddl", "--goal", goal, survey});
    CHECK(done.exitCode == 2);
    CHECK(done.out.empty());
    return done.err;
  };
  CHECK(contains(errors("(area Green)"), "`Green` is not a value of `area`\n --> goal:1:7\n"));
  CHECK(contains(errors("(and (area Photographed)\n  (are Unknown))"), " --> goal:2:4\n"));
  CHECK(contains(errors("(ended land)"), "goal:1:1: error: PDDL cannot say this: a condition"));
  CHECK(command({"emit", "pddl", "--goal", "(area Photographed) ; soon", survey}).exitCode == 0);
  const TemporaryDirectory directory;
  (void)directory.write("goal", contentOf(survey));
  CHECK(run({"/usr/bin/env", "-C", directory.path(), PROSKILL_PROGRAM, "emit", "pddl", "--goal",
             "(area Photographed)", "goal"})
            .exitCode == 0);
  for (const auto* goal : {"(area Photographed", "(area Photographed))", "area", ")", "(", "\"x"})
    CHECK(contains(errors(goal), " --> goal:1:"));
}

TEST_CASE("plan reports what is wrong with a goal before it looks for planners") {
  const auto survey = std::string(PROSKILL_SOURCE_DIR "/docs/bridges/survey.proskill");
  const TemporaryDirectory directory;
  const auto none = directory.write("unified_planning.py", "raise ImportError('none')\n");
  const auto plan = [&](const std::string& goal) {
    return run({"/usr/bin/env", "PYTHONPATH=" + none.substr(0, none.rfind('/')), PROSKILL_PROGRAM,
                "plan", goal, survey});
  };
  const auto wrong = plan("(area Green)");
  CHECK(wrong.exitCode == 2);
  CHECK(contains(wrong.err, " --> goal:1:7\n"));
  CHECK_FALSE(contains(wrong.err, "planners"));
  const auto impossible = plan("(and (area Unknown) (area Photographed))");
  CHECK(impossible.exitCode == 1);
  CHECK(contains(impossible.err, "the goal is impossible"));
  const auto possible = plan("(area Photographed)");
  CHECK(possible.exitCode == 2);
  CHECK(contains(possible.err, "error: planners are not installed"));
}

TEST_CASE("emit pddl writes a domain and a problem") {
  const auto survey = std::string(PROSKILL_SOURCE_DIR "/docs/bridges/survey.proskill");
  const auto domain = command({"emit", "pddl", survey});
  CHECK(domain.exitCode == 0);
  CHECK(contains(domain.out, R"(
  ; skill photograph (success done)
  (:durative-action photograph
    :parameters ()
    :duration (and (>= ?duration 10) (<= ?duration 100))
    :condition (and
      (at start (photograph-is-idle))
      (at start (flight-is-inair))
      (over all (flight-is-inair)))
    :effect (and
      (at start (not (photograph-is-idle)))
      (at end (photograph-is-idle))
      (at end (not (area-is-unknown)))
      (at end (area-is-photographed))))
)"));
  CHECK(contains(domain.out, "    (gps-is-fixed) ; (gps Fixed)\n"));
  CHECK(contains(domain.out, "  ; event gps_fixed\n  (:action gps-fixed\n"));
  const TemporaryDirectory directory;
  const auto leak = directory.write("leak.proskill", R"((defsv tank :states (Full Empty) :init Full)
(defevent leaks :every [1,2] :effects (tank Empty))
)");
  CHECK(contains(command({"emit", "pddl", leak}).out,
                 "  ; event leaks by itself\n  (:action leaks\n"));
  const auto problem = command({"emit", "pddl", "--goal", "(not (area Unknown))", survey});
  CHECK(contains(problem.out, "(:goal (not (area-is-unknown)))"));
  const auto wrong = command({"emit", "pddl", "--goal", "(area Green)", survey});
  CHECK(wrong.exitCode == 2);
  CHECK(contains(wrong.err, "`Green` is not a value of `area`"));
  CHECK(command({"emit", "fiacre", "--goal", "true", survey}).exitCode == 2);
}

TEST_CASE("numbers, resources and failures in PDDL") {
  const TemporaryDirectory directory;
  const auto path = directory.write("p.proskill", R"((defsv parts :init 1 :min 0 :max 3)
(defsv Arm :states (Up Down) :init Up)
(defsv arm :states (UP up) :init up)
(defresource gripper :capacity 2)
(defskill take
  :precondition (some (and (> parts 0) (=> (Arm Up) (/= Arm Down))))
  :resources (gripper)
  :time_interval ]0.5,...[
  :action (take)
  :success taken (:effects (parts (- parts 1)) :postcondition (and (Arm Up) (arm UP)))
  :failure dropped)
)");
  const auto best = command({"emit", "pddl", path}).out;
  CHECK(contains(best, ":duration (>= ?duration 0.500000)"));
  CHECK(contains(best, "(at start (>= (gripper-left) 1))"));
  CHECK(contains(best, "(at start (decrease (gripper-left) 1))"));
  CHECK(contains(best, "(at end (assign (parts) (- (parts) 1)))"));
  CHECK(contains(best, "(arm-is-up-2) ; (arm UP)"));
  CHECK(contains(best, "(at end (arm-is-up))"));
  CHECK_FALSE(contains(best, "dropped"));
  CHECK(contains(command({"emit", "pddl", "--outcomes", "all", path}).out,
                 "(:durative-action take--dropped\n"));
  CHECK(contains(command({"emit", "pddl", "--goal", "(= parts 0)", path}).out, "(= (parts) 1)\n"));
}

TEST_CASE("in PDDL no effect is a forbidden move or leaves the range of a number") {
  const TemporaryDirectory directory;
  const auto path = directory.write(
      "p.proskill", R"((defsv x :states (A B C) :init A :transitions ((A B) (B C) (C B)))
(defsv n :init 1 :min 1 :max 3)
(defevent falls :guard (= n 2) :effects (x C))
(defskill go :start (x B) :action (go) :success done (:effects ((x C) (n (+ n 1)))))
(defskill reset :action (reset) :success done (:effects (n 1)))
)");
  const auto out = command({"emit", "pddl", path}).out;
  CHECK(contains(out, R"(
    :condition (and
      (at start (go-is-idle))
      (at start (or (x-is-b) (x-is-a) (x-is-c)))
      (over all (or (x-is-c) (x-is-b)))
      (at start (>= (+ (n) 1) 1))
      (over all (>= (+ (n) 1) 1))
      (at start (<= (+ (n) 1) 3))
      (over all (<= (+ (n) 1) 3)))
)"));
  CHECK(contains(out, ":precondition (and (= (n) 2) (or (x-is-c) (x-is-b)))"));
  CHECK(contains(out, "(and\n      (at start (reset-is-idle)))"));
}

TEST_CASE("PDDL has an action for each value of an input that a skill reads") {
  const TemporaryDirectory directory;
  const auto skill = [](const std::string& most) {
    return "(defsv place :states (Dock Bed_1) :init Dock)\n(defsv load :min 0 :max " + most +
           " :init 0)\n(defskill go :input ($to place $by load $fast float) :precondition (there "
           "(not (place $to)) heavy (<= load $by))\n"
           "  :action (go $to $fast) :success there (:effects (place $to)))\n";
  };
  const auto path = directory.write("p.proskill", skill("2"));
  const auto out = command({"emit", "pddl", path}).out;
  CHECK(contains(out, R"(
  ; skill go (success there) to=Bed_1 by=2 fast:float
  (:durative-action go-bed-1-2
)"));
  CHECK(contains(out, "(at start (not (place-is-bed-1)))\n      (at start (<= (load) 2))"));
  CHECK(contains(out, "(at end (not (place-is-dock)))\n      (at end (place-is-bed-1))"));
  CHECK(contains(out, "(:durative-action go-dock-0\n"));
  const auto compared = directory.write(
      "compared.proskill",
      "(defsv door :states (Open Closed) :init Open)\n(defsv at :states (Dock Bed) :init Dock)\n"
      "(defskill go :input ($to at $by door $fast bool)\n"
      "  :precondition (open (=> (= $to Bed) (door Open)) slow (/= $fast true) by (= $by door))\n"
      "  :action (go $to) :success there (:effects (at $to)))\n");
  const auto conditions = command({"emit", "pddl", compared}).out;
  CHECK(contains(conditions, R"(go-bed-open-false
    :parameters ()
    :duration (>= ?duration 0)
    :condition (and
      (at start (go-is-idle))
      (at start (or (not (and)) (door-is-open)))
      (at start (not (or)))
      (at start (door-is-open)))"));
  CHECK(contains(conditions, "(at start (or (not (or)) (door-is-open)))\n"
                             "      (at start (not (and)))"));
  const auto about = directory.write(
      "about.proskill", "(defsv at :states (Dock Bed) :init Dock)\n"
                        "(defskill go :input ($to at) :precondition (new (=> (= $to Bed) (/= "
                        "go.status success)))\n  :action (go $to) :success there)\n");
  CHECK(command({"emit", "pddl", about}).err ==
        about + ":2:65: error: PDDL cannot say this: a condition about a skill\n");
  const auto heavy = directory.write("heavy.proskill", skill("5000"));
  const auto refused = command({"emit", "pddl", heavy});
  CHECK(refused.exitCode == 2);
  CHECK(contains(refused.err, "heavy.proskill:3:11: error: PDDL cannot say this: `go` needs an "
                              "action for each value of its input `by`, and `"));
  CHECK(contains(refused.err, "` has 5001 of them, more than 1000; read the input in the action "
                              "only, or use fewer values"));
}

} // namespace import_command
