#pragma once

#include "analysis/flow/result/report.h"
#include "syntax/diagnostics/diagnostic.h"

#include <string>
#include <string_view>
#include <vector>

namespace proskill::test {

/// A question about a condition that may come true at some time, and what the analysis says.
struct Query {
  std::string condition;
  bool possible = true;
  /// What the engine is asked where a property of ProSkill cannot say it: a variable of the model,
  /// and its value.
  std::string variable{};
  std::int64_t value = 0;
};

/// All that can be asked about a program and is answered by the analysis: values everywhere, inside
/// of skills and at labels; skills that run at once; events; how many have taken a resource.
[[nodiscard]] std::vector<Query> questionsOf(const analysis::flow::Report& report,
                                             const std::vector<syntax::Diagnostic>& found);

/// The words of a message that stand in backquotes.
[[nodiscard]] std::vector<std::string> quoted(const std::string& message);

} // namespace proskill::test
