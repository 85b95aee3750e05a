#include "tests/support/run.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace proskill::test::hippo_test {

namespace {

const std::string kTree = PROSKILL_SOURCE_DIR;
/// A substitute for Hippo, which could not be run here.
const std::string kSubstitute = kTree + "/tests/cli/hippo";

Finished emit(const std::string& program, const std::string& directory,
              const std::vector<std::string>& more = {}) {
  std::vector<std::string> command{PROSKILL_PROGRAM, "emit", "hippo", program, "-o", directory};
  command.insert(command.end(), more.begin(), more.end());
  return run(command);
}

Finished make(const std::string& directory, const std::string& engine = kSubstitute) {
  return run({"/usr/bin/env", "make", "-C", directory, "HIPPO=" + engine,
              "FRAC2HIPPO=" + kSubstitute + "/frac2hippo",
              "CFLAGS=-Wall -Wextra -Werror -Wno-unused-parameter"});
}

std::string textOf(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

} // namespace

TEST_CASE("the project for Hippo compiles, and its functions perform actions and stop them") {
  const TemporaryDirectory files;
  const auto made = emit(kTree + "/docs/tour/dock.proskill", files.path("dock"));
  INFO(made.out << made.err);
  REQUIRE(made.exitCode == 0);
  std::filesystem::copy_file(kSubstitute + "/robot.c", files.path("dock/robot.c"),
                             std::filesystem::copy_options::overwrite_existing);
  const auto built = make(files.path("dock"));
  INFO(built.out << built.err);
  REQUIRE(built.exitCode == 0);
  // numbers are positions in the model's union skill_result
  REQUIRE(
      textOf(files.path("dock/mission.fcr"))
          .find("no_result | drive_onto_dock_interrupted | drive_onto_dock_failure_missed |\n"
                "    drive_onto_dock_success_docked | charge_interrupted | charge_success_full") !=
      std::string::npos);
  const auto done = run({files.path("dock/mission")});
  INFO(done.err);
  CHECK(done.exitCode == 0);
  CHECK(done.out == "drive 3\npushed away\ncharge 5\novertaken 4\nstopped 4\nnext 5\n");
}

TEST_CASE("every example becomes a project for Hippo that compiles") {
  const TemporaryDirectory files;
  files.write("hippo.h", textOf(kSubstitute + "/hippo.h"));
  files.write("hippo.c", "#include \"hippo.h\"\nvoid engine_run(void) {}\n");
  for (const std::string name : {"drone/drone", "rover/rover", "lift/lift"}) {
    const auto directory = files.path(std::filesystem::path(name).filename());
    const auto made = emit(kTree + "/examples/" + name + ".proskill", directory, {"--rate", "50"});
    INFO(name << "\n" << made.out << made.err);
    REQUIRE(made.exitCode == 0);
    const auto built = make(directory, files.path());
    INFO(built.out << built.err);
    CHECK(built.exitCode == 0);
    CHECK(textOf(directory + "/Makefile").find("TICK = 20000000\n") != std::string::npos);
  }
}

TEST_CASE("a project for Hippo is written anew without what belongs to its user") {
  const TemporaryDirectory files;
  const auto program = kTree + "/docs/tour/dock.proskill";
  REQUIRE(emit(program, files.path("dock")).exitCode == 0);
  files.write("dock/robot.c", "mine\n");
  REQUIRE(emit(program, files.path("dock")).exitCode == 0);
  CHECK(textOf(files.path("dock/robot.c")) == "mine\n");
  files.write("dock/hippo_glue.c", "mine\n");
  CHECK(emit(program, files.path("dock")).exitCode == 2);
  CHECK(textOf(files.path("dock/hippo_glue.c")) == "mine\n");
  const auto nowhere = run({PROSKILL_PROGRAM, "emit", "hippo", program});
  CHECK(nowhere.exitCode == 2);
  CHECK(nowhere.err.find("name it with `-o`") != std::string::npos);
}

} // namespace proskill::test::hippo_test
