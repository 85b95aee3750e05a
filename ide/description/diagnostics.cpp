#include "ide/description/diagnostics.h"

#include <set>
#include <string_view>
#include <tuple>

namespace proskill::ide {

namespace {

/// A diagnostic as users see it. Several programs with the same file often report the same.
using Saying = std::tuple<syntax::Offset, syntax::Offset, syntax::Code, std::string_view>;

Saying sayingOf(const syntax::Diagnostic& diagnostic) {
  const auto& range = diagnostic.location.range;
  return {range.begin, range.end, diagnostic.code, diagnostic.message};
}

} // namespace

/// The findings of a file, with those of the flow analysis if the program is in use.
std::vector<Finding> diagnostics(const Snapshot& snapshot, const std::filesystem::path& file) {
  std::vector<Finding> result;
  if (snapshot.kindOf(file) == TextKind::Notebook) return result;
  std::set<Saying> said;
  snapshot.eachView(file, [&](const View& view) {
    for (const auto& diagnostic : view.owner->findings())
      if (diagnostic.location.file == view.file && said.insert(sayingOf(diagnostic)).second)
        result.push_back({view.owner, &diagnostic});
    if (snapshot.isLookedAt(*view.owner))
      (void)view.owner->flow(); // it may have been dropped while the program was not in use
    else
      view.owner->forgetFlow();
  });
  return result;
}

} // namespace proskill::ide
