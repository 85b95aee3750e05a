#include "tests/support/run.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

using namespace proskill;

namespace {

/// Runs the program where each thread needs a gigabyte of addresses, and the process gets so many
/// megabytes.
test::Finished runWithFewThreads(int megabytes, const std::string& arguments) {
  return test::run({"/bin/sh", "-c",
                    "ulimit -s 1000000 && ulimit -v " + std::to_string(megabytes * 1000) +
                        " && exec " PROSKILL_PROGRAM " " + arguments});
}

/// A model in which two numbers count to this one: more than one thread explores before it asks for
/// others.
std::string grid(int last) {
  const auto end = std::to_string(last);
  return "process p is states s var x : 0.." + end + " := 0, y : 0.." + end +
         " := 0\nfrom s select on x < " + end + "; x := x + 1; to s [] on y < " + end +
         "; y := y + 1; to s end\nproperty corner is present (p/value (x = " + end +
         " and y = " + end + "))\np\nassert corner\n";
}

std::string manyDefinitions(std::size_t bytes) {
  std::string text;
  while (text.size() < bytes) text += "(defevent some_event_with_a_name)\n";
  return text;
}

} // namespace

TEST_CASE("threads that the system does not have are done without") {
  const test::TemporaryDirectory files;
  const auto small = files.write("small.fcr", grid(299));
  const auto large = files.write("large.fcr", grid(511));
  const auto program = files.write("long.proskill", manyDefinitions(1'000'000));
  for (const int megabytes : {900, 1'900, 2'900}) { // no other thread, one, two
    INFO(megabytes);
    const auto explored = runWithFewThreads(megabytes, "verify --jobs 4 --reduce none " + small);
    CHECK(explored.exitCode == 0);
    const auto counted = runWithFewThreads(megabytes, "verify --jobs 4 --graph counts " + large);
    CHECK(counted.exitCode == 0);
    CHECK(counted.out.starts_with("262144 classe(s)"));
    CHECK(runWithFewThreads(megabytes, "check " + program).exitCode == 1);
  }
}

TEST_CASE("memory that is exhausted in one of several threads is reported as that") {
  const test::TemporaryDirectory files;
  const auto path = files.write("large.proskill", manyDefinitions(6'000'000));
  const auto done =
      test::run({"/bin/sh", "-c", "ulimit -v 400000; exec " PROSKILL_PROGRAM " check " + path});
  CHECK(done.exitCode == 71);
  CHECK(done.err.find("error: out of memory") != std::string::npos);
}
