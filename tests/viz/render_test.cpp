#include "tests/viz/outline.h"
#include "tests/viz/well_formed.h"

#include "viz/dot/label.h"
#include "viz/render.h"

#include <catch2/catch.hpp>

#include <cstdio>
#include <fcntl.h>
#include <thread>
#include <unistd.h>

using namespace proskill;
using namespace proskill::viz;
using namespace proskill::viz::test;

namespace {

Graph drone(Kind kind, const std::string& name) {
  return picture(example("drone/drone.proskill"), kind, name);
}

std::string rendered(const Graph& graph, Format format, Scheme scheme = Scheme::Light) {
  auto bytes = render(graph, format, scheme);
  REQUIRE(bytes);
  return std::move(*bytes);
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Captures standard error while this lives.
class StandardError {
public:
  StandardError() : kept(dup(STDERR_FILENO)), file(std::tmpfile()) {
    std::fflush(stderr);
    dup2(fileno(file), STDERR_FILENO);
  }
  ~StandardError() {
    std::fflush(stderr);
    dup2(kept, STDERR_FILENO);
    close(kept);
    std::fclose(file);
  }
  StandardError(const StandardError&) = delete;
  StandardError& operator=(const StandardError&) = delete;

  [[nodiscard]] long bytes() const {
    std::fflush(stderr);
    return lseek(fileno(file), 0, SEEK_END);
  }

private:
  int kept;
  std::FILE* file;
};

} // namespace

TEST_CASE("DOT has a range, a place and a link for each node") {
  const auto p = program("(defskill a :action (a))\n(defskill m :body ((a)))");
  const auto dot = rendered(picture(p, Kind::Body, "m"), Format::Dot);
  CHECK(contains(dot, R"(range="p.proskill:44-47")"));
  CHECK(contains(dot, R"(tooltip="p.proskill:2:20")"));
  CHECK(contains(dot, R"(URL="p.proskill#44-47")"));
  CHECK(contains(dot, R"(class="role-call")"));
}

TEST_CASE("SVG keeps ids, classes, links and places") {
  const auto p = program("(defskill a :action (a))\n(defskill m :body ((a)))");
  const auto svg = rendered(picture(p, Kind::Body, "m"), Format::Svg);
  CHECK(contains(svg, R"(<g id="n1" class="node role&#45;call">)"));
  CHECK(contains(svg, R"(xlink:href="p.proskill#44-47")"));
  CHECK(contains(svg, R"(xlink:title="p.proskill:2:20")"));
}

TEST_CASE("SVG is well-formed XML for every picture of the examples, and nobody complains") {
  for (const auto* path :
       {"drone/drone.proskill", "rover/rover.proskill", "arm/arm.proskill", "lift/lift.proskill"}) {
    const auto p = example(path);
    for (const auto& request : allPictures(p)) {
      INFO(path << " " << request.name);
      const StandardError complaints;
      const auto svg = rendered(picture(p, request.kind, request.name, true), Format::Svg);
      CHECK(complaints.bytes() == 0);
      CHECK(whyNotWellFormed(svg) == "");
    }
  }
}

TEST_CASE("whatever a message says, the picture is sound and says it") {
  const auto p = program(
      "(defskill m :body ((printf \"<b> & 'é' \\\" 漢 -->\") (printf \"\xff\x01 \xe2\x82\")))");
  const auto graph = picture(p, Kind::Body, "m");
  const StandardError complaints;
  const auto svg = rendered(graph, Format::Svg);
  CHECK(complaints.bytes() == 0);
  CHECK(whyNotWellFormed(svg) == "");
  CHECK(contains(svg, "&lt;b&gt; &amp;"));
  CHECK(contains(svg, "é"));
  CHECK(contains(svg, "漢"));
  CHECK(rendered(graph, Format::Png).starts_with("\x89PNG"));
}

TEST_CASE("names of files are quoted where they need to be") {
  Graph graph{
      .title = "t",
      .nodes = {{.label = "x", .source = {.file = "a \"b\"<&>#é.proskill", .range = {1, 2}}}}};
  const auto dot = rendered(graph, Format::Dot);
  CHECK(contains(dot, R"(range="a \"b\"<&>#é.proskill:1-2")"));
  CHECK(contains(dot, R"(URL="a%20%22b%22%3C%26%3E%23%C3%A9.proskill#1-2")"));
  CHECK(whyNotWellFormed(rendered(graph, Format::Svg)) == "");
}

TEST_CASE("light and dark are different, the same twice is the same") {
  const auto graph = drone(Kind::Body, "uav_mission");
  for (auto format : {Format::Dot, Format::Svg, Format::Png}) {
    const auto light = rendered(graph, format, Scheme::Light);
    const bool same = light == rendered(graph, format, Scheme::Light);
    const bool darkIsSame = light == rendered(graph, format, Scheme::Dark);
    CHECK(same);
    CHECK_FALSE(darkIsSame);
  }
}

TEST_CASE("any thread may render") {
  const auto graph = drone(Kind::Skill, "takeoff");
  const auto alone = rendered(graph, Format::Svg);
  std::vector<std::string> found(4);
  std::vector<std::thread> threads;
  for (auto& each : found)
    threads.emplace_back([&] { each = render(graph, Format::Svg, Scheme::Light).value_or(""); });
  for (auto& thread : threads) thread.join();
  for (const auto& each : found) CHECK(each == alone);
}

TEST_CASE("the legend explains what is in the picture, and nothing else") {
  const auto svg = rendered(drone(Kind::StateVariable, "camera"), Format::Svg);
  CHECK(contains(svg, "state variable camera"));
  CHECK(contains(svg, ">state"));
  CHECK_FALSE(contains(svg, "must not happen"));
  const auto mission = rendered(drone(Kind::Body, "uav_mission"), Format::Svg);
  for (const auto* meaning : {"calls a skill", "waits", "parallel branches", "must not happen"})
    CHECK(contains(mission, meaning));
}

TEST_CASE("an empty graph has a picture") {
  CHECK(whyNotWellFormed(rendered({.title = "nothing"}, Format::Svg)) == "");
}

TEST_CASE("long labels are broken between words, short parentheses are kept together") {
  CHECK(wrap("until (localization_status Valid)", 30) ==
        std::vector<std::string>{"until", "(localization_status Valid)"});
  CHECK(wrap("(and (a X) (b Y) (c Z))", 12) ==
        std::vector<std::string>{"(and (a X)", "(b Y) (c Z))"});
  CHECK(wrap("", 10).empty());
  CHECK(wrap("a_very_long_word_indeed", 5) == std::vector<std::string>{"a_very_long_word_indeed"});
}

TEST_CASE("what is no UTF-8 becomes the replacement character") {
  CHECK(clean("a\xff"
              "b") == "a\uFFFD"
                      "b");
  CHECK(clean("\xc0\xaf") == "\uFFFD\uFFFD");
  CHECK(clean("\xed\xa0\x80") == "\uFFFD\uFFFD\uFFFD");
  CHECK(clean("tab\there") == "tab here");
  CHECK(escape("<&>\"é") == "&lt;&amp;&gt;&quot;é");
}
