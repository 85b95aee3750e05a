#pragma once

#include "rpc/error_codes.h"

#include <nlohmann/json.hpp>

#include <expected>
#include <string>
#include <string_view>

namespace proskill {

/// JSON for protocols. For output that people read, use `OrderedJson`, see report/ordered_json.h.
using Json = nlohmann::json;

} // namespace proskill

/// JSON-RPC 2.0 as LSP uses it: no batches, identifiers are numbers or strings.
namespace proskill::rpc {

struct RpcError {
  ErrorCode code = ErrorCode::InternalError;
  std::string message;
  Json data = nullptr; ///< defined by the method's specification; null if there is none
};

enum class MessageKind : std::uint8_t { Request, Notification, Response };

struct Message {
  MessageKind kind = MessageKind::Notification;
  Json id;            ///< of requests and responses
  std::string method; ///< of requests and notifications
  Json params;        ///< null if absent
  Json result;        ///< of a successful response
  Json error;         ///< of a failed response; null otherwise
  /// The message contained an unpaired surrogate or invalid UTF-8, each of which was replaced by
  /// U+FFFD. That is one unit of UTF-16, like an unpaired surrogate, so positions keep their
  /// meaning.
  bool isRepaired = false;
};

/// The error of a body that is not a message, and the identifier for the answer:
/// null if unknown.
struct MalformedMessage {
  RpcError error;
  Json id;
};

[[nodiscard]] std::expected<Message, MalformedMessage> parseMessage(std::string_view body);

[[nodiscard]] std::string request(const Json& id, std::string_view method, const Json& params);
[[nodiscard]] std::string notification(std::string_view method, const Json& params);
[[nodiscard]] std::string reply(const Json& id, const Json& result);
[[nodiscard]] std::string replyError(const Json& id, const RpcError& error);

/// A member of a member …; null if one of them is absent or not an object.
[[nodiscard]] const Json& memberAt(const Json& json, std::initializer_list<const char*> path);

} // namespace proskill::rpc
