#include "analysis/checks/deprecated.h"

#include "syntax/diagnostics/codes.h"
#include "syntax/text/quote.h"
#include "syntax/text/scan.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace proskill::analysis {

namespace {

using syntax::Offset;
using syntax::Range;

constexpr std::string_view kMark = "Deprecated:";

std::optional<std::string_view> commentIn(const syntax::Document& document, std::uint32_t line) {
  const auto range = document.lines().line(line, document.text());
  return syntax::commentLine(std::string_view(document.text()).substr(range.begin, range.length()));
}

/// Without leading white space.
std::string_view trimmed(std::string_view text) {
  return text.substr(std::min(text.find_first_not_of(" \t"), text.size()));
}

/// The first symbol that a line defines.
SymbolId definedIn(const Index& index, FileId file, Range line) {
  for (const Occurrence& it : index.occurrences({file, line}))
    if (it.role == Role::Definition) return it.symbol;
  return kNoSymbol;
}

void addDeprecations(const syntax::Document& document, FileId file, const Index& index,
                     std::vector<Deprecation>& found) {
  const std::string_view text = document.text();
  const auto& lines = document.lines();
  for (auto at = text.find(kMark); at != std::string_view::npos; at = text.find(kMark, at)) {
    auto line = lines.position(static_cast<Offset>(at)).line;
    const auto comment = commentIn(document, line);
    const bool begins = comment && trimmed(*comment).data() == text.data() + at;
    at += kMark.size();
    if (!begins) continue;
    const auto why = trimmed(trimmed(*comment).substr(kMark.size()));
    do ++line;
    while (line < lines.lineCount() && commentIn(document, line));
    if (line == lines.lineCount()) return;
    const Range below = lines.line(line, text);
    const auto symbol = definedIn(index, file, below);
    if (symbol != kNoSymbol) found.push_back({symbol, why});
    at = below.begin; // one match per comment is enough
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
