#pragma once

#include "rpc/connection.h"
#include "rpc/framing.h"

#include <mutex>

namespace proskill::rpc {

/// Messages to the client, from any thread; each is sent as a whole.
class Outbox {
public:
  explicit Outbox(Connection& connection) : connection(connection) {}

  void send(std::string_view body) {
    if (body.size() > kCopied) return sendLarge(body);
    auto message = frame(body);
    std::lock_guard lock(mutex);
    connection.write(message);
  }

private:
  static constexpr std::size_t kCopied =
      65536; ///< bodies up to this size are copied after their header

  void sendLarge(std::string_view body) {
    std::lock_guard lock(mutex);
    if (connection.write(header(body.size()))) connection.write(body);
  }

  std::mutex mutex;
  Connection& connection;
};

} // namespace proskill::rpc
