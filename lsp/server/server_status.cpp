#include "lsp/server/server.h"
#include "lsp/workspace/fingerprint.h"

/// The answer to `proskill/status`.
namespace proskill::lsp {

namespace {

Json documents(const ide::Snapshot& snapshot) {
  Json result = Json::array();
  for (const auto& [path, text] : snapshot.open())
    if (text.kind != ide::TextKind::Notebook)
      result.push_back({{"uri", text.uri},
                        {"version", text.version},
                        {"bytes", text.document.text().size()},
                        {"hash", fingerprint(text.document.text())}});
  return result;
}

} // namespace

Json Server::status(const ide::Snapshot& snapshot) const {
  return {{"version", options.version},
          {"seconds",
           std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count()},
          {"pending", pending.size()},
          {"errors", errors.load()},
          {"memoryBytes", residentBytes()},
          {"documents", documents(snapshot)},
          {"files", snapshot.files().size()},
          {"requests", statistics.latencies()}};
}

} // namespace proskill::lsp
