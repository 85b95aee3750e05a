#include "lsp/server/platform_publisher.h"

#include "lsp/features/platform.h"

#include <algorithm>

namespace proskill::lsp {

namespace {

constexpr const char* kPlatformMethod = "textDocument/publishDiagnostics";

} // namespace

void PlatformPublisher::changed(std::chrono::milliseconds debounce) {
  ++revision;
  dueAt = std::chrono::steady_clock::now() + debounce;
}

void PlatformPublisher::publish(const Snapshot& snapshot, const DataTexts& texts) {
  dueAt.reset();
  retract(texts);
  if (texts.empty()) return;
  scheduler.post(rpc::Priority::Background, [this, snapshot, texts, asked = revision.load()] {
    compute(*snapshot, texts, asked);
  });
}

/// Removes the diagnostics of files that are not open any more.
void PlatformPublisher::retract(const DataTexts& texts) {
  const std::lock_guard lock(mutex);
  std::erase_if(told, [&](const std::string& uri) {
    const auto has = [&](const auto& entry) { return entry.second.uri == uri; };
    if (std::ranges::any_of(texts, has)) return false;
    peer.notify(kPlatformMethod, {{"uri", uri}, {"diagnostics", Json::array()}});
    return true;
  });
}

void PlatformPublisher::compute(const ide::Snapshot& snapshot, const DataTexts& texts,
                                std::uint64_t asked) {
  for (const auto& [path, data] : texts) {
    if (asked != revision) return;
    try {
      send(data, platformFileDiagnostics(snapshot, path, data.text, client), asked);
    } catch (const std::exception& error) {
      onFailure(data.uri, error.what());
    }
  }
}

void PlatformPublisher::send(const DataText& text, Json found, std::uint64_t asked) {
  const std::lock_guard lock(mutex);
  if (asked != revision) return;
  const bool hadAny = told.contains(text.uri);
  if (found.empty() && !hadAny) return;
  if (found.empty())
    told.erase(text.uri);
  else
    told.insert(text.uri);
  peer.notify(kPlatformMethod,
              {{"uri", text.uri}, {"version", text.version}, {"diagnostics", std::move(found)}});
}

} // namespace proskill::lsp
