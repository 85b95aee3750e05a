#include "tests/support/run.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

using namespace proskill::test;

namespace {

constexpr auto kLamp = "(defsv lamp :states (On Off) :init Off :transitions :all)\n"
                       "(defevent switch_on :effects (lamp On))\n"
                       "(defskill wait_for_light :time_interval [1,2] :action (look)\n"
                       "  :success seen (:postcondition (lamp On)))\n";
constexpr auto kDark = "property dark is absent model/value lamp = On\nassert dark\n";

struct Folder {
  TemporaryDirectory directory;
  std::string program = directory.write("lamp.proskill", kLamp);
  std::string properties = directory.write("dark.fcr", kDark);

  Finished verify(std::vector<std::string> words) const {
    words.insert(words.begin(), {PROSKILL_PROGRAM, "verify", program});
    return run(words);
  }
};

} // namespace

TEST_CASE("verify decides added properties in an environment of the user's own") {
  const Folder folder;
  const std::vector<std::string> dark{"--properties", folder.properties, "--property", "dark"};
  const Finished open = folder.verify(dark);
  CHECK(open.exitCode == 1);
  CHECK(open.out.find("dark") != std::string::npos);

  const auto never = folder.directory.write("never.fcr", "process never is\nstates idle\n");
  auto words = dark;
  words.insert(words.end(), {"--environment", never});
  CHECK(folder.verify(words).exitCode == 0);
}

TEST_CASE("verify shows mistakes of what is added at its lines") {
  const Folder folder;
  const auto wrong = folder.directory.write("wrong.fcr", "process e [ring: sync] is\nstates a\n");
  const Finished result = folder.verify({"--environment", wrong});
  CHECK(result.exitCode == 2);
  CHECK(result.err.find("wrong.fcr:1:12") != std::string::npos);
  CHECK(result.err.find("the program has no event or interrupt `ring`") != std::string::npos);
  CHECK(folder.verify({"--properties", "missing.fcr"}).exitCode == 2);
}

TEST_CASE("a model by hand has its environment, and takes more properties") {
  const TemporaryDirectory directory;
  const auto model = directory.write(
      "m.fcr", "process P is\nstates a\nfrom a\n    loop\ncomponent m is par P end\nm\n");
  const auto properties = directory.write("p.fcr", "property p is absent m/1/state a\nassert p\n");
  CHECK(run({PROSKILL_PROGRAM, "verify", model, "--properties", properties}).exitCode == 1);
  const Finished result = run({PROSKILL_PROGRAM, "verify", model, "--environment", properties});
  CHECK(result.exitCode == 2);
  CHECK(result.err.find("has its environment") != std::string::npos);
}
