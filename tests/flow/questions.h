#pragma once

#include "analysis/flow/result/report.h"
#include "syntax/diagnostics/diagnostic.h"

#include <string>
#include <string_view>
#include <vector>

namespace proskill::test {

/// A question whether a condition can become true, and the answer of the analysis.
struct Query {
  std::string condition;
  bool possible = true;
  /// A question to the engine that a property of ProSkill cannot express: a variable of the model,
  /// and its value.
  std::string variable{};
  std::int64_t value = 0;
};

/// All questions about a program that the analysis answers: values everywhere, within skills and at
/// labels; parallel skills; events; amounts of resources taken.
[[nodiscard]] std::vector<Query> questionsOf(const analysis::flow::Report& report,
                                             const std::vector<syntax::Diagnostic>& found);

/// The words in backquotes in a message.
[[nodiscard]] std::vector<std::string> quoted(const std::string& message);

} // namespace proskill::test
