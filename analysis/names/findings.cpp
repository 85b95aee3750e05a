#include "analysis/names/findings.h"
#include "syntax/diagnostics/codes.h"
#include "syntax/diagnostics/suggest.h"
#include "syntax/text/quote.h"

#include <algorithm>
#include <tuple>

namespace proskill::analysis {

Finding& Finding::related(syntax::Location at, std::string_view message) {
  diagnostic.related.push_back({at, syntax::withShortQuotes(message)});
  return *this;
}

Finding& Finding::suggest(std::string_view word) {
  syntax::suggest(diagnostic, word);
  return *this;
}

Finding& Finding::fix(std::string_view title, syntax::Location at, std::string text) {
  diagnostic.fixes.push_back({syntax::withShortQuotes(title), at, std::move(text)});
  return *this;
}

Finding& Finding::severity(syntax::Severity value) {
  diagnostic.severity = value;
  return *this;
}

namespace {

auto place(const syntax::Location& it) { return std::tuple(it.file, it.range.begin); }

bool isAboutArguments(syntax::Code code) {
  return code == syntax::Code::MalformedArgument || code == syntax::Code::WrongOperandCount;
}

} // namespace

void Findings::add(const Found& more) {
  auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
  append(found.diagnostics, more.diagnostics);
  append(found.notCalls, more.notCalls);
  append(found.unknown, more.unknown);
}

void Findings::dropForgotten() {
  auto& [diagnostics, notCalls, unknown] = found;
  std::ranges::sort(notCalls, {}, place);
  auto forgotten = [&](const syntax::Diagnostic& it) {
    if (!isAboutArguments(it.code)) return false;
    auto after = std::ranges::upper_bound(notCalls, place(it.location), {}, place);
    if (after == notCalls.begin()) return false;
    const syntax::Location& call = *std::prev(after);
    return call.file == it.location.file && it.location.range.begin < call.range.end;
  };
  if (!notCalls.empty()) std::erase_if(diagnostics, forgotten);
}

std::vector<syntax::Diagnostic> Findings::inOrder() && {
  dropForgotten();
  std::ranges::stable_sort(found.diagnostics, {},
                           [](const syntax::Diagnostic& it) { return place(it.location); });
  return std::move(found.diagnostics);
}

} // namespace proskill::analysis
