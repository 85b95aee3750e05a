#include "lsp/verification/verification.h"

#include "ide/fiacre/fiacre_text.h"
#include "ide/snapshot/fiacre_file.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::lsp {

namespace {

bool hasErrors(const ide::AnalysedProgram& program) {
  const bool byHand = ide::isFiacre(program.program.files.front().path);
  const auto& found = byHand ? program.findings() : program.analysis.diagnostics;
  return std::ranges::any_of(
      found, [](const auto& diagnostic) { return diagnostic.severity == syntax::Severity::Error; });
}

/// Whether there is a model: files with only environments and properties have none.
bool isVerifiable(const ide::AnalysedProgram& program) {
  const auto& root = program.program.files.front();
  return !ide::isFiacre(root.path) || ide::FiacreText(root.document.text()).model().has_value();
}

std::map<std::filesystem::path, std::int64_t> versionsOf(const analysis::Program& program,
                                                         const ide::OpenTexts& open) {
  std::map<std::filesystem::path, std::int64_t> versions;
  for (const auto& file : program.files)
    if (auto text = open.find(file.path); text != open.end())
      versions[file.path] = text->second.version;
  return versions;
}

bool contains(const analysis::Program& program, const std::filesystem::path& file) {
  return std::ranges::find(program.files, file, &analysis::File::path) != program.files.end();
}

constexpr std::string_view kUntrusted =
    "the workspace is not trusted: nothing is verified, only static checks run";

} // namespace

Verification::Verification(Outside with)
    : outside(std::move(with)),
      store([this](const ProgramState& state) { announce(state); }),
      thread([this](const std::stop_token& stop) { live(stop); }) {}

Verification::~Verification() {
  thread.request_stop();
  {
    const std::lock_guard lock(mutex);
    cancelRunning();
  }
  wake.notify_all();
}

void Verification::start(const ClientFeatures& client, VerificationSettings chosen) {
  const std::lock_guard lock(mutex);
  encoding = client.encoding;
  verdictNews = client.verdictNews;
  settings = chosen;
  started = true;
}

void Verification::configure(const Json& section) {
  {
    const std::lock_guard lock(mutex);
    settings = withSettings(settings, section);
    due = std::chrono::steady_clock::now();
    if (!settings.live) cancelRunning();
  }
  wake.notify_all();
}

void Verification::textsChanged(std::shared_ptr<const ide::Snapshot> now, Paths lostNow,
                                const std::optional<std::filesystem::path>& inView) {
  {
    const std::lock_guard lock(mutex);
    snapshot = std::move(now);
    lost = std::move(lostNow);
    if (inView) view(*inView);
    edited = true;
    due = std::chrono::steady_clock::now() + delayAfter(settings, took);
    const bool isUseless =
        runningOn &&
        (hasChanged(runningOn->program, runningVersions, snapshot->open()) ||
         (inView && snapshot->open().contains(*inView) && !contains(runningOn->program, *inView)));
    if (inBackground || isUseless) cancelRunning();
  }
  wake.notify_all();
}

void Verification::filesChanged(const std::vector<std::filesystem::path>& files) {
  const std::lock_guard lock(mutex);
  const bool isConcerned = !runningOn || std::ranges::any_of(files, [&](const auto& file) {
    return contains(runningOn->program, file);
  });
  if (isConcerned) cancelRunning();
}

void Verification::setView(const std::filesystem::path& path, std::optional<Lines> lines) {
  {
    const std::lock_guard lock(mutex);
    if (!snapshot || !snapshot->open().contains(path)) return;
    if (lines) visible[path] = *lines;
    if (!viewed.empty() && viewed.front() == path) return noticeScrolling();
    view(path);
    due = std::chrono::steady_clock::now() + delayAfter(settings, took);
    if (inBackground) cancelRunning();
  }
  wake.notify_all();
}

/// Also what is in view. \pre the mutex is held
void Verification::cancelRunning() {
  running.cancel();
  runningInView.cancel();
}

/// \pre the mutex is held
void Verification::view(const std::filesystem::path& path) {
  viewed.remove(path);
  viewed.push_front(path);
}

/// The text in view, and then the others that the user has viewed and not closed.
/// \pre the mutex is held
std::vector<std::filesystem::path> Verification::textsByView() {
  if (!snapshot) return {};
  viewed.remove_if([&](const auto& path) { return !snapshot->open().contains(path); });
  return {viewed.begin(), viewed.end()};
}

bool Verification::isInBackground() {
  const std::lock_guard lock(mutex);
  return inBackground;
}

VerificationSettings Verification::settingsNow() const {
  const std::lock_guard lock(mutex);
  return settings;
}

void Verification::live(const std::stop_token& stop) {
  std::unique_lock lock(mutex);
  while (!stop.stop_requested()) {
    const bool ripe = due && std::chrono::steady_clock::now() >= *due;
    if (!edited && !ripe) {
      if (due)
        wake.wait_until(lock, *due);
      else
        wake.wait(lock);
      continue;
    }
    const auto now = snapshot;
    if (std::exchange(edited, false)) {
      const auto lostNow = lost;
      lock.unlock();
      noticeEdit(*now, lostNow);
    } else {
      due.reset();
      const auto texts = textsByView();
      if (!started || !now || texts.empty()) continue;
      running = rpc::Cancellation();
      const auto chosen = settings;
      const auto cancellation = running;
      lock.unlock();
      try {
        checkTexts(*now, texts, chosen, cancellation);
      } catch (const std::exception& error) {
        log(fmt::format("live verification failed: {}", error.what()));
      }
    }
    lock.lock();
  }
}

void Verification::noticeEdit(const ide::Snapshot& now, const Paths& lostNow) {
  if (store.noticeEdit(now.open(), *now.includes(), lostNow)) outside.changed();
}

bool Verification::hasLostText(const ide::AnalysedProgram& program) {
  const std::lock_guard lock(mutex);
  return containsAny(program.program, lost);
}

/// Programs that are not in view come last, and any edit or change of the view interrupts them.
void Verification::checkTexts(const ide::Snapshot& now,
                              const std::vector<std::filesystem::path>& texts,
                              const VerificationSettings& chosen,
                              const rpc::Cancellation& cancellation) {
  for (const auto& path : texts) {
    {
      const std::lock_guard lock(mutex);
      inBackground = path != texts.front();
    }
    if (cancellation.isCancelled()) break;
    checkLive(now, path, chosen, cancellation);
  }
  const std::lock_guard lock(mutex);
  inBackground = false;
}

void Verification::checkLive(const ide::Snapshot& now, const std::filesystem::path& path,
                             const VerificationSettings& chosen,
                             const rpc::Cancellation& cancellation) {
  const auto begin = std::chrono::steady_clock::now();
  std::vector<Programs> verified;
  bool isAnyNew = false;
  for (const auto& of : now.views(path)) {
    if (cancellation.isCancelled()) break;
    if (!isVerifiable(*of.owner) || hasLostText(*of.owner)) continue;
    if (!chosen.trusted)
      store.set(of.owner, VerificationState::Off, std::string(kUntrusted));
    else if (!chosen.live)
      store.set(of.owner, VerificationState::Off, "live verification is switched off");
    else if (const auto checked = checkProgram(of.owner, now, chosen, cancellation);
             checked != Checked::No) {
      verified.push_back(of.owner);
      isAnyNew = isAnyNew || checked == Checked::Now;
    }
  }
  {
    const std::lock_guard lock(mutex);
    const auto passed = std::chrono::steady_clock::now() - begin;
    if (!inBackground && (isAnyNew || (took && passed > *took))) took = passed;
  }
  for (const auto& program : verified) measure(program, now.open(), chosen, cancellation);
}

/// An edit of a program that is in work cancels the work, and so does one that came just before.
void Verification::beginWork(const Programs& program, const ide::OpenTexts& open) {
  const std::lock_guard lock(mutex);
  runningOn = program;
  runningVersions = versionsOf(program->program, open);
  askedInView.clear();
  if (hasChanged(program->program, runningVersions, snapshot->open())) cancelRunning();
}

void Verification::endWork() {
  const std::lock_guard lock(mutex);
  runningOn.reset();
}

Verification::Checked Verification::checkProgram(const Programs& program, const ide::Snapshot& now,
                                                 const VerificationSettings& chosen,
                                                 const rpc::Cancellation& cancellation) {
  if (hasErrors(*program)) {
    store.set(program, VerificationState::Errors, "the program has errors");
    return Checked::No;
  }
  const auto known = store.of(program->program.files.front().path);
  const bool isBehind = isInBackground(); // one answer is enough there
  if (isBehind && known && known->state == VerificationState::Failed && known->program == program)
    return Checked::No;
  const bool isEnough =
      known && known->verified && (isBehind || known->verified->verdicts->isComplete());
  if (isEnough && ide::areCurrent(*known->verified->verdicts, program->program)) {
    const bool told = known->state == VerificationState::Done && !known->stale;
    if (!told) store.set(program, VerificationState::Done);
    if (known->stale) outside.changed();
    return Checked::Before;
  }
  beginWork(program, now.open());
  store.set(program, VerificationState::Checking);
  auto job = worker::jobFor(program->program);
  job.budget = chosen.liveBudget;
  auto verified = inViewFirst(program, now, chosen, cancellation, [&] {
    return run(
        program, now.open(), job, kLiveLimits, cancellation,
        [&](const worker::WorkerProgress& progress) { store.setProgress(program, progress); });
  });
  endWork();
  if (verified) {
    record(program, std::move(*verified));
    unmeasured.insert(program->program.files.front().path);
    return Checked::Now;
  }
  if (verified.error().cancelled)
    store.set(program, VerificationState::Waiting);
  else
    store.set(program, VerificationState::Failed, verified.error().message);
  return Checked::No;
}

/// Measures how long skills take, when all verdicts are known. Without an answer nothing is shown;
/// if an edit ends it and is undone, it is done again.
void Verification::measure(const Programs& program, const ide::OpenTexts& open,
                           const VerificationSettings& chosen,
                           const rpc::Cancellation& cancellation) {
  const auto& root = program->program.files.front().path;
  if (!chosen.durations || !unmeasured.contains(root) || ide::isFiacre(root)) return;
  auto job = worker::jobFor(program->program);
  job.durations = true;
  job.budget = chosen.liveBudget;
  beginWork(program, open);
  const auto report = worker::runWorker(outside.worker, job, cancellation, {});
  endWork();
  if (report || !report.error().cancelled) unmeasured.erase(root);
  if (!report) return;
  auto measured = readDurations(*report);
  if (!measured || measured->empty()) return;
  store.setDurations(program, std::move(*measured));
  outside.measured();
}

void Verification::record(const Programs& program, Verified verified) {
  std::shared_ptr<const ide::Snapshot> now;
  {
    const std::lock_guard lock(mutex);
    now = snapshot;
  }
  store.setVerified(program, std::move(verified), now ? now->open() : ide::OpenTexts());
  outside.changed();
}

std::expected<Verified, worker::WorkerFailure>
Verification::run(const Programs& program, const ide::OpenTexts& open, const worker::WorkerJob& job,
                  const LimitSettings& limits, const rpc::Cancellation& cancellation,
                  const std::function<void(const worker::WorkerProgress&)>& progress) {
  const auto& root = program->program.files.front().path;
  log(fmt::format("verifying {}", root.string()));
  GrowingReport growing(program, open, limits);
  auto report =
      worker::runWorker(outside.worker, job, cancellation, progress,
                        [&](const OrderedJson& soFar, const std::vector<std::size_t>& rows) {
                          auto decided = growing.with(soFar, rows);
                          if (!decided) return;
                          store.setDecided(program, std::move(*decided), open);
                          outside.changed();
                        });
  if (!report) {
    log(fmt::format("verifying {}: {}", root.string(), report.error().message));
    return std::unexpected(report.error());
  }
  auto verified = readReport(*report, program, open, limits);
  if (!verified)
    return std::unexpected(
        worker::WorkerFailure{false, "the process that verifies gave a report of an unknown form"});
  return job.names.empty() ? ofWholeProgram(std::move(*verified)) : std::move(*verified);
}

} // namespace proskill::lsp
