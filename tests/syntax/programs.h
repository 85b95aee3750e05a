#pragma once

#include "syntax/document.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::test {

/// The listings of the paper, as printed there.
extern const std::string_view kPaperStateVariables;
extern const std::string_view kPaperEvent;
extern const std::string_view kPaperBasicSkill;
extern const std::string_view kPaperCompositeSkill;
extern const std::string_view kPaperMonitor;

/// All five of them in one text.
[[nodiscard]] std::string paperProgram();

/// The text of each program in examples/, after the paper's listings.
[[nodiscard]] std::vector<std::string> allPrograms();

/// The first form of a text, with the document that keeps it alive.
template <class Node> struct Parsed {
  syntax::Document document;

  explicit Parsed(std::string text) : document(syntax::Document::parse(std::move(text))) {}
  const Node* operator->() const { return &std::get<Node>(document.forms().at(0).node()); }
};

/// The codes of the errors in a text, in order: `PS0101 PS0105`.
[[nodiscard]] std::string codesOf(const syntax::Document& document);

} // namespace proskill::test
