#pragma once

#include "analysis/flow/inspect.h"
#include "syntax/diagnostics/codes.h"
#include "tests/support/marked_source.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>

#include <vector>

namespace proskill::test {

/// A program, `[[` and `]]` around the reported range, and the code; empty: no finding.
struct Case {
  const char* program;
  const char* code = "";
};

/// The findings of a program, without hints of style, are exactly that of the mark.
inline void expectTold(const Case& each) {
  MarkedSource marked(each.program);
  INFO(marked.text);
  std::vector<std::string> found;
  std::vector<syntax::Range> places;
  for (const auto& it : analysis::flow::inspect(programOfText(marked.text), {})) {
    found.push_back(std::string(syntax::info(it.code).id));
    places.push_back(it.location.range);
    UNSCOPED_INFO(found.back() << " " << it.message);
  }
  CHECK(found == std::vector<std::string>(marked.ranges.size(), each.code));
  CHECK(places == marked.ranges);
}

inline void expectAllTold(const std::vector<Case>& cases) {
  for (const Case& each : cases) expectTold(each);
}

} // namespace proskill::test
