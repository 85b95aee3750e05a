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
