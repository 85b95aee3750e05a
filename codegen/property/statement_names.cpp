#include "codegen/property/statement_names.h"

#include "syntax/tree/statements.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace proskill::codegen {
namespace {

using Kind = syntax::StatementKind;

std::string_view wordFor(Kind kind) {
  switch (kind) {
  case Kind::Unknown: return "statement";
  case Kind::Call: return "call";
  case Kind::Interrupt: return "interrupt";
  case Kind::WaitCondition: return "wait";
  case Kind::WaitTime: return "delay";
  case Kind::If: return "if";
  case Kind::Case: return "case";
  case Kind::While: return "while";
  case Kind::DoUntil: return "do";
  case Kind::Break: return "break";
  case Kind::Label: return "label";
  case Kind::Goto: return "goto";
  case Kind::Parallel: return "parallel";
  case Kind::Race: return "race";
  case Kind::Set: return "set";
  case Kind::Printf: return "printf";
  case Kind::Success: return "success";
  case Kind::Failure: return "failure";
  case Kind::Emit: return "emit";
  case Kind::Choose: return "choose";
  }
  std::unreachable();
}

/// The first name in the condition.
std::string_view firstName(const syntax::Expr& condition) {
  if (!condition.name.text.empty()) return condition.name.text;
  for (const auto& operand : condition.operands)
    if (auto found = firstName(operand); !found.empty()) return found;
  return {};
}

/// The single thing that the statement is about, if any.
std::string_view objectOf(const syntax::Statement& statement) {
  switch (statement.kind) {
  case Kind::Call: return statement.head.text;
  case Kind::Case: return syntax::callOf(statement)->head.text;
  case Kind::Interrupt:
  case Kind::Label:
  case Kind::Goto:
  case Kind::Success:
  case Kind::Failure:
  case Kind::Emit: return statement.name.text;
  case Kind::WaitCondition:
  case Kind::While:
  case Kind::DoUntil: return firstName(statement.condition);
  case Kind::If:
    return statement.arms.empty() || !statement.arms[0].condition
               ? std::string_view{}
               : firstName(*statement.arms[0].condition);
  case Kind::Set:
    return statement.effects.items.empty() ? std::string_view{}
                                           : statement.effects.items[0].variable.text;
  case Kind::Unknown:
  case Kind::WaitTime:
  case Kind::Break:
  case Kind::Parallel:
  case Kind::Race:
  case Kind::Printf:
  case Kind::Choose: return {};
  }
  std::unreachable();
}

std::vector<const syntax::Statement*> statementsOf(const BodyAutomaton& body) {
  std::vector<const syntax::Statement*> all;
  forEachThread(body, [&](const BodyAutomaton& thread) {
    for (const auto& state : thread.states)
      if (state.statement) all.push_back(&state.source());
  });
  std::ranges::sort(all, {}, [](const syntax::Statement* each) { return each->range.begin; });
  return all;
}

} // namespace

StatementNames::StatementNames(const BodyAutomaton& body) {
  std::map<std::string, std::size_t> counts;
  for (const auto* statement : statementsOf(body)) {
    const auto object = objectOf(*statement);
    auto name = std::string(wordFor(statement->kind));
    if (!object.empty()) name += fmt::format("[{}]", object);
    const auto count = ++counts[name];
    names[statement] = count == 1 ? name : fmt::format("{}.{}", name, count);
  }
}

} // namespace proskill::codegen
