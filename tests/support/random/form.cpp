#include "tests/support/random/form.h"

#include <algorithm>

namespace proskill::test {

namespace {

constexpr std::size_t kWidth = 90;

std::string flat(const Form& form) {
  if (!form.isList()) return form.word;
  std::string text = "(";
  for (const auto& item : form.items) {
    if (text.size() > 1) text += ' ';
    text += flat(item);
  }
  return text + ")";
}

void lay(const Form& form, std::size_t indent, std::string& text) {
  std::string line = flat(form);
  if (!form.isList() || indent + line.size() <= kWidth) {
    text += line;
    return;
  }
  text += '(';
  bool afterKeyword = true; // its value, and a form's head, stay on the line
  for (std::size_t i = 0; i < form.items.size(); ++i) {
    if (i > 0 && afterKeyword) text += ' ';
    if (i > 0 && !afterKeyword) text += "\n" + std::string(indent + 2, ' ');
    lay(form.items[i], indent + 2, text);
    const auto& word = form.items[i].word;
    afterKeyword = word.starts_with(':') || (i == 0 && !word.empty());
  }
  text += ')';
}

std::size_t sizeOf(const Form& form) {
  std::size_t sum = 1;
  for (const auto& item : form.items) sum += sizeOf(item);
  return sum;
}

/// Replaces items `first` to `first + count` of the list at `path` by `instead`.
struct Cut {
  std::vector<std::size_t> path;
  std::size_t first = 0;
  std::size_t count = 0;
  std::vector<Form> instead;
  std::size_t gain = 0;
};

void addCut(std::vector<Cut>& cuts, const Form& list, const std::vector<std::size_t>& path,
            std::size_t first, std::size_t count, std::vector<Form> instead) {
  std::size_t before = 0;
  for (std::size_t i = first; i < first + count; ++i) before += sizeOf(list.items[i]);
  std::size_t after = 0;
  for (const auto& item : instead) after += sizeOf(item);
  if (after < before) cuts.push_back({path, first, count, std::move(instead), before - after});
}

void collectCuts(const Form& list, std::vector<std::size_t>& path, std::vector<Cut>& cuts) {
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    const Form& item = list.items[i];
    addCut(cuts, list, path, i, 1, {});
    if (i + 1 < list.items.size()) addCut(cuts, list, path, i, 2, {});
    if (!item.isList()) continue;
    for (const auto& part : item.items) addCut(cuts, list, path, i, 1, {part});
    addCut(cuts, list, path, i, 1, {Form("true")});
    if (item.items.size() > 2) // by the statements of an `if` or a loop
      addCut(cuts, list, path, i, 1, {item.items.begin() + 2, item.items.end()});
    path.push_back(i);
    collectCuts(item, path, cuts);
    path.pop_back();
  }
}

Form apply(Form root, const Cut& cut) {
  Form* list = &root;
  for (std::size_t step : cut.path) list = &list->items[step];
  auto at = list->items.begin() + static_cast<std::ptrdiff_t>(cut.first);
  at = list->items.erase(at, at + static_cast<std::ptrdiff_t>(cut.count));
  list->items.insert(at, cut.instead.begin(), cut.instead.end());
  return root;
}

} // namespace

std::string textOf(const std::vector<Form>& program) {
  std::string text;
  for (const auto& form : program) {
    lay(form, 0, text);
    text += "\n\n";
  }
  return text;
}

std::vector<Form> minimise(std::vector<Form> program,
                           const std::function<bool(const std::vector<Form>&)>& shows) {
  Form root;
  root.items = std::move(program);
  for (bool shorter = true; shorter;) {
    shorter = false;
    std::vector<std::size_t> path;
    std::vector<Cut> cuts;
    collectCuts(root, path, cuts);
    std::ranges::stable_sort(cuts, std::ranges::greater{}, &Cut::gain);
    for (const auto& cut : cuts) {
      Form candidate = apply(root, cut);
      if (!shows(candidate.items)) continue;
      root = std::move(candidate);
      shorter = true;
      break;
    }
  }
  return root.items;
}

} // namespace proskill::test
