#include "analysis/flow/checks/checks.h"

#include "analysis/names/walk.h"
#include "syntax/diagnostics/codes.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <map>
#include <set>

/// Hints of style.
namespace proskill::analysis::flow {

namespace {

using syntax::Code;
using syntax::Expr;
using syntax::ExprKind;

std::string lowered(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

/// All tags of a skill's outcomes are compared with `.res`, so they form one family.
SymbolKind family(SymbolKind kind) {
  bool ends = kind == SymbolKind::FailureTag || kind == SymbolKind::InvariantTag;
  return ends ? SymbolKind::SuccessTag : kind;
}

/// Finds similar names of one kind and owner, which readers may confuse.
/// \return the names that were reported
std::set<const Symbol*> checkSimilarNames(Report& report) {
  std::set<const Symbol*> told;
  std::map<std::tuple<SymbolKind, SymbolId, std::string>, const Symbol*> known;
  for (const Symbol& symbol : report.index.symbols().all()) {
    auto [place, isNew] =
        known.try_emplace({family(symbol.kind), symbol.owner, lowered(symbol.name)}, &symbol);
    if (isNew || place->second->name == symbol.name) continue;
    report.findings.report(Code::SimilarNames, symbol.at, symbol.name, place->second->name)
        .related(place->second->at, "the other one");
    told.insert({&symbol, place->second});
  }
  return told;
}

/// Values are capitalised, constants may be, all other names are not.
void checkNaming(Report& report, const std::set<const Symbol*>& told) {
  for (const Symbol& symbol : report.index.symbols().all()) {
    if (symbol.name.empty() || told.contains(&symbol)) continue;
    const bool isValue = symbol.kind == SymbolKind::Value;
    if (isValue && std::islower(static_cast<unsigned char>(symbol.name.front())) != 0)
      report.findings.report(Code::ValueWithoutCapital, symbol.at, symbol.name);
    const bool mayHave = isValue || symbol.kind == SymbolKind::Constant;
    if (!mayHave && lowered(symbol.name) != symbol.name)
      report.findings.report(Code::NameNotLowerCase, symbol.at, symbol.name);
  }
}

/// Finds `(= battery Good)`, which can be written `(battery Good)`.
class Equalities {
public:
  Equalities(Report& report, FileId file) : report(report), file(file) {}

  void visit(const Expr& expr) {
    for (const Expr& operand : expr.operands) visit(operand);
    if (expr.kind != ExprKind::Equal || expr.operands.size() != 2) return;
    const Expr& variable = expr.operands[0];
    const Expr& value = expr.operands[1];
    if (variable.kind != ExprKind::Symbol) return;
    auto id = report.system().resolver().stateVariable(variable.name.text);
    if (!id || !isValue(report.variables()[*id].domain, value)) return;
    std::string better = fmt::format("({} {})", variable.name.text, text(value.range));
    report.findings.report(Code::EqualityReadsLonger, {file, expr.range}, better)
        .fix(fmt::format("write `{}`", better), {file, expr.range}, better);
  }

  void visit(const syntax::Block& body) {
    forEachStatement(body, [this](const syntax::Statement& statement) {
      visit(statement.condition);
      for (const auto& arm : statement.arms)
        if (arm.condition) visit(*arm.condition);
    });
  }

  void visit(const syntax::Skill& skill) {
    for (const auto& each : skill.preconditions) visit(each.condition);
    for (const auto& each : skill.invariants) visit(each.guard);
    for (const auto* outcomes : {&skill.successes, &skill.failures})
      for (const auto& each : *outcomes)
        if (each.postcondition) visit(*each.postcondition);
    if (skill.body) visit(*skill.body);
  }

  void visit(const syntax::Property& property) {
    for (const Expr& operand : property.operands) visit(operand);
    if (property.after) visit(*property.after);
    if (property.before) visit(*property.before);
  }

private:
  /// Numbers are excluded: they read well with `=`.
  static bool isValue(const Domain& domain, const Expr& value) {
    return !domain.isNumeric() && value.kind == ExprKind::Symbol &&
           domain.numberOf(value.name.text).has_value();
  }

  [[nodiscard]] std::string_view text(syntax::Range range) const {
    return std::string_view(report.program.files[file].document.text())
        .substr(range.begin, range.length());
  }

  Report& report;
  FileId file;
};

} // namespace

void checkStyle(Report& report) {
  checkNaming(report, checkSimilarNames(report));
  for (const auto& skill : report.program.skills.all)
    Equalities(report, skill.file).visit(skill.node());
  for (const auto& environment : report.program.environments.all)
    Equalities(report, environment.file).visit(environment->body);
  for (const auto& property : report.program.properties.all)
    Equalities(report, property.file).visit(property.node());
}

} // namespace proskill::analysis::flow
