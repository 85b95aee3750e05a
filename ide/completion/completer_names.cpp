#include "ide/completion/completer.h"
#include "ide/description/describe.h"
#include "syntax/text/natural.h"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace proskill::ide {

namespace {

using analysis::kNoSymbol;
using analysis::SymbolId;
using analysis::SymbolKind;

/// `${1|A,B|}`, or empty if there is nothing to choose.
std::string choice(unsigned number, const syntax::List<syntax::Name>& values) {
  std::string all;
  for (const auto& value : values)
    if (value) all += fmt::format("{}{}", all.empty() ? "" : ",", value.text);
  return all.empty() ? fmt::format("${{{}}}", number) : fmt::format("${{{}|{}|}}", number, all);
}

std::string_view placeholderOf(std::string_view type) {
  if (type == "float") return "0.0";
  if (type == kTruthValue) return "true";
  return "0";
}

bool takesNumbers(std::string_view type) {
  return type == "int" || type == "nat" || type == "float";
}

} // namespace

/// Completes where names of the program are allowed.
void Completer::fillNames() {
  switch (place.slot) {
  case Slot::InitialValue: return values(place.subject);
  case Slot::VariableValue:
  case Slot::EffectValue: values(place.subject); return inputs(place.subject);
  case Slot::Transition: return values(place.subject);
  case Slot::InputType: return types();
  case Slot::Command: return command();
  case Slot::CommandArgument: parameters(); return constants();
  case Slot::Resource: return resources();
  case Slot::Effects:
  case Slot::EffectItem: return variables(false);
  case Slot::Operand: return operands();
  case Slot::Number: return numbers();
  case Slot::Constant: return constants();
  case Slot::Label: return members(SymbolKind::Label, owner(), CompletionKind::Label);
  case Slot::AnyLabel: return anyLabels();
  case Slot::SuccessTag: return members(SymbolKind::SuccessTag, owner(), CompletionKind::Tag);
  case Slot::FailureTag: return members(SymbolKind::FailureTag, owner(), CompletionKind::Tag);
  case Slot::Event: return members(SymbolKind::Event, kNoSymbol, CompletionKind::Event);
  case Slot::Skill: return members(SymbolKind::Skill, kNoSymbol, CompletionKind::Skill);
  case Slot::Variable:
    return members(SymbolKind::StateVariable, kNoSymbol, CompletionKind::Variable);
  case Slot::CaseCall: return calls();
  case Slot::CaseTag: return caseTags();
  case Slot::ArgumentName: return argumentNames();
  case Slot::ArgumentValue: return argumentValues();
  case Slot::PrintArgument: parameters(); return operands();
  default: return;
  }
}

Completion& Completer::name(SymbolId symbol, CompletionKind kind) {
  Completion& item = add(std::string(symbols[symbol].name), kind);
  item.symbol = keyOf(symbols, symbol);
  item.isDeprecated = deprecated.contains(symbol);
  return item;
}

void Completer::members(SymbolKind kind, SymbolId owner, CompletionKind as) {
  for (auto id : symbols.members(kind, owner)) {
    const auto text = symbols[id].name;
    if (text.empty() || symbols.find(kind, text, owner) != id) continue;
    name(id, as);
  }
  ++rank;
}

void Completer::values(std::string_view variableName) {
  const auto id = find(SymbolKind::StateVariable, variableName);
  if (id == kNoSymbol) return;
  if (!variable(id).isNatural()) return members(SymbolKind::Value, id, CompletionKind::Value);
  if (place.slot != Slot::Operand) constants();
  if (place.slot != Slot::EffectValue || place.isHead) return;
  for (const char sign : {'+', '-'}) {
    Completion& item = add(fmt::format("({} {} 1)", sign, variableName), CompletionKind::Operator);
    item.snippet = fmt::format("({} {} ${{1:1}})", sign, variableName);
  }
}

/// Completes `battery` within its parentheses; otherwise adds them, with a choice of values.
void Completer::test(SymbolId id) {
  Completion& item = name(id, CompletionKind::Variable);
  item.detail = valuesOf(variable(id));
  if (place.isHead) return;
  const auto& values = variable(id).states;
  item.insert = fmt::format("({})", item.label);
  item.snippet = fmt::format("({} {})", item.label, choice(1, values));
}

void Completer::variables(bool numbersOnly) {
  for (auto id : symbols.members(SymbolKind::StateVariable, kNoSymbol)) {
    const bool isFirst = find(SymbolKind::StateVariable, symbols[id].name) == id;
    if (!isFirst || (numbersOnly && !variable(id).isNatural())) continue;
    if (numbersOnly || place.slot == Slot::Operand || place.slot == Slot::PrintArgument)
      name(id, CompletionKind::Variable).detail = valuesOf(variable(id));
    else
      test(id);
  }
  ++rank;
}

/// Operands that have values come first.
void Completer::operands() {
  const auto dot = place.subject.find('.');
  if (!place.isHead && dot != std::string_view::npos) {
    const auto skillName = place.subject.substr(0, dot);
    if (place.subject.substr(dot) == ".status") return words(WordKind::Status);
    if (place.subject.substr(dot) == ".res") return results(skillName);
  }
  if (place.isHead) return forms(WordKind::Arithmetic);
  const auto type = typeOf(place.subject);
  if (place.subject.starts_with('$') && type == kTruthValue) return truthValues();
  values(type);
  const bool beside = !items.empty();
  inputs(type);
  if (type.empty()) inputs(kTruthValue);
  variables(false);
  if (beside) return;
  constants();
  accesses();
  forms(WordKind::Arithmetic);
}

/// Completes beside an input that is a truth value.
void Completer::truthValues() {
  words(WordKind::Constant);
  inputs(kTruthValue);
}

void Completer::numbers() {
  if (!place.isHead) {
    inputs({});
    variables(true);
  }
  constants();
  forms(WordKind::Arithmetic);
}

void Completer::constants() {
  if (place.isHead) return;
  for (auto id : symbols.members(SymbolKind::Constant, kNoSymbol))
    if (!symbols[id].name.empty() && find(SymbolKind::Constant, symbols[id].name) == id)
      name(id, CompletionKind::Value).detail = signature(view, id);
  ++rank;
}

void Completer::results(std::string_view skillName) {
  const auto id = find(SymbolKind::Skill, skillName);
  if (id == kNoSymbol) return;
  for (auto kind : {SymbolKind::SuccessTag, SymbolKind::FailureTag, SymbolKind::InvariantTag})
    members(kind, id, CompletionKind::Tag);
  words(WordKind::Result);
}

void Completer::accesses() {
  for (const auto* member : {"status", "res"})
    for (auto id : symbols.members(SymbolKind::Skill, kNoSymbol)) {
      if (symbols[id].name.empty()) continue;
      Completion& item = name(id, CompletionKind::Skill);
      item.label = item.insert = item.filter = fmt::format("{}.{}", symbols[id].name, member);
      item.detail = findWord(WordKind::Member, member)->sentence;
    }
  ++rank;
}

/// Completes after the dot of `skill.…`.
void Completer::access() {
  const auto skillName = path.prefix.substr(0, path.prefix.find('.'));
  const auto id = find(SymbolKind::Skill, skillName);
  if (id == kNoSymbol) return;
  const bool isStatement = place.slot == Slot::Statement || place.slot == Slot::IfStatement ||
                           place.slot == Slot::DoStatement || place.slot == Slot::TimeoutStatement;
  for (const Word& member : wordsOf(WordKind::Member))
    if ((member.text == "interrupt") == isStatement) word(member);
}

/// The caller's variable of the same name, otherwise a default of the type.
std::string Completer::argument(const syntax::Input& input, unsigned number) const {
  const auto text = analysis::withoutDollar(input.name).text;
  const auto self = owner();
  if (self != kNoSymbol && symbols.find(SymbolKind::Parameter, text, self) != kNoSymbol)
    return fmt::format("${{{}:\\${}}}", number, text);
  const auto type = find(SymbolKind::StateVariable, input.type.text);
  if (type != kNoSymbol) return choice(number, variable(type).states);
  if (input.type.text == "string") return fmt::format("\"${{{}}}\"", number);
  return fmt::format("${{{}:{}}}", number, placeholderOf(input.type.text));
}

void Completer::call(SymbolId id) {
  Completion& item = name(id, CompletionKind::Skill);
  item.detail = signature(view, id);
  std::string arguments;
  unsigned number = 0;
  for (const auto& input : skill(id).inputs)
    arguments +=
        fmt::format(" {} {}", analysis::withoutDollar(input.name).text, argument(input, ++number));
  item.snippet = item.label + arguments;
  if (place.isHead) return;
  item.insert = fmt::format("({})", item.label);
  item.snippet = fmt::format("({})", item.snippet);
}

void Completer::calls() {
  const auto self = owner();
  for (auto id : symbols.members(SymbolKind::Skill, kNoSymbol)) {
    const bool canBeCalled = id != self && !skill(id).monitor;
    if (canBeCalled && find(SymbolKind::Skill, symbols[id].name) == id) call(id);
  }
  ++rank;
}

/// The tags of the call that begins the surrounding `case`.
void Completer::caseTags() {
  const auto around =
      std::ranges::find_if(path.lists.rbegin(), path.lists.rend(), [](const auto& it) {
        return !it.items.empty() && it.items.front().text == "case";
      });
  if (around == path.lists.rend()) return;
  const auto call = std::ranges::find_if(around->items, &Item::isList);
  if (call == around->items.end()) return;
  const auto text = std::string_view(view.text()).substr(call->range.begin, call->range.length());
  const auto from = std::min(text.find_first_not_of("( \t\r\n"), text.size());
  const auto callee = text.substr(from, text.find_first_of(") \t\r\n", from) - from);
  const auto id = find(SymbolKind::Skill, callee);
  if (id == kNoSymbol) return;
  const auto kind = place.subject == "success"   ? SymbolKind::SuccessTag
                    : place.subject == "failure" ? SymbolKind::FailureTag
                                                 : SymbolKind::InvariantTag;
  members(kind, id, CompletionKind::Tag);
  std::erase_if(items, [&](const Completion& item) { return isInList(item.label); });
}

void Completer::interrupts() {
  for (auto id : symbols.members(SymbolKind::Skill, kNoSymbol)) {
    if (!skill(id).interrupt || id == owner()) continue;
    Completion& item = name(id, CompletionKind::Skill);
    item.label = item.filter = fmt::format("{}.interrupt", symbols[id].name);
    item.insert = place.isHead ? item.label : fmt::format("({})", item.label);
    item.detail = findWord(WordKind::Member, "interrupt")->sentence;
  }
  ++rank;
}

void Completer::argumentNames() {
  const auto id = find(SymbolKind::Skill, place.subject);
  if (id == kNoSymbol) return;
  unsigned number = 0;
  for (const auto& input : skill(id).inputs) {
    const auto text = analysis::withoutDollar(input.name).text;
    const auto symbol = symbols.find(SymbolKind::Parameter, text, id);
    if (symbol == kNoSymbol || isInList(text)) continue;
    Completion& item = name(symbol, CompletionKind::Parameter);
    item.detail = input.type.text;
    item.snippet = fmt::format("{} {}", text, argument(input, ++number));
    ++rank;
  }
}

void Completer::argumentValues() {
  const auto id = find(SymbolKind::Skill, place.subject);
  if (id == kNoSymbol || place.isHead) return parameters();
  for (const auto& input : skill(id).inputs) {
    if (analysis::withoutDollar(input.name).text != place.argument) continue;
    values(input.type.text);
    if (input.type.text == kTruthValue) words(WordKind::Constant);
    if (takesNumbers(input.type.text)) constants();
  }
  parameters();
}

void Completer::parameters() {
  if (owner() == kNoSymbol) return;
  for (auto id : symbols.members(SymbolKind::Parameter, owner())) parameter(id);
  ++rank;
}

void Completer::parameter(SymbolId id) {
  Completion& item = name(id, CompletionKind::Parameter);
  item.label = item.insert = item.filter = fmt::format("${}", symbols[id].name);
  item.snippet = fmt::format("\\{}", item.label);
  item.detail = signature(view, id);
}

/// The skill's inputs that conditions and effects may read; a `printf` takes any input.
/// \param type the state variable whose values they have; empty: any
void Completer::inputs(std::string_view type) {
  if (place.isHead || place.slot == Slot::PrintArgument) return;
  if (place.definition != "defskill" || owner() == kNoSymbol) return;
  for (const auto& input : skill(owner()).inputs) {
    const bool fits = type.empty() ? find(SymbolKind::StateVariable, input.type.text) != kNoSymbol
                                   : input.type.text == type;
    const auto name = analysis::withoutDollar(input.name).text;
    const auto id = symbols.find(SymbolKind::Parameter, name, owner());
    if (fits && id != kNoSymbol) parameter(id);
  }
  ++rank;
}

/// The state variable that an operand is, or whose values it has.
std::string_view Completer::typeOf(std::string_view operand) const {
  if (!operand.starts_with('$') || place.definition != "defskill" || owner() == kNoSymbol)
    return operand;
  for (const auto& input : skill(owner()).inputs)
    if (input.name.text == operand) return input.type.text;
  return operand;
}

/// The platform's commands are unknown, but most skills have the name of their command.
void Completer::command() {
  if (place.owner.empty()) return;
  Completion& item = add(std::string(place.owner), CompletionKind::Skill);
  std::string arguments;
  if (const auto self = owner(); self != kNoSymbol)
    for (const auto& input : skill(self).inputs) arguments += fmt::format(" {}", input.name.text);
  item.insert += arguments;
  if (!place.isHead) item.insert = fmt::format("({})", item.insert);
}

void Completer::anyLabels() {
  for (SymbolId id = 0; id < symbols.all().size(); ++id) {
    const bool isFirst =
        symbols[id].kind == SymbolKind::Label && symbols.labels(symbols[id].name).front() == id;
    if (isFirst) name(id, CompletionKind::Label);
  }
}

void Completer::types() {
  words(WordKind::Type);
  members(SymbolKind::StateVariable, kNoSymbol, CompletionKind::Type);
}

void Completer::resources() {
  members(SymbolKind::Resource, kNoSymbol, CompletionKind::Resource);
  std::erase_if(items, [&](const Completion& item) { return isInList(item.label); });
}

/// The workspace's files as paths relative to this file, without itself and those already included.
void Completer::files() {
  const auto& self = view.program().files[view.file].path;
  const auto folder = self.parent_path();
  std::set<std::string> included{self.native()};
  for (const auto& target : includesOf(self, view.document()))
    included.insert(snapshot.nameOf(target).native());
  for (const auto& file : snapshot.files()) {
    if (included.contains(file.native()) || snapshot.kindOf(file) != TextKind::File) continue;
    addFile(file.lexically_relative(folder));
  }
  std::ranges::stable_sort(items, syntax::isNaturallyBefore, &Completion::label);
}

void Completer::addFile(const std::filesystem::path& relative) {
  if (relative.empty()) return;
  Completion& item = add(relative.generic_string(), CompletionKind::File);
  item.rank = static_cast<unsigned>(std::ranges::count(item.label, '/'));
}

/// The JSON files below this file's folder; those that are called platforms come first.
void Completer::platformFiles() {
  const auto folder = view.program().files[view.file].path.parent_path();
  for (const auto& file : snapshot.filesBelow(folder, ".json")) {
    addFile(file.lexically_relative(folder));
    if (!file.filename().native().ends_with("platform.json")) items.back().rank += 100;
  }
}

SymbolId Completer::find(SymbolKind kind, std::string_view text) const {
  return symbols.find(kind, text);
}

SymbolId Completer::owner() const {
  return find(inEnvironment() ? SymbolKind::Environment : SymbolKind::Skill, place.owner);
}

const syntax::Skill& Completer::skill(SymbolId symbol) const {
  return view.program().skills.all[symbols[symbol].definition].node();
}

const syntax::StateVariable& Completer::variable(SymbolId symbol) const {
  return view.program().stateVariables.all[symbols[symbol].definition].node();
}

} // namespace proskill::ide
