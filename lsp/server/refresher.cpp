#include "lsp/server/refresher.h"

#include <algorithm>

namespace proskill::lsp {

namespace {

/// Whether another open text shares one of the file's programs, of which there may be hundreds.
bool sharesProgram(const ide::IncludeGraph& graph, const std::filesystem::path& file,
                   const ide::OpenTexts& open) {
  const auto roots = graph.rootsOf(file);
  auto isRoot = [&](const auto& root) { return std::ranges::binary_search(roots, root); };
  return std::ranges::any_of(open, [&](const auto& entry) {
    const auto& [path, text] = entry;
    return path != file && text.kind != ide::TextKind::Notebook &&
           std::ranges::any_of(graph.rootsOf(path), isRoot);
  });
}

} // namespace

void Refresher::changed(const Path& file, const ide::Snapshot& then,
                        std::chrono::milliseconds delay) {
  if (client.refreshes.empty()) return; // no client needs it
  if (!before) before = then.includes();
  files.insert(file);
  delayBy(delay);
}

void Refresher::allChanged(std::chrono::milliseconds delay) {
  all = true;
  delayBy(delay);
}

void Refresher::findingsChanged(std::chrono::milliseconds delay) {
  findings = true;
  delayBy(delay);
}

void Refresher::delayBy(std::chrono::milliseconds delay) {
  if (!client.refreshes.empty()) dueAt = std::chrono::steady_clock::now() + delay;
}

/// An edit may split a program, or join two.
bool Refresher::concernsOthers(const ide::Snapshot& now) const {
  const auto& after = now.includes();
  return std::ranges::any_of(files, [&](const Path& file) {
    return sharesProgram(*after, file, now.open()) ||
           (before != after && sharesProgram(*before, file, now.open()));
  });
}

void Refresher::refresh(const ide::Snapshot& now) {
  dueAt.reset();
  const bool wanted = all ? !now.open().empty() : concernsOthers(now);
  if (wanted)
    ask({"workspace/semanticTokens/refresh", "workspace/inlayHint/refresh",
         "workspace/inlineValue/refresh", "workspace/codeLens/refresh"});
  if (wanted || findings) ask({"workspace/diagnostic/refresh"});
  all = findings = false;
  files.clear();
  before.reset();
}

void Refresher::ask(std::initializer_list<const char*> methods) {
  if (stopped) return;
  for (const auto* method : methods)
    if (client.refreshes.contains(method)) peer.ask(method, nullptr);
}

} // namespace proskill::lsp
