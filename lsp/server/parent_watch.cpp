#include "lsp/server/parent_watch.h"

#include <cerrno>
#include <csignal>

namespace proskill::lsp {

namespace {

constexpr std::chrono::seconds kBetweenLooks{5};

bool isRunning(int process) { return kill(process, 0) == 0 || errno != ESRCH; }

} // namespace

ParentWatch::ParentWatch(const Json& processId) {
  if (!processId.is_number_unsigned() || processId.get<std::uint64_t>() > INT32_MAX) return;
  process = processId.get<int>();
  if (process > 0 && isRunning(process)) next = std::chrono::steady_clock::now() + kBetweenLooks;
}

bool ParentWatch::isGone() {
  const auto now = std::chrono::steady_clock::now();
  if (!next || now < *next) return false;
  next = now + kBetweenLooks;
  return !isRunning(process);
}

} // namespace proskill::lsp
