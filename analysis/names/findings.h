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
  /// "did you mean …?", where the word is not empty.
  Finding& suggest(std::string_view word);
  /// The edit that mends it.
  Finding& fix(std::string_view title, syntax::Location at, std::string text);
  Finding& severity(syntax::Severity value);

private:
  syntax::Diagnostic& diagnostic;
};

/// A name that means nothing where it stands. Whether that is one mistake or several is known of
/// all definitions together.
struct UnknownName {
  syntax::CodeFor<2> code; ///< its message is given the text, and the owner's name
  std::string text;
  Location at;
  SymbolId owner = kNoSymbol;                ///< of whose names it is none; none: of the program's
  std::vector<SymbolKind> kinds;             ///< what it might be
  bool anywhere = false;                     ///< whoever the owner is
  std::span<const std::string_view> words{}; ///< of the language, that may stand there
};

/// What a check has found.
struct Found {
  std::vector<syntax::Diagnostic> diagnostics;
  std::vector<syntax::Location> notCalls; ///< what the parser says of their arguments is no matter
  std::vector<UnknownName> unknown;       ///< which is told when all are known
};

/// Collects what the checks find.
class Findings {
public:
  Findings() = default;
  explicit Findings(std::vector<syntax::Diagnostic> known) : found{std::move(known), {}, {}} {}

  /// `arguments` are for the message of the code, in its order.
  template <class... Arguments>
  Finding report(syntax::CodeFor<sizeof...(Arguments)> code, syntax::Location at,
                 const Arguments&... arguments) {
    found.diagnostics.push_back(syntax::makeDiagnostic(code, at, arguments...));
    return Finding(found.diagnostics.back());
  }

  /// What is said about the form of this call's arguments is taken back: it is no call.
  void forgetArguments(syntax::Location call) { found.notCalls.push_back(call); }

  void unknown(UnknownName name) { found.unknown.push_back(std::move(name)); }

  void add(const Found& more);
  [[nodiscard]] const std::vector<UnknownName>& unknownNames() const { return found.unknown; }
  /// All of them as they were reported.
  [[nodiscard]] Found asFound() && { return std::move(found); }

  /// All of them in the order of the files and of their texts.
  [[nodiscard]] std::vector<syntax::Diagnostic> inOrder() &&;

private:
  void dropForgotten();

  Found found;
};

} // namespace proskill::analysis
