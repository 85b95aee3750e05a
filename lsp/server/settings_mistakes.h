#pragma once

#include "lsp/protocol/client.h"
#include "report/program_settings.h"
#include "rpc/peer.h"

#include <filesystem>
#include <map>

namespace proskill::lsp {

/// Reports errors in settings files as diagnostics of these files. For the main thread.
class SettingsMistakes {
public:
  using Mistakes = std::map<std::filesystem::path, report::SettingsMistake>;

  /// Both must outlive this.
  SettingsMistakes(rpc::Peer& peer, const ClientFeatures& client) : peer(peer), client(client) {}

  /// Publishes changes since the last call.
  void publish(Mistakes now);

private:
  rpc::Peer& peer;
  const ClientFeatures& client;
  Mistakes published;
};

} // namespace proskill::lsp
