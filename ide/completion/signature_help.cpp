#include "ide/completion/signature_help.h"

#include "ide/description/describe.h"
#include "ide/names/word_at.h"

#include <algorithm>

namespace proskill::ide {

namespace {

using analysis::SymbolKind;

/// A list that contains so many others is not the one being written.
constexpr std::size_t kNearLists = 64;

void append(Signature& signature, std::string_view part, std::string_view documentation) {
  if (!signature.label.ends_with('(')) signature.label += ' ';
  const auto begin = static_cast<syntax::Offset>(signature.label.size());
  signature.label += part;
  const auto end = static_cast<syntax::Offset>(signature.label.size());
  signature.parameters.push_back({{begin, end}, std::string(documentation)});
}

const syntax::Skill* findSkill(const View& view, std::string_view name) {
  const auto* found = view.program().skills.find(name);
  return found ? &found->node() : nullptr;
}

bool isGiven(const OpenList& list, std::string_view name) {
  return std::ranges::find(list.items, name, &Item::text) != list.items.end();
}

/// The input whose value is being written, otherwise the first missing one.
std::optional<std::size_t> activeInput(const syntax::Skill& skill, const Place& place) {
  for (std::size_t i = 0; i < skill.inputs.size(); ++i) {
    const auto name = analysis::withoutDollar(skill.inputs[i].name).text;
    const bool isIt =
        place.slot == Slot::ArgumentValue ? name == place.argument : !isGiven(*place.list, name);
    if (isIt) return i;
  }
  return std::nullopt;
}

std::optional<Signature> ofCall(const View& view, const Place& place) {
  if (place.slot != Slot::ArgumentName && place.slot != Slot::ArgumentValue) return std::nullopt;
  const auto* skill = findSkill(view, place.subject);
  if (!skill) return std::nullopt;
  Signature result;
  result.label = "(" + std::string(place.subject);
  for (const auto& input : skill->inputs) {
    const auto* type = findWord(WordKind::Type, input.type.text);
    append(result,
           std::string(analysis::withoutDollar(input.name).text) + " " +
               std::string(input.type.text),
           type ? type->sentence : std::string_view());
  }
  result.label += ')';
  result.active = activeInput(*skill, place);
  const auto symbol = view.index().symbols().find(SymbolKind::Skill, place.subject);
  if (auto comment = commentAbove(view, symbol); !comment.empty())
    result.documentation.prose(comment);
  return result;
}

/// The field whose value is being written.
const Item* currentField(const OpenList& list) {
  for (const auto& item : list.items | std::views::reverse)
    if (item.isKeyword() && item.text != ":all") return &item;
  return nullptr;
}

/// The signature of a single field of a skill; all fields would fill the screen.
Signature ofOneField(const Word& field) {
  Signature result;
  result.label = field.form;
  result.parameters.push_back({{0, static_cast<syntax::Offset>(field.form.size())}, {}});
  result.active = 0;
  result.documentation.prose(field.sentence);
  return result;
}

Signature ofFields(std::string_view head, WordKind kind, const OpenList& list) {
  const Item* field = currentField(list);
  Signature result;
  result.label = "(" + std::string(head);
  for (const Word& word : wordsOf(kind)) {
    if (field && field->text == word.text) result.active = result.parameters.size();
    append(result, word.form, word.sentence);
  }
  result.label += ')';
  return result;
}

std::optional<WordKind> clauseFields(Slot slot) {
  switch (slot) {
  case Slot::InvariantClause: return WordKind::InvariantField;
  case Slot::InterruptClause: return WordKind::InterruptField;
  case Slot::OutcomeClause: return WordKind::OutcomeField;
  default: return std::nullopt;
  }
}

std::optional<Signature> ofDefinition(const OpenList& list) {
  if (list.items.empty()) return std::nullopt;
  const auto head = list.items.front().text;
  const auto* kind = fieldsOf(head);
  if (!kind || list.items.size() < 2) return std::nullopt;
  if (*kind != WordKind::SkillField) return ofFields(std::string(head) + " NAME", *kind, list);
  const Item* field = currentField(list);
  const Word* word = field ? findWord(*kind, field->text) : nullptr;
  if (!word) return std::nullopt;
  return ofOneField(*word);
}

/// The parts of a form after its head: `P`, `[:within I]`.
std::vector<std::string_view> partsOf(std::string_view form) {
  std::vector<std::string_view> parts;
  int depth = 0;
  std::size_t begin = 1;
  for (std::size_t i = 1; i < form.size(); ++i) {
    const bool ends = depth == 0 && (form[i] == ' ' || i + 1 == form.size());
    if (form[i] == '(' || form[i] == '[') ++depth;
    if ((form[i] == ')' || form[i] == ']') && i + 1 < form.size()) --depth;
    if (!ends) continue;
    parts.push_back(form.substr(begin, i - begin));
    begin = i + 1;
  }
  return parts;
}

Signature ofWord(const Word& word, std::size_t behind) {
  Signature result;
  result.label = word.form;
  result.documentation.prose(word.sentence);
  const bool isOneList = word.form.starts_with('(') && !word.form.contains(") or (");
  if (!isOneList) return result;
  const auto parts = partsOf(word.form);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const auto begin = static_cast<syntax::Offset>(parts[i].data() - word.form.data());
    result.parameters.push_back(
        {{begin, begin + static_cast<syntax::Offset>(parts[i].size())}, {}});
  }
  if (!result.parameters.empty()) result.active = std::min(behind, result.parameters.size()) - 1;
  return result;
}

/// The signature of the list at this depth of the path.
std::optional<Signature> ofList(const View& view, const Path& path, std::size_t depth) {
  const auto& list = path.lists[depth];
  const Place outer = placeOf(path, depth);
  if (depth == 0) return ofDefinition(list);
  if (auto fields = clauseFields(outer.slot)) return ofFields("", *fields, list);
  if (list.items.empty()) return std::nullopt;
  if (auto call = ofCall(view, placeOf(path, depth + 1))) return call;
  Path head;
  head.lists.assign(path.lists.begin(), path.lists.begin() + static_cast<std::ptrdiff_t>(depth));
  head.lists.push_back({list.begin, {}});
  const Word* word = wordAt(head, list.items.front().text);
  if (!word || word->kind == WordKind::Member) return std::nullopt;
  return ofWord(*word, list.items.size());
}

} // namespace

std::optional<Signature> signatureHelp(const View& view, syntax::Offset at) {
  const Path path = pathTo(view.document(), at);
  if (path.surrounding == Surrounding::Comment) return std::nullopt;
  const auto all = path.lists.size();
  for (auto depth = all; depth-- > all - std::min(all, kNearLists);)
    if (auto found = ofList(view, path, depth)) return found;
  return std::nullopt;
}

} // namespace proskill::ide
