#include "tests/viz/outline.h"

#include <catch2/catch.hpp>

namespace proskill::test::events_test {

using namespace proskill::viz;
using namespace proskill::viz::test;

TEST_CASE("an event shows when it occurs, and its effects") {
  const std::string text = "(defsv s :states (X Y) :init X)"
                           "(defevent beat :every [1,5] :effects (s X))"
                           "(defevent turns :guard (s X) :effects (s Y))"
                           "(defevent plain :effects (s X))";
  const auto p = program(text);
  CHECK(outline(picture(p, Kind::Event, "beat")) == R"(
start
wait [1,5] s {since it occurred last, or since the start}
event beat {s := X}
start -> [1,5] s
[1,5] s -> beat
beat -> [1,5] s
)");
  CHECK(outline(picture(p, Kind::Event, "turns")).contains("wait until (s X) {then at any time"));
  CHECK(outline(picture(p, Kind::Event, "plain")).contains("wait any time"));
  const auto emitted = program(text + "(defenvironment e :body ((emit turns)))");
  CHECK(outline(picture(emitted, Kind::Event, "turns")).contains("until the environment emits it"));
  CHECK(draw(p, {Kind::Event, "x", false}).error() == "there is no event `x`");
  std::vector<std::string> names;
  for (const auto& request : allPictures(p, Kind::Event)) names.push_back(request.name);
  CHECK(names == std::vector<std::string>{"beat", "turns"}); // the others happen at any time
}

} // namespace proskill::test::events_test
