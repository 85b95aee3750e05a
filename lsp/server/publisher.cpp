#include "lsp/server/publisher.h"

#include "analysis/program/stop.h"
#include "lsp/protocol/diagnostics.h"

#include <algorithm>

namespace proskill::lsp {

namespace {

constexpr const char* kMethod = "textDocument/publishDiagnostics";

template <class Pointer> bool isSame(const Pointer& a, const Pointer& b) {
  return !a.owner_before(b) && !b.owner_before(a);
}

} // namespace

void Publisher::changed(std::chrono::milliseconds debounce) {
  ++revision;
  running.cancel();
  {
    // The caller holds the old texts, and releases them when nobody waits.
    const std::lock_guard lock(mutex);
    latest.reset();
  }
  dueAt = std::chrono::steady_clock::now() + debounce;
}

void Publisher::publish(const std::shared_ptr<const ide::Snapshot>& snapshot, bool enabled) {
  dueAt.reset();
  retract(*snapshot, enabled);
  if (!enabled) return;
  running = {};
  {
    const std::lock_guard lock(mutex);
    latest = snapshot;
    const auto isFile = [](const auto& entry) {
      return entry.second.kind != ide::TextKind::Notebook;
    };
    pace.begin(revision, static_cast<std::size_t>(std::ranges::count_if(snapshot->open(), isFile)));
  }
  for (const auto& [path, text] : snapshot->open()) {
    if (text.kind == ide::TextKind::Notebook) continue;
    scheduler.post(rpc::Priority::Background,
                   [this, path = path, asked = revision.load(), wanted = running] {
                     if (wanted.isCancelled()) return;
                     const analysis::StopWhen stop([&] { return wanted.isCancelled(); });
                     publishLatest(path, asked);
                   });
  }
}

void Publisher::leave(const Path& path) {
  const std::lock_guard lock(mutex);
  told.erase(path);
}

bool Publisher::isQuick() {
  const std::lock_guard lock(mutex);
  return pace.isQuick();
}

/// Pending work holds no texts; otherwise fast typing would leave many in memory.
void Publisher::publishLatest(const Path& path, std::uint64_t asked) {
  std::shared_ptr<const ide::Snapshot> snapshot;
  {
    const std::lock_guard lock(mutex);
    snapshot = latest;
  }
  if (snapshot && snapshot->open().contains(path)) publish(*snapshot, path, asked);
}

/// Sends an empty list for each text that is no longer open, or for all.
void Publisher::retract(const ide::Snapshot& snapshot, bool enabled) {
  const std::lock_guard lock(mutex);
  std::erase_if(told, [&](const auto& entry) {
    const auto& [path, last] = entry;
    if (enabled && snapshot.open().contains(path)) return false;
    if (last.sent) peer.notify(kMethod, {{"uri", last.uri}, {"diagnostics", Json::array()}});
    return true;
  });
}

bool Publisher::isTold(const Path& path, const Told& now) {
  const std::lock_guard lock(mutex);
  const auto& last = told[path];
  return last.sent && last.version == now.version && last.uri == now.uri &&
         last.verdicts == now.verdicts &&
         std::ranges::equal(last.owners, now.owners, isSame<Owners::value_type>);
}

/// \param took of this thread
void Publisher::finish(std::uint64_t asked, Pace::Duration took) {
  const std::lock_guard lock(mutex);
  pace.finish(asked, took);
}

void Publisher::publish(const ide::Snapshot& snapshot, const Path& path, std::uint64_t asked) {
  const auto& text = snapshot.open().at(path);
  try {
    const auto start = std::chrono::steady_clock::now();
    const auto began = ThreadClock::now();
    Told now{text.uri, text.version, {}, verdicts(), true};
    for (const auto& view : snapshot.views(path)) now.owners.emplace_back(view.owner);
    if (isTold(path, now)) return finish(asked, ThreadClock::now() - began);
    scheduler.giveWay();
    auto list = diagnosticsOf(snapshot, path, client, *now.verdicts);
    finish(asked, ThreadClock::now() - began);
    std::unique_lock lock(mutex);
    if (asked != revision) return;
    peer.notify(kMethod,
                {{"uri", text.uri}, {"version", text.version}, {"diagnostics", std::move(list)}});
    told[path] = std::move(now);
    statistics.add(kMethod, std::chrono::steady_clock::now() - start);
    lock.unlock();
    onPublished(snapshot);
    (void)snapshot.takeReplaced();     // no request waits for it now
  } catch (const analysis::Stopped&) { // by an edit, which will request new ones
  } catch (const std::exception& error) {
    onFailure(kMethod, {{"uri", text.uri}}, error.what());
  }
}

} // namespace proskill::lsp
