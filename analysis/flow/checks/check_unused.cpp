#include "analysis/flow/checks/checks.h"
#include "syntax/diagnostics/codes.h"

#include <algorithm>
#include <fmt/format.h>

/// Finds definitions that the program does not need.
namespace proskill::analysis::flow {

namespace {

using syntax::Code;

class Unused {
public:
  explicit Unused(Report& report) : report(report), symbols(report.index.symbols()) {}

  void check() {
    for (SymbolId id = 0; id < symbols.all().size(); ++id) {
      const Symbol& symbol = symbols[id];
      switch (symbol.kind) {
      case SymbolKind::StateVariable: checkVariable(id, symbol); break;
      case SymbolKind::Resource:
        if (!isNamed(id)) reportRemovable(Code::UnusedResource, symbol);
        break;
      case SymbolKind::Constant:
        if (!isNamed(id)) reportRemovable(Code::UnusedConstant, symbol);
        break;
      case SymbolKind::Label:
        if (!isNamed(id)) reportRemovable(Code::UnusedLabel, symbol);
        break;
      case SymbolKind::Parameter: reportUnless(isRead(id), Code::UnusedInput, symbol); break;
      case SymbolKind::Skill:
        reportUnless(isNamed(id) || isStarted(symbol.definition), Code::UnusedSkill, symbol);
        break;
      case SymbolKind::Event:
        reportUnless(isNamed(id) || report.system().isFree(symbol.definition), Code::UnusedEvent,
                     symbol);
        break;
      case SymbolKind::Property:
      case SymbolKind::Environment:
      case SymbolKind::Value:
      case SymbolKind::PreconditionTag:
      case SymbolKind::InvariantTag:
      case SymbolKind::SuccessTag:
      case SymbolKind::FailureTag: break;
      }
    }
  }

private:
  void reportUnless(bool used, syntax::CodeFor<1> code, const Symbol& symbol) {
    if (!used) report.findings.report(code, symbol.at, symbol.name);
  }

  /// Reports a definition without references, which can be removed.
  void reportRemovable(syntax::CodeFor<1> code, const Symbol& symbol) {
    report.findings.report(code, symbol.at, symbol.name)
        .fix(fmt::format("remove `{}`", symbol.name),
             withSpaceAround(report, {symbol.at.file, symbol.extent}), "");
  }

  /// A variable that is never set has a finding of its own.
  void checkVariable(SymbolId id, const Symbol& symbol) {
    if (isNamed(id)) return;
    reportRemovable(Code::UnusedStateVariable, symbol);
    report.told.insert(report.variables().of(VariableKind::StateVariable, symbol.definition));
  }

  [[nodiscard]] bool isNamed(SymbolId id) const {
    return std::ranges::any_of(report.index.occurrencesOf(id), [](const Occurrence& each) {
      return each.role != Role::Definition;
    });
  }

  [[nodiscard]] bool isRead(SymbolId id) const {
    return std::ranges::any_of(report.index.occurrencesOf(id),
                               [](const Occurrence& each) { return each.role == Role::Read; });
  }

  [[nodiscard]] bool isStarted(std::size_t skill) const {
    const System& system = report.system();
    return system[system.ofSkill(skill)].analysed;
  }

  Report& report;
  const SymbolTable& symbols;
};

} // namespace

void checkUnused(Report& report) { Unused(report).check(); }

} // namespace proskill::analysis::flow
