#include "rpc/connection.h"

#include <array>
#include <cerrno>

#include <fcntl.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

namespace proskill::rpc {

namespace {

class StandardStreams : public Connection {
public:
  StandardStreams() : stop(eventfd(0, EFD_CLOEXEC)) {
    // Enlarges the pipe as far as the system allows, so that large answers are written at once. An
    // error, as for other files than pipes, does no harm.
    constexpr int kRoom = 1 << 20; // bytes
    fcntl(STDOUT_FILENO, F_SETPIPE_SZ, kRoom);
  }
  ~StandardStreams() override { ::close(stop); }
  StandardStreams(const StandardStreams&) = delete;
  StandardStreams& operator=(const StandardStreams&) = delete;

  std::string read() override {
    std::array<pollfd, 2> ends{{{STDIN_FILENO, POLLIN, 0}, {stop, POLLIN, 0}}};
    while (poll(ends.data(), ends.size(), -1) < 0)
      if (errno != EINTR) return {};
    if (ends[1].revents != 0) return {};
    return readSome();
  }

  bool write(std::string_view bytes) override {
    while (!bytes.empty()) {
      auto count = ::write(STDOUT_FILENO, bytes.data(), bytes.size());
      if (count < 0 && errno != EINTR) return false;
      if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
  }

  void close() override {
    const std::uint64_t one = 1;
    [[maybe_unused]] auto written = ::write(stop, &one, sizeof one);
  }

private:
  static std::string readSome() {
    std::string buffer(65536, '\0');
    while (true) {
      auto count = ::read(STDIN_FILENO, buffer.data(), buffer.size());
      if (count < 0 && errno == EINTR) continue;
      buffer.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
      return buffer;
    }
  }

  int stop; ///< readable once the stream is closed
};

} // namespace

std::unique_ptr<Connection> standardStreams() { return std::make_unique<StandardStreams>(); }

} // namespace proskill::rpc
