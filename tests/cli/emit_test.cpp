#include "tests/support/run.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>

using namespace proskill::test;

namespace {

constexpr auto kDrone = PROSKILL_SOURCE_DIR "/examples/drone/drone.proskill";

Finished emit(std::vector<std::string> words) {
  words.insert(words.begin(), {PROSKILL_PROGRAM, "emit"});
  return run(words);
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("emit prints the model of a program") {
  const auto done = emit({"fiacre", kDrone});
  CHECK(done.exitCode == 0);
  CHECK(done.err.empty());
  CHECK(contains(done.out, "\nprocess skill_takeoff\n"));
  CHECK(contains(done.out, "\nassert "));
}

TEST_CASE("emit has an expanded, a polling and a runtime edition") {
  const auto compact = emit({"fiacre", kDrone}).out;
  const auto expanded = emit({"fiacre", "--expanded", kDrone}).out;
  const auto polling = emit({"fiacre", "--sv-automata", "paper", kDrone}).out;
  const auto runtime = emit({"hfiacre", kDrone}).out;
  CHECK(expanded.size() > compact.size());
  CHECK(contains(polling, "states Good, Low, Critical, error"));
  CHECK_FALSE(contains(compact, "states Good, Low, Critical, error"));
  CHECK(contains(runtime, "\ntask "));
  CHECK_FALSE(contains(compact, "\ntask "));
}

TEST_CASE("emit proves properties where that is asked for") {
  const auto out = emit({"fiacre", "--prove", kDrone}).out;
  CHECK(contains(out, "\nprove "));
  CHECK_FALSE(contains(out, "\nassert "));
}

TEST_CASE("emit counts ticks at the rate that is asked for") {
  CHECK(contains(emit({"hfiacre", kDrone}).out, "[100,100]"));
  CHECK(contains(emit({"hfiacre", "--rate", "10", kDrone}).out, "[10,10]"));
  CHECK(emit({"hfiacre", "--rate", "0", kDrone}).exitCode == 2);
}

TEST_CASE("emit writes into a file") {
  const TemporaryDirectory directory;
  const auto path = directory.path("drone.fcr");
  const auto done = emit({"fiacre", kDrone, "-o", path});
  CHECK(done.exitCode == 0);
  CHECK(done.out.empty());
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  CHECK(text.str() == emit({"fiacre", kDrone}).out);
}

TEST_CASE("no command replaces the file that it reads") {
  const TemporaryDirectory directory;
  const auto path = directory.path("mission.proskill");
  const std::string text = "(defskill m :body ((^ 1)))\n";
  std::ofstream(path) << text;
  std::filesystem::create_symlink(path, directory.path("link"));
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"emit", "fiacre"}, {"emit", "promela"}, {"emit", "bt"}, {"graph"}, {"import", "rl"}}) {
    auto command = words;
    command.insert(command.begin(), PROSKILL_PROGRAM);
    command.insert(command.end(), {path, "-o", directory.path("link")});
    const auto done = run(command);
    INFO(words.front());
    CHECK(done.exitCode == 2);
    CHECK(done.err == "error: `-o` names the file that is read\n");
  }
  std::ostringstream left;
  left << std::ifstream(path).rdbuf();
  CHECK(left.str() == text);
}

TEST_CASE("emit says when it cannot write, a full disk included") {
  const auto nowhere = emit({"fiacre", kDrone, "-o", "/no/such/directory/drone.fcr"});
  CHECK(nowhere.exitCode == 2);
  CHECK(nowhere.err ==
        "error: /no/such/directory/drone.fcr cannot be written: No such file or directory\n");
  const auto full = emit({"fiacre", kDrone, "-o", "/dev/full"});
  CHECK(full.exitCode == 2);
  CHECK(full.err == "error: /dev/full cannot be written: No space left on device\n");
}

TEST_CASE("emit shows what is wrong with a program, and prints no model") {
  const TemporaryDirectory directory;
  const auto path = directory.write("bad.proskill", "(defskill m :body ((nothing)))\n");
  const auto done = emit({"fiacre", path});
  CHECK(done.exitCode == 2);
  CHECK(done.out.empty());
  CHECK(contains(done.err, "error[PS"));
  CHECK(contains(done.err, "(nothing)"));
}

TEST_CASE("a model in Fiacre is no program to emit or draw") {
  const auto done = emit({"fiacre", PROSKILL_SOURCE_DIR "/examples/fiacre/fischer.fcr"});
  CHECK(done.exitCode == 2);
  CHECK(done.out.empty());
  CHECK(contains(done.err, "is a model in Fiacre"));
}

namespace {

/// A model in a file, as it is emitted.
Finished emitModel(const std::string& target, const std::string& text) {
  const TemporaryDirectory directory;
  return emit({target, directory.write("model.fcr", text)});
}

constexpr auto kCounter = R"(process counter (&n: 0..9) is
states up, down
from up
    on n < 9;
    n := n + 1;
    to down
from down
    wait [2,5];
    n := n * 1;
    to up
component main is
var n: 0..9 := 0
par counter (&n) end
main
property nine is absent (main/value n = 9)
assert nine
)";

} // namespace

TEST_CASE("emit writes a model for Spin, with a note on time") {
  const auto done = emitModel("promela", kCounter);
  CHECK(done.exitCode == 0);
  CHECK(contains(done.out, ":: d_step { "));
  CHECK(contains(done.out, "hidden byte p_nine = true; /* nine */"));
  CHECK(contains(done.out, "/* time passes */"));
  CHECK(contains(done.err, "note: time is discrete: one tick is 1 unit(s) of the model"));
}

TEST_CASE("a step in Promela checks only the properties that it can violate") {
  std::string text = kCounter;
  const std::string_view first = "par counter (&n) end";
  text.replace(text.find(first), first.size(), "par counter (&n) || idle end");
  text.insert(text.find("component"), R"(process idle is
states off, lit
from off
    wait [1,1];
    to lit
from lit
    wait [1,1];
    to off
)");
  const auto done = emitModel("promela", text);
  CHECK(done.exitCode == 0);
  const auto checks = [&](std::string_view step) {
    const auto begin = done.out.find(step);
    REQUIRE(begin != std::string::npos);
    const auto end = done.out.find("\n     }\n", begin);
    return contains(done.out.substr(begin, end - begin), "expect(p_nine");
  };
  CHECK(checks("counter_1 from up"));
  CHECK_FALSE(checks("idle_1 from off"));
  CHECK_FALSE(checks("idle_1 from lit"));
}

TEST_CASE("emit writes a timed automaton for TChecker") {
  const auto done = emitModel("tchecker", kCounter);
  CHECK(done.exitCode == 0);
  CHECK(contains(done.out, "\nsystem:model\n"));
  CHECK(contains(done.out, "\nlocation:model:s0{initial:}\n"));
  CHECK(contains(done.out, "invariant:x0<=5"));
  CHECK(contains(done.out, "{provided:x0>=2}"));
  CHECK(contains(done.out, "labels:p_nine"));
}

TEST_CASE("emit says where a model calculates with more than Spin can") {
  std::string text = kCounter;
  text.replace(text.find("n * 1"), 5, "(n * 9000000000) / 9000000000");
  const auto done = emitModel("promela", text);
  CHECK(done.exitCode == 2);
  CHECK(contains(done.err, "model.fcr:8:5: error: Promela calculates with numbers of 32 bits"));
}

TEST_CASE("emit names the properties that other model checkers are not asked for") {
  const auto done = emit({"promela", kDrone});
  CHECK(done.exitCode == 0);
  CHECK(contains(done.err, "note: Spin is not asked for `program.time_progress`: it is about "
                           "whether time can pass"));
  CHECK(contains(done.err, "with open bounds"));
}
