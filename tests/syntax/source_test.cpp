#include "syntax/text/source.h"

#include <catch2/catch.hpp>

using namespace proskill::syntax;

TEST_CASE("places in lines, from 0, in bytes") {
  std::string_view text = "ab\ncé\r\n\nx";
  LineIndex lines(text);
  CHECK(lines.lineCount() == 4);
  CHECK(lines.position(0) == Position{0, 0});
  CHECK(lines.position(2) == Position{0, 2});
  CHECK(lines.position(3) == Position{1, 0});
  CHECK(lines.position(9) == Position{3, 0});
  CHECK(lines.position(10) == Position{3, 1});
}

TEST_CASE("position and offset are inverse to each other") {
  std::string_view text = "ab\ncé\r\n\nx";
  LineIndex lines(text);
  for (Offset at = 0; at <= text.size(); ++at) CHECK(lines.offset(lines.position(at)) == at);
}

TEST_CASE("a place past the end of its line is that end") {
  LineIndex lines("ab\ncd");
  CHECK(lines.offset({0, 99}) == 2);
  CHECK(lines.offset({1, 99}) == 5);
  CHECK(lines.offset({9, 0}) == 5);
}

TEST_CASE("a line has no end of line in it") {
  std::string_view text = "ab\ncd\r\n\nx";
  LineIndex lines(text);
  CHECK(lines.line(0, text) == Range{0, 2});
  CHECK(lines.line(1, text) == Range{3, 5});
  CHECK(lines.line(2, text) == Range{7, 7});
  CHECK(lines.line(3, text) == Range{8, 9});
}

TEST_CASE("an empty text has one empty line") {
  LineIndex lines("");
  CHECK(lines.lineCount() == 1);
  CHECK(lines.position(0) == Position{0, 0});
  CHECK(lines.line(0, "") == Range{0, 0});
}
