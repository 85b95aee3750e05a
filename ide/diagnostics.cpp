#include "ide/diagnostics.h"

#include <algorithm>

namespace proskill::ide {

namespace {

bool saysTheSame(const syntax::Diagnostic& a, const syntax::Diagnostic& b) {
  return a.code == b.code && a.location.range == b.location.range && a.message == b.message;
}

} // namespace

std::vector<Finding> diagnostics(const Snapshot& snapshot, const std::filesystem::path& file) {
  std::vector<Finding> result;
  for (const auto& view : snapshot.views(file))
    for (const auto& diagnostic : view.owner->findings()) {
      if (diagnostic.location.file != view.file) continue;
      auto known = [&](const Finding& other) { return saysTheSame(*other.diagnostic, diagnostic); };
      if (std::ranges::none_of(result, known)) result.push_back({view.owner, &diagnostic});
    }
  return result;
}

} // namespace proskill::ide
