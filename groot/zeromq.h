#pragma once

#include <cstdint>
#include <expected>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace proskill::groot {

/// The two sockets that viewers of a run expect, at a port of the loopback interface and the next
/// one: the first answers requests, the second publishes messages. libzmq is loaded when they are
/// opened, so that the program runs without it.
class Sockets {
public:
  /// \param port 0: any free one \return the sockets, or why there are none
  [[nodiscard]] static std::expected<std::unique_ptr<Sockets>, std::string>
  open(std::uint16_t port);
  Sockets() = default;
  Sockets(const Sockets&) = delete;
  Sockets& operator=(const Sockets&) = delete;
  virtual ~Sockets() = default;

  [[nodiscard]] virtual std::uint16_t port() const = 0;
  /// Waits until a request has come, the descriptor is readable, or for the time in milliseconds;
  /// -1: without limit.
  virtual void wait(int descriptor, long milliseconds) = 0;
  /// The parts of the next request, if there is one. It must be answered before the next one.
  [[nodiscard]] virtual std::optional<std::vector<std::string>> receive() = 0;
  virtual void reply(const std::vector<std::string>& parts) = 0;
  /// Sends a message to those that have subscribed; without waiting for them.
  virtual void publish(const std::vector<std::string>& parts) = 0;
};

} // namespace proskill::groot
