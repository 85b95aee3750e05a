#include "viz/dot/text_width.h"

#include <catch2/catch.hpp>

using namespace proskill::viz;

TEST_CASE("text is measured by its characters, whatever fonts there are") {
  CHECK(textWidth("", false) == 0);
  CHECK(textWidth("landing", false) == Approx(3.707).epsilon(0.001));
  CHECK(textWidth("iii", false) < textWidth("mmm", false));
  CHECK(textWidth("landing", true) > textWidth("landing", false));
}

TEST_CASE("a character counts once, however many bytes it has") {
  CHECK(textWidth("é", false) == textWidth("ж", false));
  CHECK(textWidth("着", false) > textWidth("é", false));
  CHECK(textWidth("🤖", false) == textWidth("着", false));
}

TEST_CASE("bytes that are no text are measured, too") {
  CHECK(textWidth("\xC3", false) > 0);
  CHECK(textWidth("\x80\xFF", false) > 0);
}
