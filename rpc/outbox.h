#pragma once

#include "rpc/connection.h"
#include "rpc/framing.h"

#include <mutex>

namespace proskill::rpc {

/// Where every thread leaves its messages to the client; each goes out whole.
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
  static constexpr std::size_t kCopied = 65536; ///< bytes that are put behind their header

  void sendLarge(std::string_view body) {
    std::lock_guard lock(mutex);
    if (connection.write(header(body.size()))) connection.write(body);
  }

  std::mutex mutex;
  Connection& connection;
};

} // namespace proskill::rpc
