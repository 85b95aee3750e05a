#pragma once

#include "lsp/connection.h"
#include "lsp/framing.h"

#include <mutex>

namespace proskill::lsp {

/// Where every thread leaves its messages to the client; each goes out whole.
class Outbox {
public:
  explicit Outbox(Connection& connection) : connection(connection) {}

  void send(std::string_view body) {
    auto message = frame(body);
    std::lock_guard lock(mutex);
    connection.write(message);
  }

private:
  std::mutex mutex;
  Connection& connection;
};

} // namespace proskill::lsp
