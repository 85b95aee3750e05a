#include "analysis/deprecated.h"

#include "syntax/codes.h"
#include "syntax/quote.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace proskill::analysis {

namespace {

using syntax::Offset;
using syntax::Range;

constexpr std::string_view kMark = "Deprecated:";

/// The line of the text, where it is nothing but a comment, without its semicolons.
std::optional<std::string_view> commentIn(const syntax::Document& document, std::uint32_t line) {
  const auto range = document.lines().line(line, document.text());
  const auto text = std::string_view(document.text()).substr(range.begin, range.length());
  const auto begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos || text[begin] != ';') return std::nullopt;
  const auto words = text.find_first_not_of("; \t", begin);
  return words == std::string_view::npos ? std::string_view() : text.substr(words);
}

/// The first symbol that is defined in a line.
SymbolId definedIn(const Index& index, FileId file, Range line) {
  for (const Occurrence& it : index.occurrences({file, line}))
    if (it.role == Role::Definition) return it.symbol;
  return kNoSymbol;
}

void addDeprecations(const syntax::Document& document, FileId file, const Index& index,
                     std::vector<Deprecation>& found) {
  const auto& text = document.text();
  const auto& lines = document.lines();
  for (auto at = text.find(kMark); at != std::string::npos; at = text.find(kMark, at + 1)) {
    auto line = lines.position(static_cast<Offset>(at)).line;
    const auto comment = commentIn(document, line);
    if (!comment || comment->data() != text.data() + at) continue;
    const auto why =
        comment->substr(std::min(comment->find_first_not_of(" \t", kMark.size()), comment->size()));
    while (++line < lines.lineCount() && commentIn(document, line)) {
    }
    if (line == lines.lineCount()) return;
    const auto symbol = definedIn(index, file, lines.line(line, text));
    const bool isKnown = !found.empty() && found.back().symbol == symbol;
    if (symbol != kNoSymbol && !isKnown) found.push_back({symbol, why});
  }
}

} // namespace

std::vector<Deprecation> deprecations(const Program& program, const Index& index) {
  std::vector<Deprecation> found;
  for (FileId file = 0; file < program.files.size(); ++file)
    addDeprecations(program.files[file].document, file, index, found);
  return found;
}

void reportDeprecated(const Program& program, const Index& index, Findings& findings) {
  for (const auto& [id, why] : deprecations(program, index)) {
    const Symbol& symbol = index.symbols()[id];
    for (const Occurrence& use : index.occurrencesOf(id)) {
      const bool isWithin = use.at.file == symbol.at.file &&
                            symbol.extent.begin <= use.at.range.begin &&
                            use.at.range.end <= symbol.extent.end;
      if (isWithin) continue;
      findings
          .report(syntax::Code::DeprecatedName, use.at, symbol.name,
                  why.empty() ? std::string() : fmt::format(": {}", syntax::shortened(why)))
          .related(symbol.at, "defined here");
    }
  }
}

} // namespace proskill::analysis
