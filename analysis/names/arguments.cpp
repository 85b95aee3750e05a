#include "analysis/names/arguments.h"
#include "syntax/diagnostics/codes.h"
#include "syntax/text/quote.h"
#include "syntax/tree/enumerate.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace proskill::analysis {

using syntax::Argument;
using syntax::Code;
using syntax::Expr;
using syntax::ExprKind;
using syntax::Input;
using syntax::Statement;

namespace {

const Input* find(const syntax::List<Input>& inputs, std::string_view name) {
  auto found =
      std::ranges::find(inputs, name, [](const Input& it) { return withoutDollar(it.name).text; });
  return found == inputs.end() ? nullptr : &*found;
}

} // namespace

const syntax::Skill& Arguments::skill(SymbolId symbol) const {
  return context.program.skills.all[context.symbols[symbol].definition].node();
}

Type Arguments::type(const Expr& argument, Type wanted) {
  switch (argument.kind) {
  case ExprKind::Missing: return {};
  case ExprKind::Number: return number(argument, wanted);
  case ExprKind::String: return {TypeKind::String, kNoSymbol};
  case ExprKind::True:
  case ExprKind::False: return {TypeKind::Boolean, kNoSymbol};
  case ExprKind::Parameter: return parameter(argument.name);
  case ExprKind::Symbol:
    if (wanted.kind == TypeKind::Value) {
      names.use(SymbolKind::Value, argument.name, Role::Mention, wanted.of);
      return wanted;
    }
    if (!mayBeConstant(argument.name, wanted)) break;
    names.use(SymbolKind::Constant, argument.name, Role::Read);
    return {};
  case ExprKind::Access:
  case ExprKind::Test:
  case ExprKind::Equal:
  case ExprKind::NotEqual:
  case ExprKind::Less:
  case ExprKind::LessEqual:
  case ExprKind::Greater:
  case ExprKind::GreaterEqual:
  case ExprKind::And:
  case ExprKind::Or:
  case ExprKind::Not:
  case ExprKind::Implies:
  case ExprKind::Equivalent:
  case ExprKind::Add:
  case ExprKind::Subtract:
  case ExprKind::Running:
  case ExprKind::Called:
  case ExprKind::Ended:
  case ExprKind::Occurs:
  case ExprKind::At:
  case ExprKind::Value:
  case ExprKind::Globally:
  case ExprKind::Finally:
  case ExprKind::Next:
  case ExprKind::Until:
  case ExprKind::WeakUntil:
  case ExprKind::Release:
  case ExprKind::StrongRelease: break;
  }
  notLiteral(argument, wanted);
  return {};
}

/// A word that is not a state variable may have been meant as a text.
void Arguments::notLiteral(const Expr& argument, Type wanted) {
  auto finding = context.findings.report(Code::ArgumentNotLiteral, {file, argument.range});
  const bool mayBeText = !wanted.known() || wanted.kind == TypeKind::String;
  if (argument.kind != ExprKind::Symbol || !mayBeText) return;
  const auto word = argument.name.text;
  if (context.symbols.find(SymbolKind::StateVariable, word) != kNoSymbol) return;
  finding.fix("write it in quotes, as a string", {file, argument.range},
              fmt::format("\"{}\"", word));
}

/// Whether an unknown word may have been meant as a constant. Known constants have their numbers
/// already, unless the program is a fragment.
bool Arguments::mayBeConstant(const syntax::Name& word, Type wanted) const {
  if (context.symbols.find(SymbolKind::StateVariable, word.text) != kNoSymbol) return false;
  return isNumber(wanted.kind) || (!wanted.known() && context.program.extent == Extent::Fragment);
}

/// A natural may be a value of a state variable; this checks whether it is.
Type Arguments::number(const Expr& argument, Type wanted) {
  const Type type = typeOfNumber(argument);
  if (type.kind != TypeKind::Natural || wanted.kind != TypeKind::Natural) return type;
  names.checkDomain(argument, wanted);
  return wanted;
}

Type Arguments::parameter(const syntax::Name& name) {
  const SymbolId symbol = names.useParameter(name, Role::Read, caller);
  if (symbol == kNoSymbol) return {};
  const Input* input = find(skill(caller).inputs, context.symbols[symbol].name);
  return input ? typeNamed(context.program, context.symbols, input->type.text) : Type{};
}

void Arguments::checkCall(const Statement& call, SymbolId callee) {
  if (const auto* argument = unnamed(call, callee)) return suggestName(call, callee, *argument);
  checkNames(call, callee);
  checkTypes(call, callee);
}

/// The argument whose name was forgotten, if there is only one and one input is not given.
const Argument* Arguments::unnamed(const Statement& call, SymbolId callee) const {
  const auto& inputs = skill(callee).inputs;
  const auto isNamed = [&](const Argument& it) { return find(inputs, it.name.text) != nullptr; };
  const auto found = std::ranges::find_if_not(call.arguments, isNamed);
  if (found == call.arguments.end()) return nullptr;
  const bool isValue = found->name.text.empty() || found->value.kind == ExprKind::Missing;
  const bool isOnly = std::all_of(std::next(found), call.arguments.end(), isNamed);
  return isValue && isOnly && absentInputs(call, callee).size() == 1 ? &*found : nullptr;
}

void Arguments::suggestName(const Statement& call, SymbolId callee, const Argument& argument) {
  const auto name = absentInputs(call, callee).front();
  const Symbol& symbol = context.symbols[callee];
  context.findings.forgetArguments({file, call.range});
  context.findings
      .report(Code::MissingArgument, {file, argument.range}, symbol.name, syntax::backquoted(name))
      .related(symbol.at, "defined here")
      .fix(fmt::format("write the name `{}` before the value", name),
           {file, {argument.range.begin, argument.range.begin}}, fmt::format("{} ", name));
}

/// Reports unknown names of inputs. The input that was meant is then not reported as missing.
void Arguments::checkNames(const Statement& call, SymbolId callee) {
  std::map<std::string_view, syntax::Range> given;
  bool complete = true;
  for (const Argument& argument : call.arguments) {
    const auto symbol = names.useParameter(argument.name, Role::Mention, callee);
    complete &= symbol != kNoSymbol;
    auto [first, isNew] = given.try_emplace(argument.name.text, argument.name.range);
    if (!isNew && symbol != kNoSymbol)
      context.findings
          .report(Code::RepeatedArgument, {file, argument.name.range}, argument.name.text)
          .related({file, first->second}, "first given here");
  }
  if (complete && given.size() < skill(callee).inputs.size()) missing(call, callee);
}

std::vector<std::string_view> Arguments::absentInputs(const Statement& call,
                                                      SymbolId callee) const {
  std::vector<std::string_view> absent;
  for (const Input& input : skill(callee).inputs) {
    const auto name = withoutDollar(input.name).text;
    const bool given = std::ranges::any_of(
        call.arguments, [&](const Argument& it) { return it.name.text == name; });
    if (!given && !name.empty() && std::ranges::find(absent, name) == absent.end())
      absent.push_back(name);
  }
  return absent;
}

void Arguments::missing(const Statement& call, SymbolId callee) {
  const auto absent = absentInputs(call, callee);
  if (absent.empty()) return;
  const Symbol& symbol = context.symbols[callee];
  context.findings
      .report(Code::MissingArgument, {file, call.head.range}, symbol.name,
              syntax::enumerateNames(absent))
      .related(symbol.at, "defined here");
}

void Arguments::checkTypes(const Statement& call, SymbolId callee) {
  for (const Argument& argument : call.arguments) {
    const Input* input = find(skill(callee).inputs, argument.name.text);
    const Type wanted =
        input ? typeNamed(context.program, context.symbols, input->type.text) : Type{};
    if (!input && argument.value.kind != ExprKind::Parameter) continue;
    // it may be a value of the input's type, which is unknown and was reported
    if (!wanted.known() && argument.value.kind == ExprKind::Symbol) continue;
    const Type given = type(argument.value, wanted);
    if (fits(given, wanted)) continue;
    context.findings
        .report(Code::ArgumentType, {file, argument.value.range}, argument.name.text,
                describe(wanted, context.symbols), describe(given, context.symbols))
        .related({context.symbols[callee].at.file, input->range}, "declared here");
  }
}

} // namespace proskill::analysis
