#include "rpc/connection.h"

#include <asio.hpp>

#include <array>

namespace proskill::rpc {

namespace {

using asio::ip::tcp;

class Socket : public Connection {
public:
  explicit Socket(std::unique_ptr<asio::io_context> owner, tcp::socket socket)
      : owner(std::move(owner)), socket(std::move(socket)) {}

  std::string read() override {
    std::array<char, 65536> buffer{};
    asio::error_code error;
    auto count = socket.read_some(asio::buffer(buffer), error);
    return error ? std::string() : std::string(buffer.data(), count);
  }

  bool write(std::string_view bytes) override {
    asio::error_code error;
    asio::write(socket, asio::buffer(bytes), error);
    return !error;
  }

  void close() override {
    asio::error_code ignored;
    socket.shutdown(tcp::socket::shutdown_both, ignored);
  }

private:
  std::unique_ptr<asio::io_context> owner; ///< declared before its socket, to outlive it
  tcp::socket socket;
};

} // namespace

std::expected<std::unique_ptr<Connection>, std::string>
acceptLoopback(std::uint16_t port, const std::function<void(std::uint16_t)>& onListening) {
  auto context = std::make_unique<asio::io_context>();
  asio::error_code error;
  tcp::acceptor acceptor(*context);
  const tcp::endpoint endpoint(asio::ip::address_v4::loopback(), port);
  acceptor.open(endpoint.protocol(), error);
  if (!error) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
  if (!error) acceptor.bind(endpoint, error);
  if (!error) acceptor.listen(1, error);
  tcp::socket socket(*context);
  if (!error) onListening(acceptor.local_endpoint(error).port());
  if (!error) acceptor.accept(socket, error);
  if (error) return std::unexpected(error.message());
  return std::make_unique<Socket>(std::move(context), std::move(socket));
}

} // namespace proskill::rpc
