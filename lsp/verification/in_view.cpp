#include "lsp/verification/defined_in.h"
#include "lsp/verification/verification.h"

#include <algorithm>

/// What is visible of a large program is verified first: few properties need only a small part of
/// the model. Errors are ignored, since the whole program is verified, too.
namespace proskill::lsp {

namespace {

/// The complete verification of a larger program may exceed its budget.
constexpr std::size_t kLarge = 64 * 1024;

/// Limit for definitions that come into view while the whole program is being verified, whose
/// results wait for theirs.
constexpr double kMostSecondsAside = 5;

std::size_t bytesOf(const analysis::Program& program) {
  std::size_t bytes = 0;
  for (const auto& file : program.files) bytes += file.document.text().size();
  return bytes;
}

} // namespace

void Verification::checkInView(const Programs& program, const ide::Snapshot& now,
                               const VerificationSettings& chosen,
                               const rpc::Cancellation& cancellation) {
  auto budget = chosen.liveBudget;
  budget.seconds /= 2;
  checkInView(program, now, budget, cancellation);
}

void Verification::checkScrolledTo(const Programs& program, const ide::Snapshot& now,
                                   const VerificationSettings& chosen,
                                   const rpc::Cancellation& cancellation) {
  if (!hasScrolled()) return;
  auto budget = chosen.liveBudget;
  budget.seconds = std::min(budget.seconds / 2, kMostSecondsAside);
  checkInView(program, now, budget, cancellation);
}

/// When the user scrolls to other definitions, they are verified instead.
void Verification::checkInView(const Programs& program, const ide::Snapshot& now,
                               const worker::Budget& budget,
                               const rpc::Cancellation& cancellation) {
  if (bytesOf(program->program) < kLarge) return;
  auto job = worker::jobFor(program->program);
  job.budget = budget;
  while (true) {
    job.names = takeInView(program->program, cancellation);
    if (job.names.empty()) return;
    const auto found = run(program, now.open(), job, kLiveLimits, runningInView, {});
    if (found)
      recordInView(program, *found, now.open());
    else if (found.error().cancelled)
      forgetInView(job.names);
  }
}

/// The definitions in view that were not verified as such yet; none after a cancellation.
std::vector<std::string> Verification::takeInView(const analysis::Program& program,
                                                  const rpc::Cancellation& cancellation) {
  const std::lock_guard lock(mutex);
  scrolled = false;
  if (cancellation.isCancelled()) return {};
  auto names = newInView(program);
  askedInView.insert(names.begin(), names.end());
  runningInView = rpc::Cancellation();
  return names;
}

/// \pre the mutex is held
std::vector<std::string> Verification::newInView(const analysis::Program& program) const {
  if (viewed.empty()) return {};
  const auto lines = visible.find(viewed.front());
  if (lines == visible.end()) return {};
  auto names = definedIn(program, viewed.front(), lines->second.first, lines->second.last);
  std::erase_if(names, [&](const auto& name) { return askedInView.contains(name); });
  return names;
}

void Verification::forgetInView(const std::vector<std::string>& names) {
  const std::lock_guard lock(mutex);
  for (const auto& name : names) askedInView.erase(name);
}

/// What is inconclusive so far may be decided with the whole program.
void Verification::recordInView(const Programs& program, Verified found,
                                const ide::OpenTexts& open) {
  auto decided = std::make_shared<ide::ProgramVerdicts>(*found.verdicts);
  for (auto& property : decided->properties)
    property.pending = property.verdict == ide::Verdict::Inconclusive;
  found.verdicts = std::move(decided);
  store.setDecided(program, std::move(found), open);
  outside.changed();
}

/// \pre the mutex is held
void Verification::noticeScrolling() {
  if (!runningOn || newInView(runningOn->program).empty()) return;
  scrolled = true;
  runningInView.cancel();
}

bool Verification::hasScrolled() {
  const std::lock_guard lock(mutex);
  return scrolled;
}

} // namespace proskill::lsp
