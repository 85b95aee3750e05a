#pragma once

#include "lsp/protocol/numbers.h"
#include "rpc/peer.h"

#include <chrono>
#include <map>
#include <string>

namespace proskill::lsp {

/// Shows messages to the user in the editor, rate-limited: the same message at most once a minute,
/// and only a few of any kind in that time. All messages go to the editor's log. For the main
/// thread.
class Announcer {
public:
  using Time = std::chrono::steady_clock::time_point;
  using Kind = protocol::MessageType;

  explicit Announcer(rpc::Peer& peer) : peer(peer) {}

  void show(Kind kind, const std::string& message, Time now = std::chrono::steady_clock::now()) {
    const Json params{{"type", kind}, {"message", message}};
    peer.notify("window/logMessage", params);
    std::erase_if(shown, [&](const auto& entry) { return now - entry.second >= kPause; });
    if (shown.size() >= kMost || !shown.try_emplace(message, now).second) return;
    peer.notify("window/showMessage", params);
  }

private:
  static constexpr std::chrono::minutes kPause{1};
  static constexpr std::size_t kMost = 3;

  rpc::Peer& peer;
  std::map<std::string, Time> shown;
};

} // namespace proskill::lsp
