#pragma once

#include "view/http.h"

#include <atomic>
#include <cstdint>
#include <expected>
#include <functional>
#include <memory>

namespace proskill::view {

/// An HTTP server on the loopback interface.
class HttpServer {
public:
  using Reply = std::function<void(HttpResponse)>;
  /// Must reply exactly once, immediately or later, from any thread.
  using Handler = std::function<void(const HttpRequest&, Reply)>;

  /// Listens on a port (0: any free port).
  [[nodiscard]] static std::expected<std::unique_ptr<HttpServer>, std::string>
  listen(std::uint16_t port);
  virtual ~HttpServer() = default;

  [[nodiscard]] virtual std::uint16_t port() const = 0;
  /// Runs until Ctrl-C or SIGTERM, then calls `stopping`, so that no handler keeps waiting. Several
  /// threads call the handler.
  virtual void run(const Handler& handler, const std::function<void()>& stopping) = 0;
  /// The same until another thread calls `stop`; signals are left to the caller.
  virtual void serve(const Handler& handler, const std::function<void()>& stopping) = 0;
  virtual void stop() = 0;
};

} // namespace proskill::view
