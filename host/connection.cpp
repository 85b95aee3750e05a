#include "host/connection.h"

#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <unistd.h>

namespace proskill::host {

namespace {

bool writeAll(int to, std::string_view bytes) {
  while (!bytes.empty()) {
    const auto count = ::write(to, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

} // namespace

Connection::Connection() : output(fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1)) {
  dup2(STDERR_FILENO, STDOUT_FILENO);
  std::signal(SIGPIPE, SIG_IGN);
}

std::optional<Json> Connection::receive() {
  for (;;) {
    if (const auto end = held.find('\n'); end != std::string::npos) {
      auto message = Json::parse(held.begin(), held.begin() + static_cast<std::ptrdiff_t>(end),
                                 nullptr, false);
      held.erase(0, end + 1);
      return message;
    }
    char bytes[4096];
    const auto count = ::read(STDIN_FILENO, bytes, sizeof bytes);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return std::nullopt;
    held.append(bytes, static_cast<std::size_t>(count));
  }
}

void Connection::send(const Json& message) {
  const auto line = lineOf(message);
  const std::lock_guard lock(sending);
  writeAll(output, line);
}

void Connection::sendInDistress(const std::string& line) const { writeAll(output, line); }

std::string Connection::lineOf(const Json& message) {
  return message.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

} // namespace proskill::host
