#include "lsp/verification/verdict_store.h"

#include <algorithm>

namespace proskill::lsp {

namespace {

const std::filesystem::path& rootOf(const ide::AnalysedProgram& program) {
  return program.program.files.front().path;
}

bool isOpen(const analysis::Program& program, const ide::OpenTexts& open) {
  return std::ranges::any_of(program.files,
                             [&](const auto& file) { return open.contains(file.path); });
}

/// Why a program is not verified any more; null if it is still one.
const char* whyGone(const std::filesystem::path& root, const analysis::Program& program,
                    const ide::OpenTexts& open, const ide::IncludeGraph& includes) {
  if (!isOpen(program, open)) return "the program is not open any more";
  if (!includes.named(root)) return "the file does not exist any more";
  const auto roots = includes.rootsOf(root);
  return std::ranges::find(roots, root) == roots.end() ? "the file is part of a program" : nullptr;
}

} // namespace

std::string_view nameOf(VerificationState state) {
  switch (state) {
  case VerificationState::Waiting: return "waiting";
  case VerificationState::Checking: return "checking";
  case VerificationState::Done: return "done";
  case VerificationState::Errors: return "errors";
  case VerificationState::Failed: return "failed";
  case VerificationState::Off: return "off";
  }
  return "";
}

bool containsAny(const analysis::Program& program, const std::set<std::filesystem::path>& files) {
  return std::ranges::any_of(program.files,
                             [&](const auto& file) { return files.contains(file.path); });
}

bool hasChanged(const analysis::Program& program,
                const std::map<std::filesystem::path, std::int64_t>& wereOpen,
                const ide::OpenTexts& open) {
  return std::ranges::any_of(program.files, [&](const analysis::File& file) {
    auto text = open.find(file.path);
    if (text == open.end())
      return wereOpen.contains(file.path); // closed: now the version on the
                                           // disk counts
    return !file.document.isSameAs(text->second.document) &&
           file.document.text() != text->second.document.text();
  });
}

std::shared_ptr<const ide::Verdicts> VerdictStore::verdicts() const {
  const std::lock_guard lock(mutex);
  return published;
}

std::optional<ProgramState> VerdictStore::of(const std::filesystem::path& root) const {
  const std::lock_guard lock(mutex);
  auto found = entries.find(root);
  return found == entries.end() ? std::nullopt : std::optional(found->second);
}

/// \pre the mutex is held
ProgramState& VerdictStore::entry(const std::shared_ptr<const ide::AnalysedProgram>& program) {
  auto& state = entries[rootOf(*program)];
  state.program = program;
  state.stale = state.verified && !ide::areCurrent(*state.verified->verdicts, program->program);
  return state;
}

void VerdictStore::set(const std::shared_ptr<const ide::AnalysedProgram>& program,
                       VerificationState now, std::string message) {
  const std::lock_guard lock(mutex);
  const bool isNew = !entries.contains(rootOf(*program));
  const bool wasStale = !isNew && entries[rootOf(*program)].stale;
  auto& state = entry(program);
  const bool isComplete = state.verified && state.verified->verdicts->isComplete();
  if (now == VerificationState::Waiting && isComplete && !state.stale)
    now = VerificationState::Done; // nothing is pending
  if (!isNew && now == state.state && message == state.message && wasStale == state.stale) return;
  state.state = now;
  state.message = std::move(message);
  state.progress.reset();
  tell(state);
}

void VerdictStore::setProgress(const std::shared_ptr<const ide::AnalysedProgram>& program,
                               const worker::WorkerProgress& progress) {
  const std::lock_guard lock(mutex);
  auto& state = entry(program);
  state.state = VerificationState::Checking;
  state.progress = progress;
  tell(state);
}

void VerdictStore::setDecided(const std::shared_ptr<const ide::AnalysedProgram>& program,
                              Verified soFar, const ide::OpenTexts& open) {
  const std::lock_guard lock(mutex);
  auto& state = entry(program);
  if (state.verified) soFar = merged(*state.verified, std::move(soFar));
  state.verified = std::make_shared<const Verified>(std::move(soFar));
  state.stale = hasChanged(program->program, state.verified->verdicts->versions, open);
  state.state = VerificationState::Checking;
  publish();
  tell(state);
}

void VerdictStore::setVerified(const std::shared_ptr<const ide::AnalysedProgram>& program,
                               Verified verified, const ide::OpenTexts& open) {
  const std::lock_guard lock(mutex);
  auto& state = entry(program);
  if (state.verified) verified = merged(*state.verified, std::move(verified));
  state.verified = std::make_shared<const Verified>(std::move(verified));
  state.stale = hasChanged(program->program, state.verified->verdicts->versions, open);
  state.state = state.stale ? VerificationState::Waiting : VerificationState::Done;
  state.message.clear();
  state.progress.reset();
  publish();
  tell(state);
}

void VerdictStore::setDurations(const std::shared_ptr<const ide::AnalysedProgram>& program,
                                std::vector<ide::SkillDuration> durations) {
  const std::lock_guard lock(mutex);
  const auto found = entries.find(rootOf(*program));
  if (found == entries.end() || !found->second.verified) return;
  Verified verified = *found->second.verified;
  if (!ide::areCurrent(*verified.verdicts, program->program)) return;
  auto verdicts = std::make_shared<ide::ProgramVerdicts>(*verified.verdicts);
  verdicts->durations = std::move(durations);
  verified.verdicts = std::move(verdicts);
  found->second.verified = std::make_shared<const Verified>(std::move(verified));
  publish();
}

/// \pre the mutex is held
void VerdictStore::forget(ProgramState& state, std::string why) {
  state.state = VerificationState::Off;
  state.message = std::move(why);
  tell(state);
}

bool VerdictStore::noticeEdit(const ide::OpenTexts& open, const ide::IncludeGraph& includes,
                              const std::set<std::filesystem::path>& lost) {
  const std::lock_guard lock(mutex);
  bool changed = false;
  for (auto it = entries.begin(); it != entries.end();) {
    auto& state = it->second;
    const bool isLost = containsAny(state.program->program, lost);
    const char* why = isLost ? nullptr : whyGone(it->first, state.program->program, open, includes);
    if (why) {
      forget(state, why);
      it = entries.erase(it);
      changed = true;
      continue;
    }
    ++it;
    if (!state.verified) continue;
    const auto& verdicts = *state.verified->verdicts;
    const bool stale = isLost || hasChanged(verdicts.program->program, verdicts.versions, open);
    if (stale == state.stale) continue;
    state.stale = stale;
    if (state.state != VerificationState::Off)
      state.state = stale ? VerificationState::Waiting : VerificationState::Done;
    state.message.clear();
    tell(state);
    changed = true;
  }
  if (changed) publish();
  return changed;
}

/// \pre the mutex is held
void VerdictStore::publish() {
  auto all = std::make_shared<ide::Verdicts>();
  for (const auto& [root, state] : entries)
    if (state.verified) (*all)[root] = state.verified->verdicts;
  published = std::move(all);
}

} // namespace proskill::lsp
