#pragma once

#include "analysis/names/symbols.h"
#include "syntax/diagnostics/codes.h"

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace proskill::analysis {

/// A diagnostic that is being written: `findings.report(…).related(…).suggest(…)`.
class Finding {
public:
  explicit Finding(syntax::Diagnostic& diagnostic) : diagnostic(diagnostic) {}

  Finding& related(syntax::Location at, std::string_view message);
  /// Adds "did you mean …?" with a fix, unless the word is empty.
  Finding& suggest(std::string_view word);
  /// Adds a fix.
  Finding& fix(std::string_view title, syntax::Location at, std::string text);
  Finding& severity(syntax::Severity value);

private:
  syntax::Diagnostic& diagnostic;
};

/// A name that cannot be resolved. Whether several of them are one error is decided when all
/// definitions are known.
struct UnknownName {
  syntax::CodeFor<2> code; ///< its message takes the name and the owner's name
  std::string text;
  Location at;
  SymbolId owner = kNoSymbol;    ///< the scope in which it was looked up; kNoSymbol: the program
  std::vector<SymbolKind> kinds; ///< the kinds of symbols that it may be
  bool anywhere = false;         ///< in the scope of any owner
  std::span<const std::string_view> words{}; ///< words of the language that are allowed there
};

/// The findings of a check.
struct Found {
  std::vector<syntax::Diagnostic> diagnostics;
  std::vector<syntax::Location> notCalls; ///< calls whose diagnostics about arguments are withdrawn
  std::vector<UnknownName> unknown;       ///< reported when all are known
};

/// Collects the findings of checks.
class Findings {
public:
  Findings() = default;
  explicit Findings(std::vector<syntax::Diagnostic> known) : found{std::move(known), {}, {}} {}

  /// \param arguments for the message of the code, in its order
  template <class... Arguments>
  Finding report(syntax::CodeFor<sizeof...(Arguments)> code, syntax::Location at,
                 const Arguments&... arguments) {
    found.diagnostics.push_back(syntax::makeDiagnostic(code, at, arguments...));
    return Finding(found.diagnostics.back());
  }

  /// Withdraws the diagnostics about the arguments of a call that turned out not to be a call.
  void forgetArguments(syntax::Location call) { found.notCalls.push_back(call); }

  void unknown(UnknownName name) { found.unknown.push_back(std::move(name)); }

  void add(const Found& more);
  [[nodiscard]] const std::vector<UnknownName>& unknownNames() const { return found.unknown; }
  /// The findings in the order in which they were reported.
  [[nodiscard]] Found asFound() && { return std::move(found); }

  /// The findings in the order of the files and their texts.
  [[nodiscard]] std::vector<syntax::Diagnostic> inOrder() &&;

private:
  void dropForgotten();

  Found found;
};

} // namespace proskill::analysis
