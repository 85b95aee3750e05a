#include "view/http_server.h"

#include <asio.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>

namespace proskill::view {

namespace {

using asio::ip::tcp;

constexpr std::size_t kLargestHead = std::size_t{1} << 14;
constexpr std::size_t kThreads = 4;
/// Delay before accepting connections again after the process ran out of descriptors.
constexpr std::chrono::milliseconds kPause{200};
/// Time for answers that are on their way when the server is asked to stop.
constexpr std::chrono::milliseconds kLastMoment{200};
/// Time that a client has to send or receive; browsers open connections that they do not use.
constexpr std::chrono::seconds kPatience{10};

/// One request and its response; then the connection is closed. Reading and writing is
/// asynchronous, on the thread of its context; the handler runs on a worker. The timer holds the
/// connection too, so it is cancelled when the client has left.
class Exchange : public std::enable_shared_from_this<Exchange> {
public:
  Exchange(tcp::socket connection, asio::thread_pool& pool, const HttpServer::Handler& answer)
      : socket(std::move(connection)),
        patience(socket.get_executor()),
        workers(pool),
        handler(answer) {}

  void start() {
    wait();
    asio::async_read_until(socket, asio::dynamic_buffer(bytes, kLargestHead), "\r\n\r\n",
                           [self = shared_from_this()](asio::error_code error, std::size_t length) {
                             if (error == asio::error::not_found)
                               self->refuse(413, "the request is too large");
                             else if (error)
                               self->patience.cancel();
                             else
                               self->takeHead(length);
                           });
  }

private:
  void wait() {
    patience.expires_after(kPatience);
    patience.async_wait([self = shared_from_this()](asio::error_code error) {
      if (!error) self->socket.close(error);
    });
  }

  void takeHead(std::size_t length) {
    auto head = parseHead(std::string_view(bytes).substr(0, length - 4));
    if (!head) return refuse(400, "not a valid request");
    request = std::move(*head);
    bytes.erase(0, length);
    const auto size = bodySize(request);
    if (!size) return refuse(413, "the request is too large, or has no length");
    const auto missing = *size - std::min(*size, bytes.size());
    asio::async_read(
        socket, asio::dynamic_buffer(bytes), asio::transfer_exactly(missing),
        [self = shared_from_this(), size = *size](asio::error_code error, std::size_t) {
          self->patience.cancel();
          if (!error) self->takeBody(size);
        });
  }

  void takeBody(std::size_t size) {
    request.body = bytes.substr(0, size);
    asio::post(workers, [self = shared_from_this()] {
      self->handler(self->request, [self](HttpResponse response) {
        asio::post(self->socket.get_executor(),
                   [self, response = std::move(response)] { self->send(response); });
      });
    });
  }

  void refuse(int status, std::string why) { send({status, "text/plain", std::move(why), {}}); }

  void send(const HttpResponse& response) {
    wait();
    bytes = toBytes(response, request.method);
    asio::async_write(socket, asio::buffer(bytes),
                      [self = shared_from_this()](asio::error_code error, std::size_t) {
                        self->patience.cancel();
                        self->socket.shutdown(tcp::socket::shutdown_both, error);
                      });
  }

  tcp::socket socket;
  asio::steady_timer patience;
  asio::thread_pool& workers;
  const HttpServer::Handler& handler;
  HttpRequest request;
  std::string bytes;
};

class LoopbackServer : public HttpServer {
public:
  LoopbackServer() : signals(context), acceptor(context), pause(context), moment(context) {}

  asio::error_code open(std::uint16_t wanted) {
    asio::error_code error;
    const tcp::endpoint endpoint(asio::ip::address_v4::loopback(), wanted);
    acceptor.open(endpoint.protocol(), error);
    if (!error) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
    if (!error) acceptor.bind(endpoint, error);
    if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
    return error;
  }

  [[nodiscard]] std::uint16_t port() const override { return acceptor.local_endpoint().port(); }

  void run(const Handler& handler, const std::function<void()>& stopping) override {
    signals.add(SIGINT);
    signals.add(SIGTERM);
    signals.async_wait([this](const asio::error_code&, int) { context.stop(); });
    serve(handler, stopping);
  }

  void serve(const Handler& handler, const std::function<void()>& stopping) override {
    asio::thread_pool workers(kThreads);
    accept(workers, handler);
    context.run();
    asio::error_code ignored;
    acceptor.close(ignored);
    stopping();
    workers.join();
  }

  void stop() override {
    asio::post(context, [this] {
      moment.expires_after(kLastMoment);
      moment.async_wait([this](const asio::error_code&) { context.stop(); });
    });
  }

private:
  void accept(asio::thread_pool& workers, const Handler& handler) {
    acceptor.async_accept([&](const asio::error_code& error, tcp::socket socket) {
      if (error) return acceptLater(workers, handler);
      std::make_shared<Exchange>(std::move(socket), workers, handler)->start();
      accept(workers, handler);
    });
  }

  /// Without free descriptors the connection stays queued. Accepting at once would loop without
  /// progress.
  void acceptLater(asio::thread_pool& workers, const Handler& handler) {
    pause.expires_after(kPause);
    pause.async_wait([&](const asio::error_code& error) {
      if (!error) accept(workers, handler);
    });
  }

  asio::io_context context;
  asio::signal_set signals;
  tcp::acceptor acceptor;
  asio::steady_timer pause;
  asio::steady_timer moment;
};

} // namespace

std::expected<std::unique_ptr<HttpServer>, std::string> HttpServer::listen(std::uint16_t port) {
  auto server = std::make_unique<LoopbackServer>();
  if (const auto error = server->open(port)) return std::unexpected(error.message());
  return server;
}

} // namespace proskill::view
