#include "ide/description/diagnostics.h"

#include <set>
#include <string_view>
#include <tuple>

namespace proskill::ide {

namespace {

/// What a reader sees of a diagnostic: the programs that a file belongs to say much twice.
using Saying = std::tuple<syntax::Offset, syntax::Offset, syntax::Code, std::string_view>;

Saying sayingOf(const syntax::Diagnostic& diagnostic) {
  const auto& range = diagnostic.location.range;
  return {range.begin, range.end, diagnostic.code, diagnostic.message};
}

} // namespace

/// Of a program that features look into they want the flow as well; of others only the findings
/// are.
std::vector<Finding> diagnostics(const Snapshot& snapshot, const std::filesystem::path& file) {
  std::vector<Finding> result;
  if (snapshot.kindOf(file) == TextKind::Notebook) return result;
  std::set<Saying> said;
  snapshot.eachView(file, [&](const View& view) {
    for (const auto& diagnostic : view.owner->findings())
      if (diagnostic.location.file == view.file && said.insert(sayingOf(diagnostic)).second)
        result.push_back({view.owner, &diagnostic});
    if (snapshot.isLookedAt(*view.owner))
      (void)view.owner->flow(); // which may have been forgotten while nobody looked
    else
      view.owner->forgetFlow();
  });
  return result;
}

} // namespace proskill::ide
