#include "fiacre/syntax/parse.h"
#include "verify/compile/compile.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace proskill::test::place_counts_test {

namespace {

/// Whether a step may fail with two users of a resource. Each does `from` in its three locations.
bool mayFail(const std::string& from, const std::string& capacity = "1") {
  const auto program = fiacre::parse(fmt::format(
      "process User (&used: 0..{0}) is states idle, busy, over\n{1}\n"
      "component main is var used: 0..{0} := 0 par * in User(&used) || User(&used) end\n"
      "main\n",
      capacity, from));
  REQUIRE(program.problems.empty());
  const auto compiled = verify::compile(program.program, {}, {});
  REQUIRE(compiled);
  return std::ranges::any_of(compiled->system.paths, &verify::Path::mayFail);
}

} // namespace

TEST_CASE("the number of users of a resource stays within its range") {
  CHECK_FALSE(mayFail("from idle on used < 1; used := used + 1; to busy\n"
                      "from busy used := used - 1; to idle"));
  CHECK_FALSE(mayFail("from idle if used < 1 then used := used + 1; to busy else to over end\n"
                      "from busy used := used - 1; to over"));
}

TEST_CASE("users that are as many as the resource allows need not ask") {
  CHECK_FALSE(
      mayFail("from idle used := used + 1; to busy\nfrom busy used := used - 1; to idle", "2"));
  CHECK(mayFail("from idle used := used + 1; to busy\nfrom busy used := used - 1; to idle", "1"));
}

TEST_CASE("a number that is given back too often, or not on each way, may leave its range") {
  CHECK(mayFail("from idle on used < 1; used := used + 1; to busy\n"
                "from busy used := used - 1; to over\nfrom over used := used - 1; to idle"));
  CHECK(mayFail("from idle on used < 1; used := used + 1; to busy\n"
                "from busy select used := used - 1; to idle [] to idle end"));
  CHECK(mayFail("from idle on used < 2; used := used + 1; to busy\n"
                "from busy used := used - 1; to idle"));
}

TEST_CASE("what a step writes before its test is not what is tested") {
  CHECK(mayFail("from idle used := 0; if used < 1 then used := used + 1 end; to busy\n"
                "from busy used := used - 1; to idle"));
}

} // namespace proskill::test::place_counts_test
