#pragma once

#include "syntax/diagnostic.h"
#include "syntax/suggest.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace proskill::analysis {

/// A diagnostic that is being written: `findings.report(…).related(…).suggest(…)`.
class Finding {
public:
  explicit Finding(syntax::Diagnostic& diagnostic) : diagnostic(diagnostic) {}

  Finding& related(syntax::Location at, std::string message);
  /// "did you mean …?", where there is a word that is near enough.
  Finding& suggest(const syntax::Suggestion& suggestion);
  /// The edit that mends it.
  Finding& fix(std::string title, syntax::Location at, std::string text);
  Finding& severity(syntax::Severity value);

private:
  syntax::Diagnostic& diagnostic;
};

/// What a check has found.
struct Found {
  std::vector<syntax::Diagnostic> diagnostics;
  std::vector<syntax::Location> notCalls; ///< what the parser says of their arguments is no matter
};

/// Collects what the checks find.
class Findings {
public:
  Findings() = default;
  explicit Findings(std::vector<syntax::Diagnostic> known) : found{std::move(known), {}} {}

  /// `arguments` are for the message of the code, in its order.
  template <class... Arguments>
  Finding report(syntax::Code code, syntax::Location at, const Arguments&... arguments) {
    found.diagnostics.push_back(syntax::makeDiagnostic(code, at, arguments...));
    return Finding(found.diagnostics.back());
  }

  /// What is said about the form of this call's arguments is taken back: it is no call.
  void forgetArguments(syntax::Location call) { found.notCalls.push_back(call); }

  void add(const Found& more);
  /// All of them as they were reported.
  [[nodiscard]] Found asFound() && { return std::move(found); }

  /// All of them in the order of the files and of their texts.
  [[nodiscard]] std::vector<syntax::Diagnostic> inOrder() &&;

private:
  void dropForgotten();

  Found found;
};

} // namespace proskill::analysis
