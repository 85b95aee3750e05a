#include "bridge/text/form.h"

#include "syntax/format/format.h"
#include "syntax/text/edit.h"

#include <algorithm>
#include <sstream>

namespace proskill::bridge {
namespace {

void writeComment(const std::string& comment, std::string& text) {
  std::istringstream lines(comment);
  for (std::string line; std::getline(lines, line);) text += "\n; " + line;
  if (!comment.empty()) text += "\n";
}

void writeForm(const Form& form, std::string& text) {
  writeComment(form.comment, text);
  if (form.parts.empty() && !form.word.empty()) {
    text += form.word;
    return;
  }
  text += "(";
  for (std::size_t i = 0; i < form.parts.size(); ++i) {
    if (i > 0) text += form.parts[i].word.starts_with(':') ? "\n" : " ";
    writeForm(form.parts[i], text);
  }
  text += ")";
}

std::string formatted(const std::string& text) {
  const auto document = syntax::Document::parse(text);
  return syntax::applyEdits(text, syntax::format(document));
}

} // namespace

bool contains(const Form& form, const Form& part) {
  return form == part ||
         std::ranges::any_of(form.parts, [&](const Form& inner) { return contains(inner, part); });
}

void append(Block& block, const Block& more) {
  block.insert(block.end(), more.begin(), more.end());
}

std::string write(const std::string& head, const Block& program) {
  std::string text;
  writeComment(head, text);
  for (const auto& form : program) {
    text += "\n";
    writeForm(form, text);
    text += "\n";
  }
  return formatted(text.substr(text.find_first_not_of('\n')));
}

} // namespace proskill::bridge
