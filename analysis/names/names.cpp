#include "analysis/names/names.h"
#include "syntax/diagnostics/codes.h"
#include "syntax/diagnostics/suggest.h"

#include <algorithm>

namespace proskill::analysis {

using syntax::Code;
using syntax::Name;

namespace {

syntax::CodeFor<2> unknownCode(SymbolKind kind) {
  switch (kind) {
  case SymbolKind::StateVariable: return Code::UnknownStateVariable;
  case SymbolKind::Event: return Code::UnknownEvent;
  case SymbolKind::Resource: return Code::UnknownResource;
  case SymbolKind::Constant: return Code::UnknownConstant;
  case SymbolKind::Value: return Code::UnknownValue;
  case SymbolKind::Parameter: return Code::UnknownParameter;
  case SymbolKind::Label: return Code::UnknownLabel;
  case SymbolKind::PreconditionTag:
  case SymbolKind::InvariantTag:
  case SymbolKind::SuccessTag:
  case SymbolKind::FailureTag: return Code::UnknownTag;
  case SymbolKind::Skill:
  case SymbolKind::Property:
  case SymbolKind::Environment: break;
  }
  return Code::UnknownSkill;
}

bool isNumber(const std::optional<syntax::Expr>& expr) {
  return expr && expr->kind == syntax::ExprKind::Number;
}

constexpr std::string_view kStatementWords[] = {"if",      "case", "while",  "do",     "break",
                                                "label",   "goto", "set",    "printf", "success",
                                                "failure", "emit", "choose", "race"};

} // namespace

std::span<const std::string_view> statementWords() { return kStatementWords; }

SymbolId Names::use(SymbolKind kind, const Name& name, Role role, SymbolId owner) {
  if (!name) return kNoSymbol;
  const SymbolId symbol = context.symbols.find(kind, name.text, owner);
  if (symbol == kNoSymbol)
    unknown(kind, name, owner);
  else
    note(symbol, name, role);
  return symbol;
}

SymbolId Names::useOperand(const Name& name) {
  if (!name) return kNoSymbol;
  const SymbolId symbol = context.symbols.find(SymbolKind::StateVariable, name.text);
  if (symbol != kNoSymbol) {
    note(symbol, name, Role::Read);
    return symbol;
  }
  context.findings.unknown({.code = Code::UnknownStateVariable,
                            .text = std::string(name.text),
                            .at = {file, name.range},
                            .kinds = {SymbolKind::StateVariable, SymbolKind::Constant}});
  return kNoSymbol;
}

SymbolId Names::useParameter(const Name& name, Role role, SymbolId skill) {
  return use(SymbolKind::Parameter, withoutDollar(name), role, skill);
}

void Names::checkDomain(const syntax::Expr& number, Type type) {
  if (type.kind != TypeKind::Natural || type.of == kNoSymbol) return;
  const Symbol& variable = context.symbols[type.of];
  const auto& definition = context.program.stateVariables.all[variable.definition];
  if (!isNumber(definition->min) || !isNumber(definition->max)) return;
  const syntax::Rational least = definition->min->number, most = definition->max->number;
  if (least > most || (least <= number.number && number.number <= most)) return;
  context.findings
      .report(Code::OutOfDomain, {file, number.range}, toString(number.number), variable.name,
              toString(least), toString(most))
      .related(variable.at, "defined here");
}

void Names::note(SymbolId symbol, const Name& name, Role role) {
  context.occurrences.push_back({symbol, {file, name.range}, role});
}

void Names::unknown(SymbolKind kind, const Name& name, SymbolId owner) {
  context.findings.unknown(
      {.code = unknownCode(kind),
       .text = std::string(name.text),
       .at = {file, name.range},
       .owner = owner,
       .kinds = {kind},
       // a call of an unknown skill may be a misspelt statement
       .words = kind == SymbolKind::Skill ? kStatementWords : std::span<const std::string_view>()});
}

void Names::useResult(const Name& tag, SymbolId skill) {
  if (!tag || tag.text == kNoResult) return;
  if (const SymbolId symbol = context.symbols.findResult(tag.text, skill); symbol != kNoSymbol)
    return note(symbol, tag, Role::Mention);
  context.findings.unknown(
      {.code = Code::UnknownTag,
       .text = std::string(tag.text),
       .at = {file, tag.range},
       .owner = skill,
       .kinds = {SymbolKind::SuccessTag, SymbolKind::FailureTag, SymbolKind::InvariantTag}});
}

void Names::useStatus(const Name& word, std::span<const std::string_view> allowed) {
  if (!word || std::ranges::find(allowed, word.text) != allowed.end()) return;
  context.findings.report(Code::UnknownStatus, {file, word.range}, word.text)
      .suggest(syntax::nearest(word.text, allowed));
}

void Names::useLabelAnywhere(const Name& label) {
  if (!label) return;
  const auto labels = context.symbols.labels(label.text);
  for (SymbolId symbol : labels) note(symbol, label, Role::Mention);
  if (!labels.empty()) return;
  context.findings.unknown({.code = Code::UnknownLabel,
                            .text = std::string(label.text),
                            .at = {file, label.range},
                            .kinds = {SymbolKind::Label},
                            .anywhere = true});
}

Type Names::useType(const Name& name) {
  if (!name) return {};
  const Type type = typeNamed(context.program, context.symbols, name.text);
  const SymbolId variable = context.symbols.find(SymbolKind::StateVariable, name.text);
  const bool isVariable = variable != kNoSymbol && (type.of == variable || !type.known());
  if (isVariable) note(variable, name, Role::Mention);
  if (type.known() || isVariable) return type;
  context.findings.unknown({.code = Code::UnknownType,
                            .text = std::string(name.text),
                            .at = {file, name.range},
                            .kinds = {SymbolKind::StateVariable},
                            .words = basicTypeWords()});
  return {};
}

} // namespace proskill::analysis
