#include "analysis/findings.h"

#include <algorithm>
#include <tuple>

namespace proskill::analysis {

Finding& Finding::related(syntax::Location at, std::string message) {
  diagnostic.related.push_back({at, std::move(message)});
  return *this;
}

Finding& Finding::suggest(const Suggestion& suggestion) {
  const std::string best(suggestion.best());
  return best.empty() ? *this : fix("did you mean `" + best + "`?", diagnostic.location, best);
}

Finding& Finding::fix(std::string title, syntax::Location at, std::string text) {
  diagnostic.fixes.push_back({std::move(title), at, std::move(text)});
  return *this;
}

Finding& Finding::severity(syntax::Severity value) {
  diagnostic.severity = value;
  return *this;
}

std::vector<syntax::Diagnostic> Findings::inOrder() && {
  auto place = [](const syntax::Diagnostic& it) {
    return std::tuple(it.location.file, it.location.range.begin);
  };
  std::ranges::stable_sort(diagnostics, {}, place);
  return std::move(diagnostics);
}

} // namespace proskill::analysis
