#include "ide/features/moved_files.h"
#include "tests/ide/marked_program.h"

#include <catch2/catch.hpp>

using namespace proskill;

namespace {

const test::MarkedProgram& programs() {
  static const test::MarkedProgram kPrograms({
      {"main.proskill", "(include \"lib/lamp.proskill\")\n(include \"gone.proskill\")"},
      {"lib/lamp.proskill", "(include \"base.proskill\")\n(include \"/w/door.proskill\")"},
      {"lib/base.proskill", ""},
      {"robot/robot.proskill", "(defplatform \"robot.json\")"},
      {"door.proskill", "; (include \"lib/lamp.proskill\")"},
  });
  return kPrograms;
}

/// The changed files, each with its new includes.
std::string after(const std::vector<ide::Move>& moves) {
  std::string all;
  for (const auto& [path, edits] : ide::includesAfter(programs().snapshot(), moves)) {
    all += path.string() + ":";
    for (const auto& edit : edits) all += " " + edit.text;
    all += "\n";
  }
  return all;
}

} // namespace

TEST_CASE("includes follow a file that moves, and those within it") {
  CHECK(after({{"/w/lib/base.proskill", "/w/lib/ground.proskill"}}) ==
        "/w/lib/lamp.proskill: ground.proskill\n");
  CHECK(after({{"/w/lib/lamp.proskill", "/w/lamp.proskill"}}) ==
        "/w/lib/lamp.proskill: lib/base.proskill\n/w/main.proskill: lamp.proskill\n");
  CHECK(after({{"/w/door.proskill", "/w/gate.proskill"}}) ==
        "/w/lib/lamp.proskill: /w/gate.proskill\n");
}

TEST_CASE("includes follow a folder that moves") {
  CHECK(after({{"/w/lib", "/w/share/lib"}}) == "/w/main.proskill: share/lib/lamp.proskill\n");
  CHECK(after({{"/w/main.proskill", "/w/lib/main.proskill"}}) ==
        "/w/main.proskill: lamp.proskill ../gone.proskill\n");
}

TEST_CASE("a platform follows the program that moves, and stays if its folder does") {
  CHECK(after({{"/w/robot/robot.proskill", "/w/robot.proskill"}}) ==
        "/w/robot/robot.proskill: robot/robot.json\n");
  CHECK(after({{"/w/robot", "/w/arm"}}) == "");
}

TEST_CASE("what moves together goes on as it is, and so does what nothing includes") {
  CHECK(after({{"/w", "/v"}}) == "/w/lib/lamp.proskill: /v/door.proskill\n");
  CHECK(after({{"/w/other.proskill", "/w/more.proskill"}}) == "");
  CHECK(after({{"/w/li", "/w/la"}}) == "");
}
