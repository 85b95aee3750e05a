#include "tests/support/run.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>

using namespace proskill::test;

namespace import_command {

namespace {

constexpr auto kPatrol = PROSKILL_SOURCE_DIR "/examples/patrol/patrol.xml";
constexpr auto kBug = PROSKILL_SOURCE_DIR "/examples/patrol/bug.xml";
constexpr auto kLeaves = PROSKILL_SOURCE_DIR "/examples/patrol/leaves.json";

Finished command(std::vector<std::string> words) {
  words.insert(words.begin(), PROSKILL_PROGRAM);
  return run(words);
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

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

} // namespace import_command
