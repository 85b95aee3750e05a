#include "analysis/program/named_platform.h"
#include "tests/analysis/findings.h"
#include "tests/support/memory_files.h"

#include <catch2/catch.hpp>

using namespace proskill;
using Files = std::map<std::string, std::string>;

namespace {

analysis::Program load(const Files& files) {
  return analysis::load(test::MemoryFiles(files), "w/main.proskill");
}

} // namespace

TEST_CASE("a platform is relative to the file in which it stands") {
  const auto program = load({{"w/main.proskill", "(include \"robot/robot.proskill\")"},
                             {"w/robot/robot.proskill", "(defplatform \"../sim/robot.json\")"}});
  const auto named = analysis::namedPlatform(program);
  REQUIRE(named);
  CHECK(named->written == "../sim/robot.json");
  CHECK(named->file == "w/sim/robot.json");
  CHECK(named->at == analysis::Location{1, {14, 31}});
}

TEST_CASE("a program need not name a platform") {
  CHECK_FALSE(analysis::namedPlatform(load({{"w/main.proskill", "(defresource arm)"}})));
  CHECK_FALSE(analysis::namedPlatform(load({{"w/main.proskill", "(defplatform)"}})));
}

TEST_CASE("a second platform is an error, also in another file") {
  const auto found = analysis::check(load({{"w/main.proskill", "(defplatform \"a.json\")\n"
                                                               "(include \"b.proskill\")"},
                                           {"w/b.proskill", "(defplatform \"a.json\")"}}));
  REQUIRE(found.size() == 1);
  CHECK(found[0].message == "second platform: a program can have only one");
  CHECK(found[0].location == analysis::Location{1, {1, 12}});
  REQUIRE(found[0].related.size() == 1);
  CHECK(found[0].related[0].location == analysis::Location{0, {1, 12}});
}

TEST_CASE("the checks of a program do not read its platform") {
  CHECK(test::findings(Files{{"main.proskill", "(defplatform \"nowhere.json\")"}}) == "");
}
