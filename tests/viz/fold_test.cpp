#include "tests/viz/outline.h"
#include "viz/fold.h"

#include <catch2/catch.hpp>

using namespace proskill;
using namespace proskill::viz;
using namespace proskill::viz::test;

namespace {

Graph body(const std::string& statements) {
  const auto p = program("(defskill a :action (a))\n(defskill b :action (b))\n"
                         "(defskill m :body (" +
                         statements + "))");
  return picture(p, Kind::Body, "m");
}

} // namespace

TEST_CASE("a folded branch is one node in its place") {
  const auto folded = fold(body("(// ((a)) ((b) (^ 2) (a)))"), {1});
  CHECK(outline(folded.graph) == R"(
start
fork
call a in branch 1
folded branch 2 {3 nodes}
join
success success {end of the body}
start -> fork
fork -> a
fork -> branch 2
a -> join
branch 2 -> join
join -> success
)");
  CHECK(folded.parts[0].cluster == 0);
  CHECK(folded.parts[1].node == 3);
  CHECK_FALSE(folded.parts[1].cluster);
}

TEST_CASE("within a folded branch nothing is left of the branches in it") {
  const auto whole = body("(// ((a) (// ((a)) ((b)))) ((b)))");
  const auto folded = fold(whole, {0});
  REQUIRE(folded.parts.size() == 4);
  CHECK(folded.graph.clusters.size() == 1);
  CHECK(folded.parts[0].node);
  int gone = 0;
  for (const auto& part : folded.parts) gone += !part.node && !part.cluster;
  CHECK(gone == 2);
}

TEST_CASE("nothing folded is the graph as it was") {
  const auto whole = body("(while true (// ((a)) ((b) (^ 2))))");
  CHECK(outline(fold(whole, {}).graph) == outline(whole));
}

TEST_CASE("large graphs are folded, the largest clusters first, as far as needed") {
  const auto whole = body("(// ((a)) ((b) (^ 2) (a) (b)) ((a) (b)))");
  CHECK(clustersToFold(whole, whole.nodes.size()).empty());
  CHECK(clustersToFold(whole, whole.nodes.size() - 2) == std::set<std::size_t>{1});
  CHECK(clustersToFold(whole, 1) == std::set<std::size_t>{1, 2});
}
