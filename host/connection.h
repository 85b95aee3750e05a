#pragma once

#include <nlohmann/json.hpp>

#include <mutex>
#include <optional>
#include <string>

namespace proskill::host {

using Json = nlohmann::ordered_json;

/// Connection to `proskill run`. Standard output carries only messages; what the library prints
/// goes to standard error.
class Connection {
public:
  Connection();

  /// The next message; nullopt at the end of the input.
  [[nodiscard]] std::optional<Json> receive();
  /// Thread-safe. Messages are dropped once the other end is gone.
  void send(const Json& message);
  /// Async-signal-safe; the line must have been prepared before.
  void sendInDistress(const std::string& line) const;

  [[nodiscard]] static std::string lineOf(const Json& message);

private:
  int output = -1;
  std::mutex sending;
  std::string held; ///< bytes received, not yet returned as messages
};

} // namespace proskill::host
