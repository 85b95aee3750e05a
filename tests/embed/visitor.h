#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace proskill::test {

/// Who visits the page of a run.
class Visitor {
public:
  /// \param address `http://127.0.0.1:PORT/TOKEN/`
  explicit Visitor(const std::string& address);

  /// The answer to a request of the page; its status if it is not 200.
  [[nodiscard]] nlohmann::json ask(const std::string& method,
                                   const nlohmann::json& params = nlohmann::json::object()) const;
  /// \return why the control is refused; "": it is not
  [[nodiscard]] std::string control(const std::string& action,
                                    const std::string& signal = "") const;
  /// The status of the run.
  [[nodiscard]] nlohmann::json status() const { return ask("hello")["result"]["run"]["status"]; }
  /// The head and the body of a response; "" if nobody listens.
  [[nodiscard]] std::string request(const std::string& method, const std::string& path,
                                    const std::string& body = "") const;

  int port = 0;
  std::string token;
};

} // namespace proskill::test
