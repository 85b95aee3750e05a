#pragma once

#include "rpc/error_codes.h"

#include <nlohmann/json.hpp>

#include <expected>
#include <string>
#include <string_view>

namespace proskill {

/// JSON of protocols. What people read is `OrderedJson`, see report/ordered_json.h.
using Json = nlohmann::json;

} // namespace proskill

/// JSON-RPC 2.0 as LSP uses it: no batches, identifiers are numbers or strings.
namespace proskill::rpc {

struct RpcError {
  ErrorCode code = ErrorCode::InternalError;
  std::string message;
  Json data = nullptr; ///< as the method's specification says; null where there is none
};

enum class MessageKind : std::uint8_t { Request, Notification, Response };

struct Message {
  MessageKind kind = MessageKind::Notification;
  Json id;            ///< of requests and responses
  std::string method; ///< of requests and notifications
  Json params;        ///< null where absent
  Json result;        ///< of a response that is no error
  Json error;         ///< of a response; null where there is none
  /// Half a character or a byte that is no UTF-8 was in it, each of which reads as U+FFFD now: one
  /// unit of UTF-16 as half a character is, so that later places mean what the client means.
  bool isRepaired = false;
};

/// What is wrong with a body that is no message, and the identifier that an answer to it must bear:
/// null where it cannot be known.
struct MalformedMessage {
  RpcError error;
  Json id;
};

[[nodiscard]] std::expected<Message, MalformedMessage> parseMessage(std::string_view body);

[[nodiscard]] std::string request(const Json& id, std::string_view method, const Json& params);
[[nodiscard]] std::string notification(std::string_view method, const Json& params);
[[nodiscard]] std::string reply(const Json& id, const Json& result);
[[nodiscard]] std::string replyError(const Json& id, const RpcError& error);

/// A member of a member …; null where one of them is absent, or no object.
[[nodiscard]] const Json& memberAt(const Json& json, std::initializer_list<const char*> path);

} // namespace proskill::rpc
