#include "tests/support/run.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <string>

namespace proskill::test::real_size_test {

namespace {

Finished verify(const std::string& file) {
  return run({PROSKILL_PROGRAM, "verify", "--traces", "none", file});
}

} // namespace

TEST_CASE("programs of real size are decided") {
  const std::string missions = PROSKILL_SOURCE_DIR "/bench/missions/";
  for (const auto* name : {"ocean_glider", "orchard_sprayer", "wall_printer"}) {
    INFO(name);
    const Finished done = verify(missions + name + ".proskill");
    CHECK(done.exitCode == 1); // each has a property that is violated
    CHECK(done.out.find("inconclusive") == std::string::npos);
    CHECK(done.out.find(" properties: ") != std::string::npos);
  }
}

TEST_CASE("many skills that nothing connects are decided") {
  std::string text;
  for (int i = 0; i < 40; ++i)
    text += "(defskill s" + std::to_string(i) +
            " :time_interval [1,5] :action (a) :success ok :failure bad)\n";
  const TemporaryDirectory files;
  const Finished done = verify(files.write("many.proskill", text));
  CHECK(done.exitCode == 0);
  CHECK(done.out.find("inconclusive") == std::string::npos);
}

} // namespace proskill::test::real_size_test
