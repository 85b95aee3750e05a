#include "tests/embed/visitor.h"

#include <fmt/format.h>

#include <arpa/inet.h>
#include <array>
#include <sys/socket.h>
#include <unistd.h>

namespace proskill::test {

using nlohmann::json;

Visitor::Visitor(const std::string& address) {
  const std::string host = "http://127.0.0.1:";
  if (!address.starts_with(host)) return;
  const auto slash = address.find('/', host.size());
  port = std::stoi(address.substr(host.size(), slash - host.size()));
  token = address.substr(slash + 1, address.size() - slash - 2);
}

std::string Visitor::request(const std::string& method, const std::string& path,
                             const std::string& body) const {
  const int connection = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in at{};
  at.sin_family = AF_INET;
  at.sin_port = htons(static_cast<std::uint16_t>(port));
  at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  std::string response;
  if (connect(connection, reinterpret_cast<const sockaddr*>(&at), sizeof at) == 0) {
    const auto text = fmt::format("{} {} HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nContent-Type: "
                                  "application/json\r\nContent-Length: {}\r\n\r\n{}",
                                  method, path, port, body.size(), body);
    std::ignore = send(connection, text.data(), text.size(), MSG_NOSIGNAL);
    std::array<char, 4096> part{};
    for (ssize_t size = 0; (size = recv(connection, part.data(), part.size(), 0)) > 0;)
      response.append(part.data(), static_cast<std::size_t>(size));
  }
  close(connection);
  return response;
}

json Visitor::ask(const std::string& method, const json& params) const {
  const auto response = request("POST", "/" + token + "/api/" + method, params.dump());
  const auto status = response.substr(std::min<std::size_t>(9, response.size()), 3);
  if (status != "200") return status;
  return json::parse(response.substr(response.find("\r\n\r\n") + 4));
}

std::string Visitor::control(const std::string& action, const std::string& signal) const {
  return ask("control", {{"do", action}, {"signal", signal}}).value("error", "");
}

} // namespace proskill::test
