#pragma once

#include "rpc/outbox.h"
#include "rpc/rpc.h"

#include <functional>
#include <map>
#include <mutex>
#include <string>

namespace proskill::rpc {

/// Sends notifications and requests to the client. Any thread may use it.
class Peer {
public:
  /// Receives the result of the answer on the main thread. Not called if the answer is an error.
  using OnResult = std::function<void(const Json& result)>;

  explicit Peer(Outbox& outbox) : outbox(outbox) {}

  void notify(std::string_view method, const Json& params) {
    outbox.send(notification(method, params));
  }

  void ask(std::string_view method, const Json& params, OnResult onResult = nullptr) {
    std::string id;
    {
      const std::lock_guard lock(mutex);
      id = "proskill-" + std::to_string(++last);
      waiting[id] = std::move(onResult);
    }
    outbox.send(request(id, method, params));
  }

  /// Handles a response. \return whether it answers a request of this peer
  bool answered(const Message& answer) {
    OnResult onResult;
    {
      const std::lock_guard lock(mutex);
      auto found =
          answer.id.is_string() ? waiting.find(answer.id.get<std::string>()) : waiting.end();
      if (found == waiting.end()) return false;
      onResult = std::move(found->second);
      waiting.erase(found);
    }
    if (onResult && answer.error.is_null()) onResult(answer.result);
    return true;
  }

private:
  Outbox& outbox;
  std::mutex mutex;
  std::map<std::string, OnResult, std::less<>> waiting;
  unsigned long last = 0;
};

} // namespace proskill::rpc
