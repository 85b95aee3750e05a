#include "lsp/verification/verification_settings.h"

#include <catch2/catch.hpp>

using namespace proskill::lsp;
using namespace std::chrono_literals;

TEST_CASE("where verification is fast, it starts soon after an edit") {
  const VerificationSettings settings;
  CHECK(delayAfter(settings, std::nullopt) == 500ms);
  CHECK(delayAfter(settings, 60ms) == 30ms);
  CHECK(delayAfter(settings, 3s) == 500ms);
  CHECK(delayAfter({.delay = 0ms}, 3s) == 0ms);
}
