#include "ide/completion/completion.h"

#include "ide/completion/completer.h"
#include "ide/completion/fuzzy.h"
#include "ide/description/describe.h"

#include <algorithm>

namespace proskill::ide {

namespace {

/// A longer list slows editors down, and nobody reads it.
constexpr std::size_t kMostItems = 200;

/// Whether few names are possible here, so that typing a space can trigger completion.
bool isNarrow(const Place& place) {
  switch (place.slot) {
  case Slot::InitialValue:
  case Slot::VariableValue:
  case Slot::EffectValue:
  case Slot::Transition:
  case Slot::Transitions:
  case Slot::InputType:
  case Slot::Resource:
  case Slot::Label:
  case Slot::AnyLabel:
  case Slot::SuccessTag:
  case Slot::FailureTag:
  case Slot::Event:
  case Slot::Skill:
  case Slot::Status:
  case Slot::Variable:
  case Slot::ArgumentName:
  case Slot::ArgumentValue:
  case Slot::CommandArgument:
  case Slot::CaseCall:
  case Slot::CaseTag:
  case Slot::Interruptible:
  case Slot::Fair:
  case Slot::Monitor: return true;
  case Slot::Operand: return !place.subject.empty();
  default: return false;
  }
}

/// Whether the typed character begins something that can be completed.
bool isWanted(char typed, const Path& path, const Place& place) {
  switch (typed) {
  case ' ': return isNarrow(place);
  case '(': return path.surrounding == Surrounding::Code;
  case ':':
  case '$': return path.prefix == std::string_view(&typed, 1);
  case '.': return path.prefix.ends_with('.');
  default: return path.surrounding == Surrounding::String;
  }
}

bool isNumber(std::string_view prefix) {
  return !prefix.empty() && std::string_view("0123456789[]").contains(prefix.front());
}

/// Keeps the best matches if there are too many.
bool limit(std::vector<Completion>& items, std::string_view typed) {
  if (items.size() <= kMostItems) return true;
  std::vector<std::pair<int, Completion>> scored;
  for (auto& item : items)
    if (auto score = fuzzyScore(typed, item.filter)) scored.emplace_back(*score, std::move(item));
  std::ranges::stable_sort(scored, std::ranges::greater(), [](const auto& it) { return it.first; });
  scored.resize(std::min(scored.size(), kMostItems));
  items.clear();
  for (auto& [score, item] : scored) items.push_back(std::move(item));
  return false;
}

} // namespace

Completions complete(const Snapshot& snapshot, const View& view, syntax::Offset at,
                     CompletionTrigger trigger) {
  Completions result;
  const Path path = pathTo(view.document(), at);
  const Place place = placeOf(path);
  result.replace = path.word;
  result.insert = {path.word.begin, at};
  if (path.surrounding == Surrounding::Comment || isNumber(path.prefix)) return result;
  if (trigger.typed && !isWanted(*trigger.typed, path, place)) return result;
  result.items = Completer(snapshot, view, path, place).gather();
  auto typed = path.prefix;
  if (const auto dot = typed.find('.');
      dot != std::string_view::npos && path.surrounding == Surrounding::Code) {
    typed.remove_prefix(dot + 1);
    result.insert.begin = result.replace.begin = at - static_cast<syntax::Offset>(typed.size());
  }
  result.isComplete = limit(result.items, typed);
  std::ranges::stable_sort(result.items, {}, &Completion::rank);
  return result;
}

Markup documentation(const View& view, const Completion& item) {
  Markup text;
  if (item.word) {
    text.code(item.word->form);
    text.prose(item.word->sentence);
  } else if (item.symbol) {
    const auto symbol = findSymbol(view.index().symbols(), *item.symbol);
    if (symbol != analysis::kNoSymbol) describe(text, view, symbol);
  }
  return text;
}

} // namespace proskill::ide
