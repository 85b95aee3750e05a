#pragma once

#include <cstdint>
#include <expected>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace proskill::rpc {

/// A stream of bytes to a client and from it. One thread reads, another may write at the same time.
class Connection {
public:
  virtual ~Connection() = default;
  /// The next bytes; empty when the client has gone.
  [[nodiscard]] virtual std::string read() = 0;
  /// All of the bytes; false when the client has gone.
  virtual bool write(std::string_view bytes) = 0;
  /// Makes a pending read return.
  virtual void close() = 0;
};

/// Standard input and output.
[[nodiscard]] std::unique_ptr<Connection> standardStreams();

/// The first client that connects to a port of the loopback interface. Blocks until it does.
/// \param port 0: any free port; `onListening` gets the number
[[nodiscard]] std::expected<std::unique_ptr<Connection>, std::string>
acceptLoopback(std::uint16_t port, const std::function<void(std::uint16_t)>& onListening);

} // namespace proskill::rpc
