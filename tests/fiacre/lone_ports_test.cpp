#include "fiacre/check/lone_ports.h"

#include "fiacre/check/check.h"
#include "fiacre/syntax/parse.h"

#include <catch2/catch.hpp>

using namespace proskill::fiacre;

namespace {

/// `main.p of A` for a port that only A has, `main.p` for one that several pass alone.
std::vector<std::string> lone(const std::string& composition) {
  const auto parsed =
      parse("process A [p: sync] is states s from s p; to s\n"
            "process B [p: sync] is states s from s p; to s\n"
            "process Idle [p: sync] is states s from s wait [1,1]; to s\n"
            "process Sends [p: 0..3] is states s from s p!1; to s\n"
            "process Gets [p: 0..3] is states s var x: 0..3 := 0 from s p?x; to s\n"
            "process Two [p, q: sync] is states s from s select p; to s [] q; to s end\n" +
            composition + "\nmain");
  REQUIRE(parsed.problems.empty());
  for (const auto& problem : check(parsed.program)) FAIL(problem.message);
  std::vector<std::string> all;
  for (const auto& port : lonePorts(parsed.program))
    all.push_back(port.component + "." + port.port + (port.only.empty() ? "" : " of " + port.only));
  return all;
}

const std::vector<std::string> kNone;

} // namespace

TEST_CASE("a port of one instance alone is found") {
  CHECK(lone("component main is port p: sync par * in A[p] end") ==
        std::vector<std::string>{"main.p of A"});
  CHECK(lone("component main is port p, q: sync par * in A[p] || Two[p, q] end") ==
        std::vector<std::string>{"main.q of Two"});
  CHECK(lone("component main is port p: sync par * in A[p] || B[p] end") == kNone);
  CHECK(lone("component main is port p: sync par * in Two[p, p] end") ==
        std::vector<std::string>{"main.p of Two"});
}

TEST_CASE("who has a port and never passes it holds the others up") {
  CHECK(lone("component main is port p: sync par * in A[p] || Idle[p] end") == kNone);
  CHECK(lone("component main is port p: sync par * in Idle[p] end") == kNone);
}

TEST_CASE("what nobody sends nobody gets, alone or not") {
  CHECK(lone("component main is port p: 0..3 par * in Gets[p] end") == kNone);
  CHECK(lone("component main is port p: 0..3 par * in Sends[p] end") ==
        std::vector<std::string>{"main.p of Sends"});
}

TEST_CASE("instances that do not wait for each other pass a port alone") {
  const std::vector<std::string> each{"main.p"};
  CHECK(lone("component main is port p: sync par A[p] || B[p] end") == each);
  CHECK(lone("component main is port p: sync par p -> A[p] || B[p] end") == each);
  CHECK(lone("component main is port p: sync par p -> A[p] || p -> B[p] end") == kNone);
  CHECK(lone("component main is port p: sync par p in A[p] || B[p] end") == kNone);
}

TEST_CASE("a port is looked for in compositions and components within") {
  const std::string inner = "component inner [p: sync] is par * in A[p] end\n";
  CHECK(lone(inner + "component main is port p: sync par * in inner[p] end") ==
        std::vector<std::string>{"main.p of A"});
  CHECK(lone(inner + "component main is port p: sync par * in inner[p] || inner[p] end") == kNone);
  CHECK(lone("component main is port p: sync par * in par A[p] || A[p] end || B[p] end") == kNone);
  CHECK(lone("component inner is port p: sync par * in A[p] end\n"
             "component main is port p: sync par * in inner || A[p] || B[p] end") ==
        std::vector<std::string>{"inner.p of A"});
}

TEST_CASE("an interval, a priority or a probe gives one instance a port on purpose") {
  CHECK(lone("component main is port p: sync in [0,...[ par * in A[p] end") == kNone);
  CHECK(lone("component main is port p: sync in [2,2] par * in A[p] end") == kNone);
  CHECK(lone("component main is port p, q: sync priority p > q par * in Two[p, q] end") == kNone);
  CHECK(lone("component main is port p: sync is main/1/state s par * in A[p] end") == kNone);
}
