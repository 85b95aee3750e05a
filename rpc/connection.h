#pragma once

#include <cstdint>
#include <expected>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace proskill::rpc {

/// A stream of bytes from and to a client. One thread may read while another one writes.
class Connection {
public:
  virtual ~Connection() = default;
  /// The next bytes; empty when the client has disconnected.
  [[nodiscard]] virtual std::string read() = 0;
  /// Writes all bytes; returns false if the client has disconnected.
  virtual bool write(std::string_view bytes) = 0;
  /// Unblocks a pending read.
  virtual void close() = 0;
};

/// Standard input and output.
[[nodiscard]] std::unique_ptr<Connection> standardStreams();

/// Waits for the first client that connects to a port on the loopback interface.
/// \param port 0: any free port; `onListening` receives its number
[[nodiscard]] std::expected<std::unique_ptr<Connection>, std::string>
acceptLoopback(std::uint16_t port, const std::function<void(std::uint16_t)>& onListening);

} // namespace proskill::rpc
