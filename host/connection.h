#pragma once

#include <nlohmann/json.hpp>

#include <mutex>
#include <optional>
#include <string>

namespace proskill::host {

using Json = nlohmann::ordered_json;

/// The line to `proskill run`. What the library prints goes to the standard error: the standard
/// output is the line's.
class Connection {
public:
  Connection();

  /// The next message; nothing when there will be none.
  [[nodiscard]] std::optional<Json> receive();
  /// From any thread. What cannot be sent is dropped: the other end is gone.
  void send(const Json& message);
  /// From a signal handler: a message that was made before.
  void sendInDistress(const std::string& line) const;

  [[nodiscard]] static std::string lineOf(const Json& message);

private:
  int output = -1;
  std::mutex sending;
  std::string held; ///< what has come, without what was returned
};

} // namespace proskill::host
