#include "ide/actions/action.h"

#include "syntax/format.h"

#include <algorithm>

namespace proskill::ide {

namespace {

/// What differs between two texts, as one edit.
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

/// Cuts lie between words, so that none is inside of a character.
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

} // namespace

const syntax::Form* ActionContext::form() const {
  for (const auto& form : view.document().forms()) {
    bool holds = form.range.begin <= selection.begin && selection.end <= form.range.end;
    if (holds) return form.mended ? nullptr : &form;
  }
  return nullptr;
}

void addLaidOut(const ActionContext& context, Actions& actions, std::string title, ActionKind kind,
                std::vector<syntax::TextEdit> edits) {
  std::ranges::sort(edits, {}, [](const auto& edit) { return edit.range.begin; });
  const auto& before = context.view.text();
  auto changed = difference(before, syntax::applyEdits(before, edits));
  auto document = context.view.document().edit(changed.range, changed.text);
  syntax::Range touched{changed.range.begin,
                        changed.range.begin + static_cast<syntax::Offset>(changed.text.size())};
  for (const auto& form : document.forms()) {
    bool touches = form.range.begin <= touched.end && touched.begin <= form.range.end;
    if (!touches) continue;
    touched = {std::min(touched.begin, form.range.begin), std::max(touched.end, form.range.end)};
  }
  auto after = syntax::applyEdits(document.text(), syntax::formatRange(document, touched));
  if (after == before) return;
  actions.push_back({std::move(title),
                     kind,
                     context.view.owner,
                     {{context.view.file, atWords(before, difference(before, after))}}});
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
