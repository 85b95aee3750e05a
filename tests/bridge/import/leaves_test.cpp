#include "bridge/text/leaves.h"
#include "tests/bridge/errors_text.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace proskill;

namespace {

std::string leavesErrors(const std::string& json) {
  return test::errorsText(bridge::Leaves::read(json, "leaves.json"));
}

} // namespace

TEST_CASE("all errors of a file of leaves are reported, at their places") {
  CHECK(leavesErrors(R"({
  "tick": -1,
  "leaves": {
    "Drive": {"duration": [3, 2], "outcomes": ["done", "failure"]},
    "Near": {"kind": "check", "changes": 1},
    "Lift": {"duration": ["a", "b"], "speed": 2},
    "Wait": 3
  },
  "ticks": 0
})") == R"(leaves.json:2:3: /tick must be a number of seconds, at most 1e6
leaves.json:4:31: /leaves/Drive/duration/1 is less than the first number
leaves.json:4:48: /leaves/Drive/outcomes/0 must be "success" or "failure"
leaves.json:5:14: /leaves/Near/kind must be "action" or "condition"
leaves.json:5:31: /leaves/Near/changes must be true or false
leaves.json:6:27: /leaves/Lift/duration/0 must be a number of seconds, at most 1e6
leaves.json:6:32: /leaves/Lift/duration/1 must be a number of seconds, at most 1e6
leaves.json:6:38: /leaves/Lift/speed is not a field of a leaf: these are `duration`, `outcomes`, `kind` and `changes`
leaves.json:7:5: /leaves/Wait must be an object
leaves.json:9:3: /ticks is not a field of this file
)");
}

TEST_CASE("columns are those of characters, as everywhere") {
  CHECK(leavesErrors("{\"leaves\": {\"\xC3\xA9\": {}, \"B\": 1}}") ==
        "leaves.json:1:22: /leaves/B must be an object\n");
}

TEST_CASE("of very many errors the number is shown") {
  std::string many = "{\"leaves\": {";
  for (int i = 0; i < 130; ++i) many += (i > 0 ? ", \"L" : "\"L") + std::to_string(i) + "\": 1";
  const auto text = leavesErrors(many + "}}");
  CHECK(std::ranges::count(text, '\n') == 101);
  CHECK(text.ends_with("30 more errors are not shown\n"));
}

TEST_CASE("a text that is not a file of leaves is an error at its place") {
  CHECK(leavesErrors("[") == "leaves.json:1:2: the file is not JSON\n");
  CHECK(leavesErrors("{\n  \"tick\": 1,\n}") == "leaves.json:3:1: the file is not JSON\n");
  CHECK(leavesErrors(std::string("{}\n\0 ]", 6)) == "leaves.json:2:1: the file is not JSON\n");
  CHECK(leavesErrors("[1]") == "leaves.json:1:1: the file must contain an object\n");
  CHECK(leavesErrors("{\"tick\": 1e999}") == "leaves.json:1:10: the number is too large\n");
  CHECK(leavesErrors("\xEF\xBB\xBF{\"leaves\": 1}") ==
        "leaves.json:1:2: /leaves must be an object\n");
  const std::string deep(100'000, '[');
  CHECK(leavesErrors("{\"leaves\": {\"A\": " + deep + std::string(deep.size(), ']') + "}}") ==
        "leaves.json:1:13: /leaves/A must be an object\n");
}

TEST_CASE("a name that a file of leaves has twice is an error") {
  CHECK(leavesErrors(R"({"leaves": {"A": {"duration": [1, 2]}, "A": {"duration": [2, "x"]},
  "A/duration": {}, "~1": {}, "/": {}}})") ==
        "leaves.json:1:40: /leaves/A is there twice\n"
        "leaves.json:1:62: /leaves/A/duration/1 must be a number of seconds, at most 1e6\n");
  CHECK(leavesErrors(R"({"leaves": {"A/duration": {}, "A": {"duration": [1, 2]}}})") == "none");
}
