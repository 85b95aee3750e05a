#include "analysis/flow/inspect.h"
#include "analysis/program/program.h"
#include "fuzz/targets.h"
#include "syntax/format/format.h"

#include <string>

namespace proskill::fuzz {

namespace {

using analysis::NoFiles;
using syntax::Document;

void isWithin(syntax::Range range, const std::string& text) {
  expect(range.begin <= range.end && range.end <= text.size(), "a range is within the text");
}

void isLaidOutOnce(const Document& document) {
  const auto once = Document::parse(syntax::applyEdits(document.text(), syntax::format(document)));
  expect(syntax::sameTokens(document, once), "laying out changes white space alone");
  expect(syntax::format(once).empty(), "what is laid out stays as it is");
}

/// The text comes in two halves, as if typed.
void isReadPiecewise(const Document& document) {
  const auto& text = document.text();
  const auto half = static_cast<syntax::Offset>(text.size() / 2);
  const auto typed = Document::parse(text.substr(0, half)).edit({half, half}, text.substr(half));
  expect(typed.dump() == document.dump(), "an edit gives the tree of a fresh parse");
  expect(typed.diagnostics().size() == document.diagnostics().size(),
         "an edit gives the diagnostics of a fresh parse");
}

void isChecked(const Document& document) {
  const auto program = analysis::load(NoFiles(), "main.proskill", document);
  for (const auto& diagnostic : analysis::flow::inspect(program)) {
    expect(diagnostic.location.file < program.files.size(), "a diagnostic is of a file");
    isWithin(diagnostic.location.range, document.text());
    for (const auto& fix : diagnostic.fixes) isWithin(fix.location.range, document.text());
  }
}

} // namespace

void proskill(std::string_view bytes) {
  const auto document = Document::parse(std::string(bytes));
  expect(document.text() == bytes, "the text is kept");
  isReadPiecewise(document);
  isLaidOutOnce(document);
  isChecked(document);
}

} // namespace proskill::fuzz
