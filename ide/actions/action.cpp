#include "ide/actions/action.h"

#include "syntax/format/format.h"

#include <algorithm>

namespace proskill::ide {

namespace {

/// The difference between two texts as a single edit.
syntax::TextEdit difference(std::string_view before, std::string_view after) {
  auto shortest = std::min(before.size(), after.size());
  std::size_t head = 0;
  while (head < shortest && before[head] == after[head]) ++head;
  std::size_t tail = 0;
  while (tail < shortest - head &&
         before[before.size() - 1 - tail] == after[after.size() - 1 - tail])
    ++tail;
  return {{static_cast<syntax::Offset>(head), static_cast<syntax::Offset>(before.size() - tail)},
          std::string(after.substr(head, after.size() - tail - head))};
}

/// Widens an edit to whole words, so that characters are not split.
syntax::TextEdit atWords(std::string_view text, syntax::TextEdit edit) {
  auto isInWord = [](char c) { return !std::string_view(" \n()").contains(c); };
  auto [begin, end] = edit.range;
  while (begin > 0 && isInWord(text[begin - 1])) --begin;
  while (end < text.size() && isInWord(text[end])) ++end;
  edit.text = std::string(text.substr(begin, edit.range.begin - begin)) + edit.text +
              std::string(text.substr(edit.range.end, end - edit.range.end));
  edit.range = {begin, end};
  return edit;
}

/// The regions that edits touch, and their neighbours. Their layout does not depend on the rest.
/// \pre there is an edit
syntax::Range surroundings(const syntax::Document& document,
                           const std::vector<syntax::TextEdit>& edits) {
  const auto first = edits.front().range.begin;
  const auto last =
      std::ranges::max(edits, {}, [](const auto& it) { return it.range.end; }).range.end;
  const auto regions = document.regions();
  auto begin = std::ranges::find_if(regions, [&](const auto& it) { return it.range.end >= first; });
  auto end = std::ranges::find_if(regions, [&](const auto& it) { return it.range.begin > last; });
  if (begin != regions.begin()) --begin;
  return {begin == regions.end() ? 0 : begin->range.begin,
          end == regions.end() ? static_cast<syntax::Offset>(document.text().size())
                               : end->range.end};
}

} // namespace

const syntax::Form* ActionContext::form() const {
  for (const auto& form : view.document().forms()) {
    bool holds = form.range.begin <= selection.begin && selection.end <= form.range.end;
    if (holds) return form.recovered ? nullptr : &form;
  }
  return nullptr;
}

void addLaidOut(const ActionContext& context, Actions& actions, std::string title, ActionKind kind,
                std::vector<syntax::TextEdit> edits) {
  std::ranges::sort(edits, {}, [](const auto& edit) { return edit.range.begin; });
  const auto within = surroundings(context.view.document(), edits);
  const auto before = context.textOf(within);
  for (auto& edit : edits) {
    edit.range.begin -= within.begin;
    edit.range.end -= within.begin;
  }
  const auto document = syntax::Document::parse(syntax::applyEdits(before, edits));
  auto changed = difference(before, document.text());
  syntax::Range touched{changed.range.begin,
                        changed.range.begin + static_cast<syntax::Offset>(changed.text.size())};
  for (const auto& form : document.forms()) {
    if (!form.range.touches(touched)) continue;
    touched = {std::min(touched.begin, form.range.begin), std::max(touched.end, form.range.end)};
  }
  auto after = syntax::applyEdits(document.text(), syntax::formatRange(document, touched));
  if (after == before) return;
  auto edit = atWords(before, difference(before, after));
  edit.range = {edit.range.begin + within.begin, edit.range.end + within.begin};
  actions.push_back(
      {std::move(title), kind, context.view.owner, {{context.view.file, std::move(edit)}}});
}

Actions actions(const Snapshot& snapshot, const std::filesystem::path& file,
                syntax::Range selection) {
  const ActionContext context{snapshot, file, snapshot.view(file), selection};
  Actions result;
  for (auto add :
       {addDiagnosticFixes, addIgnore, addFixAll, addFailureBranch, addWrapInIf, addExtractSkill,
        addInlineSkill, addMonitor, addTransitions, addSortFields, addExplain})
    add(context, result);
  return result;
}

} // namespace proskill::ide
