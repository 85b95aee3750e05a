#include "lsp/verification/defined_in.h"
#include "lsp/verification/verification.h"

#include <algorithm>

/// What is visible of a large program is verified first: few properties need only a small part of
/// the model. Errors are ignored, since the whole program is verified, too.
namespace proskill::lsp {

namespace {

/// The complete verification of a larger program may exceed its budget.
constexpr std::size_t kLarge = 64 * 1024;

/// Limit for definitions that come into view while the whole program is being verified: both use
/// the same processors.
constexpr double kMostSecondsAside = 5;

std::size_t bytesOf(const analysis::Program& program) {
  std::size_t bytes = 0;
  for (const auto& file : program.files) bytes += file.document.text().size();
  return bytes;
}

} // namespace

void Verification::checkInView(const Programs& program, const ide::Snapshot& now, double seconds,
                               const VerificationSettings& chosen,
                               const rpc::Cancellation& cancellation, const std::stop_token& stop) {
  const auto [names, part] = takeInView(program->program, cancellation, stop);
  if (names.empty()) return;
  auto job = worker::jobFor(program->program);
  job.names = names;
  job.budget = chosen.liveBudget;
  job.budget.seconds = seconds;
  const auto found = run(program, now.open(), job, kLiveLimits, part, {});
  if (found)
    recordInView(program, *found, now.open());
  else if (found.error().cancelled)
    forgetInView(names);
}

std::expected<Verified, worker::WorkerFailure>
Verification::inViewFirst(const Programs& program, const ide::Snapshot& now,
                          const VerificationSettings& chosen, const rpc::Cancellation& cancellation,
                          const RunAll& all) {
  if (bytesOf(program->program) < kLarge) return all();
  const double most = chosen.liveBudget.seconds / 2;
  checkInView(program, now, most, chosen, cancellation, {});
  std::jthread aside([&](const std::stop_token& stop) {
    while (hasScrolled(stop))
      checkInView(program, now, std::min(most, kMostSecondsAside), chosen, cancellation, stop);
  });
  auto verified = all();
  aside.request_stop();
  const std::lock_guard lock(mutex);
  runningInView.cancel();
  return verified;
}

/// The definitions in view that were not verified as such yet, and what cancels their
/// verification; none after a cancellation.
std::pair<std::vector<std::string>, rpc::Cancellation>
Verification::takeInView(const analysis::Program& program, const rpc::Cancellation& cancellation,
                         const std::stop_token& stop) {
  const std::lock_guard lock(mutex);
  scrolled = false;
  takenInView.clear();
  if (cancellation.isCancelled() || stop.stop_requested()) return {};
  auto names = namesInView(program);
  std::erase_if(names, [&](const auto& name) { return askedInView.contains(name); });
  askedInView.insert(names.begin(), names.end());
  takenInView.insert(names.begin(), names.end());
  runningInView = rpc::Cancellation();
  return {names, runningInView};
}

/// \pre the mutex is held
std::vector<std::string> Verification::namesInView(const analysis::Program& program) const {
  if (viewed.empty()) return {};
  const auto lines = visible.find(viewed.front());
  if (lines == visible.end()) return {};
  return definedIn(program, viewed.front(), lines->second.first, lines->second.last);
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

/// What is being verified goes on as long as any of it is in view.
/// \pre the mutex is held
void Verification::noticeScrolling() {
  if (!runningOn) return;
  const auto names = namesInView(runningOn->program);
  const auto isIn = [](const auto& set) {
    return [&set](const auto& name) { return set.contains(name); };
  };
  if (std::ranges::all_of(names, isIn(askedInView))) return;
  if (std::ranges::none_of(names, isIn(takenInView))) runningInView.cancel();
  scrolled = true;
  scrolling.notify_all();
}

/// Waits until the user scrolls. \return whether he has, before the stop
bool Verification::hasScrolled(const std::stop_token& stop) {
  std::unique_lock lock(mutex);
  return scrolling.wait(lock, stop, [&] { return scrolled; });
}

} // namespace proskill::lsp
