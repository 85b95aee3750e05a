#include "ide/snapshot/known_flow.h"

#include <ranges>

namespace proskill::ide {

namespace {

using analysis::Location;

/// Reading so many steps is faster than any flow analysis; a larger flow would keep much old text
/// in memory.
constexpr std::size_t kMostSteps = 1'000;

} // namespace

KnownFlow::KnownFlow(std::shared_ptr<const analysis::Program> program)
    : computed(std::make_shared<const Computed>(std::move(program))) {}

std::shared_ptr<const KnownFlow> KnownFlow::after(analysis::FileId file,
                                                  const syntax::Replacement& edit) const {
  if (steps.size() == kMostSteps) return nullptr;
  auto result = std::make_shared<KnownFlow>(*this);
  if (!edit.isEmpty()) result->steps.push_back({file, edit});
  return result;
}

Location KnownFlow::then(Location now) const {
  for (const auto& [file, edit] : steps | std::views::reverse)
    if (file == now.file) now.range = edit.inverse().nearest(now.range);
  return now;
}

Location KnownFlow::now(Location then) const {
  for (const auto& [file, edit] : steps)
    if (file == then.file) then.range = edit.nearest(then.range);
  return then;
}

} // namespace proskill::ide
