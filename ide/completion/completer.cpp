#include "ide/completion/completer.h"

#include "analysis/checks/deprecated.h"

#include <algorithm>
#include <fmt/format.h>

namespace proskill::ide {

namespace {

struct Exclusion {
  std::string_view present;
  std::string_view senseless;
};
/// Fields that exclude each other: a skill is basic or composite, and interruptible by one of two
/// fields; a variable has values or bounds.
constexpr Exclusion kExclusions[] = {
    {":action", ":body"},
    {":action", ":monitor"},
    {":body", ":action"},
    {":monitor", ":action"},
    {":states", ":min"},
    {":states", ":max"},
    {":min", ":states"},
    {":min", ":transitions"},
    {":max", ":states"},
    {":max", ":transitions"},
    {":transitions", ":min"},
    {":transitions", ":max"},
    {":interrupt", ":interruptible"},
    {":interruptible", ":interrupt"},
};

CompletionKind kindOf(WordKind kind) {
  switch (kind) {
  case WordKind::Statement:
  case WordKind::CaseOutcome:
  case WordKind::EnvironmentStatement: return CompletionKind::Statement;
  case WordKind::Connective:
  case WordKind::Comparison:
  case WordKind::Arithmetic:
  case WordKind::Observation:
  case WordKind::Temporal: return CompletionKind::Operator;
  case WordKind::Type: return CompletionKind::Type;
  case WordKind::Status:
  case WordKind::Result:
  case WordKind::Constant: return CompletionKind::Value;
  default: return CompletionKind::Keyword;
  }
}

/// Calls, and the tags of outcomes, are not allowed in an environment.
bool isForSkillsOnly(std::string_view statement) {
  return statement == "success" || statement == "failure";
}

} // namespace

Completer::Completer(const Snapshot& snapshot, const View& view, const Path& path,
                     const Place& place)
    : snapshot(snapshot), view(view), path(path), place(place), symbols(view.index().symbols()) {
  for (const auto& each : analysis::deprecations(view.program(), view.index()))
    deprecated.insert(each.symbol);
}

std::vector<Completion> Completer::gather() && {
  if (path.surrounding == Surrounding::String) {
    if (place.slot == Slot::IncludePath) files();
    if (place.slot == Slot::PlatformPath) platformFiles();
  } else if (path.prefix.contains('.')) {
    access();
  } else {
    fill();
  }
  return std::move(items);
}

/// Completes where keywords are allowed; other places have names.
void Completer::fill() {
  switch (place.slot) {
  case Slot::Definition: return forms(WordKind::Definition);
  case Slot::Field: return fields(place.fields);
  case Slot::OutcomeClause:
    if (place.fields == WordKind::SkillField) fields(place.fields);
    return skeleton("(:effects …)", "(:effects ())", "(:effects ($0))");
  case Slot::InterruptClause: return skeleton("(:effects …)", "(:effects ())", "(:effects ($0))");
  case Slot::InvariantClause: return skeleton("(:guard …)", "(:guard ())", "(:guard ($0))");
  case Slot::Interval: return skeleton("[least,most]", "[1,3]", "[${1:1},${2:3}]");
  case Slot::Transitions: return skeleton(":all", ":all", "");
  case Slot::Monitor: skeleton("t", "t", ""); return skeleton("always", "always", "");
  case Slot::Interruptible: skeleton("nil", "nil", ""); return skeleton("t", "t", "");
  case Slot::Fair:
    for (const auto* value : {"nil", "t"}) skeleton(value, value, "");
    return skeleton("(skill …)", "()", "($0)");
  case Slot::CaseArm: return forms(WordKind::CaseOutcome);
  case Slot::CasePattern: return forms(WordKind::CaseOutcome, false);
  case Slot::Condition:
  case Slot::WaitCondition:
  case Slot::Proposition:
  case Slot::Temporal: return conditions();
  case Slot::IfStatement: forms(WordKind::Clause, false); return statements();
  case Slot::DoStatement: forms(WordKind::Until, false); return statements();
  case Slot::TimeoutStatement:
    if (!place.isHead) fields(WordKind::WaitField);
    return statements();
  case Slot::Statement: return statements();
  case Slot::Pattern: return forms(WordKind::Pattern);
  case Slot::Status: return words(WordKind::Status);
  default: return fillNames();
  }
}

Completion& Completer::add(std::string label, CompletionKind kind) {
  items.push_back({.label = std::move(label), .kind = kind, .rank = rank});
  Completion& item = items.back();
  item.insert = item.filter = item.label;
  return item;
}

void Completer::word(const Word& word) {
  Completion& item = add(std::string(word.text), kindOf(word.kind));
  item.word = &word;
  item.detail = word.form;
}

void Completer::words(WordKind kind) {
  for (const Word& each : wordsOf(kind)) word(each);
  ++rank;
}

/// Without a list, a snippet that begins with a line break is not offered: to an editor, Enter
/// after the whole word would choose it.
void Completer::form(const Word& word, bool isList) {
  Completer::word(word);
  Completion& item = items.back();
  if (isList && !place.isHead) {
    item.insert = fmt::format("({})", word.text);
    item.snippet = fmt::format("({}{})", word.text, word.snippet);
  } else if (!word.snippet.empty() && !word.snippet.starts_with('\n')) {
    item.snippet = fmt::format("{}{}", word.text, word.snippet);
  }
}

void Completer::forms(WordKind kind, bool areLists) {
  for (const Word& each : wordsOf(kind)) form(each, areLists);
  ++rank;
}

void Completer::fields(WordKind kind) {
  auto isSenseless = [&](std::string_view keyword) {
    return std::ranges::any_of(kExclusions, [&](const Exclusion& it) {
      return it.senseless == keyword && isInList(it.present);
    });
  };
  for (const Word& each : wordsOf(kind)) {
    if (isInList(each.text) || isSenseless(each.text)) continue;
    form(each, false);
    items.back().kind = CompletionKind::Field;
  }
  ++rank;
}

void Completer::skeleton(std::string_view label, std::string_view insert,
                         std::string_view snippet) {
  if (place.isHead) return;
  Completion& item = add(std::string(label), CompletionKind::Keyword);
  item.insert = insert;
  item.snippet = snippet;
}

void Completer::conditions() {
  const bool inProperty = place.slot == Slot::Proposition || place.slot == Slot::Temporal;
  variables(false);
  inputs(kTruthValue);
  if (place.slot == Slot::Temporal && !place.isHead) values(place.subject);
  if (inProperty) forms(WordKind::Observation);
  if (place.slot == Slot::Temporal) forms(WordKind::Temporal);
  forms(WordKind::Connective);
  forms(WordKind::Comparison);
  if (place.isHead) return;
  words(WordKind::Constant);
  if (place.slot == Slot::WaitCondition) constants();
}

void Completer::statements() {
  if (!inEnvironment()) calls();
  if (inEnvironment()) forms(WordKind::EnvironmentStatement);
  for (const Word& each : wordsOf(WordKind::Statement)) {
    if (inEnvironment() && isForSkillsOnly(each.text)) continue;
    form(each, each.text != "break");
  }
  ++rank;
  interrupts();
}

bool Completer::isInList(std::string_view word) const {
  return place.list &&
         std::ranges::find(place.list->items, word, &Item::text) != place.list->items.end();
}

} // namespace proskill::ide
