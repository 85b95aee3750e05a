#include "syntax/text/natural.h"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

using namespace proskill::syntax;

TEST_CASE("names are sorted by their numbers") {
  const std::vector<std::string> sorted{"",   "room", "s",   "s02",   "s2",     "s2.status", "s2a",
                                        "s9", "s10",  "s11", "s11b2", "s11b10", "t"};
  for (std::size_t i = 0; i < sorted.size(); ++i)
    for (std::size_t j = 0; j < sorted.size(); ++j) {
      INFO(sorted[i] << " " << sorted[j]);
      CHECK(isNaturallyBefore(sorted[i], sorted[j]) == (i < j));
    }
}
