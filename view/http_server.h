#pragma once

#include "view/http.h"

#include <atomic>
#include <cstdint>
#include <expected>
#include <functional>
#include <memory>

namespace proskill::view {

/// Answers requests on the loopback interface alone.
class HttpServer {
public:
  using Reply = std::function<void(HttpResponse)>;
  /// Replies once, at once or later, from any thread.
  using Handler = std::function<void(const HttpRequest&, Reply)>;

  /// Listens on a port (0: any free one).
  [[nodiscard]] static std::expected<std::unique_ptr<HttpServer>, std::string>
  listen(std::uint16_t port);
  virtual ~HttpServer() = default;

  [[nodiscard]] virtual std::uint16_t port() const = 0;
  /// Until Ctrl-C or SIGTERM; then `stopping` is called, so that no handler waits any longer. The
  /// handler is called by several threads.
  virtual void run(const Handler& handler, const std::function<void()>& stopping) = 0;
};

} // namespace proskill::view
