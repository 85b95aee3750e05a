#include "analysis/checks/cases.h"

#include "analysis/program/outcomes.h"
#include "syntax/diagnostics/codes.h"
#include "syntax/tree/enumerate.h"
#include "syntax/tree/statements.h"

#include <algorithm>

namespace proskill::analysis {

using syntax::Arm;
using syntax::Code;

namespace {

constexpr std::string_view kStatuses[] = {"success",     "failure", "failed_inv",
                                          "interrupted", "refused", "else"};

SymbolKind kindOfTag(std::string_view status) {
  if (status == "success") return SymbolKind::SuccessTag;
  return status == "failure" ? SymbolKind::FailureTag : SymbolKind::InvariantTag;
}

class CaseCheck {
public:
  CaseCheck(Context& context, const Body& body, const syntax::Statement& statement)
      : context(context), body(body), statement(statement), names(context, body.file) {}

  void check(const syntax::Statement& call) {
    const SymbolId callee = context.symbols.find(SymbolKind::Skill, call.head.text);
    bool understood = callee != kNoSymbol;
    for (const Arm& arm : statement.arms) understood &= useNames(arm, callee);
    if (!understood) return; // already reported
    left = outcomesOf(context.program.skills.all[context.symbols[callee].definition].node());
    for (const Arm& arm : statement.arms) take(arm, call.head);
    if (!left.empty()) reportMissing();
  }

private:
  /// \return whether all tags are known
  bool useNames(const Arm& arm, SymbolId callee) {
    const auto& [status, tags, range] = arm.pattern;
    names.useStatus(status, kStatuses);
    if (callee == kNoSymbol || std::ranges::find(kStatuses, status.text) == std::end(kStatuses))
      return false;
    bool known = true;
    for (const auto& tag : tags)
      known &= names.use(kindOfTag(status.text), tag, Role::Mention, callee) != kNoSymbol;
    return known;
  }

  void take(const Arm& arm, const syntax::Name& callee) {
    const auto before = left.size();
    std::erase_if(left, [&](const auto& outcome) { return matches(arm.pattern, outcome); });
    if (left.size() == before)
      context.findings.report(Code::ArmNeverTaken, {body.file, arm.pattern.range}, callee.text);
  }

  void reportMissing() {
    std::vector<std::string> missing;
    std::string arms;
    for (const auto& outcome : left) {
      missing.push_back(toString(outcome));
      arms += " (" + missing.back() + ")";
    }
    const syntax::Offset end = statement.range.end - 1; // the closing parenthesis
    context.findings
        .report(Code::CaseNotExhaustive, {body.file, statement.head.range},
                syntax::enumerateNames(missing))
        .fix("add the missing arms", {body.file, {end, end}}, arms);
  }

  Context& context;
  const Body& body;
  const syntax::Statement& statement;
  Names names;
  std::vector<CallOutcome> left; ///< outcomes without an arm so far
};

} // namespace

void checkCase(Context& context, const Body& body, const syntax::Statement& statement) {
  if (const auto* call = syntax::callOf(statement))
    CaseCheck(context, body, statement).check(*call);
}

} // namespace proskill::analysis
